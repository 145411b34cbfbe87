// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Thousands of umbilics, each of them known:
//
//   RidgesCensus [--size 100] [--spacing 0.125] [--waves 600] [--seed 1] [--noise 0]
//
// A random Gaussian surface with correlation length 1 over a square. Prints the shares of umbilics
// of each kind beside those of the theory, and how many of them vtkUmbilicDetection reports as they
// are, with exact Monge forms and with those that vtkJetFitting fits. Noise is normal, by its
// standard deviation along z in spacings.

#include "FilterTestTools.h"
#include "TestMeshes.h"
#include "UmbilicCensus.h"

#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkUmbilicDetection.h"

#include <cstdio>
#include <cstdlib>
#include <string>

using namespace ridges::testing;

namespace
{

struct Usage
{
  CensusCase settings;
  double noise = 0.0;
};

//------------------------------------------------------------------------------
bool Parse(int argc, char* argv[], Usage& usage)
{
  for (int i = 1; i < argc; i += 2)
  {
    if (i + 1 == argc)
    {
      return false;
    }
    const std::string name = argv[i];
    const double value = std::strtod(argv[i + 1], nullptr);
    if (name == "--size")
    {
      usage.settings.size = value;
    }
    else if (name == "--spacing")
    {
      usage.settings.spacing = value;
    }
    else if (name == "--waves")
    {
      usage.settings.numberOfWaves = static_cast<int>(value);
    }
    else if (name == "--seed")
    {
      usage.settings.seed = static_cast<std::uint64_t>(value);
    }
    else if (name == "--noise")
    {
      usage.noise = value;
    }
    else
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void PrintShares(const UmbilicCensus& census)
{
  const struct
  {
    const char* name;
    Trait trait;
  } rows[] = { { "umbilics in a unit of area", Trait::All }, { "stars", Trait::Star },
    { "lemons", Trait::Lemon }, { "monstars", Trait::Monstar },
    { "three ridges", Trait::ThreeRidges },
    { "three ridges, index +1/2", Trait::ThreeRidgesOfIndexPlus } };
  std::printf("| share                      | theory | found  | standard error |\n");
  std::printf("|----------------------------|--------|--------|----------------|\n");
  for (const auto& row : rows)
  {
    const Estimate estimate = census.Measure(row.trait);
    const double theory =
      row.trait == Trait::All ? census.ExpectedDensity() : TheoryOf(row.trait);
    std::printf("| %-26s | %.4f | %.4f | %-14.4f |\n", row.name, theory, estimate.value,
      estimate.error);
  }
}

//------------------------------------------------------------------------------
void PrintScore(const char* forms, vtkPolyData* found, const UmbilicCensus& census)
{
  const CensusScore score = census.Compare(found);
  const auto share = [](std::size_t count, std::size_t of) {
    return of == 0 ? 0.0 : 100.0 * static_cast<double>(count) / static_cast<double>(of);
  };
  std::printf("| %-5s | %zu / %zu | %zu | %zu (%.2f %%) | %zu (%.2f %%) | %zu (%.2f %%) | "
              "%.4f / %.3f / %.2f | %.1e | %.2f |\n",
    forms, score.found, score.umbilics, score.spurious, score.rightIndex,
    share(score.rightIndex, score.found), score.rightPattern,
    share(score.rightPattern, score.found), score.rightRidgeCount,
    share(score.rightRidgeCount, score.found), score.medianError, score.percentile99,
    score.largestError, score.largestMargin, score.widestMissing);
  std::fflush(stdout);
}

} // namespace

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  Usage usage;
  if (!Parse(argc, argv, usage))
  {
    std::fprintf(stderr,
      "usage: RidgesCensus [--size 100] [--spacing 0.125] [--waves 600] [--seed 1] [--noise 0]\n");
    return 2;
  }
  const UmbilicCensus census(usage.settings);
  std::printf("%zu points, %zu umbilics\n\n", census.NumberOfPoints(), census.Umbilics().size());
  PrintShares(census);
  std::printf("\n| forms | found | spurious | index | pattern | ridge count | position error, median "
              "/ 99 %% / largest | margin | missing |\n|---|---|---|---|---|---|---|---|---|\n");

  vtkNew<vtkUmbilicDetection> detection;
  if (usage.noise == 0.0)
  {
    detection->SetInputData(census.MeshWithExactForms());
    detection->Update();
    PrintScore("exact", detection->GetOutput(1), census);
  }
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(usage.noise == 0.0 ? census.Mesh()
                                        : ToPolyData(AddNormalNoise(ToMesh(census.Mesh()),
                                            usage.noise * usage.settings.spacing, 1)));
  detection->SetInputConnection(jets->GetOutputPort());
  detection->Update();
  PrintScore("fits", detection->GetOutput(1), census);
  return 0;
}
