// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMeshes.h"

#include "vtkRidgeExampleSource.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <Eigen/Geometry>

#include <cmath>
#include <fstream>
#include <random>
#include <vector>

namespace benchmarks
{

vtkSmartPointer<vtkPolyData> EllipsoidMesh(int frequency)
{
  vtkNew<vtkRidgeExampleSource> source;
  source->SetSurfaceToEllipsoid();
  source->SetFrequency(frequency);
  source->Update();
  return source->GetOutput();
}

namespace
{

Eigen::Vector3d PointOf(vtkPolyData* mesh, vtkIdType p)
{
  Eigen::Vector3d x;
  mesh->GetPoint(p, x.data());
  return x;
}

// A sum of area normals for each point, and the mean length of the edges.
double SumNormals(vtkPolyData* mesh, std::vector<Eigen::Vector3d>& normals)
{
  normals.assign(mesh->GetNumberOfPoints(), Eigen::Vector3d::Zero());
  double sum = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, corners);
    const Eigen::Vector3d x = PointOf(mesh, corners->GetId(0));
    const Eigen::Vector3d a = PointOf(mesh, corners->GetId(1)) - x;
    const Eigen::Vector3d b = PointOf(mesh, corners->GetId(2)) - x;
    sum += a.norm() + b.norm() + (b - a).norm();
    for (const vtkIdType p : *corners)
    {
      normals[p] += a.cross(b);
    }
  }
  return sum / (3.0 * static_cast<double>(mesh->GetNumberOfPolys()));
}

} // namespace

vtkSmartPointer<vtkPolyData> NoisyEllipsoidMesh(int frequency, double noise)
{
  vtkSmartPointer<vtkPolyData> mesh = EllipsoidMesh(frequency);
  std::vector<Eigen::Vector3d> normals;
  const double deviation = noise * SumNormals(mesh, normals);
  // Box and Muller's: the distributions of the standard library differ from one to the other.
  std::mt19937_64 generator(1);
  const auto uniform = [&generator]
  { return (static_cast<double>(generator() >> 11) + 0.5) / 9007199254740992.0; };
  constexpr double twoPi = 6.283185307179586;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    const double shift = deviation * radius * std::cos(twoPi * uniform());
    const Eigen::Vector3d x = PointOf(mesh, p) + shift * normals[p].normalized();
    mesh->GetPoints()->SetPoint(p, x.data());
  }
  mesh->GetPoints()->Modified();
  return mesh;
}

vtkSmartPointer<vtkPolyData> ReadOff(const std::string& path)
{
  std::ifstream file(path);
  std::string keyword;
  vtkIdType pointCount = 0;
  vtkIdType faceCount = 0;
  vtkIdType edgeCount = 0;
  file >> keyword >> pointCount >> faceCount >> edgeCount;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; file && i < pointCount; ++i)
  {
    double point[3];
    file >> point[0] >> point[1] >> point[2];
    points->InsertNextPoint(point);
  }
  vtkNew<vtkCellArray> polys;
  for (vtkIdType i = 0; file && i < faceCount; ++i)
  {
    int size = 0;
    vtkIdType corners[3];
    file >> size >> corners[0] >> corners[1] >> corners[2];
    polys->InsertNextCell(3, corners);
  }
  if (!file)
  {
    return nullptr;
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

} // namespace benchmarks
