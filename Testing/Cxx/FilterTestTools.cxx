// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTestTools.h"

#include "MessageRecorder.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRidgeExampleSource.h"
#include "vtkRidgeExtraction.h"
#include "vtkUmbilicDetection.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ridges
{
namespace testing
{
namespace
{

vtkSmartPointer<vtkPolyData> ExampleData(int surface, int frequency)
{
  vtkNew<vtkRidgeExampleSource> source;
  source->SetSurface(surface);
  source->SetFrequency(frequency);
  source->Update();
  return source->GetOutput();
}

template <typename Action>
void ForArrays(vtkPolyData* data, Action action)
{
  if (data->GetPoints())
  {
    action(data->GetPoints()->GetData(), "points");
  }
  for (vtkFieldData* arrays : { static_cast<vtkFieldData*>(data->GetPointData()),
         static_cast<vtkFieldData*>(data->GetCellData()), data->GetFieldData() })
  {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      if (arrays->GetArray(i))
      {
        action(arrays->GetArray(i), arrays->GetArrayName(i));
      }
    }
  }
}

/// Names and bytes of all arrays.
std::vector<std::pair<std::string, std::string>> PartsOf(vtkPolyData* data)
{
  std::vector<std::pair<std::string, std::string>> parts;
  const auto append = [&parts](vtkDataArray* array, const char* name)
  {
    std::string bytes = name + std::to_string(array->GetNumberOfComponents());
    if (array->GetNumberOfTuples() > 0)
    {
      bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
        static_cast<std::size_t>(array->GetDataSize()) * array->GetDataTypeSize());
    }
    parts.emplace_back(name, std::move(bytes));
  };
  ForArrays(data, append);
  for (vtkCellArray* cells :
    { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
  {
    append(cells->GetOffsetsArray(), "offsets");
    append(cells->GetConnectivityArray(), "connectivity");
  }
  return parts;
}

} // namespace

vtkSmartPointer<vtkPolyData> ToPolyData(const Mesh& mesh, int pointType)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(pointType);
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.PointCount()));
  for (std::size_t p = 0; p < mesh.PointCount(); ++p)
  {
    points->SetPoint(static_cast<vtkIdType>(p), mesh.Point(p).data());
  }
  vtkNew<vtkCellArray> triangles;
  for (std::size_t t = 0; t < mesh.TriangleCount(); ++t)
  {
    triangles->InsertNextCell(
      { mesh.triangles[3 * t], mesh.triangles[3 * t + 1], mesh.triangles[3 * t + 2] });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

Mesh ToMesh(vtkPolyData* polyData)
{
  Mesh mesh;
  for (vtkIdType p = 0; p < polyData->GetNumberOfPoints(); ++p)
  {
    mesh.AddPoint(PointAt(polyData, p));
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < polyData->GetNumberOfPolys(); ++t)
  {
    polyData->GetPolys()->GetCellAtId(t, corners);
    if (corners->GetNumberOfIds() == 3)
    {
      mesh.AddTriangle(static_cast<std::int32_t>(corners->GetId(0)),
        static_cast<std::int32_t>(corners->GetId(1)), static_cast<std::int32_t>(corners->GetId(2)));
    }
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> EllipsoidData(int frequency)
{
  return ExampleData(vtkRidgeExampleSource::ELLIPSOID, frequency);
}

vtkSmartPointer<vtkPolyData> BlendData(int frequency)
{
  return ExampleData(vtkRidgeExampleSource::BLEND, frequency);
}

vtkSmartPointer<vtkPolyData> MakePolyData(const std::vector<std::array<double, 3>>& points,
  const std::vector<std::vector<vtkIdType>>& polygons)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  for (const auto& point : points)
  {
    coordinates->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  data->SetPoints(coordinates);
  data->SetPolys(cells);
  return data;
}

Outputs RunFilters(vtkPolyData* mesh, int neighborhood)
{
  vtkNew<vtkJetFitting> jets;
  vtkNew<vtkUmbilicDetection> umbilics;
  vtkNew<vtkRidgeExtraction> ridges;
  const MessageRecorder fromJets(jets);
  const MessageRecorder fromUmbilics(umbilics);
  const MessageRecorder fromRidges(ridges);
  jets->SetNeighborhood(neighborhood);
  jets->SetInputData(mesh);
  umbilics->SetInputConnection(jets->GetOutputPort());
  ridges->SetInputConnection(umbilics->GetOutputPort());
  ridges->SetLoopSignificance(0.0); // All ridges: tests look for every crossing.
  ridges->SetZoneSignificance(0.0);
  ridges->SetTypeSignificance(0.0);
  ridges->Update();

  Outputs outputs;
  outputs.fitted = jets->GetOutput();
  outputs.marked = umbilics->GetOutput(0);
  outputs.umbilics = umbilics->GetOutput(1);
  outputs.ridges = ridges->GetOutput();
  for (const MessageRecorder* recorder : { &fromJets, &fromUmbilics, &fromRidges })
  {
    outputs.warnings += recorder->WarningText();
    outputs.errors += recorder->ErrorText();
  }
  return outputs;
}

double Value(vtkFieldData* data, const char* name, vtkIdType tuple, int component)
{
  vtkDataArray* array = data->GetArray(name);
  if (!array || tuple < 0 || tuple >= array->GetNumberOfTuples())
  {
    throw std::out_of_range(std::string("no such value in ") + name);
  }
  return array->GetComponent(tuple, component);
}

Eigen::Vector3d VectorAt(vtkFieldData* data, const char* name, vtkIdType tuple)
{
  return { Value(data, name, tuple, 0), Value(data, name, tuple, 1), Value(data, name, tuple, 2) };
}

Eigen::Vector3d PointAt(vtkPolyData* data, vtkIdType id)
{
  Eigen::Vector3d point;
  data->GetPoint(id, point.data());
  return point;
}

void ExpectArray(vtkFieldData* data, const char* name, int type, int components, vtkIdType tuples)
{
  vtkDataArray* array = data->GetArray(name);
  ASSERT_NE(array, nullptr) << name;
  EXPECT_EQ(array->GetDataType(), type) << name;
  EXPECT_EQ(array->GetNumberOfComponents(), components) << name;
  EXPECT_EQ(array->GetNumberOfTuples(), tuples) << name;
}

void ExpectAllFinite(vtkPolyData* data)
{
  ForArrays(data,
    [](vtkDataArray* array, const char* name)
    {
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      {
        for (int j = 0; j < array->GetNumberOfComponents(); ++j)
        {
          ASSERT_TRUE(std::isfinite(array->GetComponent(i, j))) << name << " of " << i;
        }
      }
    });
}

std::string BytesOf(vtkPolyData* data)
{
  std::string bytes;
  for (const auto& part : PartsOf(data))
  {
    bytes += part.second;
  }
  return bytes;
}

std::string FirstDifference(vtkPolyData* a, vtkPolyData* b)
{
  const auto partsOfA = PartsOf(a);
  const auto partsOfB = PartsOf(b);
  for (std::size_t i = 0; i < std::min(partsOfA.size(), partsOfB.size()); ++i)
  {
    if (partsOfA[i] != partsOfB[i])
    {
      return partsOfA[i].first + " and " + partsOfB[i].first;
    }
  }
  return partsOfA.size() == partsOfB.size() ? "" : "number of arrays";
}

bool IsEmpty(vtkPolyData* data)
{
  return data && data->GetNumberOfPoints() == 0 && data->GetNumberOfCells() == 0;
}

void AddPointArray(vtkPolyData* data, const char* name, int components,
  const std::function<void(vtkIdType, double*)>& fill)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    fill(p, array->GetPointer(components * p));
  }
  data->GetPointData()->AddArray(array);
}

void AddRandomMongeArrays(vtkPolyData* data, std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  const auto random = [&generator] { return 2.0 * Uniform(generator) - 1.0; };
  const std::vector<Eigen::Vector3d> normals = PointNormals(ToMesh(data));
  std::vector<Eigen::Vector3d> d1(normals.size());
  for (std::size_t p = 0; p < normals.size(); ++p)
  {
    const double angle = EIGEN_PI * random();
    const Eigen::Vector3d axis = normals[p].unitOrthogonal();
    d1[p] = std::cos(angle) * axis + std::sin(angle) * normals[p].cross(axis);
  }
  AddPointArray(data, "MaximumDirection", 3,
    [&](vtkIdType p, double* d) { Eigen::Map<Eigen::Vector3d>{ d } = d1[p]; });
  AddPointArray(data, "MinimumDirection", 3,
    [&](vtkIdType p, double* d) { Eigen::Map<Eigen::Vector3d>{ d } = normals[p].cross(d1[p]); });
  AddPointArray(data, "MaximumCurvature", 1, [&](vtkIdType, double* k) { *k = 1.0 + random(); });
  AddPointArray(data, "MinimumCurvature", 1, [&](vtkIdType, double* k) { *k = random() - 1.0; });
  AddPointArray(data, "ThirdOrder", 4,
    [&](vtkIdType, double* b)
    {
      for (int i = 0; i < 4; ++i)
      {
        b[i] = Uniform(generator) < 0.1 ? 0.0 : random();
      }
    });
  AddPointArray(data, "P1", 1, [&](vtkIdType, double* P) { *P = random(); });
  AddPointArray(data, "P2", 1, [&](vtkIdType, double* P) { *P = random(); });
}

} // namespace testing
} // namespace ridges
