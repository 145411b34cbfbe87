// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesPolylines_h
#define vtkRidgesPolylines_h

#include "Core/RidgeAssembly.h"
#include "Core/RidgeMeasures.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <unordered_map>
#include <vector>

class vtkDataArray;
class vtkPolyData;
class vtkRidgesMesh;

/**
 * Collects ridges as the polylines and arrays that vtkRidgeExtraction puts out, private to the
 * module. What it is given has to outlive it.
 */
class vtkRidgesPolylines
{
public:
  vtkRidgesPolylines(const vtkRidgesMesh& mesh, const ridges::MongeField& field,
    const ridges::UmbilicCutOff& cutOff, double modelSize);

  void SetCrestOnly(bool crestOnly) { this->CrestOnly = crestOnly; }

  /// The next ridge between these crossings: its runs of one type become polylines. From an umbilic
  /// to the contour of its patch a ridge is hyperbolic (RR-5294, section 6.5).
  void AddRidge(ridges::Ridge& ridge, std::vector<ridges::RidgeSegment>& segments,
    const ridges::RidgeCrossings& crossings);

  void Store(vtkPolyData* output);

private:
  void SetHyperbolicInPatches(const ridges::Ridge& ridge,
    std::vector<ridges::RidgeSegment>& segments, ridges::Color color) const;
  std::vector<ridges::RidgePoint> PointsOf(
    const ridges::Ridge& ridge, const ridges::RidgeCrossings& crossings) const;
  vtkIdType InsertPoint(ridges::Id node, const ridges::RidgePoint& point, ridges::Color color);
  vtkIdType UmbilicIdOf(ridges::Id triangle) const;

  const vtkRidgesMesh& Mesh;
  const ridges::MongeField& Field;
  const ridges::UmbilicCutOff& CutOff;
  double ModelSize;
  bool CrestOnly = false;
  vtkDataArray* UmbilicPatch;

  vtkIdType NextRidgeId = 0;
  std::unordered_map<ridges::Id, vtkIdType> UmbilicPoints; ///< By singular triangle.

  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkIntArray> RidgeType, Crest, Closed, TurningPoint;
  vtkNew<vtkIdTypeArray> RidgeId, Umbilic, EdgePoint0, EdgePoint1;
  vtkNew<vtkDoubleArray> Sharpness, Strength, Length, Curvature, SecondDerivative, EdgeParameter;
};

#endif
