// SPDX-License-Identifier: BSD-3-Clause
#include "vtkUmbilicDetection.h"

#include "Core/DirectionIndex.h"
#include "Core/FitErrors.h"
#include "Core/IndexCharge.h"
#include "Core/UmbilicDetection.h"
#include "Core/UmbilicGathering.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesFitErrors.h"
#include "vtkRidgesMongeInput.h"
#include "vtkRidgesUmbilicOutput.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"

#include <cmath>
#include <memory>
#include <utility>

vtkStandardNewMacro(vtkUmbilicDetection);

namespace
{

struct FindCandidates
{
  FindCandidates(const ridges::TriangleMesh& mesh, const ridges::MongeField& field, double size)
    : Mesh(mesh)
    , Field(field)
    , PatchSize(size)
    , IsCandidate(mesh.NumberOfTriangles(), 0)
  {
  }

  void operator()(vtkIdType begin, vtkIdType end)
  {
    std::shared_ptr<ridges::UmbilicDetector>& detector = this->PerThread.Local();
    if (!detector)
    {
      detector =
        std::make_shared<ridges::UmbilicDetector>(this->Mesh, this->Field, this->PatchSize);
    }
    for (vtkIdType t = begin; t < end; ++t)
    {
      this->IsCandidate[t] = detector->Minimizes(static_cast<ridges::Id>(t)) ? 1 : 0;
    }
  }

  std::vector<ridges::Id> Collect() const
  {
    std::vector<ridges::Id> candidates;
    for (ridges::Id t = 0; t < this->Mesh.NumberOfTriangles(); ++t)
    {
      if (this->IsCandidate[t])
      {
        candidates.push_back(t);
      }
    }
    return candidates;
  }

private:
  const ridges::TriangleMesh& Mesh;
  const ridges::MongeField& Field;
  double PatchSize;
  std::vector<std::uint8_t> IsCandidate;
  // Shared, as vtkSMPThreadLocal copies the (empty) value it starts from.
  vtkSMPThreadLocal<std::shared_ptr<ridges::UmbilicDetector>> PerThread;
};

/// What is asked of every point first: whether it is tame, and the error of k1 - k2.
struct LookAtPoints
{
  LookAtPoints(const ridges::TriangleMesh& mesh, const ridges::DirectionIndex& index,
    const ridges::FitErrorSource& errors)
    : Mesh(mesh)
    , Index(index)
    , Errors(errors)
    , IsTame(mesh.NumberOfPoints(), 0)
    , GapErrors(mesh.NumberOfPoints(), 0.0)
  {
  }

  void operator()(vtkIdType begin, vtkIdType end)
  {
    for (auto p = static_cast<ridges::Id>(begin); p < static_cast<ridges::Id>(end); ++p)
    {
      this->IsTame[p] = this->Index.IsTame(p) ? 1 : 0;
      this->GapErrors[p] = ridges::GapError(this->Mesh, this->Errors, p);
    }
  }

  const ridges::TriangleMesh& Mesh;
  const ridges::DirectionIndex& Index;
  const ridges::FitErrorSource& Errors;
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

int SumOf(const std::vector<ridges::IndexCharge>& charges)
{
  int sum = 0;
  for (const ridges::IndexCharge& charge : charges)
  {
    sum += charge.halfTurns;
  }
  return sum;
}

bool IsClosed(const ridges::TriangleMesh& mesh)
{
  for (ridges::Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    if (mesh.EdgeAt(e).t1 < 0)
    {
      return false;
    }
  }
  return true;
}

} // namespace

vtkUmbilicDetection::vtkUmbilicDetection()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkUmbilicDetection::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* markedMesh = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* vertices = vtkPolyData::GetData(outputVector, 1);

  if (std::isnan(this->PatchSize) || std::isnan(this->Significance))
  {
    vtkErrorMacro(<< (std::isnan(this->PatchSize) ? "PatchSize" : "Significance")
                  << " is not a number.");
    return 0;
  }
  const bool byIndices = this->Method == INDICES;
  vtkRidgesMongeInput monge;
  if (!monge.Fetch(this, input, false,
        byIndices ? vtkRidgesMongeInput::Unusable::Kept : vtkRidgesMongeInput::Unusable::LeftOut))
  {
    return 0;
  }
  vtkRidgesUmbilicOutput found;
  if (!(byIndices ? this->FindByIndices(monge, found) : this->FindMinima(monge, found)))
  {
    return 1;
  }
  found.MarkOnMesh(monge.mesh, markedMesh);
  found.StoreVertices(monge.mesh, vertices);
  return 1;
}

bool vtkUmbilicDetection::FindByIndices(vtkRidgesMongeInput& monge, vtkRidgesUmbilicOutput& found)
{
  const ridges::TriangleMesh& mesh = monge.mesh.GetTriangles();
  const ridges::MongeField& field = monge.arrays.GetField();
  const std::uint8_t* usable = monge.arrays.GetUsable().data();
  const ridges::DirectionIndex index(mesh, field, usable);
  const ridges::FitErrorSource errors = vtkRidgesFetchFitErrors(monge.mesh.GetPolyData());
  LookAtPoints points(mesh, index, errors);
  LookAtTriangles triangles(field, points, this->Significance);
  if (!vtkRidgesForBatches(this, mesh.NumberOfPoints(), 0.1, 0.4, points) ||
    !vtkRidgesForBatches(this, mesh.NumberOfTriangles(), 0.4, 0.6, triangles))
  {
    return false;
  }
  std::vector<ridges::IndexCharge> charges = triangles.Collect();
  if (SumOf(charges) != 2 * mesh.EulerCharacteristic() && IsClosed(mesh))
  {
    // The theorem is about oriented surfaces, and the test that spares most triangles is a rule of
    // thumb.
    monge.mesh.OrientConsistently();
    triangles.All = true;
    if (!vtkRidgesForBatches(this, mesh.NumberOfTriangles(), 0.6, 0.7, triangles))
    {
      return false;
    }
    charges = triangles.Collect();
  }
  ridges::SpreadLargeCharges(mesh, charges);
  ridges::UmbilicGathering gathering(mesh, field, std::move(charges), triangles.IsWeak, usable);
  this->UpdateProgress(0.8);
  found.umbilics = gathering.Umbilics(this->PatchSize);
  found.cancelled = gathering.CancelledRegions();
  found.zones = ridges::WeakZones(mesh, triangles.IsWeak);
  return true;
}

bool vtkUmbilicDetection::FindMinima(
  const vtkRidgesMongeInput& monge, vtkRidgesUmbilicOutput& found)
{
  const ridges::TriangleMesh& mesh = monge.mesh.GetTriangles();
  const ridges::MongeField& field = monge.arrays.GetField();
  FindCandidates findCandidates(mesh, field, this->PatchSize);
  if (!vtkRidgesForBatches(this, mesh.NumberOfTriangles(), 0.1, 0.9, findCandidates))
  {
    return false;
  }
  ridges::UmbilicDetector detector(mesh, field, this->PatchSize);
  found.umbilics = detector.Select(findCandidates.Collect());
  return true;
}

void vtkUmbilicDetection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << (this->Method == INDICES ? "Indices" : "Minima") << "\n";
  os << indent << "Significance: " << this->Significance << "\n";
  os << indent << "PatchSize: " << this->PatchSize << "\n";
}
