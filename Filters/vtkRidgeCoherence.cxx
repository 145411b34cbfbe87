// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgeCoherence.h"

#include "Core/Coherence/CheckCoherence.h"
#include "Core/Coherence/CoherenceCheck.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesCheckTable.h"
#include "vtkRidgesCompatibility.h"
#include "vtkRidgesMonitor.h"
#include "vtkRidgesPictureInput.h"
#include "vtkRidgesRequest.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <string>
#include <vector>

namespace names = vtkRidgesArrayNames;

vtkStandardNewMacro(vtkRidgeCoherence);

namespace
{

/// What is checked together: the inputs, or a block of each.
struct Surface
{
  vtkDataObject* mesh;
  vtkDataObject* ridges;
  vtkDataObject* umbilics; ///< Null: those of the mesh's field data.
};

/// Crossings of certified ridges are on the surface.
void LeaveOutPointsOnEdges(std::vector<ridges::CoherenceCheck>& checks)
{
  for (ridges::CoherenceCheck& check : checks)
  {
    if (check.kind == ridges::CheckKind::PointsOnEdges)
    {
      check.applies = false;
      check.offenders.clear();
    }
  }
}

/// Returns what is wrong with the inputs, as text. If nothing is, fills the output, unless the user
/// aborts the filter, whose progress runs from `from` to `to`.
std::string Check(
  vtkRidgeCoherence* filter, const Surface& surface, double from, double to, vtkTable* output)
{
  auto* mesh = vtkPolyData::SafeDownCast(surface.mesh);
  auto* lines = vtkPolyData::SafeDownCast(surface.ridges);
  auto* umbilics = vtkPolyData::SafeDownCast(surface.umbilics);
  if (!mesh || !lines || (surface.umbilics && !umbilics))
  {
    return "mesh, ridges and umbilics are not all of type vtkPolyData";
  }
  vtkRidgesPictureInput input;
  std::string faults = input.Fetch(filter, mesh, lines, umbilics);
  if (faults.empty() && input.GetMesh().HasDuplicates())
  {
    faults = "the mesh has duplicates of cells in other pieces (vtkGhostType); give whole surfaces";
  }
  if (!faults.empty())
  {
    return faults;
  }
  const double fetched = from + 0.2 * (to - from);
  const ridges::Monitor monitor = vtkRidgesMonitor(filter, fetched, to);
  if (!monitor(0.0))
  {
    return {};
  }
  std::vector<ridges::CoherenceCheck> checks =
    ridges::CheckCoherence(input.GetPicture(), filter->GetRightAngleCosine(), monitor);
  if (checks.empty())
  {
    return {};
  }
  if (mesh->GetCellData()->HasArray(names::Certificate))
  {
    LeaveOutPointsOnEdges(checks);
  }
  vtkRidgesCheckTable table(input.GetMesh());
  table.Add(checks, input.GetPicture());
  faults = table.AddCertificate();
  if (faults.empty())
  {
    table.Store(output);
  }
  return faults;
}

/// The same for each block of a composite mesh. Blocks without a fault are checked all the same.
std::string CheckBlocks(
  vtkRidgeCoherence* filter, const Surface& surface, vtkCompositeDataSet* output)
{
  auto* meshes = vtkCompositeDataSet::SafeDownCast(surface.mesh);
  auto* lines = vtkCompositeDataSet::SafeDownCast(surface.ridges);
  auto* umbilics = vtkCompositeDataSet::SafeDownCast(surface.umbilics);
  if (!lines || (surface.umbilics && !umbilics))
  {
    return "the mesh is a composite data set, but the ridges or the umbilics are not";
  }
  output->CopyStructure(meshes);
  std::string faults;
  const auto block = vtk::TakeSmartPointer(meshes->NewIterator());
  int count = 0;
  for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
  {
    ++count;
  }
  int done = 0;
  for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem(), ++done)
  {
    vtkNew<vtkTable> table;
    const Surface ofBlock{ block->GetCurrentDataObject(), lines->GetDataSet(block),
      umbilics ? umbilics->GetDataSet(block) : nullptr };
    const std::string faultsOfBlock = Check(filter, ofBlock, static_cast<double>(done) / count,
      static_cast<double>(done + 1) / count, table);
    if (faultsOfBlock.empty())
    {
      output->SetDataSet(block, table);
    }
    else
    {
      faults += (faults.empty() ? "block " : "; block ") +
        std::to_string(block->GetCurrentFlatIndex()) + ": " + faultsOfBlock;
    }
    if (vtkRidgesCompatibility::IsAborted(filter))
    {
      break;
    }
  }
  return faults;
}

} // namespace

vtkRidgeCoherence::vtkRidgeCoherence()
{
  this->SetNumberOfInputPorts(3);
  vtkRidgesChooseMongeArrays(this);
}

// VTK would run the filter on the blocks of one input only. That the mesh's port names composite
// data sets first stops it; the others name first what VTK's message about wrong types should.
int vtkRidgeCoherence::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkCompositeDataSet" : "vtkPolyData");
  info->Append(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkCompositeDataSet");
  if (port == 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkRidgeCoherence::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

vtkTypeBool vtkRidgeCoherence::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->RequestDataObject(inputVector[0], outputVector);
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

/// A table, or a composite data set like that of the mesh, for tables.
int vtkRidgeCoherence::RequestDataObject(
  vtkInformationVector* meshVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkDataObject* old = vtkDataObject::GetData(info);
  auto* composite = vtkCompositeDataSet::GetData(meshVector, 0);
  const char* type = composite ? composite->GetClassName() : "vtkTable";
  if (!old || std::string(old->GetClassName()) != type)
  {
    vtkSmartPointer<vtkDataObject> output;
    output.TakeReference(
      composite ? composite->NewInstance() : static_cast<vtkDataObject*>(vtkTable::New()));
    info->Set(vtkDataObject::DATA_OBJECT(), output);
  }
  return 1;
}

int vtkRidgeCoherence::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!vtkRidgesAreNumbers(this, { { "RightAngleCosine", this->RightAngleCosine } }))
  {
    return 0;
  }
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  const Surface surface{ vtkDataObject::GetData(inputVector[0]),
    vtkDataObject::GetData(inputVector[1]), vtkDataObject::GetData(inputVector[2]) };
  auto* blocks = vtkCompositeDataSet::SafeDownCast(output);
  const std::string faults = blocks
    ? CheckBlocks(this, surface, blocks)
    : Check(this, surface, 0.0, 1.0, vtkTable::SafeDownCast(output));
  if (!faults.empty())
  {
    vtkErrorMacro("The inputs are not outputs of vtkUmbilicDetection and vtkRidgeExtraction: "
      << faults << ".");
    output->Initialize();
    return 0;
  }
  if (vtkRidgesCompatibility::IsAborted(this))
  {
    output->Initialize(); // not the tables of some blocks
  }
  return 1;
}

void vtkRidgeCoherence::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RightAngleCosine: " << this->RightAngleCosine << "\n";
}
