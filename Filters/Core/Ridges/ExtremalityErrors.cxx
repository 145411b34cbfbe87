// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/ExtremalityErrors.h"

#include "Monge/CurvatureSlope.h"

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

/// The error of points that do not count.
constexpr double NotKnown = -1.0;

/// Of a fit to two rings, where it is not known.
constexpr double UsualGain = 60.0;

/// As a part of 1 / radius^2: where curvatures vanish, the fit leaves 1e-12 to 1e-10 of it.
constexpr double FitRounding = 3e-10;

/// Of the difference to the derivative: where nothing else is wrong, two and a half of it are as
/// rare as three standard errors of noise.
constexpr double ShareOfDifference = 2.5 / 3.0;

} // namespace

ExtremalityErrors::ExtremalityErrors(const Source& source, Color color, double significance)
  : Source_(source)
  , Color_(color)
  , Significance_(significance)
  , Rounding_(FindCoordinateRounding(source.mesh))
{
}

void ExtremalityErrors::Begin()
{
  this->Own_.resize(this->Source_.mesh.NumberOfPoints());
  this->Rings_.resize(this->Own_.size());
  this->Verdicts_.assign(this->Own_.size(), Verdict::Unknown);
}

void ExtremalityErrors::Measure(Id begin, Id end)
{
  for (Id p = begin; p < end; ++p)
  {
    this->Own_[p] = this->At(p);
  }
}

void ExtremalityErrors::Sum(Id begin, Id end)
{
  for (Id p = begin; p < end; ++p)
  {
    this->Rings_[p] = this->OverRing(p, [this](Id q) { return this->Own_[q]; });
  }
}

void ExtremalityErrors::Judge(Id begin, Id end)
{
  for (Id p = begin; p < end; ++p)
  {
    Verdict& verdict = this->Verdicts_[p];
    if (this->IsRoundOff(p))
    {
      verdict = Verdict::RoundOff;
    }
    else if (this->Own_[p].squaredError == NotKnown)
    {
      verdict = this->IsBad(p) ? Verdict::Unresolved : Verdict::Unknown;
    }
    else if (this->IsUnresolved(p))
    {
      verdict = Verdict::Unresolved;
    }
    else
    {
      const Sums sums = this->OverRing(p, [this](Id q) { return this->Rings_[q]; });
      verdict = this->Compare(sums);
    }
  }
}

ExtremalityErrors::Verdict ExtremalityErrors::VerdictAt(Id p)
{
  if (const Verdict* known = this->Told_.Find(p))
  {
    return *known;
  }
  const Verdict verdict = this->FindVerdict(p);
  this->Told_[p] = verdict;
  return verdict;
}

ExtremalityErrors::Verdict ExtremalityErrors::FindVerdict(Id p)
{
  this->Source_.mesh.LookAt(p, 3);
  const auto own = [this](Id q)
  {
    if (const Sums* known = this->Asked_.Find(q))
    {
      return *known;
    }
    return this->Asked_[q] = this->At(q);
  };
  if (this->IsRoundOff(p))
  {
    return Verdict::RoundOff;
  }
  if (own(p).squaredError == NotKnown)
  {
    return this->IsBad(p) ? Verdict::Unresolved : Verdict::Unknown;
  }
  if (this->IsUnresolved(p))
  {
    return Verdict::Unresolved;
  }
  const Sums sums = this->OverRing(p, [this, &own](Id q) { return this->OverRing(q, own); });
  return this->Compare(sums);
}

double ExtremalityErrors::MeanSquareInErrors(const std::vector<Id>& points) const
{
  double square = 0.0;
  double squaredError = 0.0;
  for (const Id p : points)
  {
    if (this->Own_[p].squaredError >= 0.0)
    {
      square += this->Own_[p].square;
      squaredError += this->Own_[p].squaredError;
    }
  }
  return squaredError > 0.0 ? square / squaredError : 0.0;
}

bool ExtremalityErrors::IsBad(Id p) const
{
  const std::vector<std::uint8_t>& isFlagged = this->Source_.isFlagged;
  return !isFlagged.empty() && isFlagged[p] == FlaggedAsWrong;
}

ExtremalityErrors::Verdict ExtremalityErrors::Compare(const Sums& sums) const
{
  constexpr double noiseByChance = 2.0;
  const double factor = this->Significance_ * this->Significance_;
  if (!(sums.square > factor * sums.squaredError))
  {
    return Verdict::Insignificant;
  }
  return sums.square > noiseByChance * noiseByChance * factor * sums.squaredNoise
    ? Verdict::Significant
    : Verdict::Faint;
}

/// Each neighbour once, inside of the surface, where two triangles have it.
template <typename AtPoint>
ExtremalityErrors::Sums ExtremalityErrors::OverRing(Id p, const AtPoint& atPoint) const
{
  Sums sums;
  const auto add = [&sums](const Sums& more, double weight)
  {
    if (more.squaredError >= 0.0)
    {
      sums.square += weight * more.square;
      sums.squaredError += weight * more.squaredError;
      sums.squaredNoise += weight * more.squaredNoise;
    }
  };
  add(atPoint(p), 1.0);
  for (const Id t : this->Source_.mesh.TrianglesAround(p))
  {
    for (const Id q : this->Source_.mesh.Corners(t))
    {
      if (q != p)
      {
        add(atPoint(q), 0.5);
      }
    }
  }
  return sums;
}

/// Points next to flagged ones do not count: their derivatives depend on these.
ExtremalityErrors::Sums ExtremalityErrors::At(Id p) const
{
  const double radius = this->RadiusAt(p);
  const Surroundings around = this->LookAround(p);
  if (!(radius > 0.0) || around.isFlagged || this->Source_.mesh.TrianglesAround(p).size() == 0)
  {
    return { 0.0, NotKnown, 0.0 };
  }
  const double b = this->Source_.field.Extremality(this->Color_, p);
  const double squaredRounding = std::pow(this->RoundingError(p, radius), 2) +
    std::pow(this->Magnified(this->Rounding_.OfDigits(this->LargestCoordinate(p)), p, radius), 2);
  Sums sums{ b * b, squaredRounding, squaredRounding };
  const FitErrorSource& errors = this->Source_.errors;
  if (errors.fitResidual && errors.fitScale)
  {
    const double noise = this->Magnified(around.height, p, radius);
    const double difference = ShareOfDifference * (b - around.derivative);
    sums.squaredNoise += noise * noise;
    sums.squaredError += noise * noise + difference * difference;
  }
  return sums;
}

ExtremalityErrors::Surroundings ExtremalityErrors::LookAround(Id p) const
{
  const TriangleMesh& mesh = this->Source_.mesh;
  const FitErrorSource& errors = this->Source_.errors;
  const std::vector<std::uint8_t>& isFlagged = this->Source_.isFlagged;
  const bool hasHeights = errors.fitResidual && errors.fitScale;
  // Averaged, as single fits have few points more than coefficients.
  const auto squaredHeight = [&errors, hasHeights](Id q)
  {
    const double height = hasHeights ? errors.fitResidual[q] * errors.fitScale[q] : 0.0;
    return height * height;
  };
  Surroundings around;
  around.isFlagged = !isFlagged.empty() && isFlagged[p] != 0;
  double heights = squaredHeight(p);
  double points = 1.0;
  for (const Id t : mesh.TrianglesAround(p))
  {
    const Triangle& c = mesh.Corners(t);
    const int corner = CornerOf(c, p);
    const Id q = c[(corner + 1) % 3];
    const Id r = c[(corner + 2) % 3];
    around.isFlagged =
      around.isFlagged || (!isFlagged.empty() && (isFlagged[q] != 0 || isFlagged[r] != 0));
    heights += 0.5 * (squaredHeight(q) + squaredHeight(r));
    points += 1.0;
  }
  around.height = std::sqrt(heights / points);
  around.derivative = CurvatureSlope(mesh, this->Source_.field, this->Color_, p);
  return around;
}

/// Of the fit, or, where there is none, about that of two rings.
double ExtremalityErrors::RadiusAt(Id p) const
{
  if (this->Source_.errors.fitScale)
  {
    return this->Source_.errors.fitScale[p];
  }
  const TriangleMesh& mesh = this->Source_.mesh;
  double squared = 0.0;
  for (const Id t : mesh.TrianglesAround(p))
  {
    for (const Id q : mesh.Corners(t))
    {
      squared = std::max(squared, (mesh.Point(q) - mesh.Point(p)).squaredNorm());
    }
  }
  return 2.0 * std::sqrt(squared);
}

double ExtremalityErrors::GainAt(Id p) const
{
  const double* gain = this->Source_.errors.noiseGain;
  return gain ? gain[p] : UsualGain;
}

double ExtremalityErrors::LargestCoordinate(Id p) const
{
  return this->Source_.mesh.Point(p).cwiseAbs().maxCoeff();
}

/// What an error of heights does to the extremality.
double ExtremalityErrors::Magnified(double height, Id p, double radius) const
{
  return this->GainAt(p) * height / (radius * radius * radius);
}

/// Of the coordinates' precision and of the fit itself.
double ExtremalityErrors::RoundingError(Id p, double radius) const
{
  const double height = this->Rounding_.OfPrecision() * this->LargestCoordinate(p);
  return FitRounding / (radius * radius) + this->Magnified(height, p, radius);
}

bool ExtremalityErrors::IsRoundOff(Id p) const
{
  const double radius = this->RadiusAt(p);
  return radius > 0.0 &&
    std::abs(this->Source_.field.Extremality(this->Color_, p)) <=
    this->Significance_ * this->RoundingError(p, radius);
}

/// What coarse meshes of smooth surfaces leave over is much less.
bool ExtremalityErrors::IsUnresolved(Id p) const
{
  const FitErrorSource& errors = this->Source_.errors;
  if (!errors.fitResidual || !errors.fitScale)
  {
    return false;
  }
  constexpr double mostTurn = 5.0;
  constexpr double turn = 1.2;
  constexpr double rough = 0.01;
  const MongeField& field = this->Source_.field;
  const double here = std::max(std::abs(field.k1[p]), std::abs(field.k2[p])) * errors.fitScale[p];
  return here > mostTurn || (here > turn && errors.fitResidual[p] > rough);
}

} // namespace ridges
