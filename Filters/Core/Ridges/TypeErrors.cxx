// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/TypeErrors.h"

#include "Mesh/MeanGradient.h"
#include "Mesh/MeanSquare.h"
#include "Monge/AcuteRule.h"

#include <cmath>

namespace ridges
{
namespace
{

/// Of b1 (b2), and of c0 (c4) times the fitting radius, over that of the third-order tensor: about,
/// for fits of degree 4 to 8 to even points.
constexpr double ErrorOfMixedThird = 0.3;
constexpr double ErrorOfFourth = 6.0;

} // namespace

TypeErrors::TypeErrors(
  const TriangleMesh& mesh, const MongeField& field, const FitErrorSource& errors)
  : Mesh_(mesh)
  , Field_(field)
  , Errors_(errors)
{
}

void TypeErrors::Require(Color color, Id p)
{
  PointValues& points = this->Colors_[IndexOf(color)];
  if (points.isRequired.empty())
  {
    points.isRequired.assign(this->Mesh_.NumberOfPoints(), 0);
    points.values = Buffer<Values>(this->Mesh_.NumberOfPoints());
  }
  points.isRequired[p] = 1;
}

void TypeErrors::Require(const RidgeTrace& trace)
{
  for (const RidgeVertex& vertex : trace.vertices)
  {
    if (vertex.edge != RidgeVertex::None)
    {
      const Edge& edge = this->Mesh_.EdgeAt(vertex.edge);
      this->Require(vertex.point.color, edge.v0);
      this->Require(vertex.point.color, edge.v1);
    }
  }
}

void TypeErrors::Find(Id begin, Id end)
{
  for (const Color color : { Color::Blue, Color::Red })
  {
    PointValues& points = this->Colors_[IndexOf(color)];
    for (Id p = begin; p < end && !points.isRequired.empty(); ++p)
    {
      if (points.isRequired[p] != 0)
      {
        points.values[p] = { this->FindError(color, p), this->FindSlope(color, p) };
      }
    }
  }
}

double TypeErrors::FindError(Color color, Id p) const
{
  const FitErrorSource& errors = this->Errors_;
  if (!errors.fitResidual || !errors.fitScale || !errors.noiseGain || !(errors.fitScale[p] > 0.0))
  {
    return 0.0;
  }
  // Averaged, as single fits have few points more than coefficients.
  const double meanSquare = MeanSquareAround(this->Mesh_, p,
    [&errors](Id q)
    {
      const double height = errors.fitResidual[q] * errors.fitScale[q];
      return height * height;
    });
  const double radius = errors.fitScale[p];
  const double third = errors.noiseGain[p] * std::sqrt(meanSquare) / (radius * radius * radius);
  const double mixed = this->Field_.ThirdOrder(p)[color == Color::Blue ? 1 : 2];
  const double gap = this->Field_.k1[p] - this->Field_.k2[p];
  return third * std::hypot(6.0 * mixed * ErrorOfMixedThird, gap * ErrorOfFourth / radius);
}

double TypeErrors::FindSlope(Color color, Id p) const
{
  const double here = this->Field_.Extremality(color, p);
  const auto rise = [this, color, p, here](Id q)
  { return AcuteSign(this->Field_, p, q) * this->Field_.Extremality(color, q) - here; };
  const double slope = GradientAround(this->Mesh_, p, rise).Along(this->Field_.Direction(color, p));
  const double gap = this->Field_.k1[p] - this->Field_.k2[p];
  return (color == Color::Blue ? gap : -gap) * slope;
}

template <typename AtPoint>
std::vector<double> TypeErrors::Along(const RidgeTrace& trace, const AtPoint& atPoint) const
{
  std::vector<double> values(trace.vertices.size(), 0.0);
  const auto isOnEdge = [&trace](std::size_t i)
  { return trace.vertices[i].edge != RidgeVertex::None; };
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const RidgeVertex& vertex = trace.vertices[i];
    if (isOnEdge(i))
    {
      const Edge& edge = this->Mesh_.EdgeAt(vertex.edge);
      const double t = vertex.point.parameter;
      values[i] =
        (1.0 - t) * atPoint(vertex.point.color, edge.v0) + t * atPoint(vertex.point.color, edge.v1);
    }
    else if (i > 0)
    {
      values[i] = values[i - 1];
    }
  }
  for (std::size_t i = values.size(); i-- > 1 && !isOnEdge(0);)
  {
    if (isOnEdge(i))
    {
      values[0] = values[i];
    }
  }
  return values;
}

std::vector<double> TypeErrors::ErrorsOf(const RidgeTrace& trace) const
{
  return this->Along(trace, [this](Color color, Id p) { return this->ErrorAt(color, p); });
}

std::vector<double> TypeErrors::ScalesOf(const RidgeTrace& trace) const
{
  const double* scale = this->Errors_.fitScale;
  return this->Along(trace, [scale](Color, Id p) { return scale ? scale[p] : 0.0; });
}

std::vector<double> TypeErrors::SlopesOf(const RidgeTrace& trace) const
{
  return this->Along(trace, [this](Color color, Id p) { return this->SlopeAt(color, p); });
}

} // namespace ridges
