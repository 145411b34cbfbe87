// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/Batch/NestedJetFiller.h"

#include "Fit/Batch/JetBatchFan.h"
#include "Monge/MongeForm.h"

#include <algorithm>

namespace ridges
{

NestedJetFiller::NestedJetFiller(const TriangleMesh& mesh, const OrderedRings& rings)
  : Mesh_(mesh)
  , Rings_(rings)
  , Batch_(std::make_unique<NestedJetBatch>())
{
  for (int i = 0; i < Fits; ++i)
  {
    JetBatch& batch = this->Batch_->fits[i];
    batch.degree = NestedJetBatch::Degrees[i];
    batch.weighted = false;
    batch.standardErrors = false;
    batch.exactGain = true;
  }
}

bool NestedJetFiller::Add(Id vertex, Span<Id> points, const Counts& counts)
{
  for (int i = 0; i < Fits; ++i)
  {
    if (counts[i] < HeightJet::Size(NestedJetBatch::Degrees[i]))
    {
      return false;
    }
  }
  if (counts.back() > JetBatch::MaximumRows)
  {
    return false;
  }
  this->Waiting_.push_back({ vertex, this->Points_.size(), counts });
  this->Points_.insert(this->Points_.end(), points.begin(), points.end());
  return true;
}

/// So that hardly a lane waits for a longer one.
void NestedJetFiller::SortBySize()
{
  std::stable_sort(this->Waiting_.begin(), this->Waiting_.end(),
    [](const Neighborhood& a, const Neighborhood& b) { return a.counts < b.counts; });
  // Kernels read as many points of each lane as the longest has: any will do.
  this->Points_.resize(this->Points_.size() + JetBatch::MaximumRows, 0);
}

int NestedJetFiller::Fill(int first, int lanes)
{
  const int used = std::min(lanes, static_cast<int>(this->Waiting_.size()) - first);
  for (JetBatch& batch : this->Batch_->fits)
  {
    batch.points = this->Mesh_.Point(0).data();
    batch.rows = 0;
    batch.triangles = 0;
  }
  for (int lane = 0; lane < lanes; ++lane)
  {
    // Lanes that are left over repeat the first, and nobody asks for their results.
    this->FillLane(lane, lanes, this->Waiting_[lane < used ? first + lane : first]);
  }
  return used;
}

void NestedJetFiller::FillLane(int lane, int lanes, const Neighborhood& neighborhood)
{
  for (int i = 0; i < Fits; ++i)
  {
    JetBatch& batch = this->Batch_->fits[i];
    batch.neighbors[lane] = this->Points_.data() + neighborhood.first;
    batch.counts[lane] = neighborhood.counts[i];
    batch.rows = std::max(batch.rows, static_cast<int>(neighborhood.counts[i]));
  }
  // The frame is that of the middle one.
  FillFan(this->Mesh_, this->Rings_, neighborhood.vertex, lane, lanes, this->Batch_->fits[1]);
}

} // namespace ridges
