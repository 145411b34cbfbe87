// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CGALPipeline.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Ridges.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Umbilics.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

namespace benchmarks
{

namespace
{

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Fitter = CGAL::Monge_via_jet_fitting<Kernel>;
using Scalars = Mesh::Property_map<Vertex, double>;
using Vectors = Mesh::Property_map<Vertex, Vector>;

constexpr std::size_t PointsOfBlock = 256;

} // namespace

struct CGALPipeline::Data
{
  Mesh mesh;
  Scalars k1, k2, b0, b3, P1, P2;
  Vectors d1, d2;
  Mesh::Property_map<Vertex, bool> gathered;
  std::vector<Vertex> neighborhood;
  std::vector<Point> points;
  std::vector<Minimum> blocks;
  std::size_t degree = 4;
  std::size_t pointsOfNeighborhood = 18;

  // Whole rings, the vertex first; result in neighborhood.
  void Gather(Vertex vertex)
  {
    this->neighborhood.assign(1, vertex);
    this->gathered[vertex] = true;
    std::size_t ringBegin = 0;
    while (this->neighborhood.size() < this->pointsOfNeighborhood)
    {
      const std::size_t ringEnd = this->neighborhood.size();
      for (std::size_t i = ringBegin; i < ringEnd; ++i)
      {
        for (const Vertex v :
          this->mesh.vertices_around_target(this->mesh.halfedge(this->neighborhood[i])))
        {
          if (!this->gathered[v])
          {
            this->gathered[v] = true;
            this->neighborhood.push_back(v);
          }
        }
      }
      if (this->neighborhood.size() == ringEnd)
      {
        break;
      }
      ringBegin = ringEnd;
    }
    this->points.clear();
    for (const Vertex v : this->neighborhood)
    {
      this->gathered[v] = false;
      this->points.push_back(this->mesh.point(v));
    }
  }

  Vector Normal(Vertex vertex) const
  {
    Vector sum(0.0, 0.0, 0.0);
    for (const auto h : this->mesh.halfedges_around_target(this->mesh.halfedge(vertex)))
    {
      if (!this->mesh.is_border(h))
      {
        const Point& p = this->mesh.point(vertex);
        sum = sum +
          CGAL::cross_product(this->mesh.point(this->mesh.target(this->mesh.next(h))) - p,
            this->mesh.point(this->mesh.source(h)) - p);
      }
    }
    return sum;
  }

  void Fit(Vertex vertex)
  {
    this->Gather(vertex);
    Fitter fitter;
    Fitter::Monge_form form = fitter(this->points.begin(), this->points.end(), this->degree, 4);
    form.comply_wrt_given_normal(this->Normal(vertex));
    const double max = form.principal_curvatures(0);
    const double min = form.principal_curvatures(1);
    const double b1 = form.third_order_coefficients(1);
    const double b2 = form.third_order_coefficients(2);
    const double c0 = form.fourth_order_coefficients(0);
    const double c4 = form.fourth_order_coefficients(4);
    this->d1[vertex] = form.maximal_principal_direction();
    this->d2[vertex] = form.minimal_principal_direction();
    this->k1[vertex] = max;
    this->k2[vertex] = min;
    this->b0[vertex] = form.third_order_coefficients(0);
    this->b3[vertex] = form.third_order_coefficients(3);
    this->P1[vertex] = 3.0 * b1 * b1 + (max - min) * (c0 - 3.0 * max * max * max);
    this->P2[vertex] = 3.0 * b2 * b2 + (min - max) * (c4 - 3.0 * min * min * min);
  }
};

CGALPipeline::CGALPipeline(vtkPolyData* mesh, int degree, int numberOfPoints)
  : Members(std::make_unique<Data>())
{
  Data& data = *this->Members;
  data.degree = static_cast<std::size_t>(degree);
  data.pointsOfNeighborhood = static_cast<std::size_t>(numberOfPoints);
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double point[3];
    mesh->GetPoint(p, point);
    data.mesh.add_vertex(Point(point[0], point[1], point[2]));
  }
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  vtkCellArray* polys = mesh->GetPolys();
  for (polys->InitTraversal(); polys->GetNextCell(size, corners);)
  {
    data.mesh.add_face(Vertex(static_cast<Mesh::size_type>(corners[0])),
      Vertex(static_cast<Mesh::size_type>(corners[1])),
      Vertex(static_cast<Mesh::size_type>(corners[2])));
  }
  const auto scalars = [&data](const char* name)
  { return data.mesh.add_property_map<Vertex, double>(name, 0.0).first; };
  const auto vectors = [&data](const char* name)
  { return data.mesh.add_property_map<Vertex, Vector>(name, Vector(0.0, 0.0, 0.0)).first; };
  data.k1 = scalars("v:k1");
  data.k2 = scalars("v:k2");
  data.b0 = scalars("v:b0");
  data.b3 = scalars("v:b3");
  data.P1 = scalars("v:P1");
  data.P2 = scalars("v:P2");
  data.d1 = vectors("v:d1");
  data.d2 = vectors("v:d2");
  data.gathered = data.mesh.add_property_map<Vertex, bool>("v:gathered", false).first;
  data.blocks.resize((data.mesh.number_of_vertices() + PointsOfBlock - 1) / PointsOfBlock);
}

CGALPipeline::~CGALPipeline() = default;

Times CGALPipeline::Fit(const std::function<void()>& between)
{
  return this->FitSome(1, between);
}

Times CGALPipeline::FitSome(int everyBlock, const std::function<void()>& between)
{
  Data& data = *this->Members;
  const std::size_t count = data.mesh.number_of_vertices();
  const auto step = static_cast<std::size_t>(everyBlock);
  const std::size_t blocksInTurn = step * ((data.blocks.size() / step + 9) / 10);
  Times sum;
  std::size_t fitted = 0;
  for (std::size_t block = 0; block < data.blocks.size(); block += step)
  {
    if (between && block % blocksInTurn == 0)
    {
      between();
    }
    const std::size_t begin = block * PointsOfBlock;
    const std::size_t end = std::min(begin + PointsOfBlock, count);
    data.blocks[block].Time(
      [&]
      {
        for (std::size_t p = begin; p < end; ++p)
        {
          data.Fit(Vertex(static_cast<Mesh::size_type>(p)));
        }
      });
    sum = sum + data.blocks[block].Get();
    fitted += end - begin;
  }
  const double scale = static_cast<double>(count) / static_cast<double>(fitted);
  return { scale * sum.wall, scale * sum.thread };
}

std::size_t CGALPipeline::ExtractRidges() const
{
  const Data& data = *this->Members;
  CGAL::Ridge_approximation<Mesh, Scalars, Vectors> ridges(
    data.mesh, data.k1, data.k2, data.b0, data.b3, data.d1, data.d2, data.P1, data.P2);
  std::vector<CGAL::Ridge_line<Mesh>*> lines;
  ridges.compute_max_ridges(std::back_inserter(lines), CGAL::Ridge_order_4);
  ridges.compute_min_ridges(std::back_inserter(lines), CGAL::Ridge_order_4);
  for (const auto* line : lines)
  {
    delete line;
  }
  return lines.size();
}

std::size_t CGALPipeline::DetectUmbilics(double patchSize) const
{
  const Data& data = *this->Members;
  CGAL::Umbilic_approximation<Mesh, Scalars, Vectors> detector(
    data.mesh, data.k1, data.k2, data.d1, data.d2);
  std::vector<CGAL::Umbilic<Mesh>*> umbilics;
  detector.compute(std::back_inserter(umbilics), patchSize);
  for (const auto* umbilic : umbilics)
  {
    delete umbilic;
  }
  return umbilics.size();
}

} // namespace benchmarks
