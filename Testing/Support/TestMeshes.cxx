// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The builders.

#include "TestMeshes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>

namespace ridges
{
namespace testing
{

using Eigen::Vector3d;
using Id = std::int32_t;

namespace
{

const double Pi = 3.14159265358979323846;

//------------------------------------------------------------------------------
// Two triangles of the quadrilateral i j k l, cut along the shorter diagonal.
void AddQuadrilateral(Mesh& mesh, Id i, Id j, Id k, Id l)
{
  const double ik = (mesh.Point(i) - mesh.Point(k)).squaredNorm();
  const double jl = (mesh.Point(j) - mesh.Point(l)).squaredNorm();
  if (ik <= jl * (1 + 1e-9)) // ties are not left to round-off
  {
    mesh.AddTriangle(i, j, k);
    mesh.AddTriangle(i, k, l);
  }
  else
  {
    mesh.AddTriangle(i, j, l);
    mesh.AddTriangle(j, k, l);
  }
}

//------------------------------------------------------------------------------
// nu by nv cells of a parametric surface on the unit square. A wrapped direction is periodic.
// Orientation: the normal is that of (dp/du) x (dp/dv).
Mesh Grid(
  int nu, int nv, bool wrapped, const std::function<Vector3d(double, double)>& parametrization)
{
  Mesh mesh;
  const int pu = wrapped ? nu : nu + 1;
  const int pv = wrapped ? nv : nv + 1;
  for (int j = 0; j < pv; ++j)
  {
    for (int i = 0; i < pu; ++i)
    {
      mesh.AddPoint(parametrization(static_cast<double>(i) / nu, static_cast<double>(j) / nv));
    }
  }
  for (int j = 0; j < nv; ++j)
  {
    for (int i = 0; i < nu; ++i)
    {
      const int right = (i + 1) % pu;
      const int up = (j + 1) % pv;
      AddQuadrilateral(mesh, j * pu + i, j * pu + right, up * pu + right, up * pu + i);
    }
  }
  return mesh;
}

} // namespace

//------------------------------------------------------------------------------
void Mesh::SetPoint(std::size_t i, const Vector3d& point)
{
  std::copy(point.data(), point.data() + 3, this->points.begin() + 3 * i);
}

//------------------------------------------------------------------------------
void Mesh::AddPoint(const Vector3d& point)
{
  this->points.insert(this->points.end(), point.data(), point.data() + 3);
}

//------------------------------------------------------------------------------
void Mesh::AddTriangle(Id i, Id j, Id k)
{
  this->triangles.insert(this->triangles.end(), { i, j, k });
}

//------------------------------------------------------------------------------
Eigen::Matrix3d GenericRotation()
{
  const Vector3d axis = Vector3d(0.3217, -0.7431, 0.5873).normalized();
  return Eigen::AngleAxisd(1.2345, axis).toRotationMatrix();
}

//------------------------------------------------------------------------------
Mesh Icosphere(int frequency, bool rotated)
{
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  const Vector3d corners[12] = { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 },
    { 0, -1, g }, { 0, 1, g }, { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 },
    { -g, 0, -1 }, { -g, 0, 1 } };
  const int faces[20][3] = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 },
    { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 },
    { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },
    { 9, 8, 1 } };

  Mesh mesh;
  const Eigen::Matrix3d rotation =
    rotated ? GenericRotation() : Eigen::Matrix3d(Eigen::Matrix3d::Identity());

  // A point is known by its weights at the corners, so neighbouring faces share it.
  using Weights = std::array<std::pair<int, int>, 3>;
  std::map<Weights, Id> ids;
  const auto idOf = [&](const int* face, int i, int j) -> Id
  {
    const int k = frequency - i - j;
    Weights key = { { { face[0], k }, { face[1], i }, { face[2], j } } };
    for (std::pair<int, int>& weight : key)
    {
      weight.first = weight.second == 0 ? -1 : weight.first;
    }
    std::sort(key.begin(), key.end());
    const auto inserted = ids.emplace(key, static_cast<Id>(mesh.PointCount()));
    if (inserted.second)
    {
      // Summed in the order of the key: the same from whichever face.
      Vector3d point = Vector3d::Zero();
      for (const std::pair<int, int>& weight : key)
      {
        point += weight.second == 0 ? Vector3d(Vector3d::Zero())
                                    : Vector3d(weight.second * corners[weight.first]);
      }
      mesh.AddPoint(rotation * point.normalized());
    }
    return inserted.first->second;
  };

  for (const auto& face : faces)
  {
    for (int i = 0; i < frequency; ++i)
    {
      for (int j = 0; i + j < frequency; ++j)
      {
        mesh.AddTriangle(idOf(face, i, j), idOf(face, i + 1, j), idOf(face, i, j + 1));
        if (i + j + 1 < frequency)
        {
          mesh.AddTriangle(idOf(face, i + 1, j), idOf(face, i + 1, j + 1), idOf(face, i, j + 1));
        }
      }
    }
  }
  return mesh;
}

//------------------------------------------------------------------------------
Mesh EllipsoidMesh(int frequency, double a, double b, double c, bool rotated)
{
  Mesh mesh = Icosphere(frequency, rotated);
  for (std::size_t i = 0; i < mesh.PointCount(); ++i)
  {
    mesh.SetPoint(i, mesh.Point(i).cwiseProduct(Vector3d(a, b, c)));
  }
  return mesh;
}

//------------------------------------------------------------------------------
Mesh StarShapedMesh(int frequency, const AnalyticSurface& surface, const Vector3d& center)
{
  Mesh mesh = Icosphere(frequency);
  for (std::size_t i = 0; i < mesh.PointCount(); ++i)
  {
    mesh.SetPoint(i, surface.IntersectRay(center, mesh.Point(i)));
  }
  return mesh;
}

//------------------------------------------------------------------------------
Mesh TorusMesh(double R, double r, int nu, int nv)
{
  return Grid(nu, nv, true,
    [R, r](double u, double v)
    {
      const double h = R + r * std::cos(2 * Pi * v);
      return Vector3d(h * std::cos(2 * Pi * u), h * std::sin(2 * Pi * u), r * std::sin(2 * Pi * v));
    });
}

//------------------------------------------------------------------------------
Mesh CylinderPatch(double r, double angle, double height, int nu, int nv)
{
  return Grid(nu, nv, false,
    [=](double u, double v)
    { return Vector3d(r * std::cos(angle * u), r * std::sin(angle * u), height * v); });
}

//------------------------------------------------------------------------------
Mesh GraphPatch(const HeightField& f, double halfSize, int n, double jitter, std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  const double cell = 1.0 / n;
  return Grid(n, n, false,
    [&](double u, double v)
    {
      const double du = (2 * Uniform(generator) - 1) * jitter * cell;
      const double dv = (2 * Uniform(generator) - 1) * jitter * cell;
      if (std::min(u, v) > 0.5 * cell && std::max(u, v) < 1.0 - 0.5 * cell)
      {
        u += du;
        v += dv;
      }
      const double x = halfSize * (2 * u - 1);
      const double y = halfSize * (2 * v - 1);
      return Vector3d(x, y, f(x, y));
    });
}

//------------------------------------------------------------------------------
// After isosurface stuffing (Labelle and Shewchuk): a body-centered cubic lattice, whose points
// near the surface are first moved onto it, is cut tetrahedron by tetrahedron. Lattice points have
// integer coordinates of one parity; the neighbours of a point are 6 at distance 2 and 8 at
// distance sqrt(3).
Mesh ClosedMesh(const AnalyticSurface& surface, const Vector3d& halfSize, int n)
{
  using Index = Eigen::Vector3i;
  const double h = halfSize.maxCoeff() / n;
  const Index half = (halfSize / (2 * h)).array().ceil().cast<int>() + 2;
  const Index size = 4 * half + Index::Ones(); // the corners are lattice points
  const auto key = [&](const Index& p) { return p[0] + size[0] * (p[1] + size[1] * p[2]); };
  const auto inBox = [&](const Index& p) { return p.minCoeff() >= 0 && (size - p).minCoeff() > 0; };

  std::vector<Vector3d> positions(static_cast<std::size_t>(size.prod()));
  std::vector<double> values(positions.size());
  std::vector<Index> lattice;
  for (Index p(0, 0, 0); p[2] < size[2]; ++p[2])
  {
    for (p[1] = 0; p[1] < size[1]; ++p[1])
    {
      for (p[0] = 0; p[0] < size[0]; ++p[0])
      {
        if (p[0] % 2 == p[1] % 2 && p[0] % 2 == p[2] % 2)
        {
          positions[key(p)] = h * (p - 2 * half).cast<double>();
          values[key(p)] = surface.Value(positions[key(p)]);
          lattice.push_back(p);
          if (values[key(p)] <= 0.0 && (p.minCoeff() == 0 || (size - p).minCoeff() == 1))
          {
            throw std::runtime_error("ClosedMesh: the surface leaves the box");
          }
        }
      }
    }
  }

  const auto crosses = [&](int i, int j) { return values[i] * values[j] < 0.0; };
  // The parameter from i to j of the surface.
  const auto crossing = [&](int i, int j)
  {
    double near = 0.0;
    double far = 1.0;
    for (int step = 0; step < 45; ++step)
    {
      const double middle = 0.5 * (near + far);
      const double value = surface.Value(positions[i] + middle * (positions[j] - positions[i]));
      ((value < 0.0) == (values[i] < 0.0) ? near : far) = middle;
    }
    return 0.5 * (near + far);
  };

  std::vector<Index> neighbours;
  for (int axis = 0; axis < 3; ++axis)
  {
    neighbours.emplace_back(2 * Index::Unit(axis));
    neighbours.emplace_back(-2 * Index::Unit(axis));
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    neighbours.emplace_back(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
  }
  for (const Index& p : lattice)
  {
    const int i = key(p);
    double best = 1.0;
    Vector3d target;
    for (std::size_t neighbour = 0; neighbour < neighbours.size(); ++neighbour)
    {
      const Index q = p + neighbours[neighbour];
      if (inBox(q) && crosses(i, key(q)))
      {
        // The thresholds of the method that bound the angles of its triangles.
        const double t = crossing(i, key(q));
        const double relative = t / (neighbour < 6 ? 0.21509 : 0.35900);
        if (relative < best)
        {
          best = relative;
          target = positions[i] + t * (positions[key(q)] - positions[i]);
        }
      }
    }
    if (best < 1.0)
    {
      positions[i] = target;
      values[i] = 0.0;
    }
  }

  Mesh mesh;
  std::map<std::pair<int, int>, Id> ids; // by lattice edge; a moved lattice point is (i, i)
  const auto idOf = [&](int i, int j) -> Id
  {
    const std::pair<int, int> edge(std::min(i, j), std::max(i, j));
    const auto inserted = ids.emplace(edge, static_cast<Id>(mesh.PointCount()));
    if (inserted.second)
    {
      const double t = i == j ? 0.0 : crossing(edge.first, edge.second);
      const Vector3d& first = positions[edge.first];
      mesh.AddPoint(surface.Project(first + t * (positions[edge.second] - first)));
    }
    return inserted.first->second;
  };
  const auto cut = [&](const std::array<int, 4>& tetrahedron)
  {
    std::vector<int> inside, on, outside;
    for (const int i : tetrahedron)
    {
      (values[i] < 0.0 ? inside : values[i] > 0.0 ? outside : on).push_back(i);
    }
    std::vector<Id> polygon;
    polygon.reserve(4);
    for (const int i : on)
    {
      polygon.push_back(idOf(i, i));
    }
    for (std::size_t i = 0; i < inside.size(); ++i)
    {
      for (std::size_t j = 0; j < outside.size(); ++j)
      {
        // Around the quadrilateral of two points against two, every other pair is taken backwards.
        polygon.push_back(idOf(inside[i], outside[i == 0 ? j : outside.size() - 1 - j]));
      }
    }
    if (inside.empty() || polygon.size() < 3)
    {
      return;
    }
    const Vector3d p = mesh.Point(polygon[0]);
    const Vector3d normal = (mesh.Point(polygon[1]) - p).cross(mesh.Point(polygon[2]) - p);
    if (normal.dot(p - positions[inside[0]]) < 0.0)
    {
      std::reverse(polygon.begin(), polygon.end());
    }
    if (polygon.size() == 3)
    {
      mesh.AddTriangle(polygon[0], polygon[1], polygon[2]);
    }
    else
    {
      AddQuadrilateral(mesh, polygon[0], polygon[1], polygon[2], polygon[3]);
    }
  };

  // Four tetrahedra around the edge between the centers of two cubes that share a face.
  for (const Index& p : lattice)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const Index q = p + 2 * Index::Unit(axis);
      const Index u = Index::Unit((axis + 1) % 3);
      const Index v = Index::Unit((axis + 2) % 3);
      if (p[0] % 2 == 1 && inBox(q))
      {
        const Index middle = p + Index::Unit(axis);
        const int ring[4] = { key(middle - u - v), key(middle + u - v), key(middle + u + v),
          key(middle - u + v) };
        for (int i = 0; i < 4; ++i)
        {
          cut({ key(p), key(q), ring[i], ring[(i + 1) % 4] });
        }
      }
    }
  }
  const MeshTopology topology = Topology(mesh);
  if (!topology.oriented || topology.borderEdges > 0)
  {
    throw std::runtime_error("ClosedMesh: n is too small for this surface");
  }
  return mesh;
}

} // namespace testing
} // namespace ridges
