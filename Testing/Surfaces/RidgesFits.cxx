// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The error of the automatic fit beside those of all fixed degrees and numbers of rings:
//
//   RidgesFits [--points 10000] [--seeds 3] [--noise 0,float,0.001,0.01] [--surface blob]...
//              [--cache <directory>]
//
// For each surface and noise a line with, of b (third order) and of k (second order): the error of
// the automatic fit over that of the best fixed one, and which that is; the worst of the seeds. An
// error is the norm of the difference of the tensors, in the mean over the points. Noise is along
// the normals, in edges; "float" are points rounded to single precision. Fixed fits are of degree
// 4, 6 and 8 on 2 rings and more, until errors grow.

#include "FilterTestTools.h"
#include "TruthCache.h"

#include "Base/SymmetricTensor.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRidgesArrayNames.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;
using Eigen::Vector2d;

//------------------------------------------------------------------------------
struct Options
{
  int points = 10000;
  int seeds = 3;
  std::vector<std::string> noise{ "0", "float", "0.001", "0.01" };
  std::vector<std::string> surfaces;
  std::string cache;
};

//------------------------------------------------------------------------------
Options ParseOptions(int argc, char** argv)
{
  Options options;
  for (int i = 1; i + 1 < argc; i += 2)
  {
    const std::string name = argv[i];
    const std::string value = argv[i + 1];
    if (name == "--points")
    {
      options.points = std::stoi(value);
    }
    else if (name == "--seeds")
    {
      options.seeds = std::stoi(value);
    }
    else if (name == "--noise")
    {
      options.noise.clear();
      std::stringstream list(value);
      for (std::string item; std::getline(list, item, ',');)
      {
        options.noise.push_back(item);
      }
    }
    else if (name == "--surface")
    {
      options.surfaces.push_back(value);
    }
    else if (name == "--cache")
    {
      options.cache = value;
    }
    else
    {
      throw std::invalid_argument("unknown option " + name);
    }
  }
  if (options.surfaces.empty())
  {
    options.surfaces = { "sphere", "torus", "double torus", "blob", "metaballs" };
  }
  return options;
}

// Mean errors of the second and the third order.
using Errors = std::array<double, 2>;

//------------------------------------------------------------------------------
Errors ErrorsOf(vtkPolyData* fitted, const std::vector<ExactMonge>& exact)
{
  vtkPointData* data = fitted->GetPointData();
  Errors sums{};
  for (std::size_t p = 0; p < exact.size(); ++p)
  {
    const ExactMonge& form = exact[p];
    const auto id = static_cast<vtkIdType>(p);
    Eigen::Vector3d d1;
    data->GetArray(names::MaximumDirection)->GetTuple(id, d1.data());
    Vector2d e(d1.dot(form.d1), d1.dot(form.d2));
    e /= e.norm() > 0.0 ? e.norm() : 1.0;
    // The axes of the exact form, in the frame that was found.
    const Vector2d first(e[0], -e[1]);
    const Vector2d second(e[1], e[0]);
    std::array<double, 4> b{};
    data->GetArray(names::ThirdOrder)->GetTuple(id, b.data());
    const auto third = ridges::InBasis(b, first, second);
    const auto curvature =
      ridges::InBasis(std::array<double, 3>{ Value(data, names::MaximumCurvature, id), 0.0,
                        Value(data, names::MinimumCurvature, id) },
        first, second);
    const double times[] = { 1.0, 3.0, 3.0, 1.0 };
    double square = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      square += times[i] * (third[i] - form.b[i]) * (third[i] - form.b[i]);
    }
    sums[1] += std::sqrt(square);
    sums[0] += std::sqrt((curvature[0] - form.k1) * (curvature[0] - form.k1) +
      2.0 * curvature[1] * curvature[1] + (curvature[2] - form.k2) * (curvature[2] - form.k2));
  }
  const auto count = static_cast<double>(exact.size());
  return { sums[0] / count, sums[1] / count };
}

//------------------------------------------------------------------------------
struct Fixed
{
  double error = std::numeric_limits<double>::infinity();
  int degree = 0;
  int rings = 0;
};

//------------------------------------------------------------------------------
std::array<Fixed, 2> BestFixed(vtkPolyData* mesh, const std::vector<ExactMonge>& exact)
{
  std::array<Fixed, 2> best;
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(mesh);
  jets->SetNeighborhoodToRings();
  for (const int degree : { 4, 6, 8 })
  {
    std::array<double, 2> least{ 1e300, 1e300 };
    for (const int rings : { 2, 3, 4, 5, 6, 7, 8, 10, 12, 15, 19, 24 })
    {
      jets->SetDegree(degree);
      jets->SetNumberOfRings(rings);
      jets->Update();
      const Errors errors = ErrorsOf(jets->GetOutput(), exact);
      bool grow = true;
      for (int i = 0; i < 2; ++i)
      {
        if (errors[i] < best[i].error)
        {
          best[i] = { errors[i], degree, rings };
        }
        least[i] = std::min(least[i], errors[i]);
        grow = grow && errors[i] > 2.0 * least[i];
      }
      if (grow)
      {
        break;
      }
    }
  }
  return best;
}

//------------------------------------------------------------------------------
Mesh WithNoise(const Mesh& mesh, const std::string& noise, int seed)
{
  if (noise == "float")
  {
    Mesh rounded = mesh;
    for (double& x : rounded.points)
    {
      x = static_cast<double>(static_cast<float>(x));
    }
    return rounded;
  }
  const double share = std::stod(noise);
  return share > 0.0
    ? AddNormalNoise(mesh, share * MeanEdgeLength(mesh), static_cast<std::uint64_t>(seed))
    : mesh;
}

//------------------------------------------------------------------------------
void Run(const Options& options)
{
  std::printf("%-13s %-6s %-6s %s\n", "surface", "noise", "error", "automatic / best fixed");
  std::array<double, 2> worst{};
  for (const std::string& name : options.surfaces)
  {
    const ClosedSurface closed = ClosedSurfaceByName(name);
    const Mesh clean = TruthCache(closed, options.cache).MeshWith(options.points);
    std::vector<ExactMonge> exact;
    for (std::size_t p = 0; p < clean.PointCount(); ++p)
    {
      exact.push_back(closed.surface.Monge(clean.Point(p)));
    }
    for (const std::string& noise : options.noise)
    {
      const bool isRandom = noise != "float" && std::stod(noise) > 0.0;
      std::array<double, 2> ratio{};
      std::array<Fixed, 2> fixed;
      std::array<std::string, 2> chosen;
      for (int seed = 1; seed <= (isRandom ? options.seeds : 1); ++seed)
      {
        const auto mesh = ToPolyData(WithNoise(clean, noise, seed));
        const std::array<Fixed, 2> best = BestFixed(mesh, exact);
        for (const int order : { 0, 1 })
        {
          vtkNew<vtkJetFitting> jets;
          jets->SetInputData(mesh);
          jets->SetMongeOrder(order == 0 ? 2 : 4);
          // Needs all orders of the output, which MongeOrder 2 leaves out.
          jets->Update();
          vtkNew<vtkPolyData> fitted;
          fitted->ShallowCopy(jets->GetOutput());
          if (order == 0)
          {
            vtkNew<vtkDoubleArray> none;
            none->SetName(names::ThirdOrder);
            none->SetNumberOfComponents(4);
            none->SetNumberOfTuples(fitted->GetNumberOfPoints());
            none->Fill(0.0);
            fitted->GetPointData()->AddArray(none);
          }
          const double error = ErrorsOf(fitted, exact)[order];
          if (error > ratio[order] * best[order].error)
          {
            ratio[order] = error / best[order].error;
            fixed[order] = best[order];
            auto* text = vtkStringArray::SafeDownCast(
              fitted->GetFieldData()->GetAbstractArray(names::SelectedFit));
            chosen[order] = text ? std::string(text->GetValue(0)) : "";
          }
        }
      }
      for (const int order : { 1, 0 })
      {
        std::printf("%-13s %-6s %-6s %.2f; best: degree %d on %d rings; chosen: %s\n", name.c_str(),
          noise.c_str(), order == 1 ? "b" : "k", ratio[order], fixed[order].degree,
          fixed[order].rings, chosen[order].c_str());
        worst[order] = std::max(worst[order], ratio[order]);
      }
      std::fflush(stdout);
    }
  }
  std::printf("worst: b %.2f, k %.2f\n", worst[1], worst[0]);
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Run(ParseOptions(argc, argv));
    return 0;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "RidgesFits: %s\n", error.what());
    return 1;
  }
}
