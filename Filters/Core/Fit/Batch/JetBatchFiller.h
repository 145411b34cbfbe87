// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_JetBatchFiller_h
#define ridges_JetBatchFiller_h

#include "Fit/Batch/JetBatch.h"
#include "Fit/Weighting.h"
#include "Mesh/OrderedRings.h"
#include "Monge/MongeForm.h"

#include <array>
#include <memory>
#include <vector>

namespace ridges
{

/**
 * Neighbourhoods that wait to be fitted, some hundred at a time. They are put side by side in
 * batches by their number of points, so that hardly a lane waits for a longer one; what comes out
 * for a vertex does not depend on that.
 */
class JetBatchFiller
{
public:
  JetBatchFiller(const TriangleMesh& mesh, const OrderedRings& rings, int degree,
    Weighting weighting = Weighting::Uniform, bool standardErrors = false, bool exactGain = false);

  /// Takes a neighbourhood in; false if it has too many points for a batch, or too few for the
  /// degree. `points` begins with the vertex, and then, where `wholeRings` says so, come its
  /// neighbours in order.
  bool Add(Id vertex, Span<Id> points, bool wholeRings = true);

  bool IsFull() const { return this->Size_ == Capacity; }
  bool IsEmpty() const { return this->Size_ == 0; }

  /// Fits all that was taken in, and forgets it. Calls visit(batch, vertices) for each batch, where
  /// vertices[lane] is that of the lane; the last lanes of the last batch may have none.
  template <typename Visit>
  void Fit(const JetBatchKernel& kernel, Visit visit)
  {
    this->SortBySize();
    for (int first = 0; first < this->Size_; first += kernel.lanes)
    {
      const int lanes = this->Fill(first, kernel.lanes);
      kernel.fit(*this->Batch_);
      std::array<Id, JetBatch::MaximumLanes> vertices;
      for (int lane = 0; lane < lanes; ++lane)
      {
        vertices[lane] = this->Waiting_[this->Order_[first + lane]].vertex;
      }
      visit(*this->Batch_, Span<Id>{ vertices.data(), vertices.data() + lanes });
    }
    this->Clear();
  }

private:
  static constexpr int Capacity = 256;

  struct Neighborhood
  {
    Id vertex;
    Id first; ///< In Points_.
    Id count;
    bool wholeRings;
  };

  void SortBySize();
  int Fill(int first, int lanes);
  void FillLane(int lane, int stride, const Neighborhood& neighborhood);
  void WeightLane(int lane, int stride, const Neighborhood& neighborhood);
  void Clear();

  const TriangleMesh& Mesh_;
  const OrderedRings& Rings_;
  Weighting Weighting_;
  int Size_ = 0;
  std::array<Neighborhood, Capacity> Waiting_{};
  std::array<std::uint16_t, Capacity> Order_{};
  std::vector<Id> Points_; ///< Of one after the other; longer than they need.
  Id End_ = 0;
  std::unique_ptr<JetBatch> Batch_;
};

/// What a kernel found for a lane of a batch of `lanes`; false if there is no result.
bool TakeResult(const JetBatch& batch, int lanes, int lane, MongeForm& form);

} // namespace ridges

#endif
