// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesStreamedGathering_h
#define vtkRidgesStreamedGathering_h

#include "vtkRidgesGathering.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkJetFitting;
VTK_ABI_NAMESPACE_END

class vtkRidgesStreamedFit;

/**
 * The part of a mesh that is needed to find umbilics and ridges, where one rank fits one piece
 * after the other: of a piece is kept what may be in its triangles, and the points of the part are
 * fitted once more. Private to the module.
 */
class vtkRidgesStreamedGathering : public vtkRidgesGathering
{
public:
  /// Fits all pieces, unless the whole mesh is needed, which is fitted later. False if the user
  /// aborted. `filter` chooses the arrays; all have to stay until nothing is gathered any more.
  bool Take(
    vtkRidgesStreamedFit& fit, vtkJetFitting* jets, vtkAlgorithm* filter, const Extent& extent);

  /// The part, with ids in the whole mesh.
  void Store(vtkPolyData* part, vtkPolyData* output) const;

  /// Keeps only what Store and the numbers take.
  void Release();

protected:
  Contents ContentsOf(vtkAlgorithm* filter, const Extent& extent) override;
  void PackPoints(ridges::Bytes& message, const std::vector<ridges::Id>& points) override;
  void AddFieldData(vtkPolyData* part) override;

private:
  bool TakePiece(int piece, vtkAlgorithm* filter, const Extent& extent);
  bool NeedsAll(
    ridges::Span<ridges::Triangle> triangles, const Contents& contents, ridges::Id taken);

  vtkRidgesStreamedFit* Fit = nullptr;
  Contents Known;
  std::vector<double> Radii;         ///< Of fits.
  double Rounding = 0.0;             ///< See FitErrorSource.
  std::vector<ridges::Id> IdInPiece; ///< Of points of the piece that is taken; else -1.
  std::int64_t WithContent = 0;      ///< Triangles of pieces in which, or beside, something may be.
  vtkJetFitting* WarnsLater = nullptr;
};

#endif
