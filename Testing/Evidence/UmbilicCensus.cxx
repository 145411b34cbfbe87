// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "UmbilicCensus.h"

#include "FilterTestTools.h"
#include "ParallelFor.h"
#include "TestMeshes.h"

#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace ridges
{
namespace testing
{

namespace names = vtkRidgesArrayNames;
using Eigen::Vector3d;

namespace
{

const double Pi = 3.14159265358979323846;

//------------------------------------------------------------------------------
int PatternOf(UmbilicKind kind)
{
  return kind == UmbilicKind::Lemon ? 1 : kind == UmbilicKind::Monstar ? 2 : 3;
}

//------------------------------------------------------------------------------
double DistanceToNext(const std::vector<ExactUmbilic>& umbilics, std::size_t i)
{
  double closest = std::numeric_limits<double>::max();
  for (std::size_t j = 0; j < umbilics.size(); ++j)
  {
    const double distance = (umbilics[i].position - umbilics[j].position).norm();
    closest = j == i ? closest : std::min(closest, distance);
  }
  return closest;
}

//------------------------------------------------------------------------------
// The partner of each true umbilic, or -1: the nearest pairs first, up to a distance.
std::vector<vtkIdType> Pair(
  const std::vector<ExactUmbilic>& umbilics, vtkPolyData* found, double reach)
{
  std::vector<std::tuple<double, std::size_t, vtkIdType>> pairs;
  for (std::size_t i = 0; i < umbilics.size(); ++i)
  {
    for (vtkIdType j = 0; j < found->GetNumberOfPoints(); ++j)
    {
      const double distance = (umbilics[i].position - PointAt(found, j)).norm();
      if (distance < reach)
      {
        pairs.emplace_back(distance, i, j);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<vtkIdType> partners(umbilics.size(), -1);
  std::vector<bool> taken(found->GetNumberOfPoints(), false);
  for (const auto& [distance, i, j] : pairs)
  {
    if (partners[i] < 0 && !taken[j])
    {
      partners[i] = j;
      taken[j] = true;
    }
  }
  return partners;
}

} // namespace

//------------------------------------------------------------------------------
double TheoryOf(Trait trait)
{
  switch (trait)
  {
    case Trait::All:
      return 3.0 / (2.0 * Pi);
    case Trait::Star:
      return 0.5;
    case Trait::Lemon:
      return 1.0 / std::sqrt(5.0);
    case Trait::Monstar:
      return 0.5 - 1.0 / std::sqrt(5.0);
    case Trait::ThreeRidges:
      return 2.0 - std::sqrt(3.0);
    default:
      return 0.0;
  }
}

//------------------------------------------------------------------------------
bool Has(const ExactUmbilic& umbilic, Trait trait)
{
  switch (trait)
  {
    case Trait::All:
      return true;
    case Trait::Star:
      return umbilic.kind == UmbilicKind::Star;
    case Trait::Lemon:
      return umbilic.kind == UmbilicKind::Lemon;
    case Trait::Monstar:
      return umbilic.kind == UmbilicKind::Monstar;
    case Trait::ThreeRidges:
      return umbilic.ridgeCount == 3;
    default:
      return umbilic.ridgeCount == 3 && umbilic.index > 0.0;
  }
}

//------------------------------------------------------------------------------
Estimate SquareCounts::Ratio() const
{
  const double count = std::accumulate(this->counts.begin(), this->counts.end(), 0.0);
  const double weight = std::accumulate(this->weights.begin(), this->weights.end(), 0.0);
  double squaredError = 0.0;
  for (std::size_t i = 0; i < this->counts.size(); ++i)
  {
    squaredError += std::pow(this->counts[i] - count / weight * this->weights[i], 2);
  }
  const auto n = static_cast<double>(this->counts.size());
  return { count / weight, std::sqrt(squaredError * n / (n - 1)) / weight };
}

//------------------------------------------------------------------------------
void CensusScore::Add(const CensusScore& other)
{
  this->umbilics += other.umbilics;
  this->found += other.found;
  this->rightIndex += other.rightIndex;
  this->rightPattern += other.rightPattern;
  this->rightRidgeCount += other.rightRidgeCount;
  this->spurious += other.spurious;
  this->errors.insert(this->errors.end(), other.errors.begin(), other.errors.end());
  this->largestMargin = std::max(this->largestMargin, other.largestMargin);
  this->widestMissing = std::max(this->widestMissing, other.widestMissing);
}

//------------------------------------------------------------------------------
double CensusScore::ErrorAt(double share) const
{
  std::vector<double> sorted = this->errors;
  std::sort(sorted.begin(), sorted.end());
  return sorted.empty()
    ? 0.0
    : sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

//------------------------------------------------------------------------------
UmbilicCensus::UmbilicCensus(const CensusCase& settings)
  : Settings(settings)
  , Surface(settings.numberOfWaves, settings.amplitude, settings.seed)
  , Umbilics_(FindUmbilics(this->Surface, 0.5 * settings.size, settings.spacing))
{
  const int cells = static_cast<int>(std::round(settings.size / settings.spacing));
  ridges::testing::Mesh mesh = GraphPatch(
    [](double, double) { return 0.0; }, 0.5 * settings.size, cells, settings.jitter, settings.seed);
  ParallelFor(mesh.PointCount(),
    [&](std::size_t p)
    { mesh.points[3 * p + 2] = this->Surface.Height(mesh.points[3 * p], mesh.points[3 * p + 1]); });
  this->Mesh_ = ToPolyData(mesh);
}

//------------------------------------------------------------------------------
std::size_t UmbilicCensus::NumberOfPoints() const
{
  return static_cast<std::size_t>(this->Mesh_->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
bool UmbilicCensus::IsInside(const Vector3d& position) const
{
  return std::max(std::abs(position.x()), std::abs(position.y())) <=
    0.5 * this->Settings.size - this->Settings.strip;
}

//------------------------------------------------------------------------------
void UmbilicCensus::Count(Trait trait, SquareCounts& total) const
{
  constexpr int squares = 10; // along an axis
  const double side = this->Settings.size / squares;
  SquareCounts own;
  own.counts.resize(squares * squares);
  own.weights.assign(squares * squares, trait == Trait::All ? side * side : 0.0);
  for (const ExactUmbilic& umbilic : this->Umbilics_)
  {
    const auto squareOf = [&](double x) {
      return std::clamp(static_cast<int>((x + 0.5 * this->Settings.size) / side), 0, squares - 1);
    };
    const int square = squares * squareOf(umbilic.position.x()) + squareOf(umbilic.position.y());
    own.counts[square] += Has(umbilic, trait) ? 1.0 : 0.0;
    own.weights[square] += trait == Trait::All ? 0.0 : 1.0;
  }
  total.counts.insert(total.counts.end(), own.counts.begin(), own.counts.end());
  total.weights.insert(total.weights.end(), own.weights.begin(), own.weights.end());
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> UmbilicCensus::MeshWithExactForms() const
{
  auto exact = vtkSmartPointer<vtkPolyData>::New();
  exact->ShallowCopy(this->Mesh_);
  std::vector<MongeForm> forms(this->NumberOfPoints());
  ParallelFor(forms.size(),
    [&](std::size_t p)
    {
      const Vector3d at = PointAt(exact, static_cast<vtkIdType>(p));
      forms[p] = MongeFormOfHeightJet(
        this->Surface.Derivatives(at.x(), at.y(), 4), Eigen::Matrix3d::Identity());
    });
  const auto add = [&](const char* name, int components, auto valuesOf)
  {
    AddPointArray(exact, name, components,
      [&](vtkIdType p, double* values)
      { std::copy_n(valuesOf(forms[static_cast<std::size_t>(p)]), components, values); });
  };
  add(names::MaximumCurvature, 1, [](const MongeForm& form) { return &form.k1; });
  add(names::MinimumCurvature, 1, [](const MongeForm& form) { return &form.k2; });
  add(names::MaximumDirection, 3, [](const MongeForm& form) { return form.d1.data(); });
  add(names::MinimumDirection, 3, [](const MongeForm& form) { return form.d2.data(); });
  add(names::ThirdOrder, 4, [](const MongeForm& form) { return form.b.data(); });
  return exact;
}

//------------------------------------------------------------------------------
CensusScore UmbilicCensus::Compare(vtkPolyData* found) const
{
  const double spacing = this->Settings.spacing;
  const std::vector<vtkIdType> partners = Pair(this->Umbilics_, found, 4.0 * spacing);
  std::vector<bool> hasPartner(found->GetNumberOfPoints(), false);
  CensusScore score;
  vtkPointData* values = found->GetPointData();
  for (std::size_t i = 0; i < partners.size(); ++i)
  {
    const ExactUmbilic& umbilic = this->Umbilics_[i];
    const vtkIdType partner = partners[i];
    if (partner >= 0)
    {
      hasPartner[partner] = true;
    }
    if (!this->IsInside(umbilic.position))
    {
      continue;
    }
    ++score.umbilics;
    if (partner < 0)
    {
      score.widestMissing =
        std::max(score.widestMissing, DistanceToNext(this->Umbilics_, i) / spacing);
      continue;
    }
    ++score.found;
    score.errors.push_back((umbilic.position - PointAt(found, partner)).norm() / spacing);
    const bool index = Value(values, names::Index, partner) == umbilic.index;
    const bool pattern = Value(values, names::Pattern, partner) == PatternOf(umbilic.kind);
    const bool ridges = Value(values, names::RidgeCount, partner) == umbilic.ridgeCount;
    score.rightIndex += index ? 1 : 0;
    score.rightPattern += pattern ? 1 : 0;
    score.rightRidgeCount += ridges ? 1 : 0;
    if ((!pattern || !ridges) && DistanceToNext(this->Umbilics_, i) > 3.0 * spacing)
    {
      score.largestMargin =
        std::max({ score.largestMargin, ridges ? 0.0 : std::abs(umbilic.ridgeMargin),
          pattern ? 0.0 : std::abs(umbilic.lineMargin) });
    }
  }
  for (vtkIdType j = 0; j < found->GetNumberOfPoints(); ++j)
  {
    score.spurious += !hasPartner[j] && this->IsInside(PointAt(found, j)) ? 1 : 0;
  }
  return score;
}

} // namespace testing
} // namespace ridges
