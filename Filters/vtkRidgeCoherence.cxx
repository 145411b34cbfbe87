// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgeCoherence.h"

#include "Core/Coherence/CheckCoherence.h"
#include "Core/Coherence/Severity.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesCheckText.h"
#include "vtkRidgesPictureInput.h"
#include "vtkRidgesRequest.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <string>

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

} // namespace

vtkRidgeCoherence::vtkRidgeCoherence()
{
  this->SetNumberOfInputPorts(3);
  vtkRidgesChooseMongeArrays(this);
}

int vtkRidgeCoherence::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
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
  vtkRidgesPictureInput input;
  const std::string faults = input.Fetch(this, vtkPolyData::GetData(inputVector[0]),
    vtkPolyData::GetData(inputVector[1]), vtkPolyData::GetData(inputVector[2]));
  if (!faults.empty())
  {
    vtkErrorMacro(
      "Arrays of vtkUmbilicDetection and vtkRidgeExtraction are missing: " << faults << ".");
    return 0;
  }
  this->UpdateProgress(0.2);
  Store(ridges::CheckCoherence(input.GetPicture(), this->RightAngleCosine), input.GetPicture(),
    input.GetMesh(), vtkTable::GetData(outputVector));
  return 1;
}

void vtkRidgeCoherence::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RightAngleCosine: " << this->RightAngleCosine << "\n";
}
