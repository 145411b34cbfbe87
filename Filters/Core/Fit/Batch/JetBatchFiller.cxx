// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/Batch/JetBatchFiller.h"

#include "Fit/Batch/JetBatchFan.h"

#include <algorithm>
#include <numeric>

namespace ridges
{

JetBatchFiller::JetBatchFiller(const TriangleMesh& mesh, const OrderedRings& rings, int degree,
  Weighting weighting, bool standardErrors, bool exactGain)
  : Mesh_(mesh)
  , Rings_(rings)
  , Weighting_(weighting)
  , Batch_(std::make_unique<JetBatch>())
{
  this->Batch_->degree = degree;
  this->Batch_->weighted = weighting != Weighting::Uniform;
  this->Batch_->standardErrors = standardErrors;
  this->Batch_->exactGain = exactGain;
}

bool JetBatchFiller::Add(Id vertex, Span<Id> points, bool wholeRings)
{
  const Id count = points.size();
  if (count > JetBatch::MaximumRows || count < HeightJet::Size(this->Batch_->degree))
  {
    return false;
  }
  // Kernels read as many points of each lane as the longest has: any will do, but they must exist.
  const auto room = static_cast<std::size_t>(this->End_) + count + JetBatch::MaximumRows;
  if (this->Points_.size() < room)
  {
    this->Points_.resize(2 * room, 0);
  }
  std::copy(points.begin(), points.end(), this->Points_.data() + this->End_);
  this->Waiting_[this->Size_++] = { vertex, this->End_, count, wholeRings };
  this->End_ += count;
  return true;
}

void JetBatchFiller::SortBySize()
{
  Id least = JetBatch::MaximumRows;
  Id most = 0;
  for (int i = 0; i < this->Size_; ++i)
  {
    least = std::min(least, this->Waiting_[i].count);
    most = std::max(most, this->Waiting_[i].count);
  }
  // All of one size is usual, and there counting would be a chain of waits for one counter.
  if (least == most)
  {
    std::iota(this->Order_.begin(), this->Order_.begin() + this->Size_, std::uint16_t(0));
    return;
  }
  // Counted: there are few sizes, and no comparison that cannot be foreseen.
  std::array<std::uint16_t, JetBatch::MaximumRows + 2> begins{};
  for (int i = 0; i < this->Size_; ++i)
  {
    ++begins[this->Waiting_[i].count + 1];
  }
  for (Id count = least; count < most; ++count)
  {
    begins[count + 1] += begins[count];
  }
  for (int i = 0; i < this->Size_; ++i)
  {
    this->Order_[begins[this->Waiting_[i].count]++] = static_cast<std::uint16_t>(i);
  }
}

/// The next neighbourhoods into a batch; how many there were.
int JetBatchFiller::Fill(int first, int lanes)
{
  JetBatch& batch = *this->Batch_;
  const int used = std::min(lanes, this->Size_ - first);
  batch.points = this->Mesh_.Point(0).data();
  batch.rows = this->Waiting_[this->Order_[first + used - 1]].count;
  batch.triangles = 0;
  for (int lane = 0; lane < lanes; ++lane)
  {
    // Lanes that are left over repeat the first, and nobody asks for their results.
    const int i = lane < used ? first + lane : first;
    this->FillLane(lane, lanes, this->Waiting_[this->Order_[i]]);
  }
  return used;
}

void JetBatchFiller::FillLane(int lane, int stride, const Neighborhood& neighborhood)
{
  JetBatch& batch = *this->Batch_;
  batch.neighbors[lane] = this->Points_.data() + neighborhood.first;
  batch.counts[lane] = neighborhood.count;
  FillFan(
    this->Mesh_, this->Rings_, neighborhood.vertex, lane, stride, batch, neighborhood.wholeRings);
  if (batch.weighted)
  {
    this->WeightLane(lane, stride, neighborhood);
  }
}

void JetBatchFiller::WeightLane(int lane, int stride, const Neighborhood& neighborhood)
{
  JetBatch& batch = *this->Batch_;
  const auto vertex = this->Mesh_.Point(neighborhood.vertex);
  const auto squaredDistance = [this, &batch, &lane, &vertex](int row)
  { return (this->Mesh_.Point(batch.neighbors[lane][row]) - vertex).squaredNorm(); };
  double squaredRadius = 0.0;
  for (int row = 0; row < neighborhood.count; ++row)
  {
    squaredRadius = std::max(squaredRadius, squaredDistance(row));
  }
  for (int row = 0; row < batch.rows; ++row)
  {
    batch.weights[row * stride + lane] =
      row < neighborhood.count ? GaussianWeight(squaredDistance(row), squaredRadius) : 0.0;
  }
}

void JetBatchFiller::Clear()
{
  this->Size_ = 0;
  this->End_ = 0;
}

bool TakeResult(const JetBatch& batch, int lanes, int lane, MongeForm& form)
{
  const auto take = [lanes, lane](const double* values, auto& tuple)
  {
    for (int i = 0; i < static_cast<int>(tuple.size()); ++i)
    {
      tuple[i] = values[i * lanes + lane];
    }
  };
  take(batch.d1, form.d1);
  take(batch.d2, form.d2);
  take(batch.n, form.n);
  take(batch.b, form.b);
  take(batch.c, form.c);
  form.k1 = batch.k1[lane];
  form.k2 = batch.k2[lane];
  return batch.good[lane] != 0.0;
}

} // namespace ridges
