// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesPolylines_h
#define vtkRidgesPolylines_h

#include "Core/Base/Monitor.h"
#include "Core/Ridges/RidgeMeasures.h"
#include "Core/Ridges/RidgeTrace.h"
#include "Core/Salience/FoldAngle.h"
#include "vtkRidgesCompatibility.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

class vtkRidgesMesh;
class vtkRidgesUmbilicMarks;

/**
 * Collects ridges as the polylines and arrays that vtkRidgeExtraction puts out, private to the
 * module. What it is given has to outlive it.
 */
class vtkRidgesPolylines
{
public:
  vtkRidgesPolylines(const vtkRidgesMesh& mesh, const vtkRidgesUmbilicMarks& umbilics,
    const ridges::UmbilicCutOff& cutOff, double modelSize);

  void SetCrestOnly(bool crestOnly) { this->CrestOnly = crestOnly; }

  /// Points at which fits are one-sided: see ridges::BorderStrip.
  void SetBorderStrip(std::vector<std::uint8_t> strip) { this->BorderStrip = std::move(strip); }

  /// The runs of one type of ridges become polylines, with the folds at their vertices if these are
  /// given, for all ridges or for none. False if the monitor stopped it.
  bool AddRidges(const std::vector<ridges::RidgeTrace>& ridges,
    const std::vector<ridges::RidgeFolds>* folds, const ridges::Monitor& monitor);

  void Store(vtkPolyData* output, bool hasFourthOrder, bool hasFolds);

private:
  void AddRidge(const ridges::RidgeTrace& ridge, const ridges::RidgeFolds* folds);
  bool IsNearBorder(const ridges::RidgeTrace& ridge, const ridges::RidgeRun& run) const;
  std::vector<ridges::RidgeRun> OwnedRunsOf(const ridges::RidgeTrace& ridge) const;
  vtkIdType InsertVertex(const ridges::RidgeVertex& vertex, const ridges::Fold* fold);

  const vtkRidgesMesh& Mesh;
  const vtkRidgesUmbilicMarks& Umbilics;
  const ridges::UmbilicCutOff& CutOff;
  double ModelSize;
  bool CrestOnly = false;
  std::vector<std::uint8_t> BorderStrip;

  vtkIdType NextRidgeId = 0;
  std::unordered_map<ridges::Id, vtkIdType> UmbilicPoints; ///< By triangle.

  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkIntArray> RidgeType, Crest, Closed, NearBorder, TurningPoint;
  vtkNew<vtkIdTypeArray> RidgeId, Umbilic, EdgePoint0, EdgePoint1;
  vtkNew<vtkDoubleArray> Confidence, Sharpness, Strength, Length, Curvature, SecondDerivative,
    EdgeParameter;
  vtkNew<vtkDoubleArray> FoldAngle, FoldWidth, LargestFoldAngle; ///< Empty without folds.
};

#endif
