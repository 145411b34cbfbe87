// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_JetBatchFiller_h
#define ridges_JetBatchFiller_h

#include "JetBatch.h"
#include "MongeForm.h"
#include "TriangleMesh.h"
#include "Weighting.h"

#include <array>
#include <memory>

namespace ridges
{

/// Lays vertices side by side in a JetBatch, and takes their Monge forms out of it again.
class JetBatchFiller
{
public:
  JetBatchFiller(int degree, int lanes, Weighting weighting = Weighting::Uniform);

  /// The next lane; false if the neighbourhood has too many points for a batch, or too few for the
  /// degree. `points` begins with the vertex.
  bool Add(const TriangleMesh& mesh, Id vertex, Span<Id> points);

  int Size() const { return this->Size_; }
  bool IsEmpty() const { return this->Size_ == 0; }
  bool IsFull() const { return this->Size_ == this->Lanes_; }
  Id Vertex(int lane) const { return this->Vertices_[lane]; }

  /// The batch, ready for a kernel: rows past the end of a lane, and lanes not used, are filled.
  JetBatch& Complete();

  /// What the kernel found for a lane; false if it has no result.
  bool Result(int lane, MongeForm& form, double& conditionNumber, double& residual) const;

  /// Distance of the lane's farthest point from its vertex, where there is a result.
  double Radius(int lane) const { return this->Batch_->radius[lane]; }

  void Clear() { this->Size_ = 0; }

private:
  void WeightLane(int lane);

  int Lanes_;
  Weighting Weighting_;
  int Size_ = 0;
  std::array<Id, JetBatch::MaximumLanes> Vertices_{};
  std::array<int, JetBatch::MaximumLanes> Rows_{};
  std::unique_ptr<JetBatch> Batch_;
};

} // namespace ridges

#endif
