// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What the tests of the filters share: meshes as vtkPolyData, the pipeline in one call, and checks
// of arrays.

#ifndef FilterTestTools_h
#define FilterTestTools_h

#include "TestMeshes.h"

#include "vtkDataSetAttributes.h"
#include "vtkJetFitting.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace ridges
{
namespace testing
{

vtkSmartPointer<vtkPolyData> ToPolyData(const Mesh& mesh, int pointType = VTK_DOUBLE);

/// The triangles among the cells, with their points.
Mesh ToMesh(vtkPolyData* polyData);

/// Of vtkRidgeExampleSource.
vtkSmartPointer<vtkPolyData> EllipsoidData(int frequency);
vtkSmartPointer<vtkPolyData> BlendData(int frequency);

/// Points given as x, y, z, ...; polygons by their corners.
vtkSmartPointer<vtkPolyData> MakePolyData(const std::vector<std::array<double, 3>>& points,
  const std::vector<std::vector<vtkIdType>>& polygons);

/// Outputs of the filters, each with its default properties.
struct Outputs
{
  vtkSmartPointer<vtkPolyData> fitted;
  vtkSmartPointer<vtkPolyData> marked;
  vtkSmartPointer<vtkPolyData> umbilics;
  vtkSmartPointer<vtkPolyData> ridges;
  std::string warnings;
  std::string errors;
};
Outputs RunFilters(vtkPolyData* mesh, int neighborhood = vtkJetFitting::AUTOMATIC);

/// A component of a data array that has to be there.
double Value(vtkFieldData* data, const char* name, vtkIdType tuple, int component = 0);
Eigen::Vector3d VectorAt(vtkFieldData* data, const char* name, vtkIdType tuple);
Eigen::Vector3d PointAt(vtkPolyData* data, vtkIdType id);

/// Whether the array is there with this type, number of components and number of tuples.
void ExpectArray(vtkFieldData* data, const char* name, int type, int components, vtkIdType tuples);

/// No NaN or infinity in any point, point array, cell array or field array.
void ExpectAllFinite(vtkPolyData* data);

/// Points, cells and all arrays with their names, byte for byte.
std::string BytesOf(vtkPolyData* data);

/// The name of the first array, or of the coordinates or cells, that is not the same in both, byte
/// for byte; empty if all is.
std::string FirstDifference(vtkPolyData* a, vtkPolyData* b);

/// Empty: no points and no cells.
bool IsEmpty(vtkPolyData* data);

/// A value per point, by name, that stands in for an array of vtkJetFitting.
void AddPointArray(vtkPolyData* data, const char* name, int components,
  const std::function<void(vtkIdType, double*)>& fill);

/// Monge arrays without any sense: random frames in the tangent planes of the mesh, random
/// coefficients, every tenth extremality exactly 0. Fixed by the seed.
void AddRandomMongeArrays(vtkPolyData* data, std::uint64_t seed);

} // namespace testing
} // namespace ridges

#endif
