// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesFolds.h"

#include "vtkRidgesBatches.h"
#include "vtkRidgesPerThread.h"

#include <algorithm>
#include <memory>

namespace
{

struct Place
{
  const ridges::RidgeVertex* vertex;
  ridges::Fold* fold;
};

struct MeasureFolds
{
  const ridges::TriangleMesh& mesh;
  const ridges::MongeField& field;
  const ridges::FoldRule& rule;
  const std::vector<Place>& places;
  vtkRidgesPerThread<ridges::FoldMeter> perThread;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    ridges::FoldMeter& meter = this->perThread.Get(
      [this] { return std::make_shared<ridges::FoldMeter>(this->mesh, this->field, this->rule); });
    for (vtkIdType i = begin; i < end; ++i)
    {
      const ridges::RidgeVertex& vertex = *this->places[i].vertex;
      *this->places[i].fold = meter.Measure(vertex.point.color, vertex.edge, vertex.point.position);
    }
  }
};

bool IsCrestSomewhere(const ridges::RidgeTrace& ridge)
{
  for (std::size_t i = 0; i < ridge.types.size(); ++i)
  {
    if (ridge.IsCrest(static_cast<ridges::Id>(i)))
    {
      return true;
    }
  }
  return false;
}

/// Walks from a place have the more steps the finer the mesh is.
vtkIdType PlacesAtATime(const ridges::TriangleMesh& mesh, const ridges::FoldRule& rule)
{
  constexpr double steps = 1 << 18;
  constexpr double fewest = 1 << 8;
  constexpr double most = 1 << 14;
  const double stepsOfAPlace = rule.reach / mesh.MeanEdgeLength();
  return stepsOfAPlace > 0.0
    ? static_cast<vtkIdType>(std::clamp(steps / stepsOfAPlace, fewest, most))
    : static_cast<vtkIdType>(most);
}

} // namespace

bool vtkRidgesMeasureFolds(vtkAlgorithm* filter, double from, double to,
  const ridges::TriangleMesh& mesh, const ridges::MongeField& field, const ridges::FoldRule& rule,
  bool crestOnly, const std::vector<ridges::RidgeTrace>& ridges,
  std::vector<ridges::RidgeFolds>& folds)
{
  folds.resize(ridges.size());
  std::vector<Place> places;
  for (std::size_t i = 0; i < ridges.size(); ++i)
  {
    const ridges::RidgeTrace& ridge = ridges[i];
    folds[i].assign(ridge.vertices.size(), ridges::Fold());
    if (crestOnly && !IsCrestSomewhere(ridge))
    {
      continue;
    }
    for (std::size_t j = 0; j < ridge.vertices.size(); ++j)
    {
      const bool isElliptic = (j > 0 && ridges::IsElliptic(ridge.types[j - 1])) ||
        (j < ridge.types.size() && ridges::IsElliptic(ridge.types[j]));
      if (isElliptic && ridge.vertices[j].edge != ridges::RidgeVertex::None)
      {
        places.push_back({ &ridge.vertices[j], &folds[i][j] });
      }
    }
  }
  MeasureFolds measure{ mesh, field, rule, places, {} };
  return vtkRidgesForBatches(
    filter, static_cast<vtkIdType>(places.size()), from, to, measure, PlacesAtATime(mesh, rule));
}
