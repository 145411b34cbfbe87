// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImplicitSurfaceMesh.h"

#include "AnalyticSurface.h"
#include "FilterTestTools.h"
#include "MessageRecorder.h"
#include "vtkImplicitMongeForm.h"
#include "vtkRidgesArrayNames.h"
#include "vtkUmbilicDetection.h"

#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

constexpr double Degree = 3.14159265358979323846 / 180.0;

struct Case
{
  const char* formula;
  std::array<double, 6> bounds;
  double edgeLength;
  int euler;
  double volume;      // 0 if not known
  bool bends = false; // within an edge, at its rim
};

const Case Cases[] = {
  { "x^2/1.96 + y^2 + z^2/0.36 - 1", { -1.5, 1.5, -1.1, 1.1, -0.7, 0.7 }, 0.1, 2, 3.5186 },
  // f is 0 at points of the grid.
  { "x^2 + y^2 + z^2 - 1", { -2.0, 2.0, -2.0, 2.0, -2.0, 2.0 }, 0.1, 2, 4.18879 },
  { "(sqrt(x^2+y^2)-1)^2 + z^2 - 0.16", { -1.5, 1.5, -1.5, 1.5, -0.5, 0.5 }, 0.1, 0, 3.15827 },
  { "(x^2*(x^2-1)+y^2)^2 + 0.3*z^2 - 0.04 - 0.005*(0.6*x+0.4*y*z-0.5*x*y+0.7*x^2*z+0.3*y)",
    { -1.3, 1.3, -0.85, 0.85, -0.5, 0.5 }, 0.06, -2, 0.0, true },
  // Its inside is outside.
  { "1 - x^2 - y^2 - z^2", { -1.2, 1.2, -1.2, 1.2, -1.2, 1.2 }, 0.1, 2, -4.18879 },
};

vtkSmartPointer<vtkPolyData> MeshOf(const Case& c)
{
  vtkNew<vtkImplicitSurfaceMesh> source;
  const MessageRecorder messages(source);
  source->SetFormula(c.formula);
  source->SetBounds(c.bounds.data());
  source->SetEdgeLength(c.edgeLength);
  source->Update();
  EXPECT_EQ(messages.ErrorText(), "");
  EXPECT_EQ(messages.NumberOfWarnings(), c.bends ? 1u : 0u) << messages.WarningText();
  return source->GetOutput();
}

} // namespace

// Of inscribed triangles the volume is too small, by about an eighth of the area times the square
// of the edge length and the curvature.
TEST(ImplicitSurfaceMesh, IsClosedOutwardAndEven)
{
  for (const Case& c : Cases)
  {
    SCOPED_TRACE(c.formula);
    const Mesh mesh = ToMesh(MeshOf(c));
    const MeshTopology topology = Topology(mesh);
    EXPECT_TRUE(topology.oriented);
    EXPECT_EQ(topology.borderEdges, 0);
    EXPECT_EQ(topology.EulerCharacteristic(), c.euler);
    if (c.volume != 0.0)
    {
      EXPECT_NEAR(SignedVolume(mesh), c.volume, 0.02 * std::abs(c.volume));
    }
    double least = 180.0;
    double shortest = 1e9;
    double longest = 0.0;
    double sum = 0.0;
    for (std::size_t t = 0; t < mesh.TriangleCount(); ++t)
    {
      for (int i = 0; i < 3; ++i)
      {
        const Eigen::Vector3d a = mesh.Point(mesh.triangles[3 * t + i]);
        const Eigen::Vector3d u = mesh.Point(mesh.triangles[3 * t + (i + 1) % 3]) - a;
        const Eigen::Vector3d v = mesh.Point(mesh.triangles[3 * t + (i + 2) % 3]) - a;
        least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)) / Degree);
        shortest = std::min(shortest, u.norm());
        longest = std::max(longest, u.norm());
        sum += u.norm();
      }
    }
    EXPECT_GT(least, 30.0);
    EXPECT_GT(shortest, 0.65 * c.edgeLength);
    EXPECT_LT(longest, 1.4 * c.edgeLength);
    EXPECT_NEAR(
      sum / static_cast<double>(mesh.triangles.size()), 1.03 * c.edgeLength, 0.02 * c.edgeLength);
  }
}

TEST(ImplicitSurfaceMesh, PointsAreOnTheSurface)
{
  const auto mesh = MeshOf(Cases[0]);
  const AnalyticSurface surface = MakeEllipsoid(1.4, 1.0, 0.6);
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    EXPECT_LT(std::abs(surface.Value(PointAt(mesh, p))), 1e-14);
  }
}

// The source with its default properties, then the exact forms, which find the formula there.
TEST(ImplicitSurfaceMesh, DefaultIsTheBlendOfTheFigure)
{
  vtkNew<vtkImplicitSurfaceMesh> source;
  EXPECT_EQ(source->GetEdgeLength(), 0.0);
  source->SetEdgeLength(0.025); // to be quick
  vtkNew<vtkImplicitMongeForm> forms;
  const MessageRecorder messages(source);
  forms->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkUmbilicDetection> umbilics;
  umbilics->SetInputConnection(forms->GetOutputPort());
  umbilics->Update();
  EXPECT_EQ(messages.ErrorText() + messages.WarningText(), "");
  EXPECT_EQ(umbilics->GetOutput(1)->GetNumberOfPoints(), 8);
}

TEST(ImplicitSurfaceMesh, ReportsBoundsThatCutTheSurface)
{
  vtkNew<vtkImplicitSurfaceMesh> source;
  const MessageRecorder messages(source);
  source->SetFormula("x^2 + y^2 + z^2 - 1");
  source->SetBounds(-1.2, 1.2, -1.2, 1.2, -1.2, 0.3);
  source->SetEdgeLength(0.1);
  source->Update();
  EXPECT_EQ(messages.NumberOfWarnings(), 1u);
  EXPECT_NE(messages.WarningText().find("Bounds cut the surface"), std::string::npos);
  const MeshTopology topology = Topology(ToMesh(source->GetOutput()));
  EXPECT_EQ(topology.EulerCharacteristic(), 1);
  EXPECT_GT(topology.borderEdges, 50);
  EXPECT_NEAR(source->GetOutput()->GetBounds()[5], 0.3, 1e-6);
}

TEST(ImplicitSurfaceMesh, ReportsApexes)
{
  vtkNew<vtkImplicitSurfaceMesh> source;
  const MessageRecorder messages(source);
  source->SetFormula("x^2 + y^2 - z^3*(1-z)"); // a drop, with its apex at the origin
  source->SetBounds(-1.0, 1.0, -1.0, 1.0, -0.5, 1.5);
  source->SetEdgeLength(0.05);
  source->Update();
  EXPECT_EQ(messages.NumberOfErrors(), 0u);
  EXPECT_EQ(messages.NumberOfWarnings(), 1u);
  EXPECT_NE(messages.WarningText().find("bends within an edge at"), std::string::npos)
    << messages.WarningText();
}

TEST(ImplicitSurfaceMesh, ErrorsAreOneLineThatShowsThePlace)
{
  const auto errorOf = [](const char* formula, double edgeLength, double end)
  {
    vtkNew<vtkImplicitSurfaceMesh> source;
    const MessageRecorder messages(source);
    source->SetFormula(formula);
    source->SetBounds(-1.0, end, -1.0, 1.0, -1.0, 1.0);
    source->SetEdgeLength(edgeLength);
    source->Update();
    EXPECT_EQ(messages.NumberOfErrors(), 1u) << formula;
    EXPECT_EQ(messages.NumberOfWarnings(), 0u) << formula;
    EXPECT_TRUE(IsEmpty(source->GetOutput()));
    return messages.ErrorText();
  };
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(errorOf("x^2 + 3*", 0.2, 1.0).find("the formula ends where"), std::string::npos);
  EXPECT_NE(errorOf("x^2 + y*z^)", 0.2, 1.0).find("at character 11, \")\""), std::string::npos);
  EXPECT_NE(errorOf("x^2 + y^2 + z^2 + 1", 0.2, 1.0)
              .find("surface is empty: within the Bounds f is from 1"),
    std::string::npos);
  EXPECT_NE(
    errorOf("(x^2 + y^2 + z^2 - 1)^2", 0.21, 1.0).find("surface is empty"), std::string::npos);
  EXPECT_NE(errorOf("x + log(y)", 0.2, 1.0).find("because of what is at character 5, \"log(y)\""),
    std::string::npos);
  EXPECT_NE(errorOf("x", 1e-5, 1.0).find("too short for the Bounds"), std::string::npos);
  EXPECT_NE(errorOf("x", 0.1, -1.0).find("a box that is not empty"), std::string::npos);
  EXPECT_NE(errorOf("x", 0.1, none).find("a box that is not empty"), std::string::npos);
  EXPECT_NE(errorOf("x", none, 1.0).find("EdgeLength is"), std::string::npos);
}

TEST(ImplicitSurfaceMesh, SameBytesForAnyThreads)
{
  vtkSMPTools::Initialize(1);
  const auto one = MeshOf(Cases[0]);
  vtkSMPTools::Initialize(3);
  const auto three = MeshOf(Cases[0]);
  vtkSMPTools::Initialize();
  EXPECT_EQ(FirstDifference(one, three), "");
}

TEST(ImplicitSurfaceMesh, ScalesWithItsFormula)
{
  Case large = Cases[0];
  large.formula = "x^2/(1.96*2^40) + y^2/2^40 + z^2/(0.36*2^40) - 1";
  large.edgeLength *= 0x1p20;
  for (double& bound : large.bounds)
  {
    bound *= 0x1p20;
  }
  EXPECT_EQ(MeshOf(large)->GetNumberOfCells(), MeshOf(Cases[0])->GetNumberOfCells());
}
