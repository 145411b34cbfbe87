// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkUmbilicDetection.h"

#include "Core/Umbilics/GapMinima.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesCollect.h"
#include "vtkRidgesGhosts.h"
#include "vtkRidgesIndexSearch.h"
#include "vtkRidgesMongeInput.h"
#include "vtkRidgesRequest.h"
#include "vtkRidgesUmbilicOutput.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkUmbilicDetection);

namespace
{

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

/// By the index of every triangle. False if the user aborted the filter.
bool FindByIndices(
  vtkUmbilicDetection* filter, const vtkRidgesMongeInput& monge, vtkRidgesUmbilicOutput& found)
{
  const ridges::TriangleMesh& mesh = monge.mesh.GetTriangles();
  vtkRidgesIndexSearch search(mesh, monge, filter->GetSignificance());
  if (!search.Run(filter, false, 0.1, 0.6))
  {
    return false;
  }
  if (search.HalfTurns() == 2 * found.eulerCharacteristic || !IsClosed(mesh))
  {
    search.Gather(filter->GetPatchSize(), found);
    return true;
  }
  // The theorem is about oriented surfaces, and the test that spares most triangles is a rule of
  // thumb.
  const ridges::TriangleMesh oriented = mesh.ConsistentlyOriented();
  vtkRidgesIndexSearch certain(oriented, monge, filter->GetSignificance());
  if (!certain.Run(filter, true, 0.6, 0.9))
  {
    return false;
  }
  certain.Gather(filter->GetPatchSize(), found);
  return true;
}

/// By the minima of k1 - k2. False if the user aborted the filter.
bool FindMinima(
  vtkUmbilicDetection* filter, const vtkRidgesMongeInput& monge, vtkRidgesUmbilicOutput& found)
{
  const ridges::TriangleMesh& mesh = monge.mesh.GetTriangles();
  const ridges::MongeField& field = monge.arrays.GetField();
  std::vector<std::uint8_t> isSmallest(mesh.NumberOfTriangles(), 0);
  const auto compareWithNeighbors = [&mesh, &field, &isSmallest](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType t = begin; t < end; ++t)
    {
      isSmallest[t] =
        ridges::MinimizesGapInOneRing(mesh, field, static_cast<ridges::Id>(t)) ? 1 : 0;
    }
  };
  if (!vtkRidgesForBatches(filter, mesh.NumberOfTriangles(), 0.1, 0.9, compareWithNeighbors))
  {
    return false;
  }
  std::vector<ridges::Id> candidates = vtkRidgesWhere(
    mesh.NumberOfTriangles(), [&isSmallest](ridges::Id t) { return isSmallest[t] != 0; });
  // Few are left, so that their patches can be grown on one thread.
  ridges::GapMinima minima(mesh, field, filter->GetPatchSize());
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                     [&minima](ridges::Id t) { return !minima.Minimizes(t); }),
    candidates.end());
  found.umbilics = minima.Select(std::move(candidates));
  return true;
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
  vtkRidgesUmbilicOutput found;
  found.eulerCharacteristic = monge.mesh.GetEulerCharacteristic();
  if (!(byIndices ? FindByIndices(this, monge, found) : FindMinima(this, monge, found)))
  {
    return 1;
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
