// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkUmbilicDetection.h"

#include "Core/Mesh/BorderStrip.h"
#include "Core/Umbilics/GapMinima.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesCollect.h"
#include "vtkRidgesGhosts.h"
#include "vtkRidgesIndexSearch.h"
#include "vtkRidgesMongeInput.h"
#include "vtkRidgesMonitor.h"
#include "vtkRidgesPerThread.h"
#include "vtkRidgesRequest.h"
#include "vtkRidgesUmbilicOutput.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkUmbilicDetection);

namespace
{

bool IsClosed(const ridges::TriangleMesh& mesh)
{
  if (mesh.Part())
  {
    return mesh.Part()->isClosed;
  }
  for (ridges::Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    if (mesh.EdgeAt(e).t1 < 0)
    {
      return false;
    }
  }
  return true;
}

/// By the index of every triangle. False if the user aborted the filter.
bool FindByIndices(
  vtkUmbilicDetection* filter, const vtkRidgesMongeInput& monge, vtkRidgesUmbilicOutput& found)
{
  const ridges::TriangleMesh& mesh = monge.mesh.GetTriangles();
  vtkRidgesIndexSearch search(mesh, monge, filter->GetSignificance());
  if (!search.Run(filter, false, 0.1, 0.5))
  {
    return false;
  }
  if (search.HalfTurns() == 2 * found.eulerCharacteristic || !IsClosed(mesh))
  {
    return search.Gather(filter, filter->GetPatchSize(), 0.5, 1.0, found);
  }
  if (mesh.Part())
  {
    mesh.Part()->Want(ridges::MeshPart::Wants::All);
    return true;
  }
  // The theorem is about oriented surfaces, and the test that spares most triangles is a rule of
  // thumb.
  const ridges::TriangleMesh oriented = mesh.ConsistentlyOriented();
  vtkRidgesIndexSearch certain(oriented, monge, filter->GetSignificance());
  return certain.Run(filter, true, 0.5, 0.7) &&
    certain.Gather(filter, filter->GetPatchSize(), 0.7, 1.0, found);
}

/// By the minima of k1 - k2. False if the user aborted the filter.
bool FindMinima(
  vtkUmbilicDetection* filter, const vtkRidgesMongeInput& monge, vtkRidgesUmbilicOutput& found)
{
  const ridges::TriangleMesh& mesh = monge.mesh.GetTriangles();
  const ridges::MongeField& field = monge.arrays.GetField();
  std::vector<ridges::Id> smallestAround(mesh.NumberOfPoints(), -1);
  const auto findSmallest = [&mesh, &field, &smallestAround](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType p = begin; p < end; ++p)
    {
      smallestAround[p] = ridges::SmallestGapAround(mesh, field, static_cast<ridges::Id>(p));
    }
  };
  if (!vtkRidgesForBatches(filter, mesh.NumberOfPoints(), 0.1, 0.4, findSmallest))
  {
    return false;
  }
  std::vector<ridges::Id> candidates = vtkRidgesWhere(mesh.NumberOfTriangles(),
    [&mesh, &smallestAround](ridges::Id t)
    { return ridges::MinimizesGapInOneRing(mesh, smallestAround, t); });
  const double patchSize = filter->GetPatchSize();
  std::vector<std::uint8_t> isSmallest(mesh.NumberOfTriangles(), 0);
  vtkRidgesPerThread<ridges::GapMinima> perThread;
  const auto compareInPatch = [&mesh, &field, &isSmallest, &candidates, &perThread, patchSize](
                                vtkIdType begin, vtkIdType end)
  {
    ridges::GapMinima& minima = perThread.Get([&mesh, &field, patchSize]
      { return std::make_shared<ridges::GapMinima>(mesh, field, patchSize); });
    for (vtkIdType i = begin; i < end; ++i)
    {
      isSmallest[candidates[i]] = minima.Minimizes(candidates[i]) ? 1 : 0;
    }
  };
  if (!vtkRidgesForBatches(
        filter, static_cast<vtkIdType>(candidates.size()), 0.4, 0.7, compareInPatch, 1 << 14))
  {
    return false;
  }
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                     [&isSmallest](ridges::Id t) { return isSmallest[t] == 0; }),
    candidates.end());
  found.umbilics = ridges::GapMinima(mesh, field, patchSize)
                     .Select(std::move(candidates), vtkRidgesMonitor(filter, 0.7, 1.0));
  return !vtkRidgesCompatibility::IsAborted(filter);
}

} // namespace

vtkUmbilicDetection::vtkUmbilicDetection()
{
  this->SetNumberOfOutputPorts(2);
  vtkRidgesChooseMongeArrays(this);
}

int vtkUmbilicDetection::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkRidgesRequestGhostLevels(inputVector[0], vtkRidgesGhostLevelsOf(this));
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

int vtkUmbilicDetection::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector[0]);
  if (!input)
  {
    return 0;
  }
  vtkPolyData* markedMesh = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* vertices = vtkPolyData::GetData(outputVector, 1);

  if (!vtkRidgesAreNumbers(
        this, { { "PatchSize", this->PatchSize }, { "Significance", this->Significance } }))
  {
    return 0;
  }
  const bool byIndices = this->Method == INDICES;
  vtkRidgesMongeInput monge;
  if (!monge.Fetch(this, input, false,
        byIndices ? vtkRidgesMongeInput::Unusable::Kept : vtkRidgesMongeInput::Unusable::LeftOut))
  {
    return 0;
  }
  monge.mesh.SetPart(this->GetPart());
  vtkRidgesUmbilicOutput found;
  found.eulerCharacteristic = monge.mesh.GetEulerCharacteristic();
  if (!(byIndices ? FindByIndices(this, monge, found) : FindMinima(this, monge, found)))
  {
    return 1;
  }
  const ridges::TriangleMesh& triangles = monge.mesh.GetTriangles();
  const std::vector<std::uint8_t> strip =
    ridges::BorderStrip(triangles, monge.arrays.GetErrors().fitScale);
  for (ridges::Umbilic& umbilic : found.umbilics)
  {
    umbilic.isNearBorder = ridges::IsInStrip(triangles, strip, umbilic.triangle);
  }
  found.MarkOnMesh(monge.mesh, markedMesh);
  found.StoreVertices(monge.mesh, vertices);
  return 1;
}

void vtkUmbilicDetection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << (this->Method == INDICES ? "Indices" : "Minima") << "\n";
  os << indent << "Significance: " << this->Significance << "\n";
  os << indent << "PatchSize: " << this->PatchSize << "\n";
}
