// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/RingGraph.h"

#include "Salience/LinearWeights.h"

#include <algorithm>

namespace ridges
{

RingGraph::RingGraph(const OneRings& rings, const std::vector<Id>& points)
{
  std::vector<Id> cells(points.size());
  std::size_t size = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    cells[points[i]] = static_cast<Id>(i);
    size += static_cast<std::size_t>(rings.Around(points[i]).size());
  }
  this->begins.reserve(points.size() + 1);
  this->neighbors.reserve(size);
  this->areas.reserve(points.size());
  this->positions.reserve(points.size());
  for (const Id p : points)
  {
    this->begins.push_back(static_cast<Id>(this->neighbors.size()));
    for (const Id q : rings.Around(p))
    {
      this->neighbors.push_back(cells[q]);
    }
    this->areas.push_back(rings.Area(p));
    this->positions.emplace_back(rings.Mesh().Point(p));
  }
  this->begins.push_back(static_cast<Id>(this->neighbors.size()));
}

double RingGraph::Variance(Id cell) const
{
  const Eigen::Vector3d& center = this->positions[cell];
  double weights = this->areas[cell];
  double sum = 0.0;
  for (Id i = this->begins[cell]; i < this->begins[cell + 1]; ++i)
  {
    const Id other = this->neighbors[i];
    const double weight = this->Factor(i) * this->areas[other];
    weights += weight;
    sum += weight * (this->positions[other] - center).squaredNorm();
  }
  return weights > 0.0 ? 0.5 * sum / weights : 0.0;
}

void RingGraph::SetNormals(
  const OneRings& rings, const std::vector<Id>& points, const RangeLoop& loop)
{
  this->normals.resize(points.size());
  loop(this->NumberOfCells(),
    [this, &rings, &points](Id begin, Id end)
    {
      for (Id cell = begin; cell < end; ++cell)
      {
        this->normals[cell].setZero();
        if (rings.IsClosed(points[cell]))
        {
          this->normals[cell] = rings.AreaNormal(points[cell]).normalized();
        }
      }
    });
}

void RingGraph::SetFactors(const RangeLoop& loop)
{
  this->factors.resize(this->neighbors.size());
  loop(this->NumberOfCells(),
    [this](Id begin, Id end)
    {
      for (Id cell = begin; cell < end; ++cell)
      {
        this->SetFactorsAround(cell);
      }
    });
}

void RingGraph::SetReaches()
{
  // So that cells beyond the neighbours would hardly count.
  constexpr double perSquare = 1.96;
  this->reaches.reserve(this->areas.size());
  for (Id cell = 0; cell < this->NumberOfCells(); ++cell)
  {
    double sum = 0.0;
    for (const Id other : this->Around(cell))
    {
      sum += (this->positions[other] - this->positions[cell]).squaredNorm();
    }
    this->reaches.push_back(perSquare * sum / std::max<Id>(1, this->Around(cell).size()));
  }
}

void RingGraph::SetFactorsAround(Id cell)
{
  // No weight may be negative, and so none be taken away by more than this.
  constexpr double mostTaken = 0.9;
  const Eigen::Vector3d& center = this->positions[cell];
  LinearWeights weights(this->normals[cell]);
  for (const Id other : this->Around(cell))
  {
    weights.Add(this->areas[other], this->positions[other] - center);
  }
  weights.Solve();
  double least = 0.0;
  for (Id i = this->begins[cell]; i < this->begins[cell + 1]; ++i)
  {
    const double slope = weights.Slope(this->positions[this->neighbors[i]] - center);
    this->factors[i] = static_cast<float>(slope);
    least = std::min(least, slope);
  }
  const double part = least < -mostTaken ? -mostTaken / least : 1.0;
  for (Id i = this->begins[cell]; i < this->begins[cell + 1]; ++i)
  {
    this->factors[i] = static_cast<float>(1.0 + part * this->factors[i]);
  }
}

} // namespace ridges
