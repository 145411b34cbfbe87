// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Compares the filters, with their default properties but for the fit, with the exact umbilics and
// ridges of an analytic surface:
//
//   RidgesTruth <surface> [--points 20000] [--patch-size 2] [--seed 0] [--noise 0]
//               [--degree 4] [--fit-points 18 | --rings 8 | --automatic] [--gaussian]
//               [--no-blend-noisy-fits]
//               [--smooth 0.01] [--exact] [--type-significance 3]
//               [--reference 150000] [--cache <directory>] [--brief]
//
// surface: ellipsoid, blend, sphere, torus, "double torus", blob, metaballs; "blob:7" is another
//   one of that kind.
// --seed: other than 0, the mesh is turned, and points and triangles are renumbered, at random.
// --noise: standard deviation of a displacement along the normals, in edges.
// --degree, --fit-points, --rings, --automatic, --gaussian, --no-blend-noisy-fits: of
//   vtkJetFitting; its defaults if not given.
// --smooth: all orders by vtkMongeSmoothing, to this share of the diameter. 0: not at all.
// --exact: the exact Monge forms instead of a fit. What is lost then, the mesh cannot show.
// --type-significance: of vtkRidgeExtraction.
// --reference: points of the mesh with exact Monge forms that the true ridges are traced on.
// --cache: where meshes and true ridges are kept for the next run.
// --brief: one line, one for the fit, and one for each failed check of vtkRidgeCoherence.
//
// Lengths of positions and distances are in edges of the mesh. A ridge is a whole one (RidgeId).

#include "ExactForms.h"
#include "FilterPicture.h"
#include "FilterTestTools.h"
#include "RidgeComparison.h"
#include "TruthCache.h"

#include "EvenMesh.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkJetFitting.h"
#include "vtkMongeSmoothing.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRidgeCoherence.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkUmbilicDetection.h"
#include "vtkVariant.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace ridges::testing;
using Eigen::Vector3d;

//------------------------------------------------------------------------------
struct Options
{
  std::string surface;
  int points = 20000;
  double patchSize = 2.0;
  std::uint64_t seed = 0;
  double noise = 0.0;
  int degree = 0;
  int fitPoints = 0;
  int rings = 0;
  bool automatic = false;
  bool blendNoisyFits = true;
  bool gaussian = false;
  bool exact = false;
  double smooth = 0.0;
  double typeSignificance = -1.0;
  int reference = 150000;
  std::string cache;
  bool brief = false;
};

//------------------------------------------------------------------------------
Options ParseOptions(int argc, char** argv)
{
  if (argc < 2)
  {
    throw std::invalid_argument("usage: RidgesTruth <surface> [options]; see RidgesTruth.cxx");
  }
  Options options;
  options.surface = argv[1];
  for (int i = 2; i < argc; ++i)
  {
    const std::string name = argv[i];
    if (name == "--brief")
    {
      options.brief = true;
      continue;
    }
    if (name == "--gaussian")
    {
      options.gaussian = true;
      continue;
    }
    if (name == "--automatic")
    {
      options.automatic = true;
      continue;
    }
    if (name == "--no-blend-noisy-fits")
    {
      options.blendNoisyFits = false;
      continue;
    }
    if (name == "--exact")
    {
      options.exact = true;
      continue;
    }
    if (++i == argc)
    {
      throw std::invalid_argument(name + " needs a value");
    }
    const std::string value = argv[i];
    if (name == "--points")
    {
      options.points = std::stoi(value);
    }
    else if (name == "--patch-size")
    {
      options.patchSize = std::stod(value);
    }
    else if (name == "--seed")
    {
      options.seed = std::stoull(value);
    }
    else if (name == "--noise")
    {
      options.noise = std::stod(value);
    }
    else if (name == "--degree")
    {
      options.degree = std::stoi(value);
    }
    else if (name == "--fit-points")
    {
      options.fitPoints = std::stoi(value);
    }
    else if (name == "--rings")
    {
      options.rings = std::stoi(value);
    }
    else if (name == "--smooth")
    {
      options.smooth = std::stod(value);
    }
    else if (name == "--type-significance")
    {
      options.typeSignificance = std::stod(value);
    }
    else if (name == "--reference")
    {
      options.reference = std::stoi(value);
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
  return options;
}

//------------------------------------------------------------------------------
Eigen::Matrix3d RandomRotation(std::uint64_t seed)
{
  if (seed == 0)
  {
    return Eigen::Matrix3d::Identity();
  }
  std::mt19937_64 generator(seed);
  Eigen::Vector4d q;
  do
  {
    for (double& coordinate : q)
    {
      coordinate = 2 * Uniform(generator) - 1;
    }
  } while (q.norm() > 1.0 || q.norm() < 0.1);
  return Eigen::Quaterniond(q).normalized().toRotationMatrix();
}

//------------------------------------------------------------------------------
// A line per failed check of vtkRidgeCoherence, or one that none failed.
void PrintFailedChecks(vtkAlgorithm* umbilics, vtkAlgorithm* ridges)
{
  vtkNew<vtkRidgeCoherence> coherence;
  coherence->SetInputConnection(0, ridges->GetOutputPort(2)); // with its zones
  coherence->SetInputConnection(1, ridges->GetOutputPort(0));
  coherence->SetInputConnection(2, umbilics->GetOutputPort(1));
  coherence->Update();
  vtkTable* table = coherence->GetOutput();
  int failed = 0;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const auto text = [&](const char* column)
    { return table->GetValueByName(row, column).ToString(); };
    if (table->GetValueByName(row, "Passed").ToInt() == 0)
    {
      ++failed;
      const double* x =
        vtkDataArray::SafeDownCast(table->GetColumnByName("OffenderPosition"))->GetTuple(row);
      std::printf("failed check: %s, expected %s, found %s; %s %s, the first at (%g, %g, %g)\n",
        text("Check").c_str(), text("Expected").c_str(), text("Found").c_str(),
        text("OffenderKind").c_str(), text("Offenders").c_str(), x[0], x[1], x[2]);
    }
  }
  if (failed == 0)
  {
    std::printf(
      "all %lld checks of coherence passed\n", static_cast<long long>(table->GetNumberOfRows()));
  }
}

//------------------------------------------------------------------------------
// The median error of P1, relative to its root mean square.
double MedianErrorOfP1(vtkPolyData* fitted, const ClosedSurface& closed)
{
  vtkDataArray* found = fitted->GetPointData()->GetArray(vtkRidgesArrayNames::P1);
  std::vector<double> errors;
  double squares = 0.0;
  for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
  {
    const double exact = closed.surface.Monge(PointAt(fitted, p)).P1;
    errors.push_back(std::abs(found->GetTuple1(p) - exact));
    squares += exact * exact;
  }
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return *middle / std::sqrt(squares / static_cast<double>(errors.size()));
}

//------------------------------------------------------------------------------
// What an automatic fit chose.
void PrintFit(vtkDataObject* mesh)
{
  if (vtkAbstractArray* fit =
        mesh->GetFieldData()->GetAbstractArray(vtkRidgesArrayNames::SelectedFit))
  {
    std::printf("fit: %s\n", fit->GetVariantValue(0).ToString().c_str());
  }
}

//------------------------------------------------------------------------------
double Seconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

//------------------------------------------------------------------------------
void SetFit(const Options& options, vtkJetFitting* jets)
{
  if (options.degree > 0)
  {
    jets->SetDegree(options.degree);
  }
  if (options.fitPoints > 0)
  {
    jets->SetNeighborhoodToPointCount();
    jets->SetMinimumNumberOfPoints(options.fitPoints);
  }
  if (options.rings > 0)
  {
    jets->SetNeighborhoodToRings();
    jets->SetNumberOfRings(options.rings);
  }
  if (options.gaussian)
  {
    jets->SetWeightingToGaussian();
  }
  if (options.automatic)
  {
    jets->SetNeighborhoodToAutomatic();
  }
  jets->SetBlendNoisyFits(options.blendNoisyFits);
}

//------------------------------------------------------------------------------
void Run(const Options& options)
{
  const ClosedSurface closed = ClosedSurfaceByName(options.surface);
  const TruthCache cache(closed, options.cache);
  const Mesh inPlace = cache.MeshWith(options.points);
  const Truth truth = cache.TruthWith(options.reference);
  const double edge = MeanEdgeLength(inPlace);

  const Eigen::Matrix3d rotation = RandomRotation(options.seed);
  Mesh mesh = inPlace;
  if (options.noise > 0.0)
  {
    mesh = AddNormalNoise(mesh, options.noise * edge, options.seed + 1);
  }
  if (options.seed != 0)
  {
    mesh = Permute(Transform(mesh, rotation, Vector3d::Zero()), options.seed);
  }

  vtkNew<vtkJetFitting> jets;
  vtkNew<vtkUmbilicDetection> umbilics;
  vtkNew<vtkRidgeExtraction> ridges;
  const vtkSmartPointer<vtkPolyData> data = ToPolyData(mesh);
  SetFit(options, jets);
  jets->SetInputData(data);
  vtkNew<vtkMongeSmoothing> smoothing;
  smoothing->SetMethodToAllOrders();
  smoothing->SetRelativeSigma(options.smooth);
  smoothing->SetInputConnection(jets->GetOutputPort());
  if (options.exact)
  {
    umbilics->SetInputData(WithExactForms(data, closed.surface, rotation));
  }
  else
  {
    umbilics->SetInputConnection(
      options.smooth > 0.0 ? smoothing->GetOutputPort() : jets->GetOutputPort());
  }
  umbilics->SetPatchSize(options.patchSize);
  ridges->SetInputConnection(umbilics->GetOutputPort());
  if (options.typeSignificance >= 0.0)
  {
    ridges->SetTypeSignificance(options.typeSignificance);
  }
  const double begin = Seconds();
  jets->Update();
  const double fitted = Seconds();
  umbilics->Update();
  const double detected = Seconds();
  ridges->Update();
  const double extracted = Seconds();

  const RidgeComparison comparison(
    truth, PictureOf(umbilics->GetOutput(1), ridges->GetOutput(), rotation), edge);
  const int euler = EulerCharacteristic(mesh);
  if (options.brief)
  {
    std::printf("%-12s %6zu seed %llu patch %g noise %g: ", options.surface.c_str(),
      mesh.PointCount(), static_cast<unsigned long long>(options.seed), options.patchSize,
      options.noise);
    comparison.PrintLine(euler);
    PrintFit(umbilics->GetOutput(0));
    PrintFailedChecks(umbilics, ridges);
    return;
  }
  std::printf("%s, %zu points, edge %.4g, patch size %g, seed %llu, noise %g edges\n",
    options.surface.c_str(), mesh.PointCount(), edge, options.patchSize,
    static_cast<unsigned long long>(options.seed), options.noise);
  std::printf("seconds: fit %.2f, umbilics %.2f, ridges %.2f\n", fitted - begin, detected - fitted,
    extracted - detected);
  comparison.PrintTables(euler);
  PrintFit(umbilics->GetOutput(0));
  if (options.seed == 0 && options.noise == 0.0)
  {
    std::printf("median error of P1: %.2g of its root mean square; %lld lines of one type\n",
      MedianErrorOfP1(jets->GetOutput(), closed),
      static_cast<long long>(ridges->GetOutput()->GetNumberOfLines()));
  }
  PrintFailedChecks(umbilics, ridges);
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
    std::fprintf(stderr, "RidgesTruth: %s\n", error.what());
    return 1;
  }
}
