// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_NestedJetFiller_h
#define ridges_NestedJetFiller_h

#include "Fit/Batch/NestedJetBatch.h"
#include "Mesh/OrderedRings.h"

#include <array>
#include <memory>
#include <vector>

namespace ridges
{

/// As JetBatchFiller, for neighbourhoods of three sizes.
class NestedJetFiller
{
public:
  static constexpr int Fits = NestedJetBatch::Fits;
  using Counts = std::array<Id, Fits>;

  NestedJetFiller(const TriangleMesh& mesh, const OrderedRings& rings);

  /// Takes the largest neighbourhood in, which begins with the vertex and its neighbours in order,
  /// and how many points there are in each; false if these are too many for a batch, or too few.
  bool Add(Id vertex, Span<Id> points, const Counts& counts);

  bool IsFull() const { return this->Waiting_.size() == Capacity; }
  bool IsEmpty() const { return this->Waiting_.empty(); }

  /// Fits all that was taken in, and forgets it. Calls setShares(batch, vertices) for each batch
  /// when fits are made, and visit(batch, vertices) when they are blended.
  template <typename SetShares, typename Visit>
  void Fit(const NestedJetKernel& kernel, SetShares setShares, Visit visit)
  {
    this->SortBySize();
    const int size = static_cast<int>(this->Waiting_.size());
    for (int first = 0; first < size; first += kernel.lanes)
    {
      const int lanes = this->Fill(first, kernel.lanes);
      std::array<Id, JetBatch::MaximumLanes> vertices;
      for (int lane = 0; lane < lanes; ++lane)
      {
        vertices[lane] = this->Waiting_[first + lane].vertex;
      }
      const Span<Id> ofBatch{ vertices.data(), vertices.data() + lanes };
      kernel.fit(*this->Batch_);
      setShares(*this->Batch_, ofBatch);
      kernel.blend(*this->Batch_);
      visit(*this->Batch_, ofBatch);
    }
    this->Waiting_.clear();
    this->Points_.clear();
  }

private:
  static constexpr std::size_t Capacity = 64;

  struct Neighborhood
  {
    Id vertex;
    std::size_t first; ///< In Points_.
    Counts counts;
  };

  void SortBySize();
  int Fill(int first, int lanes);
  void FillLane(int lane, int lanes, const Neighborhood& neighborhood);

  const TriangleMesh& Mesh_;
  const OrderedRings& Rings_;
  std::vector<Neighborhood> Waiting_;
  std::vector<Id> Points_; ///< Of one after the other.
  std::unique_ptr<NestedJetBatch> Batch_;
};

} // namespace ridges

#endif
