// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/TestFields.h"

#include "Fit/JetFit.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <random>

namespace ridges
{
namespace testing
{

using Eigen::Vector3d;

std::vector<Triangle> TrianglesOf(const Mesh& mesh)
{
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < mesh.TriangleCount(); ++t)
  {
    triangles.push_back(
      { mesh.triangles[3 * t], mesh.triangles[3 * t + 1], mesh.triangles[3 * t + 2] });
  }
  return triangles;
}

//------------------------------------------------------------------------------
MeshedSurface::MeshedSurface(const Mesh& mesh)
  : Points_(mesh.points)
  , Triangles_(this->Points_.data(), static_cast<Id>(mesh.PointCount()), TrianglesOf(mesh))
{
}

//------------------------------------------------------------------------------
MeshedSurface::MeshedSurface(const PointsAndTriangles& mesh)
  : Points_(mesh.points.data(), mesh.points.data() + mesh.points.size())
  , Triangles_(this->Points_.data(), static_cast<Id>(mesh.points.cols()), mesh.triangles)
{
}

//------------------------------------------------------------------------------
FieldArrays::FieldArrays(Id numberOfPoints)
  : k1(numberOfPoints)
  , k2(numberOfPoints)
  , d1(3 * static_cast<std::size_t>(numberOfPoints))
  , d2(3 * static_cast<std::size_t>(numberOfPoints))
  , b(4 * static_cast<std::size_t>(numberOfPoints))
  , c(5 * static_cast<std::size_t>(numberOfPoints))
  , P1(numberOfPoints)
  , P2(numberOfPoints)
{
}

//------------------------------------------------------------------------------
void FieldArrays::Set(Id p, const MongeForm& form)
{
  const auto i = static_cast<std::size_t>(p);
  this->k1[i] = form.k1;
  this->k2[i] = form.k2;
  this->P1[i] = form.P1();
  this->P2[i] = form.P2();
  std::copy_n(form.d1.data(), 3, &this->d1[3 * i]);
  std::copy_n(form.d2.data(), 3, &this->d2[3 * i]);
  std::copy_n(form.b.data(), 4, &this->b[4 * i]);
  std::copy_n(form.c.data(), 5, &this->c[5 * i]);
}

//------------------------------------------------------------------------------
void FieldArrays::Turn(Id p)
{
  const auto turn = [p](std::vector<double>& values, std::size_t size)
  {
    for (std::size_t i = 0; i < size; ++i)
    {
      double& value = values[size * static_cast<std::size_t>(p) + i];
      value = -value;
    }
  };
  turn(this->d1, 3);
  turn(this->d2, 3);
  turn(this->b, 4);
}

//------------------------------------------------------------------------------
MongeField FieldArrays::View() const
{
  MongeField field;
  field.k1 = this->k1.data();
  field.k2 = this->k2.data();
  field.d1 = this->d1.data();
  field.d2 = this->d2.data();
  field.b = this->b.data();
  field.c = this->c.data();
  field.P1 = this->P1.data();
  field.P2 = this->P2.data();
  return field;
}

//------------------------------------------------------------------------------
OrderedRings RingsOf(const TriangleMesh& mesh)
{
  OrderedRings rings(mesh);
  rings.Build(0, mesh.NumberOfPoints());
  return rings;
}

//------------------------------------------------------------------------------
FieldArrays FitField(const TriangleMesh& mesh, int minimumNumberOfPoints)
{
  FieldArrays field(mesh.NumberOfPoints());
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  NeighborhoodRule rule;
  rule.minimumNumberOfPoints = minimumNumberOfPoints;
  JetFitter fitter;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    const JetFit fit =
      fitter.Fit(OffsetsAround(mesh, p, neighborhood, rule), 4, mesh.PointNormal(p));
    field.Set(p, MongeFormOfHeightJet(fit.jet, fit.frame));
  }
  return field;
}

//------------------------------------------------------------------------------
FieldArrays ExactField(const TriangleMesh& mesh, const AnalyticSurface& surface)
{
  FieldArrays field(mesh.NumberOfPoints());
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    field.Set(p, ToMongeForm(surface.Monge(mesh.Point(p))));
  }
  return field;
}

//------------------------------------------------------------------------------
FieldArrays RandomField(const TriangleMesh& mesh, std::uint64_t seed, int zeroEvery)
{
  std::mt19937_64 generator(seed);
  FieldArrays field(mesh.NumberOfPoints());
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    MongeForm form;
    form.n = InBall(generator).normalized();
    form.d1 = form.n.cross(InBall(generator)).normalized();
    form.d2 = form.n.cross(form.d1);
    form.k1 = Uniform(generator);
    form.k2 = -Uniform(generator);
    for (double& b : form.b)
    {
      b = Symmetric(generator);
    }
    for (double& c : form.c)
    {
      c = 10.0 * Symmetric(generator);
    }
    const bool negative = Uniform(generator) < 0.5;
    if (zeroEvery > 0 && p % zeroEvery == 0)
    {
      form.b[0] = negative ? -0.0 : 0.0;
      form.b[3] = -form.b[0];
    }
    field.Set(p, form);
  }
  return field;
}

//------------------------------------------------------------------------------
MongeForm ToMongeForm(const ExactMonge& exact)
{
  MongeForm form;
  form.d1 = exact.d1;
  form.d2 = exact.d2;
  form.n = exact.n;
  form.k1 = exact.k1;
  form.k2 = exact.k2;
  form.b = exact.b;
  form.c = exact.c;
  return form;
}

//------------------------------------------------------------------------------
Eigen::Matrix3Xd OffsetsAround(
  const TriangleMesh& mesh, Id vertex, RingNeighborhood& neighborhood, const NeighborhoodRule& rule)
{
  const Span<Id> points = neighborhood.Gather(vertex, rule);
  Eigen::Matrix3Xd offsets(3, points.size());
  for (Id i = 0; i < points.size(); ++i)
  {
    offsets.col(i) = mesh.Point(points[i]) - mesh.Point(vertex);
  }
  return offsets;
}

} // namespace testing
} // namespace ridges
