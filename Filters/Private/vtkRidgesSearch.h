// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesSearch_h
#define vtkRidgesSearch_h

#include "Core/Fit/FitErrors.h"
#include "Core/Ridges/RidgeTrace.h"
#include "vtkRidgesCompatibility.h"
#include "vtkRidgesZoneSearch.h"

#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

class vtkRidgesMesh;
class vtkRidgesMongeInput;
class vtkRidgesUmbilicMarks;

/**
 * Finds the whole ridges of a mesh, one colour after the other, private to the module. What it is
 * given has to outlive it.
 */
class vtkRidgesSearch
{
public:
  vtkRidgesSearch(const vtkRidgesMongeInput& monge, const vtkRidgesUmbilicMarks& umbilics);

  void SetCrossingRule(ridges::CrossingRule rule) { this->CrossingRule = rule; }
  void SetExtremalityRule(ridges::ExtremalityRule rule) { this->ExtremalityRule = rule; }
  void SetTypeRule(ridges::TypeRule rule) { this->TypeRule = rule; }
  void SetUsePatches(bool use) { this->UsePatches = use; }
  void SetLoopSignificance(double significance) { this->LoopSignificance = significance; }
  void SetZoneSignificance(double significance) { this->ZoneSignificance = significance; }
  void SetShortestRun(double length) { this->ShortestRun = length; }
  void SetTypeSignificance(double significance) { this->TypeSignificance = significance; }

  /// Whether traces get their sureLengths.
  void SetMeasuresTypes(bool measures) { this->MeasuresTypes = measures; }

  /// The ridges of a colour, or with the Gaussian rule those of both, in canonical form and order;
  /// and, if wanted, the zones in which ridges were left out.
  /// False if the user aborted the filter, whose progress runs from `from` to `to`.
  bool Find(vtkAlgorithm* filter, ridges::Color color, double from, double to,
    std::vector<ridges::RidgeTrace>& found, vtkRidgesZones* zones = nullptr) const;

private:
  /// Pieces of ridges, those inside patches first.
  struct Pieces
  {
    std::vector<ridges::RidgeSegment> segments;
    std::vector<ridges::RidgePath> paths;
    std::vector<std::uint8_t> isReplaced; ///< Triangles in which marching does not hold.
  };

  // The steps of Find. Each reports progress from `from` to `to`; false if the user aborted.
  bool FindCrossings(
    vtkAlgorithm* filter, double from, double to, ridges::RidgeCrossings& crossings) const;
  bool DrawPatches(vtkAlgorithm* filter, double from, double to,
    const ridges::RidgeCrossings& crossings, Pieces& pieces) const;
  bool March(vtkAlgorithm* filter, double from, double to, const ridges::RidgeCrossings& crossings,
    Pieces& pieces) const;
  bool LeaveOutSmallLoops(vtkAlgorithm* filter, double from, double to,
    const ridges::RidgeCrossings& crossings, const Pieces& pieces,
    std::vector<ridges::Ridge>& whole) const;
  bool LeaveOutZones(vtkAlgorithm* filter, double from, double to, ridges::Color color,
    const Pieces& pieces, std::vector<ridges::Ridge>& whole, vtkRidgesZones* zones) const;
  bool Trace(vtkAlgorithm* filter, double from, double to, const ridges::RidgeCrossings& crossings,
    const Pieces& pieces, std::vector<ridges::Ridge>& whole,
    std::vector<ridges::RidgeTrace>& found) const;
  bool DecideTypes(
    vtkAlgorithm* filter, double from, double to, std::vector<ridges::RidgeTrace>& found) const;

  ridges::UmbilicLookup MakeLookup() const;

  const vtkRidgesMongeInput& Monge;
  const vtkRidgesMesh& Mesh;
  const ridges::MongeField& Field;
  const ridges::FitErrorSource& Errors;
  const vtkRidgesUmbilicMarks& Umbilics;
  ridges::CrossingRule CrossingRule = ridges::CrossingRule::Form;
  ridges::ExtremalityRule ExtremalityRule = ridges::ExtremalityRule::Principal;
  ridges::TypeRule TypeRule = ridges::TypeRule::FourthOrder;
  bool UsePatches = true;
  double LoopSignificance = 0.0;
  double ZoneSignificance = 0.0;
  double ShortestRun = 0.0;
  double TypeSignificance = 0.0;
  bool MeasuresTypes = false;
};

#endif
