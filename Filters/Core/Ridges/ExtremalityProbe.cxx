// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/ExtremalityProbe.h"

#include "Mesh/MeanGradient.h"

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

double CurvatureOf(Color color, const MongeForm& form)
{
  return color == Color::Blue ? form.k1 : form.k2;
}

} // namespace

ExtremalityProbe::ExtremalityProbe(const TriangleMesh& mesh, const OrderedRings& rings)
  : Mesh_(mesh)
  , Rings_(rings)
  , Neighborhood_(mesh, rings)
{
}

bool ExtremalityProbe::IsDeepIn(const std::function<bool(Id)>& isIn, Id vertex, int numberOfRings)
{
  if (!this->Rings_.IsClosed(vertex))
  {
    return false;
  }
  NeighborhoodRule rule;
  rule.kind = NeighborhoodRule::Kind::Rings;
  rule.numberOfRings = numberOfRings + 1;
  const Span<Id> points = this->Neighborhood_.Gather(vertex, rule);
  return std::all_of(points.begin(), points.end(), isIn);
}

ExtremalityProbe::PointFit ExtremalityProbe::Fit(Id p, int numberOfRings)
{
  NeighborhoodRule rule;
  rule.kind = NeighborhoodRule::Kind::Rings;
  rule.numberOfRings = numberOfRings;
  const Span<Id> points = this->Neighborhood_.Gather(p, rule);
  this->Offsets_.resize(3, points.size());
  for (Id i = 0; i < points.size(); ++i)
  {
    this->Offsets_.col(i) = this->Mesh_.Point(points[i]) - this->Mesh_.Point(p);
  }
  constexpr int degree = 4;
  const JetFit fit = this->Fitter_.Fit(this->Offsets_, degree, this->Mesh_.PointNormal(p));
  PointFit result;
  if (fit.status == FitGood && fit.degree == degree)
  {
    result.form = MongeFormOfHeightJet(fit.jet, fit.frame);
    result.errors = StandardErrors(this->Fitter_, fit);
    result.radius = fit.radius;
    result.isGood = result.errors.b[0] >= 0.0 && result.errors.b[3] >= 0.0;
  }
  return result;
}

ExtremalityProbe::Trial ExtremalityProbe::Try(
  Id vertex, int numberOfRings, Color color, double significance)
{
  Trial trial;
  const PointFit center = this->Fit(vertex, numberOfRings);
  constexpr double mostTurn = 0.9; // radian: degree four does not follow more
  if (!center.isGood ||
    std::max(std::abs(center.form.k1), std::abs(center.form.k2)) * center.radius > mostTurn)
  {
    return trial;
  }
  NeighborhoodRule rule;
  rule.kind = NeighborhoodRule::Kind::Rings;
  const Span<Id> points = this->Neighborhood_.Gather(vertex, rule);
  this->Points_.assign(points.begin(), points.end());
  this->Fits_.clear();
  for (const Id p : this->Points_)
  {
    this->Fits_.push_back(this->Fit(p, numberOfRings));
    if (!this->Fits_.back().isGood)
    {
      return trial;
    }
  }
  trial.isUsable = true;
  trial.isSignificant = this->IsSignificant(color, vertex, significance);
  return trial;
}

const ExtremalityProbe::PointFit& ExtremalityProbe::FitAt(Id p) const
{
  const auto found = std::find(this->Points_.begin(), this->Points_.end(), p);
  return this->Fits_[found - this->Points_.begin()];
}

bool ExtremalityProbe::IsSignificant(Color color, Id vertex, double significance) const
{
  const std::size_t i = color == Color::Blue ? 0 : 3;
  double square = 0.0;
  double squaredError = 0.0;
  const auto add = [this, color, i, &square, &squaredError](Id p)
  {
    // See ExtremalityErrors. All of the difference: large fits to regular meshes err alike.
    const PointFit& fit = this->FitAt(p);
    const double b = fit.form.b[i];
    const double difference = b - this->Derivative(color, p);
    square += b * b;
    squaredError += fit.errors.b[i] * fit.errors.b[i] + difference * difference;
  };
  add(vertex);
  const Span<Id> ring = this->Rings_.Around(vertex);
  std::for_each(ring.begin(), ring.end(), add);
  return square > significance * significance * squaredError;
}

double ExtremalityProbe::Derivative(Color color, Id vertex) const
{
  const MongeForm& form = this->FitAt(vertex).form;
  const Span<Id> ring = this->Rings_.Around(vertex);
  const double k = CurvatureOf(color, form);
  MeanGradient gradient;
  for (Id i = 0; i < ring.size(); ++i)
  {
    const Id p = ring[i];
    const Id q = ring[(i + 1) % ring.size()];
    gradient.Add(this->Mesh_.Point(p) - this->Mesh_.Point(vertex),
      this->Mesh_.Point(q) - this->Mesh_.Point(vertex), CurvatureOf(color, this->FitAt(p).form) - k,
      CurvatureOf(color, this->FitAt(q).form) - k);
  }
  return gradient.Along(color == Color::Blue ? form.d1 : form.d2);
}

} // namespace ridges
