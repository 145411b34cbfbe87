// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesIndexSearch.h"

#include "Core/DirectionIndex.h"
#include "Core/FitErrors.h"
#include "Core/UmbilicGathering.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesFitErrors.h"
#include "vtkRidgesMongeInput.h"
#include "vtkRidgesUmbilicOutput.h"

#include "vtkPolyData.h"

#include <utility>

namespace
{

/// What is asked of every point first: whether it is tame, and the error of k1 - k2.
struct LookAtPoints
{
  LookAtPoints(const ridges::TriangleMesh& mesh, const ridges::MongeField& field,
    const ridges::DirectionIndex& index, const ridges::FitErrorSource& errors, double significance)
    : Mesh(mesh)
    , Field(field)
    , Index(index)
    , Errors(errors)
    , Significance(significance)
    , IsTame(mesh.NumberOfPoints(), 0)
    , GapErrors(mesh.NumberOfPoints(), 0.0)
  {
  }

  void operator()(vtkIdType begin, vtkIdType end)
  {
    for (auto p = static_cast<ridges::Id>(begin); p < static_cast<ridges::Id>(end); ++p)
    {
      const bool tame = ridges::IsGentle(this->Field, this->Errors, p) || this->Index.IsTame(p);
      this->IsTame[p] = tame ? 1 : 0;
      if (ridges::MayBeWeak(this->Field, this->Errors, this->Significance, p))
      {
        this->GapErrors[p] = ridges::GapError(this->Mesh, this->Errors, p);
      }
    }
  }

  const ridges::TriangleMesh& Mesh;
  const ridges::MongeField& Field;
  const ridges::DirectionIndex& Index;
  const ridges::FitErrorSource& Errors;
  double Significance;
  std::vector<std::uint8_t> IsTame;
  std::vector<double> GapErrors;
};

/// The index of every triangle that has directions, and whether it is weak.
struct LookAtTriangles
{
  LookAtTriangles(const ridges::MongeField& field, const LookAtPoints& points, double significance)
    : Field(field)
    , Points(points)
    , Significance(significance)
    , HalfTurns(points.Mesh.NumberOfTriangles(), 0)
    , IsWeak(points.Mesh.NumberOfTriangles(), 0)
  {
  }

  void operator()(vtkIdType begin, vtkIdType end)
  {
    for (auto t = static_cast<ridges::Id>(begin); t < static_cast<ridges::Id>(end); ++t)
    {
      if (!this->Points.Index.IsUsable(t))
      {
        continue;
      }
      const bool looks = this->All || this->Points.Index.MayTurn(t, this->Points.IsTame);
      this->HalfTurns[t] = static_cast<std::int8_t>(looks ? this->Points.Index.HalfTurns(t) : 0);
      this->IsWeak[t] = ridges::IsWeak(this->Points.Mesh, this->Field,
                          this->Points.GapErrors.data(), this->Significance, t)
        ? 1
        : 0;
    }
  }

  std::vector<ridges::IndexCharge> Collect() const
  {
    std::vector<ridges::IndexCharge> charges;
    for (ridges::Id t = 0; t < this->Points.Mesh.NumberOfTriangles(); ++t)
    {
      if (this->HalfTurns[t] != 0)
      {
        charges.push_back({ t, this->HalfTurns[t] });
      }
    }
    const auto more = ridges::ChargesOfUnusable(this->Points.Mesh, this->Points.Index);
    charges.insert(charges.end(), more.begin(), more.end());
    return charges;
  }

  const ridges::MongeField& Field;
  const LookAtPoints& Points;
  double Significance;
  bool All = false; ///< Whether to trust no cheap test.
  std::vector<std::int8_t> HalfTurns;
  std::vector<std::uint8_t> IsWeak;
};

} // namespace

vtkRidgesIndexSearch::vtkRidgesIndexSearch(
  const ridges::TriangleMesh& mesh, const vtkRidgesMongeInput& monge, double significance)
  : Mesh(mesh)
  , Monge(monge)
  , Significance(significance)
{
}

bool vtkRidgesIndexSearch::Run(vtkAlgorithm* filter, bool all, double from, double to)
{
  const ridges::MongeField& field = this->Monge.arrays.GetField();
  const ridges::DirectionIndex index(this->Mesh, field, this->Monge.arrays.GetUsable().data());
  const ridges::FitErrorSource errors = vtkRidgesFetchFitErrors(this->Monge.mesh.GetPolyData());
  LookAtPoints points(this->Mesh, field, index, errors, this->Significance);
  LookAtTriangles triangles(field, points, this->Significance);
  triangles.All = all;
  const double middle = 0.5 * (from + to);
  if (!vtkRidgesForBatches(filter, this->Mesh.NumberOfPoints(), from, middle, points) ||
    !vtkRidgesForBatches(filter, this->Mesh.NumberOfTriangles(), middle, to, triangles))
  {
    return false;
  }
  this->Charges = triangles.Collect();
  this->IsWeak = std::move(triangles.IsWeak);
  return true;
}

int vtkRidgesIndexSearch::HalfTurns() const
{
  int sum = 0;
  for (const ridges::IndexCharge& charge : this->Charges)
  {
    sum += charge.halfTurns;
  }
  return sum;
}

void vtkRidgesIndexSearch::Gather(double patchSize, vtkRidgesUmbilicOutput& found)
{
  ridges::SpreadLargeCharges(this->Mesh, this->Charges);
  ridges::UmbilicGathering gathering(this->Mesh, this->Monge.arrays.GetField(),
    std::move(this->Charges), this->IsWeak, this->Monge.arrays.GetUsable().data());
  found.umbilics = gathering.Umbilics(patchSize);
  found.cancelled = gathering.CancelledRegions();
  found.zones = ridges::WeakZones(this->Mesh, this->IsWeak);
}
