// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/Patch/RefinedPatch.h"

#include "Monge/AcuteRule.h"
#include "Monge/FieldOrder.h"
#include "Monge/MongeInterpolation.h"
#include "Ridges/Patch/PatchTriangleForms.h"
#include "Umbilics/UmbilicForm.h"

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

/// Of each edge. Ridges of one colour that are nearer to each other may be taken for none.
constexpr int NumberOfParts = 12;

/// Around an umbilic, each half as large as the one before: inside the last one the third order is
/// constant to 1e-3.
constexpr int NumberOfRings = 10;

/// Of the orders, and of the third order in a triangle, where the form is reliable: on clean meshes
/// that resolve the surface they are smaller, on scans mostly larger.
constexpr double GreatestDifference = 0.125;
constexpr double GreatestSpread = 0.5;

constexpr double Pi = 3.14159265358979323846;

} // namespace

RefinedPatch::RefinedPatch(const TriangleMesh& mesh, const MongeField& field, Color color,
  const std::vector<Id>& triangles, Id umbilic)
  : Mesh_(mesh)
  , Field_(field)
  , Color_(color)
{
  const PatchTriangleForms forms(mesh, field, umbilic);
  if (!this->AddRays(forms))
  {
    return;
  }
  for (const Id t : triangles)
  {
    for (int side = 0; side < 3; ++side)
    {
      this->OnEdge(mesh.EdgeOf(t, side));
    }
  }
  for (const auto& edge : this->OfEdge_)
  {
    this->NoteParts(edge.first);
  }
  for (const Id t : triangles)
  {
    if (t != umbilic)
    {
      this->Cut(t);
    }
  }
  this->CutAroundUmbilic(forms);
  this->IsValid_ = true;
}

std::uint64_t RefinedPatch::Key(int v, int w)
{
  return static_cast<std::uint64_t>(std::min(v, w)) << 32U |
    static_cast<std::uint64_t>(std::max(v, w));
}

int RefinedPatch::AddInside(const PatchTriangleForms& forms, const Eigen::Vector3d& weights)
{
  const double angle = forms.AngleAt(weights);
  const Eigen::Vector3d position = weights[0] * this->Mesh_.Point(forms.corners[0]) +
    weights[1] * this->Mesh_.Point(forms.corners[1]) +
    weights[2] * this->Mesh_.Point(forms.corners[2]);
  this->Vertices_.push_back(
    { position, forms.DirectionAt(angle), forms.ExtremalityAt(weights, this->Color_, angle) });
  return this->NumberOfCorners() - 1;
}

int RefinedPatch::AddOnEdge(Id edge, double parameter)
{
  const OrderedEdge ends = EndsInOrder(this->Mesh_, this->Field_, edge);
  const MongeInterpolation interpolation(this->Field_, ends.p, ends.q);
  this->Vertices_.push_back(
    { (1.0 - parameter) * this->Mesh_.Point(ends.p) + parameter * this->Mesh_.Point(ends.q),
      interpolation.At(parameter).d1, interpolation.Extremality(this->Color_, parameter) });
  return this->NumberOfCorners() - 1;
}

int RefinedPatch::AtPoint(Id point)
{
  const auto found = this->OfPoint_.find(point);
  if (found != this->OfPoint_.end())
  {
    return found->second;
  }
  this->Vertices_.push_back({ this->Mesh_.Point(point), this->Field_.D1(point),
    this->Field_.Extremality(this->Color_, point) });
  this->OfPoint_[point] = this->NumberOfCorners() - 1;
  return this->NumberOfCorners() - 1;
}

RefinedPatch::EdgeVertices& RefinedPatch::OnEdge(Id edge)
{
  EdgeVertices& vertices = this->OfEdge_[edge];
  if (vertices.even.empty())
  {
    const OrderedEdge ends = EndsInOrder(this->Mesh_, this->Field_, edge);
    for (int k = 0; k <= NumberOfParts; ++k)
    {
      const double t = static_cast<double>(k) / NumberOfParts;
      const int v = k == 0
        ? this->AtPoint(ends.p)
        : (k == NumberOfParts ? this->AtPoint(ends.q) : this->AddOnEdge(edge, t));
      vertices.even.push_back(v);
      vertices.all.emplace_back(t, v);
    }
  }
  return vertices;
}

void RefinedPatch::AddToEdge(Id edge, double parameter)
{
  EdgeVertices& vertices = this->OnEdge(edge);
  const auto after =
    std::lower_bound(vertices.all.begin(), vertices.all.end(), std::make_pair(parameter, -1));
  constexpr double least = 1e-6;
  if (after == vertices.all.begin() || after == vertices.all.end() ||
    after->first - parameter < least || parameter - (after - 1)->first < least)
  {
    return;
  }
  vertices.all.insert(after, { parameter, this->AddOnEdge(edge, parameter) });
}

void RefinedPatch::NoteParts(Id edge)
{
  const EdgeVertices& vertices = this->OfEdge_.at(edge);
  for (std::size_t i = 0; i + 1 < vertices.all.size(); ++i)
  {
    const auto& [t, v] = vertices.all[i];
    const auto& [u, w] = vertices.all[i + 1];
    this->Parts_[Key(v, w)] = v < w ? Part{ edge, t, u } : Part{ edge, u, t };
  }
  std::size_t i = 0;
  for (int k = 0; k < NumberOfParts; ++k)
  {
    std::vector<int> between;
    for (++i; vertices.all[i].second != vertices.even[k + 1]; ++i)
    {
      between.push_back(vertices.all[i].second);
    }
    if (!between.empty())
    {
      if (vertices.even[k] > vertices.even[k + 1])
      {
        std::reverse(between.begin(), between.end());
      }
      this->Between_[Key(vertices.even[k], vertices.even[k + 1])] = between;
    }
  }
}

/// From p.
RefinedPatch::DirectedEdge RefinedPatch::EdgeBetween(Id triangle, Id p, Id q) const
{
  const Triangle& corners = this->Mesh_.Corners(triangle);
  const int i = CornerOf(corners, p);
  const int side = corners[(i + 1) % 3] == q ? i : (i + 2) % 3;
  const Id edge = this->Mesh_.EdgeOf(triangle, side);
  return { edge, EndsInOrder(this->Mesh_, this->Field_, edge).p == p };
}

std::vector<int> RefinedPatch::EvenFrom(Id triangle, Id p, Id q)
{
  const DirectedEdge side = this->EdgeBetween(triangle, p, q);
  std::vector<int> even = this->OnEdge(side.edge).even;
  if (!side.forward)
  {
    std::reverse(even.begin(), even.end());
  }
  return even;
}

void RefinedPatch::Cut(Id triangle)
{
  const PatchTriangleForms forms(this->Mesh_, this->Field_, triangle);
  const auto& c = forms.corners;
  constexpr int n = NumberOfParts;
  const std::vector<int> bottom = this->EvenFrom(triangle, c[0], c[1]);
  const std::vector<int> left = this->EvenFrom(triangle, c[0], c[2]);
  const std::vector<int> slope = this->EvenFrom(triangle, c[1], c[2]);
  std::vector<int> last = bottom;
  for (int j = 1; j <= n; ++j)
  {
    std::vector<int> row;
    for (int i = 0; i + j <= n; ++i)
    {
      const Eigen::Vector3d weights = Eigen::Vector3d(n - i - j, i, j) / static_cast<double>(n);
      row.push_back(i == 0 ? left[j] : (i + j == n ? slope[j] : this->AddInside(forms, weights)));
    }
    for (int i = 0; i + j <= n; ++i)
    {
      this->AddTriangle(triangle, { last[i], last[i + 1], row[i] });
      if (i + j < n)
      {
        this->AddTriangle(triangle, { last[i + 1], row[i + 1], row[i] });
      }
    }
    last = row;
  }
}

void RefinedPatch::CutAroundUmbilic(const PatchTriangleForms& forms)
{
  const Eigen::Vector3d umbilic = UmbilicWeights(this->Mesh_, this->Field_, forms.triangle);
  std::vector<Eigen::Vector3d> border;
  this->Rings_.resize(1);
  for (int i = 0; i < 3; ++i)
  {
    const auto [edge, forward] =
      this->EdgeBetween(forms.triangle, forms.corners[i], forms.corners[(i + 1) % 3]);
    std::vector<std::pair<double, int>> all = this->OnEdge(edge).all;
    if (!forward)
    {
      std::reverse(all.begin(), all.end());
    }
    for (std::size_t k = 0; k + 1 < all.size(); ++k)
    {
      const double t = forward ? all[k].first : 1.0 - all[k].first;
      Eigen::Vector3d weights = Eigen::Vector3d::Zero();
      weights[i] = 1.0 - t;
      weights[(i + 1) % 3] = t;
      border.push_back(weights);
      this->Rings_[0].push_back(all[k].second);
    }
  }
  const std::size_t count = border.size();
  double size = 1.0;
  for (int ring = 0; ring < NumberOfRings; ++ring)
  {
    size *= 0.5;
    const std::vector<int>& last = this->Rings_.back();
    std::vector<int> next;
    next.reserve(count);
    for (const Eigen::Vector3d& weights : border)
    {
      next.push_back(this->AddInside(forms, umbilic + size * (weights - umbilic)));
    }
    for (std::size_t k = 0; k < count; ++k)
    {
      const std::size_t after = (k + 1) % count;
      this->AddTriangle(forms.triangle, { last[k], last[after], next[k] });
      this->AddTriangle(forms.triangle, { last[after], next[after], next[k] });
    }
    this->Rings_.push_back(std::move(next));
  }
}

/// Between each two roots of the cubic form, from the umbilic to the border of its triangle.
bool RefinedPatch::AddRays(const PatchTriangleForms& forms)
{
  const Eigen::Vector3d umbilic = UmbilicWeights(this->Mesh_, this->Field_, forms.triangle);
  constexpr double tolerance = 1e-9;
  const double size = forms.second.cwiseAbs().maxCoeff();
  if (!(size > 0.0) || !((forms.second * umbilic).norm() <= tolerance * size))
  {
    return false;
  }
  const SymmetricTensor<3> cubic = forms.ThirdOrderAt(umbilic);
  if (!(forms.DifferenceOfOrders(this->Mesh_, cubic) < GreatestDifference) ||
    !(forms.SpreadAround(cubic) < GreatestSpread))
  {
    return false;
  }
  const std::vector<double> roots = RootAngles(cubic);
  for (std::size_t i = 0; i < roots.size(); ++i)
  {
    const double next = i + 1 < roots.size() ? roots[i + 1] : roots[0] + Pi;
    const double angle = 0.5 * (roots[i] + next) - (this->Color_ == Color::Blue ? 0.0 : 0.5 * Pi);
    const Eigen::Vector3d way = forms.WayTo(angle);
    int side = -1;
    double length = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      if (way[k] < 0.0 && (side < 0 || -umbilic[k] / way[k] < length))
      {
        side = k;
        length = -umbilic[k] / way[k];
      }
    }
    if (side < 0)
    {
      return false;
    }
    const Eigen::Vector3d hit = umbilic + length * way;
    const auto [edge, forward] = this->EdgeBetween(
      forms.triangle, forms.corners[(side + 1) % 3], forms.corners[(side + 2) % 3]);
    const double t = hit[(side + 2) % 3];
    this->AddToEdge(edge, forward ? t : 1.0 - t);
  }
  return true;
}

/// In several, if there are more corners on its sides.
void RefinedPatch::AddTriangle(Id owner, const Corners& corners)
{
  for (int side = 0; side < 3; ++side)
  {
    const int v = corners[side];
    const int w = corners[(side + 1) % 3];
    const auto between = this->Between_.find(Key(v, w));
    if (between != this->Between_.end())
    {
      std::vector<int> line{ v };
      line.insert(line.end(), between->second.begin(), between->second.end());
      line.push_back(w);
      if (v > w)
      {
        std::reverse(line.begin() + 1, line.end() - 1);
      }
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
      {
        this->AddTriangle(owner, { line[i], line[i + 1], corners[(side + 2) % 3] });
      }
      return;
    }
  }
  this->Triangles_.push_back(corners);
  this->Owners_.push_back(owner);
}

bool RefinedPatch::IsCrossed(int v, int w) const
{
  const Vertex& a = this->Vertices_[v];
  const Vertex& b = this->Vertices_[w];
  const int acute = a.d1.dot(b.d1) >= 0.0 ? 1 : -1;
  return acute * ExtremalitySign(a.extremality) * ExtremalitySign(b.extremality) < 0;
}

RefinedPatch::Part RefinedPatch::PartBetween(int v, int w) const
{
  const auto found = this->Parts_.find(Key(v, w));
  if (found == this->Parts_.end())
  {
    return { -1, 0.0, 0.0 };
  }
  const Part& part = found->second;
  return v < w ? part : Part{ part.edge, part.to, part.from };
}

double RefinedPatch::ParameterOn(const Part& part, int v, int w) const
{
  const Vertex& a = this->Vertices_[v];
  const Vertex& b = this->Vertices_[w];
  const double sizes = std::abs(a.extremality) + std::abs(b.extremality);
  const double t = sizes > 0.0 ? std::abs(a.extremality) / sizes : 0.5;
  return (1.0 - t) * part.from + t * part.to;
}

} // namespace ridges
