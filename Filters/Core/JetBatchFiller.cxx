// SPDX-License-Identifier: BSD-3-Clause
#include "JetBatchFiller.h"

#include <algorithm>

namespace ridges
{

JetBatchFiller::JetBatchFiller(int degree, int lanes, Weighting weighting)
  : Lanes_(lanes)
  , Weighting_(weighting)
  , Batch_(std::make_unique<JetBatch>())
{
  this->Batch_->degree = degree;
}

bool JetBatchFiller::Add(const TriangleMesh& mesh, Id vertex, Span<Id> points)
{
  JetBatch& batch = *this->Batch_;
  const int rows = points.size();
  if (rows > JetBatch::MaximumRows || rows < HeightJet::Size(batch.degree))
  {
    return false;
  }
  const int lane = this->Size_++;
  const int stride = this->Lanes_;
  this->Vertices_[lane] = vertex;
  this->Rows_[lane] = rows;
  batch.counts[lane] = rows;
  const Eigen::Vector3d origin = mesh.Point(vertex);
  double* offset = batch.offsets + lane;
  double* weight = batch.weights + lane;
  for (const Id p : points)
  {
    const auto point = mesh.Point(p);
    offset[0] = point[0] - origin[0];
    offset[stride] = point[1] - origin[1];
    offset[2 * stride] = point[2] - origin[2];
    *weight = 1.0;
    offset += 3 * stride;
    weight += stride;
  }
  if (this->Weighting_ == Weighting::Gaussian)
  {
    this->WeightLane(lane);
  }
  const Eigen::Vector3d side = mesh.PointNormal(vertex);
  for (int i = 0; i < 3; ++i)
  {
    batch.side[i * stride + lane] = side[i];
  }
  return true;
}

void JetBatchFiller::WeightLane(int lane)
{
  JetBatch& batch = *this->Batch_;
  const int stride = this->Lanes_;
  const auto squaredDistance = [&](int row)
  {
    const double* offset = batch.offsets + 3 * row * stride + lane;
    return offset[0] * offset[0] + offset[stride] * offset[stride] +
      offset[2 * stride] * offset[2 * stride];
  };
  double squaredRadius = 0.0;
  for (int row = 0; row < this->Rows_[lane]; ++row)
  {
    squaredRadius = std::max(squaredRadius, squaredDistance(row));
  }
  for (int row = 0; row < this->Rows_[lane]; ++row)
  {
    batch.weights[row * stride + lane] = GaussianWeight(squaredDistance(row), squaredRadius);
  }
}

JetBatch& JetBatchFiller::Complete()
{
  JetBatch& batch = *this->Batch_;
  batch.rows = *std::max_element(this->Rows_.begin(), this->Rows_.begin() + this->Size_);
  const int stride = this->Lanes_;
  for (int lane = 0; lane < stride; ++lane)
  {
    // A lane that is not used has no points at all, and a result that nobody asks for.
    const int used = lane < this->Size_ ? this->Rows_[lane] : 0;
    for (int row = used; row < batch.rows; ++row)
    {
      for (int i = 0; i < 3; ++i)
      {
        batch.offsets[(3 * row + i) * stride + lane] = 0.0;
      }
      batch.weights[row * stride + lane] = 0.0;
    }
    if (lane >= this->Size_)
    {
      batch.counts[lane] = 1.0;
      batch.side[lane] = batch.side[stride + lane] = batch.side[2 * stride + lane] = 0.0;
    }
  }
  return batch;
}

bool JetBatchFiller::Result(
  int lane, MongeForm& form, double& conditionNumber, double& residual) const
{
  const JetBatch& batch = *this->Batch_;
  const int stride = this->Lanes_;
  if (!(batch.pivotRatio[lane] > JetBatchKernel::SmallestPivotRatio))
  {
    return false;
  }
  const auto take = [=](const double* values, auto& tuple)
  {
    for (int i = 0; i < static_cast<int>(tuple.size()); ++i)
    {
      tuple[i] = values[i * stride + lane];
    }
  };
  take(batch.d1, form.d1);
  take(batch.d2, form.d2);
  take(batch.n, form.n);
  take(batch.b, form.b);
  take(batch.c, form.c);
  form.k1 = batch.k1[lane];
  form.k2 = batch.k2[lane];
  conditionNumber = batch.conditionNumber[lane];
  residual = batch.residual[lane];
  return true;
}

} // namespace ridges
