// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Errors of curvatures, directions and higher derivatives on meshes of surfaces that are known, for
// Accuracy.md:
//
//   RidgesAccuracy [--write FOLDER]
//
// By the size of the mesh, noise, valence, anisotropy of its triangles, and the degree: those of
// vtkJetFitting with automatic fits, of vtkJetFitting and of CGAL's Monge_via_jet_fitting with fits
// of a degree to the same number of points at least, and of vtkCurvatures. With a folder, the
// meshes are written there, too, with their exact curvatures and directions.

#include "FilterTestTools.h"
#include "Fixtures/TestFields.h"
#include "Formula/ExampleSurface.h"
#include "ParallelFor.h"
#include "TruthCache.h"

#include "Base/SymmetricTensor.h"

#include "vtkCurvatures.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"
#include "vtkSMPTools.h"

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;
using Eigen::Vector2d;
using ridges::MongeForm;

namespace
{

//------------------------------------------------------------------------------
struct KnownMesh
{
  std::string name;
  Mesh mesh;
  std::vector<ExactMonge> exact;
  std::vector<bool> isLeftOut; // points whose errors do not count; empty for none
};

//------------------------------------------------------------------------------
KnownMesh MakeKnown(std::string name, Mesh mesh, const AnalyticSurface& surface)
{
  KnownMesh known{ std::move(name), std::move(mesh), {}, {} };
  known.exact.resize(known.mesh.PointCount());
  ParallelFor(known.exact.size(),
    [&](std::size_t p) { known.exact[p] = surface.Monge(surface.Project(known.mesh.Point(p))); });
  return known;
}

//------------------------------------------------------------------------------
// Errors relative to the root mean square of the value, over the mesh; of directions in degrees.
struct Errors
{
  std::optional<double> k, d, b, c, P;
};

//------------------------------------------------------------------------------
struct Estimates
{
  std::vector<MongeForm> forms;
  int order = 4; // up to which they are known
  bool hasDirections = true;
  double microseconds = 0.0; // of a processor, per point
};

//------------------------------------------------------------------------------
// Of a tensor in the frame of the exact one.
template <std::size_t Size>
void AddSquares(const std::array<double, Size>& estimate, const std::array<double, Size>& exact,
  double& error, double& value)
{
  double times = 1.0;
  for (std::size_t i = 0; i < Size; ++i)
  {
    error += times * std::pow(estimate[i] - exact[i], 2);
    value += times * std::pow(exact[i], 2);
    times *= static_cast<double>(Size - 1 - i) / static_cast<double>(i + 1);
  }
}

//------------------------------------------------------------------------------
Errors ErrorsOf(const Estimates& estimates, const KnownMesh& known)
{
  double meanGap = 0.0;
  for (const ExactMonge& form : known.exact)
  {
    meanGap += (form.k1 - form.k2) / static_cast<double>(known.exact.size());
  }
  std::array<double, 5> errors{};
  std::array<double, 5> values{};
  for (std::size_t p = 0; p < known.exact.size(); ++p)
  {
    if (!known.isLeftOut.empty() && known.isLeftOut[p])
    {
      continue;
    }
    const ExactMonge& exact = known.exact[p];
    const MongeForm& form = estimates.forms[p];
    errors[0] += std::pow(form.k1 - exact.k1, 2) + std::pow(form.k2 - exact.k2, 2);
    values[0] += std::pow(exact.k1, 2) + std::pow(exact.k2, 2);
    Vector2d e(form.d1.dot(exact.d1), form.d1.dot(exact.d2));
    e /= e.norm() > 0.0 ? e.norm() : 1.0;
    // The axes of the exact form in the frame that was found.
    const Vector2d first(e[0], -e[1]);
    const Vector2d second(e[1], e[0]);
    AddSquares(ridges::InBasis(form.b, first, second), exact.b, errors[2], values[2]);
    AddSquares(ridges::InBasis(form.c, first, second), exact.c, errors[3], values[3]);
    if (exact.k1 - exact.k2 > 0.1 * meanGap) // directions mean nothing at umbilics
    {
      errors[1] += std::pow(std::atan2(std::abs(e[1]), std::abs(e[0])), 2);
      values[1] += 1.0;
      errors[4] += std::pow(form.P1() - exact.P1, 2) + std::pow(form.P2() - exact.P2, 2);
      values[4] += std::pow(exact.P1, 2) + std::pow(exact.P2, 2);
    }
  }
  const auto ratio = [&](int i) { return std::sqrt(errors[i] / values[i]); };
  Errors result;
  result.k = ratio(0);
  result.d = estimates.hasDirections ? std::optional(ratio(1) * 57.29577951308232) : std::nullopt;
  result.b = estimates.order >= 3 ? std::optional(ratio(2)) : std::nullopt;
  result.c = estimates.order >= 4 ? std::optional(ratio(3)) : std::nullopt;
  result.P = estimates.order >= 4 ? std::optional(ratio(4)) : std::nullopt;
  return result;
}

//------------------------------------------------------------------------------
// Of all threads together.
double MicrosecondsPerPoint(const std::function<void()>& job, std::size_t points)
{
  const std::clock_t begin = std::clock();
  job();
  return 1e6 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC /
    static_cast<double>(points);
}

//------------------------------------------------------------------------------
// Points of a neighbourhood at least, as vtkJetFitting has them for a degree.
int PointsFor(int degree)
{
  constexpr int points[] = { 0, 0, 8, 12, 18, 26, 34, 45, 56 };
  return points[degree];
}

//------------------------------------------------------------------------------
// Automatic without a degree.
Estimates ByFilter(const KnownMesh& known, int degree)
{
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(ToPolyData(known.mesh));
  Estimates result;
  if (degree > 0)
  {
    jets->SetNeighborhoodToPointCount();
    jets->SetDegree(degree);
    jets->SetMinimumNumberOfPoints(PointsFor(degree));
    result.order = std::min(degree, 4);
    jets->SetMongeOrder(result.order);
  }
  result.microseconds = MicrosecondsPerPoint([&jets] { jets->Update(); }, known.mesh.PointCount());
  vtkPointData* data = jets->GetOutput()->GetPointData();
  result.forms.resize(known.mesh.PointCount());
  for (std::size_t p = 0; p < result.forms.size(); ++p)
  {
    const auto id = static_cast<vtkIdType>(p);
    MongeForm& form = result.forms[p];
    form.k1 = Value(data, names::MaximumCurvature, id);
    form.k2 = Value(data, names::MinimumCurvature, id);
    data->GetArray(names::MaximumDirection)->GetTuple(id, form.d1.data());
    if (result.order >= 3)
    {
      data->GetArray(names::ThirdOrder)->GetTuple(id, form.b.data());
    }
    if (result.order >= 4)
    {
      data->GetArray(names::FourthOrder)->GetTuple(id, form.c.data());
    }
  }
  return result;
}

//------------------------------------------------------------------------------
Estimates ByCGAL(const KnownMesh& known, int degree)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  const MeshedSurface surface(known.mesh);
  const ridges::TriangleMesh& mesh = surface.Triangles();
  ridges::NeighborhoodRule rule;
  rule.minimumNumberOfPoints = PointsFor(degree);
  Estimates result;
  result.order = std::min(degree, 4);
  result.forms.resize(known.mesh.PointCount());
  const auto fit = [&]
  {
    ridges::OrderedRings rings(mesh);
    rings.Build(0, mesh.NumberOfPoints());
    ridges::RingNeighborhood neighborhood(mesh, rings);
    std::vector<Kernel::Point_3> points;
    for (ridges::Id p = 0; p < mesh.NumberOfPoints(); ++p)
    {
      points.clear();
      for (const ridges::Id q : neighborhood.Gather(p, rule))
      {
        points.emplace_back(mesh.Point(q)[0], mesh.Point(q)[1], mesh.Point(q)[2]);
      }
      CGAL::Monge_via_jet_fitting<Kernel> fitter;
      auto theirs = fitter(points.begin(), points.end(), static_cast<std::size_t>(degree),
        static_cast<std::size_t>(result.order));
      const Eigen::Vector3d normal = mesh.PointNormal(p);
      theirs.comply_wrt_given_normal(Kernel::Vector_3(normal[0], normal[1], normal[2]));
      MongeForm& form = result.forms[static_cast<std::size_t>(p)];
      const auto d1 = theirs.maximal_principal_direction();
      form.d1 = { d1.x(), d1.y(), d1.z() };
      form.k1 = theirs.principal_curvatures(0);
      form.k2 = theirs.principal_curvatures(1);
      for (std::size_t i = 0; i < 4 && result.order >= 3; ++i)
      {
        form.b[i] = theirs.third_order_coefficients(i);
      }
      for (std::size_t i = 0; i < 5 && result.order >= 4; ++i)
      {
        form.c[i] = theirs.fourth_order_coefficients(i);
      }
    }
  };
  result.microseconds = MicrosecondsPerPoint(fit, known.mesh.PointCount());
  return result;
}

//------------------------------------------------------------------------------
// Whose sign is the opposite.
Estimates ByCurvatures(const KnownMesh& known)
{
  Estimates result;
  result.order = 2;
  result.hasDirections = false;
  result.forms.resize(known.mesh.PointCount());
  const auto mesh = ToPolyData(known.mesh);
  const auto compute = [&](bool maximum)
  {
    vtkNew<vtkCurvatures> curvatures;
    curvatures->SetInputData(mesh);
    curvatures->SetCurvatureType(maximum ? VTK_CURVATURE_MAXIMUM : VTK_CURVATURE_MINIMUM);
    curvatures->Update();
    vtkDataArray* values = curvatures->GetOutput()->GetPointData()->GetScalars();
    for (std::size_t p = 0; p < result.forms.size(); ++p)
    {
      (maximum ? result.forms[p].k2 : result.forms[p].k1) =
        -values->GetTuple1(static_cast<vtkIdType>(p));
    }
  };
  result.microseconds = MicrosecondsPerPoint(
    [&]
    {
      compute(true);
      compute(false);
    },
    known.mesh.PointCount());
  return result;
}

//------------------------------------------------------------------------------
void PrintRow(const std::string& mesh, const std::string& method, const Estimates& estimates,
  const KnownMesh& known)
{
  const Errors errors = ErrorsOf(estimates, known);
  const auto text = [](const std::optional<double>& value)
  {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.1e", value.value_or(0.0));
    return value ? std::string(buffer) : std::string();
  };
  std::printf("| %-26s | %-20s | %-7s | %-7s | %-7s | %-7s | %-7s | %6.1f |\n", mesh.c_str(),
    method.c_str(), text(errors.k).c_str(), text(errors.d).c_str(), text(errors.b).c_str(),
    text(errors.c).c_str(), text(errors.P).c_str(), estimates.microseconds);
  std::fflush(stdout);
}

//------------------------------------------------------------------------------
void PrintHead(const char* first)
{
  std::printf("\n| %-26s | %-20s | %-7s | %-7s | %-7s | %-7s | %-7s | %6s |\n", first, "fit", "k",
    "d", "b", "c", "P", "time");
  std::printf("|%s|%s|%s|%s|%s|%s|%s|%s|\n", std::string(28, '-').c_str(),
    std::string(22, '-').c_str(), std::string(9, '-').c_str(), std::string(9, '-').c_str(),
    std::string(9, '-').c_str(), std::string(9, '-').c_str(), std::string(9, '-').c_str(),
    std::string(8, '-').c_str());
}

//------------------------------------------------------------------------------
void PrintMethods(const KnownMesh& known)
{
  PrintRow(known.name, "automatic", ByFilter(known, 0), known);
  PrintRow(known.name, "degree 4, 18 points", ByFilter(known, 4), known);
  PrintRow(known.name, "the same by CGAL", ByCGAL(known, 4), known);
  PrintRow(known.name, "vtkCurvatures", ByCurvatures(known), known);
}

//------------------------------------------------------------------------------
Mesh WithNoise(const Mesh& mesh, double share)
{
  return share > 0.0 ? AddNormalNoise(mesh, share * MeanEdgeLength(mesh), 1) : mesh;
}

//------------------------------------------------------------------------------
// A point in the middle of each triangle, so that valences are 3 and 12.
Mesh Split(const Mesh& mesh, const AnalyticSurface& surface)
{
  Mesh split = mesh;
  split.triangles.clear();
  for (std::size_t t = 0; t < mesh.TriangleCount(); ++t)
  {
    const std::int32_t* ids = mesh.triangles.data() + 3 * t;
    const auto middle = static_cast<std::int32_t>(split.PointCount());
    split.AddPoint(
      surface.Project((mesh.Point(ids[0]) + mesh.Point(ids[1]) + mesh.Point(ids[2])) / 3));
    for (int i = 0; i < 3; ++i)
    {
      split.AddTriangle(ids[i], ids[(i + 1) % 3], middle);
    }
  }
  return split;
}

//------------------------------------------------------------------------------
// Radii of about 1 and 0.4: on a torus proper all P are 0.
AnalyticSurface UnevenTorus()
{
  return AnalyticSurface(
    [](auto x, auto y, auto z)
    {
      const auto h = x * x + y * y;
      const auto s = h + z * z + (1.0 - 0.16);
      return (s * s - 4.0 * h) / 3.2 - 0.05 * (x * y + z * x + 0.4 * y * z - 0.3 * x);
    });
}

//------------------------------------------------------------------------------
void Write(const std::string& folder, const KnownMesh& known)
{
  std::string name = folder + "/" + known.name;
  std::replace(name.begin() + static_cast<std::ptrdiff_t>(folder.size()) + 1, name.end(), ' ', '_');
  std::FILE* off = std::fopen((name + ".off").c_str(), "w");
  std::FILE* exact = std::fopen((name + ".exact").c_str(), "w");
  if (!off || !exact)
  {
    std::fprintf(stderr, "cannot write %s\n", name.c_str());
    std::exit(1);
  }
  std::fprintf(off, "OFF\n%zu %zu 0\n", known.mesh.PointCount(), known.mesh.TriangleCount());
  for (std::size_t p = 0; p < known.mesh.PointCount(); ++p)
  {
    const Eigen::Vector3d point = known.mesh.Point(p);
    const ExactMonge& form = known.exact[p];
    std::fprintf(off, "%.17g %.17g %.17g\n", point[0], point[1], point[2]);
    std::fprintf(exact, "%.17g %.17g %.17g %.17g %.17g\n", form.k1, form.k2, form.d1[0], form.d1[1],
      form.d1[2]);
  }
  for (std::size_t t = 0; t < known.mesh.TriangleCount(); ++t)
  {
    const std::int32_t* ids = known.mesh.triangles.data() + 3 * t;
    std::fprintf(off, "3 %d %d %d\n", ids[0], ids[1], ids[2]);
  }
  std::fclose(off);
  std::fclose(exact);
}

//------------------------------------------------------------------------------
// One sheet of a hyperboloid over a square.
void ShowBorder()
{
  constexpr int cells = 100;
  constexpr double halfSize = 1.5;
  const AnalyticSurface surface(
    [](auto x, auto y, auto z) { return x * x / 1.69 + y * y - z * z / 0.64 + 1.0; });
  const Mesh mesh =
    GraphPatch([](double x, double y) { return 0.8 * std::sqrt(1.0 + x * x / 1.69 + y * y); },
      halfSize, cells, 0.2, 1);
  KnownMesh known = MakeKnown("", Flip(mesh), surface);
  const Estimates automatic = ByFilter(known, 0);
  const Estimates fixed = ByFilter(known, 4);
  for (int edges = 0; edges <= 6; ++edges)
  {
    known.isLeftOut.assign(known.exact.size(), true);
    for (std::size_t p = 0; p < known.exact.size(); ++p)
    {
      const Eigen::Vector3d point = known.mesh.Point(p);
      const double inside = halfSize - std::max(std::abs(point.x()), std::abs(point.y()));
      const double away = std::round(inside / (2.0 * halfSize / cells));
      known.isLeftOut[p] = edges < 6 ? away != edges : away < 15.0;
    }
    const std::string name = edges < 6 ? std::to_string(edges) : "15 and more";
    PrintRow(name, "automatic", automatic, known);
    PrintRow(name, "degree 4, 18 points", fixed, known);
  }
}

//------------------------------------------------------------------------------
void Run(const std::string& folder)
{
  const ClosedSurface blob = ClosedSurfaceByName("blob");
  const auto mesh = [&blob](int frequency)
  { return StarShapedMesh(frequency, blob.surface, Eigen::Vector3d::Zero()); };
  const auto show = [&folder](const char* name, const Mesh& points, const AnalyticSurface& surface)
  {
    const KnownMesh known = MakeKnown(name, points, surface);
    PrintMethods(known);
    if (!folder.empty())
    {
      Write(folder, known);
    }
  };

  PrintHead("points");
  show("2,562", mesh(16), blob.surface);
  show("10,242", mesh(32), blob.surface);
  show("40,962", mesh(64), blob.surface);

  PrintHead("noise, edges");
  const Mesh clean = mesh(32);
  for (const char* noise : { "0.001", "0.01", "0.05" })
  {
    show(noise, WithNoise(clean, std::stod(noise)), blob.surface);
  }

  PrintHead("valence");
  show("mostly 6", clean, blob.surface);
  show("3 and 12", Split(mesh(18), blob.surface), blob.surface);
  show("4 to 10", TruthCache(blob, "").MeshWith(10000), blob.surface);

  PrintHead("ratio of sides, 40k");
  const AnalyticSurface torus = UnevenTorus();
  const auto grid = [&torus](int nu, int nv)
  {
    Mesh points = TorusMesh(1.0, 0.4, nu, nv);
    for (std::size_t p = 0; p < points.PointCount(); ++p)
    {
      points.SetPoint(p, torus.Project(points.Point(p)));
    }
    return points;
  };
  show("1 to 1", grid(316, 126), torus);
  show("1 to 2", grid(447, 89), torus);
  show("1 to 4", grid(632, 63), torus);
  show("1 to 8", grid(894, 45), torus);

  PrintHead("edges from the border");
  ShowBorder();

  PrintHead("degree");
  const KnownMesh known = MakeKnown("degree", clean, blob.surface);
  for (int degree = 2; degree <= 8; ++degree)
  {
    PrintRow(std::to_string(degree), "vtkJetFitting", ByFilter(known, degree), known);
    PrintRow(std::to_string(degree), "CGAL", ByCGAL(known, degree), known);
  }
}

} // namespace

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  if (argc != 1 && !(argc == 3 && std::string(argv[1]) == "--write"))
  {
    std::fprintf(stderr, "usage: RidgesAccuracy [--write FOLDER]\n");
    return 2;
  }
  vtkObject::GlobalWarningDisplayOff();
  vtkSMPTools::Initialize(1);
  Run(argc == 3 ? argv[2] : "");
  return 0;
}
