// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesIndexSearch.h"

#include "Core/Fit/FitErrors.h"
#include "Core/Mesh/CoordinateRounding.h"
#include "Core/Mesh/PositionOrder.h"
#include "Core/Monge/TamePoint.h"
#include "Core/Umbilics/DirectionIndex.h"
#include "Core/Umbilics/UmbilicGathering.h"
#include "Core/Umbilics/WeakZones.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesCollect.h"
#include "vtkRidgesMongeInput.h"
#include "vtkRidgesMonitor.h"
#include "vtkRidgesPerThread.h"
#include "vtkRidgesRangeLoop.h"
#include "vtkRidgesUmbilicOutput.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace
{

/// What is asked of every point first: whether it is tame, and the error of k1 - k2.
struct LookAtPoints
{
  LookAtPoints(const ridges::TriangleMesh& triangles, const ridges::MongeField& monge,
    const ridges::FitErrorSource& source, double level)
    : mesh(triangles)
    , field(monge)
    , errors(source)
    , significance(level)
    , isTame(triangles.NumberOfPoints(), 0)
    , gapErrors(triangles.NumberOfPoints(), 0.0)
  {
    this->errors.rounding = ridges::FindCoordinateRounding(triangles).Height();
  }

  void operator()(vtkIdType begin, vtkIdType end)
  {
    for (auto p = static_cast<ridges::Id>(begin); p < static_cast<ridges::Id>(end); ++p)
    {
      const bool tame = ridges::IsGentle(this->field, this->errors, p) ||
        ridges::IsTame(this->mesh, this->field, p);
      this->isTame[p] = tame ? 1 : 0;
      if (ridges::MayBeWeak(this->field, this->errors, this->significance, p))
      {
        this->gapErrors[p] = ridges::GapError(this->mesh, this->errors, p);
      }
    }
  }

  const ridges::TriangleMesh& mesh;
  const ridges::MongeField& field;
  ridges::FitErrorSource errors;
  double significance;
  std::vector<std::uint8_t> isTame;
  std::vector<double> gapErrors;
};

/// The index of every triangle that has directions, and whether it is weak.
struct LookAtTriangles
{
  LookAtTriangles(const ridges::MongeField& monge, const ridges::DirectionIndex& indices,
    const LookAtPoints& ofPoints, double level)
    : field(monge)
    , index(indices)
    , points(ofPoints)
    , significance(level)
    , halfTurns(ofPoints.mesh.NumberOfTriangles(), 0)
    , isWeak(ofPoints.mesh.NumberOfTriangles(), 0)
  {
  }

  void operator()(vtkIdType begin, vtkIdType end)
  {
    ridges::DirectionFans::Memory& fans =
      this->perThread.Get([] { return std::make_shared<ridges::DirectionFans::Memory>(); });
    for (auto t = static_cast<ridges::Id>(begin); t < static_cast<ridges::Id>(end); ++t)
    {
      if (!this->index.IsUsable(t))
      {
        continue;
      }
      const bool looks = this->all || this->index.MayTurn(t, this->points.isTame);
      this->halfTurns[t] = static_cast<std::int8_t>(looks ? this->index.HalfTurns(t, fans) : 0);
      this->isWeak[t] = ridges::IsWeak(this->points.mesh, this->field,
                          this->points.gapErrors.data(), this->significance, t)
        ? 1
        : 0;
    }
  }

  std::vector<ridges::IndexCharge> Collect() const
  {
    std::vector<ridges::IndexCharge> charges;
    for (const ridges::Id t : vtkRidgesWhere(this->points.mesh.NumberOfTriangles(),
           [this](ridges::Id i) { return this->halfTurns[i] != 0; }))
    {
      charges.push_back({ t, this->halfTurns[t] });
    }
    const auto more = ridges::ChargesOfUnusable(this->points.mesh, this->index);
    charges.insert(charges.end(), more.begin(), more.end());
    return charges;
  }

  const ridges::MongeField& field;
  const ridges::DirectionIndex& index;
  const LookAtPoints& points;
  double significance;
  bool all = false; ///< Whether to trust no cheap test.
  std::vector<std::int8_t> halfTurns;
  std::vector<std::uint8_t> isWeak;
  vtkRidgesPerThread<ridges::DirectionFans::Memory> perThread;
};

} // namespace

vtkRidgesIndexSearch::vtkRidgesIndexSearch(
  const ridges::TriangleMesh& mesh, const vtkRidgesMongeInput& monge, double significance)
  : Mesh(mesh)
  , Monge(monge)
  , Significance(significance)
{
  // With none to be left out, no triangle has to be asked for its points.
  const std::vector<std::uint8_t>& usable = monge.arrays.GetUsable();
  const bool all = std::find(usable.begin(), usable.end(), 0) == usable.end();
  this->Usable = all ? nullptr : usable.data();
}

bool vtkRidgesIndexSearch::Run(vtkAlgorithm* filter, bool all, double from, double to)
{
  const ridges::MongeField& field = this->Monge.arrays.GetField();
  const ridges::DirectionIndex index(this->Mesh, field, this->Usable);
  const ridges::FitErrorSource& errors = this->Monge.arrays.GetErrors();
  LookAtPoints points(this->Mesh, field, errors, this->Significance);
  LookAtTriangles triangles(field, index, points, this->Significance);
  triangles.all = all;
  const double middle = 0.5 * (from + to);
  if (!vtkRidgesForBatches(filter, this->Mesh.NumberOfPoints(), from, middle, points) ||
    !vtkRidgesForBatches(filter, this->Mesh.NumberOfTriangles(), middle, to, triangles))
  {
    return false;
  }
  this->Charges = triangles.Collect();
  this->IsWeak = std::move(triangles.isWeak);
  return true;
}

int vtkRidgesIndexSearch::HalfTurns() const
{
  return ridges::SumOf(this->Charges);
}

bool vtkRidgesIndexSearch::Gather(
  vtkAlgorithm* filter, double patchSize, double from, double to, vtkRidgesUmbilicOutput& found)
{
  ridges::SpreadLargeCharges(this->Mesh, this->Charges);
  const double middle = 0.5 * (from + to);
  ridges::UmbilicGathering gathering(this->Mesh, this->Monge.arrays.GetField(), this->Charges,
    this->IsWeak, this->Usable, vtkRidgesRangeLoop, vtkRidgesMonitor(filter, from, middle));
  if (vtkRidgesCompatibility::IsAborted(filter))
  {
    return false;
  }
  found.umbilics = gathering.Umbilics(patchSize, vtkRidgesAbortableLoop(filter, middle, to));
  if (vtkRidgesCompatibility::IsAborted(filter))
  {
    return false;
  }
  found.cancelled = gathering.CancelledRegions();
  found.zones = ridges::WeakZones(this->Mesh, this->IsWeak);
  ridges::SortByPosition(this->Mesh, found.zones);
  return true;
}
