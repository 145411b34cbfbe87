// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Thousands of umbilics, each of them known:
//
//   RidgesCensus [--surfaces 4] [--size 100] [--spacing 0.125] [--waves 600] [--seed 1] [--noise 0]
//
// Random Gaussian surfaces with correlation length 1 over a square. Prints the shares of umbilics
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
#include <iterator>
#include <string>

using namespace ridges::testing;

namespace
{

struct Usage
{
  CensusCase settings;
  int surfaces = 4;
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
    if (name == "--surfaces")
    {
      usage.surfaces = static_cast<int>(value);
    }
    else if (name == "--size")
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

const struct
{
  const char* name;
  Trait trait;
} Rows[] = { { "umbilics in a unit of area", Trait::All }, { "stars", Trait::Star },
  { "lemons", Trait::Lemon }, { "monstars", Trait::Monstar },
  { "three ridges", Trait::ThreeRidges },
  { "three ridges, index +1/2", Trait::ThreeRidgesOfIndexPlus } };

struct Totals
{
  SquareCounts shares[std::size(Rows)];
  double density = 0.0; // that is expected
  CensusScore ofExactForms;
  CensusScore ofFits;
};

//------------------------------------------------------------------------------
void Measure(const Usage& usage, const UmbilicCensus& census, Totals& totals)
{
  for (std::size_t i = 0; i < std::size(Rows); ++i)
  {
    census.Count(Rows[i].trait, totals.shares[i]);
  }
  totals.density += census.ExpectedDensity() / usage.surfaces;
  vtkNew<vtkUmbilicDetection> detection;
  if (usage.noise == 0.0)
  {
    detection->SetInputData(census.MeshWithExactForms());
    detection->Update();
    totals.ofExactForms.Add(census.Compare(detection->GetOutput(1)));
  }
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(usage.noise == 0.0
      ? census.Mesh()
      : ToPolyData(AddNormalNoise(ToMesh(census.Mesh()), usage.noise * usage.settings.spacing, 1)));
  detection->SetInputConnection(jets->GetOutputPort());
  detection->Update();
  totals.ofFits.Add(census.Compare(detection->GetOutput(1)));
}

//------------------------------------------------------------------------------
void PrintShares(const Totals& totals)
{
  std::printf("| share                      | theory | found  | standard error |\n");
  std::printf("|----------------------------|--------|--------|----------------|\n");
  for (std::size_t i = 0; i < std::size(Rows); ++i)
  {
    const Estimate estimate = totals.shares[i].Ratio();
    const double theory = Rows[i].trait == Trait::All ? totals.density : TheoryOf(Rows[i].trait);
    std::printf(
      "| %-26s | %.4f | %.4f | %-14.4f |\n", Rows[i].name, theory, estimate.value, estimate.error);
  }
}

//------------------------------------------------------------------------------
void PrintScores(const CensusScore& exact, const CensusScore& fits)
{
  const auto print = [&](const char* name, auto textOf)
  {
    std::printf("| %-40s | %-16s | %-16s |\n", name,
      exact.umbilics > 0 ? textOf(exact).c_str() : "", textOf(fits).c_str());
  };
  const auto text = [](const char* format, auto... values)
  {
    char buffer[100];
    std::snprintf(buffer, sizeof buffer, format, values...);
    return std::string(buffer);
  };
  const auto share = [&](std::size_t count, std::size_t of)
  {
    return text(
      "%zu (%.2f %%)", count, 100.0 * static_cast<double>(count) / static_cast<double>(of));
  };
  std::printf("| %-40s | %-16s | %-16s |\n", "", "exact forms", "fits");
  std::printf("|%s|%s|%s|\n", std::string(42, '-').c_str(), std::string(18, '-').c_str(),
    std::string(18, '-').c_str());
  using Score = const CensusScore&;
  print("umbilics off the border", [&](Score s) { return text("%zu", s.umbilics); });
  print("found", [&](Score s) { return share(s.found, s.umbilics); });
  print("of these with the right index", [&](Score s) { return share(s.rightIndex, s.found); });
  print("with the right pattern", [&](Score s) { return share(s.rightPattern, s.found); });
  print(
    "with the right number of ridges", [&](Score s) { return share(s.rightRidgeCount, s.found); });
  print("found where there is none", [&](Score s) { return text("%zu", s.spurious); });
  print(
    "position error, median, in spacings", [&](Score s) { return text("%.3f", s.ErrorAt(0.5)); });
  print("99 %", [&](Score s) { return text("%.3f", s.ErrorAt(0.99)); });
  print("largest", [&](Score s) { return text("%.3f", s.ErrorAt(1.0)); });
  print(
    "farthest other from a missing one", [&](Score s) { return text("%.2f", s.widestMissing); });
  print("largest margin of a wrong answer", [&](Score s) { return text("%.4f", s.largestMargin); });
}

} // namespace

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  Usage usage;
  if (!Parse(argc, argv, usage))
  {
    std::fprintf(stderr,
      "usage: RidgesCensus [--surfaces 4] [--size 100] [--spacing 0.125] [--waves 600] [--seed 1] "
      "[--noise 0]\n");
    return 2;
  }
  Totals totals;
  std::size_t points = 0;
  std::size_t umbilics = 0;
  for (int i = 0; i < usage.surfaces; ++i)
  {
    CensusCase settings = usage.settings;
    settings.seed += static_cast<std::uint64_t>(i);
    const UmbilicCensus census(settings);
    points += census.NumberOfPoints();
    umbilics += census.Umbilics().size();
    Measure(usage, census, totals);
  }
  std::printf("%zu points on %d surfaces, %zu umbilics.\n\n", points, usage.surfaces, umbilics);
  PrintShares(totals);
  std::printf("\n");
  PrintScores(totals.ofExactForms, totals.ofFits);
  return 0;
}
