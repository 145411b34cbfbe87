// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesOwnedFits_h
#define vtkRidgesOwnedFits_h

#include "Core/Fit/JetSelection.h"
#include "Core/Shares/SharedMesh.h"
#include "Core/Shares/SharedSurface.h"
#include "vtkRidgesCompatibility.h"
#include "vtkRidgesFitFaults.h"
#include "vtkRidgesFitPoints.h"
#include "vtkRidgesMongeOutput.h"

#include <cstdint>
#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkIntArray;
class vtkJetFitting;
class vtkPointData;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * The fits of a rank at points that it owns, at all of them or at some at a time, and what is seen
 * of the surface meanwhile; private to the module. All ranks have to call each function.
 *
 * Points are fitted on a share of the mesh that goes as many rings farther as the fits look at.
 * Where a fit has looked farther than that, it is done again on a larger share.
 */
class vtkRidgesOwnedFits
{
public:
  /// All have to outlive the object.
  vtkRidgesOwnedFits(vtkJetFitting* filter, ridges::Ranks& ranks, ridges::SharedMesh& shared);

  /// Chooses the fit if that is automatic. False if the user aborted.
  bool Choose();

  /// Null if nothing was chosen.
  const ridges::JetChoice* GetChoice() const;

  /// The values at some owned points, in their order, before averages. False if the user aborted.
  bool Fit(const std::vector<ridges::Id>& points, vtkPointData* values);

  /// With averages, at all of them; they become those of the points of the ranks' pieces.
  bool FitPiece(vtkPointData* values);

  /// With averages, of a mesh that is all on this rank.
  bool FitAndAverage(const std::vector<ridges::Id>& points, vtkPointData* values);

  /// The output for a piece, by the values of its points.
  void Store(vtkPolyData* piece, vtkPointData* values, vtkPolyData* output) const;

  /// The fits are reported from `from` to `to`.
  void SetProgress(double from, double to);

  /// Of all points that were fitted, each counted once, of this rank.
  vtkRidgesFitFaults CountFaults() const;

  /// After all points were fitted.
  void KeepSurface(ridges::SharedSurface& surface);

private:
  std::unique_ptr<vtkRidgesMongeOutput> FitPoints(const std::vector<ridges::Id>& points);
  std::vector<ridges::Id> PointsInParts(std::vector<ridges::Id>& begins) const;
  template <typename TakePart>
  bool FitInParts(const std::vector<ridges::Id>& points, const std::vector<ridges::Id>& begins,
    const TakePart& takePart);
  void Average(vtkPointData* values);
  bool FitShare(const std::vector<ridges::Id>& points, int rings, std::vector<int>& reach);
  int GuessReach() const;
  void LookAt(const ridges::MeshShare& share, const ridges::OrderedRings& rings,
    const std::vector<ridges::Id>& points);
  void CountPoints(const std::vector<ridges::Id>& points, vtkIntArray* status);
  void AverageOn(ridges::MeshShare& share, vtkPointData* ofShare, vtkPointData* values);

  vtkJetFitting* Filter;
  ridges::Ranks& Ranks;
  ridges::SharedMesh& Shared;
  int Order;
  bool IsAutomatic;
  double From = 0.3;
  double To = 0.9;
  std::vector<vtkRidgesFitPoints::Settings> Settings; ///< Of fits, blended if there are several.
  ridges::JetChoice Choice;
  std::unique_ptr<vtkRidgesMongeOutput> Values; ///< Of the points that are fitted.

  enum class Seen : std::uint8_t
  {
    No,
    Inside,
    OnBorder
  };
  std::vector<Seen> SeenOf;    ///< Owned points: whether they were looked at.
  std::vector<bool> IsCounted; ///< Owned points: by their status.
  vtkRidgesFitFaults Faults;
  std::int64_t Fans = 0;        ///< Of owned points: see TriangleMesh::NumberOfFans.
  std::int64_t SharedEdges = 0; ///< With two triangles, each counted at both ends.
};

#endif
