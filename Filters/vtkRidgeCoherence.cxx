// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgeCoherence.h"

#include "Core/Coherence/CheckCoherence.h"
#include "Core/Coherence/Severity.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesCheckText.h"
#include "vtkRidgesCompatibility.h"
#include "vtkRidgesMonitor.h"
#include "vtkRidgesPictureInput.h"
#include "vtkRidgesRequest.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <string>
#include <vector>

namespace names = vtkRidgesArrayNames;

vtkStandardNewMacro(vtkRidgeCoherence);

namespace
{

constexpr std::size_t MostOffendersTold = 20;

const char* KindName(ridges::OffenderKind kind)
{
  switch (kind)
  {
    case ridges::OffenderKind::Umbilic:
      return "umbilic";
    case ridges::OffenderKind::Ridge:
      return "ridge";
    case ridges::OffenderKind::RidgePoint:
      return "ridge point";
    case ridges::OffenderKind::Edge:
      return "edge";
    case ridges::OffenderKind::Triangle:
      break;
  }
  return "cell";
}

std::string OffenderText(const vtkRidgesMesh& mesh, const ridges::CoherenceCheck& check)
{
  std::string text;
  for (std::size_t i = 0; i < check.offenders.size() && i < MostOffendersTold; ++i)
  {
    const auto& ids = check.offenders[i].ids;
    text += text.empty() ? "" : ", ";
    text +=
      std::to_string(check.offenderKind == ridges::OffenderKind::Triangle ? mesh.GetCellId(ids[0])
                                                                          : vtkIdType{ ids[0] });
    text += check.offenderKind == ridges::OffenderKind::Edge ? "-" + std::to_string(ids[1]) : "";
  }
  return text + (check.offenders.size() > MostOffendersTold ? ", ..." : "");
}

template <typename Array>
vtkNew<Array> AddColumn(vtkTable* table, const char* name, int components = 1)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  table->AddColumn(array);
  return array;
}

void Store(const std::vector<ridges::CoherenceCheck>& checks, const ridges::RidgePicture& picture,
  const vtkRidgesMesh& mesh, vtkTable* output)
{
  vtkNew<vtkTable> table;
  auto check = AddColumn<vtkStringArray>(table, names::Check);
  auto section = AddColumn<vtkStringArray>(table, names::Section);
  auto expected = AddColumn<vtkStringArray>(table, names::Expected);
  auto found = AddColumn<vtkStringArray>(table, names::Found);
  auto applies = AddColumn<vtkIntArray>(table, names::Applies);
  auto passed = AddColumn<vtkIntArray>(table, names::Passed);
  auto severity = AddColumn<vtkIntArray>(table, names::Severity);
  auto numberOfOffenders = AddColumn<vtkIdTypeArray>(table, names::NumberOfOffenders);
  auto kind = AddColumn<vtkStringArray>(table, names::OffenderKind);
  auto offenders = AddColumn<vtkStringArray>(table, names::Offenders);
  auto position = AddColumn<vtkDoubleArray>(table, names::OffenderPosition, 3);
  for (const ridges::CoherenceCheck& row : checks)
  {
    const vtkRidgesCheckText text(row);
    check->InsertNextValue(text.name);
    section->InsertNextValue(text.section);
    expected->InsertNextValue(text.expected);
    found->InsertNextValue(text.found);
    applies->InsertNextValue(row.applies ? 1 : 0);
    passed->InsertNextValue(row.Passed() ? 1 : 0);
    severity->InsertNextValue(static_cast<int>(ridges::SeverityOf(row, picture)));
    numberOfOffenders->InsertNextValue(static_cast<vtkIdType>(row.offenders.size()));
    kind->InsertNextValue(KindName(row.offenderKind));
    offenders->InsertNextValue(OffenderText(mesh, row));
    const Eigen::Vector3d place =
      row.offenders.empty() ? Eigen::Vector3d::Zero() : row.offenders.front().position;
    position->InsertNextTuple(place.data());
  }
  output->ShallowCopy(table);
}

/// What is checked together: the inputs, or a block of each.
struct Surface
{
  vtkDataObject* mesh;
  vtkDataObject* ridges;
  vtkDataObject* umbilics; ///< Null: those of the mesh's field data.
};

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
  const std::vector<ridges::CoherenceCheck> checks =
    ridges::CheckCoherence(input.GetPicture(), filter->GetRightAngleCosine(), monitor);
  if (!checks.empty())
  {
    Store(checks, input.GetPicture(), input.GetMesh(), output);
  }
  return {};
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
