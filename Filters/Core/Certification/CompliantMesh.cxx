// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Certification/CompliantMesh.h"

#include "Certification/PatchSearch.h"
#include "Mesh/Regions.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ridges
{
namespace
{

Eigen::Map<const Eigen::Vector3d> VectorAt(const std::vector<double>& values, Id p)
{
  return Eigen::Map<const Eigen::Vector3d>(values.data() + 3 * static_cast<std::size_t>(p));
}

} // namespace

int SideOf(const ExactSurface& exact, const TriangleMesh& mesh)
{
  bool hasFront = false;
  bool hasBack = false;
  for (const std::vector<Id>& part : RegionsWhere(mesh, [](Id) { return true; }))
  {
    Id agreeing = 0;
    for (const Id t : part)
    {
      SurfacePoints points;
      points.count = 1;
      points.position[0] = mesh.Centroid(t);
      exact.Locate(points);
      const double side = mesh.AreaNormal(t).dot(points.normal[0]);
      agreeing += side > 0.0 ? 1 : side < 0.0 ? -1 : 0;
    }
    (agreeing < 0 ? hasBack : hasFront) = true;
  }
  return hasFront && hasBack ? 0 : hasBack ? -1 : 1;
}

CompliantMesh::CompliantMesh(const ExactSurface& exact, const SurfaceBounds& bounds,
  bool isReversed, const std::vector<Eigen::Vector3d>& points, std::vector<Triangle> triangles)
  : Exact_(exact)
  , Bounds_(bounds)
  , IsReversed_(isReversed)
  , Triangles_(std::move(triangles))
{
  for (const Eigen::Vector3d& point : points)
  {
    this->AddPoint(point);
  }
  this->ComputeForms(0, this->NumberOfPoints());
  this->Rebuild();
  this->MeanEdgeAtFirst_ = this->Mesh_->MeanEdgeLength();
}

void CompliantMesh::AddPoint(const Eigen::Vector3d& position)
{
  this->Points_.insert(this->Points_.end(), position.data(), position.data() + 3);
}

void CompliantMesh::ComputeForms(Id begin, Id end)
{
  const auto n = static_cast<std::size_t>(this->NumberOfPoints());
  for (std::vector<double>* values : { &this->Normals_, &this->D1_, &this->D2_ })
  {
    values->resize(3 * n);
  }
  this->K1_.resize(n);
  this->K2_.resize(n);
  this->B_.resize(4 * n);
  this->Forms_.resize(n);
  for (Id first = begin; first < end; first += Lanes::Count)
  {
    SurfacePoints points;
    points.count = std::min(Lanes::Count, end - first);
    for (int lane = 0; lane < points.count; ++lane)
    {
      points.position[lane] = VectorAt(this->Points_, first + lane);
    }
    this->Exact_.Locate(points);
    this->Exact_.Differentiate(points);
    for (int lane = 0; lane < points.count; ++lane)
    {
      const std::size_t p = static_cast<std::size_t>(first) + static_cast<std::size_t>(lane);
      this->NumberOfFaults_ += points.fault[lane] == ExactFault::None ? 0 : 1;
      const MongeForm form = this->IsReversed_ ? Flipped(points.form[lane]) : points.form[lane];
      std::copy_n(points.position[lane].data(), 3, &this->Points_[3 * p]);
      std::copy_n(form.n.data(), 3, &this->Normals_[3 * p]);
      std::copy_n(form.d1.data(), 3, &this->D1_[3 * p]);
      std::copy_n(form.d2.data(), 3, &this->D2_[3 * p]);
      std::copy_n(form.b.data(), 4, &this->B_[4 * p]);
      this->Forms_[p] = form;
      this->K1_[p] = form.k1;
      this->K2_[p] = form.k2;
    }
  }
}

void CompliantMesh::Rebuild()
{
  this->Mesh_ =
    std::make_unique<TriangleMesh>(this->Points_.data(), this->NumberOfPoints(), this->Triangles_);
}

MongeField CompliantMesh::Field() const
{
  MongeField field;
  field.k1 = this->K1_.data();
  field.k2 = this->K2_.data();
  field.d1 = this->D1_.data();
  field.d2 = this->D2_.data();
  field.b = this->B_.data();
  return field;
}

MeshCertificate CompliantMesh::Certify(const RangeLoop& loop, const Monitor& monitor)
{
  return CertifyMesh({ this->Bounds_, *this->Mesh_, this->Field(), this->Normals_.data() },
    this->Memory_, loop, monitor);
}

bool CompliantMesh::Refine(const MeshCertificate& certificate)
{
  std::vector<std::uint8_t> moved(static_cast<std::size_t>(this->NumberOfPoints()), 0);
  std::vector<std::uint8_t> marked = this->MarkEdges(certificate, moved);
  this->MarkLongestEdges(marked);
  const Id before = this->NumberOfPoints();
  std::vector<Id> pointOfEdge(marked.size(), -1);
  Id next = before;
  std::vector<Eigen::Vector3d> added;
  for (Id e = 0; e < this->Mesh_->NumberOfEdges(); ++e)
  {
    if (marked[e] != 0)
    {
      added.push_back(this->NewPoint(this->Mesh_->EdgeAt(e), certificate.edges[e]));
      pointOfEdge[e] = next++;
    }
  }
  bool hasMoved = false;
  for (Id p = 0; p < before; ++p)
  {
    if (moved[p] != 0)
    {
      this->MoveOffRidge(p);
      this->TimesMoved_.resize(static_cast<std::size_t>(before), 0);
      ++this->TimesMoved_[p];
      this->ComputeForms(p, p + 1);
      hasMoved = true;
    }
  }
  if (added.empty() && !hasMoved)
  {
    return false;
  }
  this->Split(pointOfEdge);
  for (const Eigen::Vector3d& point : added)
  {
    this->AddPoint(point);
  }
  this->ComputeForms(before, this->NumberOfPoints());
  if (hasMoved)
  {
    moved.resize(static_cast<std::size_t>(this->NumberOfPoints()), 0);
    this->Memory_.Forget(moved);
  }
  this->Rebuild();
  return true;
}

std::vector<std::uint8_t> CompliantMesh::MarkEdges(
  const MeshCertificate& certificate, std::vector<std::uint8_t>& moved) const
{
  constexpr double onRidge = 1e-6;
  constexpr int mostMoves = 3;
  const TriangleMesh& mesh = *this->Mesh_;
  std::vector<std::uint8_t> marked(static_cast<std::size_t>(mesh.NumberOfEdges()), 0);
  const auto canHelp = [](std::uint16_t failed)
  { return failed != 0 && (failed & NotGeneric) == 0; };
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    const auto& found = certificate.edges[e];
    if (!found || !canHelp(found->failed))
    {
      continue;
    }
    const Edge& edge = mesh.EdgeAt(e);
    bool isAtVertex = false;
    if ((found->failed & NoRidgeThroughVertex) != 0)
    {
      for (const Id p : { edge.v0, edge.v1 })
      {
        const bool mayMove = static_cast<std::size_t>(p) >= this->TimesMoved_.size() ||
          this->TimesMoved_[p] < mostMoves;
        if (mayMove && this->DistanceFromRidges(p) < onRidge)
        {
          moved[p] = 1;
          isAtVertex = true;
        }
      }
    }
    marked[e] = !isAtVertex && this->IsLong(e) ? 1 : 0;
  }
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const auto& found = certificate.triangles[t];
    const Id patch = certificate.patchOfTriangle[t];
    if ((found && canHelp(found->failed)) ||
      (patch >= 0 && canHelp(certificate.patches[patch].failed)))
    {
      const Id longest = this->LongestEdge(t);
      marked[longest] |= this->IsLong(longest) ? 1 : 0;
    }
  }
  return marked;
}

/// Where shorter edges than that would be needed, the surface is not generic, or so it seems.
bool CompliantMesh::IsLong(Id edge) const
{
  constexpr double least = 1e-6;
  const Edge& ends = this->Mesh_->EdgeAt(edge);
  return (this->Mesh_->Point(ends.v0) - this->Mesh_->Point(ends.v1)).norm() >
    least * this->MeanEdgeAtFirst_;
}

/// Until every triangle with a marked edge is bisected by its longest one.
void CompliantMesh::MarkLongestEdges(std::vector<std::uint8_t>& marked) const
{
  const TriangleMesh& mesh = *this->Mesh_;
  std::vector<Id> tasks;
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    if (marked[e] != 0)
    {
      tasks.push_back(e);
    }
  }
  while (!tasks.empty())
  {
    const Edge edge = mesh.EdgeAt(tasks.back());
    tasks.pop_back();
    for (const Id t : { edge.t0, edge.t1 })
    {
      const Id longest = t < 0 ? -1 : this->LongestEdge(t);
      if (longest >= 0 && marked[longest] == 0)
      {
        marked[longest] = 1;
        tasks.push_back(longest);
      }
    }
  }
}

Id CompliantMesh::LongestEdge(Id triangle) const
{
  const TriangleMesh& mesh = *this->Mesh_;
  const auto key = [&mesh](Id e)
  {
    const Eigen::Vector3d p = mesh.Point(mesh.EdgeAt(e).v0);
    const Eigen::Vector3d q = mesh.Point(mesh.EdgeAt(e).v1);
    const Eigen::Vector3d sum = p + q; // of two of the same length, any, whatever the numbering
    return std::array<double, 4>{ (p - q).squaredNorm(), sum[0], sum[1], sum[2] };
  };
  Id longest = mesh.EdgeOf(triangle, 0);
  for (int side = 1; side < 3; ++side)
  {
    const Id e = mesh.EdgeOf(triangle, side);
    longest = key(e) > key(longest) ? e : longest;
  }
  return longest;
}

/// Without a unit: how small the smaller extremality is.
double CompliantMesh::DistanceFromRidges(Id point) const
{
  const double k = std::max(std::abs(this->K1_[point]), std::abs(this->K2_[point]));
  const double* b = &this->B_[4 * static_cast<std::size_t>(point)];
  return std::min(std::abs(b[0]), std::abs(b[3])) / (k * k);
}

/// Part of the way to the neighbour that is farthest from ridges.
void CompliantMesh::MoveOffRidge(Id point)
{
  constexpr double share = 0.15;
  Id best = -1;
  for (const Id t : this->Mesh_->TrianglesAround(point))
  {
    for (const Id q : this->Mesh_->Corners(t))
    {
      const bool isBetter =
        q != point && (best < 0 || this->DistanceFromRidges(q) > this->DistanceFromRidges(best));
      best = isBetter ? q : best;
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    double& x = this->Points_[3 * static_cast<std::size_t>(point) + i];
    x += share * (this->Points_[3 * static_cast<std::size_t>(best) + i] - x);
  }
}

/// The middle of an edge's image, or a point beside it, if a ridge goes through there.
Eigen::Vector3d CompliantMesh::NewPoint(
  const Edge& edge, const std::optional<EdgeCertificate>& known) const
{
  constexpr double nearness = 0.04;
  double t = 0.5;
  if (known)
  {
    for (int color = 0; color < 2; ++color)
    {
      const double off = t - known->parameter[color];
      if (known->crossings[color] == 1 && std::abs(off) < nearness)
      {
        t = known->parameter[color] + (off < 0.0 ? -2.0 : 2.0) * nearness;
      }
    }
  }
  const Eigen::Vector3d flat =
    (1.0 - t) * VectorAt(this->Points_, edge.v0) + t * VectorAt(this->Points_, edge.v1);
  const Eigen::Vector3d normal =
    (1.0 - t) * VectorAt(this->Normals_, edge.v0) + t * VectorAt(this->Normals_, edge.v1);
  const double height = HeightAlong(this->Bounds_, flat, normal, 0.0);
  return std::isfinite(height) ? Eigen::Vector3d(flat + height * normal) : flat;
}

void CompliantMesh::Split(const std::vector<Id>& pointOfEdge)
{
  std::vector<Triangle> result;
  const TriangleMesh& mesh = *this->Mesh_;
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const Id longest = this->LongestEdge(t);
    if (pointOfEdge[longest] < 0)
    {
      result.push_back(mesh.Corners(t));
      continue;
    }
    // From the longest side a-b with its middle m, and the corner c: halves a-m-c and m-b-c.
    const int side = mesh.SideOf(t, longest);
    const Triangle& corners = mesh.Corners(t);
    const Id a = corners[side];
    const Id b = corners[(side + 1) % 3];
    const Id c = corners[(side + 2) % 3];
    const Id m = pointOfEdge[longest];
    const Id bc = pointOfEdge[mesh.EdgeOf(t, (side + 1) % 3)];
    const Id ca = pointOfEdge[mesh.EdgeOf(t, (side + 2) % 3)];
    if (ca < 0)
    {
      result.push_back({ a, m, c });
    }
    else
    {
      result.push_back({ a, m, ca });
      result.push_back({ ca, m, c });
    }
    if (bc < 0)
    {
      result.push_back({ m, b, c });
    }
    else
    {
      result.push_back({ m, b, bc });
      result.push_back({ m, bc, c });
    }
  }
  this->Triangles_ = std::move(result);
}

} // namespace ridges
