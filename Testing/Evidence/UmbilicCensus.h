// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// All umbilics of a random surface, and what the filters report of each of them.

#ifndef RIDGES_TESTING_UMBILIC_CENSUS_H
#define RIDGES_TESTING_UMBILIC_CENSUS_H

#include "ExactUmbilics.h"
#include "WaveSurface.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ridges
{
namespace testing
{

// The correlation length is 1.
struct CensusCase
{
  double size = 100.0;     // of the square
  double spacing = 0.125;  // of the points along an axis
  double jitter = 0.2;     // of the spacing: points are moved by at most so much at random
  double amplitude = 0.01; // root mean square height
  double strip = 1.0;      // along the border: umbilics in it are left out
  int numberOfWaves = 600;
  std::uint64_t seed = 1;
};

struct Estimate
{
  double value = 0.0;
  double error = 0.0; // standard
};

// Numbers in squares, of which umbilics in one may depend on each other, but hardly on those in
// others: from these comes the standard error of the ratio of their sums, a share or a density.
struct SquareCounts
{
  std::vector<double> counts;
  std::vector<double> weights;
  Estimate Ratio() const;
};

// What umbilics have to be counted for.
enum class Trait
{
  All,
  Star,
  Lemon,
  Monstar,
  ThreeRidges,
  ThreeRidgesOfIndexPlus // impossible
};
// Shares of All in isotropic Gaussian waves; for All itself the number in a unit of area.
double TheoryOf(Trait trait);
bool Has(const ExactUmbilic& umbilic, Trait trait);

struct CensusScore
{
  std::size_t umbilics = 0; // true ones, without those in the strip
  std::size_t found = 0;    // of these, within four spacings
  std::size_t rightIndex = 0;
  std::size_t rightPattern = 0;
  std::size_t rightRidgeCount = 0;
  std::size_t spurious = 0;   // found outside the strip where there is none
  std::vector<double> errors; // of the positions, in spacings
  // Among those with the wrong pattern or ridge count that have no other within three spacings: how
  // far the form is at most from that of a right answer.
  double largestMargin = 0.0;
  // The greatest distance from a missing one to the next umbilic, in spacings.
  double widestMissing = 0.0;

  void Add(const CensusScore& other);
  // The error that this share of them does not exceed.
  double ErrorAt(double share) const;
};

class UmbilicCensus
{
public:
  explicit UmbilicCensus(const CensusCase& settings);

  const std::vector<ExactUmbilic>& Umbilics() const { return this->Umbilics_; }
  std::size_t NumberOfPoints() const;
  double ExpectedDensity() const { return this->Surface.ExpectedDensity(); }
  void Count(Trait trait, SquareCounts& total) const;

  // The mesh, and the mesh with the exact Monge arrays that vtkUmbilicDetection needs.
  vtkSmartPointer<vtkPolyData> Mesh() const { return this->Mesh_; }
  vtkSmartPointer<vtkPolyData> MeshWithExactForms() const;

  // Compares one by one with port 1 of vtkUmbilicDetection; the nearest pairs belong together.
  CensusScore Compare(vtkPolyData* found) const;

private:
  bool IsInside(const Eigen::Vector3d& position) const;

  CensusCase Settings;
  WaveSurface Surface;
  std::vector<ExactUmbilic> Umbilics_;
  vtkSmartPointer<vtkPolyData> Mesh_;
};

} // namespace testing
} // namespace ridges

#endif
