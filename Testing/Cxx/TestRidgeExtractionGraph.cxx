// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The combinatorial promise of vtkRidgeExtraction: on any mesh and with any values every crossing
// is in one ridge, and ridges end only on borders, at non-manifold edges and in singular triangles;
// inside patches of umbilics only at these.

#include "AnalyticSurface.h"
#include "FilterTestTools.h"
#include "RidgeGraph.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgeExtraction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace ridges::testing;

namespace
{

/// The ends of ridges as they are where no umbilics are marked: in singular triangles.
vtkSmartPointer<vtkPolyData> WithoutUmbilicIds(vtkPolyData* ridges)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(ridges);
  copy->GetPointData()->GetArray("Umbilic")->Fill(-1.0);
  return copy;
}

void ExpectCompleteRidges(vtkPolyData* mesh)
{
  const Outputs outputs = RunFilters(mesh);
  ASSERT_GT(outputs.ridges->GetNumberOfLines(), 0);
  ExpectCompleteRidgeGraph(outputs.marked, outputs.ridges);
  ExpectNoRidgesCross(outputs.marked, outputs.ridges);
  ExpectJoinedPolylines(outputs.ridges);

  // Without patches everything is exact.
  vtkNew<vtkRidgeExtraction> plain;
  plain->SetInputData(outputs.marked);
  plain->SetUmbilicJoiningToTriangles();
  plain->SetLoopSignificance(0.0);
  plain->SetZoneSignificance(0.0);
  plain->Update();
  ExpectCompleteRidgeGraph(outputs.fitted, WithoutUmbilicIds(plain->GetOutput()));
  ExpectJoinedPolylines(plain->GetOutput());
}

/// On a mesh that carries Monge arrays already.
void ExpectCompleteRidgesOfArrays(vtkPolyData* mesh)
{
  vtkNew<vtkRidgeExtraction> extraction;
  extraction->SetInputData(mesh);
  extraction->SetZoneSignificance(0.0);
  for (const int rule : { vtkRidgeExtraction::FOURTH_ORDER, vtkRidgeExtraction::THIRD_ORDER })
  {
    extraction->SetTypeRule(rule);
    extraction->Update();
    ASSERT_GT(extraction->GetOutput()->GetNumberOfLines(), 0);
    ExpectCompleteRidgeGraph(mesh, extraction->GetOutput());
    ExpectJoinedPolylines(extraction->GetOutput());
    ExpectAllFinite(extraction->GetOutput());
  }
}

} // namespace

TEST(RidgeExtractionGraph, IsCompleteOnTheEllipsoid)
{
  ExpectCompleteRidges(EllipsoidData(32));
}

TEST(RidgeExtractionGraph, IsCompleteOnTheBlend)
{
  ExpectCompleteRidges(BlendData(63));
}

TEST(RidgeExtractionGraph, IsCompleteOnAnOpenMesh)
{
  const auto height = [](double x, double y)
  { return 0.4 * x * x - 0.3 * y * y + 0.5 * x * x * x - 0.2 * x * y * y + 0.3 * y * y * y * y; };
  ExpectCompleteRidges(ToPolyData(GraphPatch(height, 1.0, 40, 0.2, 11)));
}

TEST(RidgeExtractionGraph, IsCompleteOnANoisyMesh)
{
  const Mesh mesh = EllipsoidMesh(24, 1.4, 1.0, 0.6);
  ExpectCompleteRidges(ToPolyData(AddNormalNoise(mesh, 0.1 * MeanEdgeLength(mesh), 3)));
}

TEST(RidgeExtractionGraph, IsCompleteWithRandomArraysOnASphere)
{
  for (const std::uint64_t seed : { 1u, 2u, 3u })
  {
    const auto mesh = ToPolyData(Icosphere(10));
    AddRandomMongeArrays(mesh, seed);
    ExpectCompleteRidgesOfArrays(mesh);
  }
}

TEST(RidgeExtractionGraph, IsCompleteWithRandomArraysOnAnOpenMesh)
{
  for (const std::uint64_t seed : { 4u, 5u, 6u })
  {
    const auto flat = [](double, double) { return 0.0; };
    const auto mesh = ToPolyData(GraphPatch(flat, 1.0, 15, 0.2, seed));
    AddRandomMongeArrays(mesh, seed);
    ExpectCompleteRidgesOfArrays(mesh);
  }
}

TEST(RidgeExtractionGraph, IsCompleteWithRandomArraysOnANonManifoldMesh)
{
  // Random triangles of 12 points, no two of the same three: up to ten at an edge, either way
  // round.
  std::mt19937_64 generator(8);
  const auto random = [&generator] { return 2.0 * Uniform(generator) - 1.0; };
  Mesh mesh;
  for (int p = 0; p < 12; ++p)
  {
    mesh.AddPoint({ random(), random(), random() });
  }
  std::set<std::set<std::int32_t>> taken;
  const auto corner = [&] { return static_cast<std::int32_t>(12 * Uniform(generator)); };
  while (mesh.TriangleCount() < 120)
  {
    const std::int32_t i = corner();
    const std::int32_t j = corner();
    const std::int32_t k = corner();
    if (i != j && j != k && k != i && taken.insert({ i, j, k }).second)
    {
      mesh.AddTriangle(i, j, k);
    }
  }
  const auto data = ToPolyData(mesh);
  AddRandomMongeArrays(data, 9);
  ExpectCompleteRidgesOfArrays(data);
}

// All extremalities 0 and all directions at right angles: the rule for ties keeps the parity.
TEST(RidgeExtractionGraph, IsCompleteWithNothingButTies)
{
  const auto flat = [](double, double) { return 0.0; };
  const auto mesh = ToPolyData(GraphPatch(flat, 1.0, 8, 0.0));
  AddRandomMongeArrays(mesh, 1);
  AddPointArray(mesh, "ThirdOrder", 4,
    [](vtkIdType p, double* b)
    {
      std::fill(b, b + 4, 0.0);
      b[0] = p % 3 == 0 ? -0.0 : 0.0;
      b[3] = p % 5 == 0 ? -1.0 : 0.0;
    });
  const auto axis = [](vtkIdType p, double* d)
  {
    std::fill(d, d + 3, 0.0);
    d[p % 2] = p % 7 == 0 ? -1.0 : 1.0;
  };
  AddPointArray(mesh, "MaximumDirection", 3, axis);
  AddPointArray(mesh, "MinimumDirection", 3,
    [axis](vtkIdType p, double* d)
    {
      double d1[3];
      axis(p, d1);
      d[0] = -d1[1];
      d[1] = d1[0];
      d[2] = 0.0;
    });
  ExpectCompleteRidgesOfArrays(mesh);
}
