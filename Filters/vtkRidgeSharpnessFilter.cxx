// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgeSharpnessFilter.h"

#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesArrayReader.h"
#include "vtkRidgesRequest.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <string>
#include <vector>

namespace names = vtkRidgesArrayNames;

vtkStandardNewMacro(vtkRidgeSharpnessFilter);

namespace
{

/// Copies chosen lines of a data set with the points they use and all arrays.
class LineCopier
{
public:
  LineCopier(vtkPolyData* input, vtkPolyData* output)
    : Input(input)
    , Output(output)
    , NewIds(input->GetNumberOfPoints(), -1)
  {
    this->Points->SetDataType(input->GetPoints() ? input->GetPoints()->GetDataType() : VTK_DOUBLE);
    output->GetPointData()->CopyAllOn();
    output->GetPointData()->CopyAllocate(input->GetPointData());
    output->GetCellData()->CopyAllOn();
    output->GetCellData()->CopyAllocate(input->GetCellData());
    output->GetFieldData()->PassData(input->GetFieldData());
  }

  /// Line number `line` of the input, as `cell` among all its cells.
  void Copy(vtkIdType line, vtkIdType cell)
  {
    this->Input->GetLines()->GetCellAtId(line, this->Ids);
    for (vtkIdType i = 0; i < this->Ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType p = this->Ids->GetId(i);
      if (this->NewIds[p] < 0)
      {
        this->NewIds[p] = this->Points->InsertNextPoint(this->Input->GetPoint(p));
        this->Output->GetPointData()->CopyData(this->Input->GetPointData(), p, this->NewIds[p]);
      }
      this->Ids->SetId(i, this->NewIds[p]);
    }
    const vtkIdType copy = this->Lines->InsertNextCell(this->Ids);
    this->Output->GetCellData()->CopyData(this->Input->GetCellData(), cell, copy);
  }

  void Finish()
  {
    this->Output->SetPoints(this->Points);
    this->Output->SetLines(this->Lines);
    this->Output->GetPointData()->Squeeze();
    this->Output->GetCellData()->Squeeze();
  }

private:
  vtkPolyData* Input;
  vtkPolyData* Output;
  std::vector<vtkIdType> NewIds;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkIdList> Ids;
};

} // namespace

bool vtkRidgeSharpnessFilter::KeepsType(int type) const
{
  switch (type)
  {
    case vtkRidgeExtraction::MAXIMUM_ELLIPTIC:
      return this->KeepMaximumElliptic;
    case vtkRidgeExtraction::MAXIMUM_HYPERBOLIC:
      return this->KeepMaximumHyperbolic;
    case vtkRidgeExtraction::MINIMUM_ELLIPTIC:
      return this->KeepMinimumElliptic;
    case vtkRidgeExtraction::MINIMUM_HYPERBOLIC:
      return this->KeepMinimumHyperbolic;
    default:
      return this->KeepUndecided;
  }
}

int vtkRidgeSharpnessFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector[0]);
  if (!input)
  {
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);

  if (!vtkRidgesAreNumbers(this,
        { { "MinimumSharpness", this->MinimumSharpness },
          { "MinimumStrength", this->MinimumStrength }, { "MinimumLength", this->MinimumLength } }))
  {
    return 0;
  }
  if (input->GetNumberOfCells() == 0)
  {
    return 1;
  }
  using Reader = vtkRidgesArrayReader;
  Reader reader;
  const Reader::Source cells{ input->GetCellData(), input->GetNumberOfCells(),
    "the cell data of the lines" };
  const vtkIdType* type = reader.Ids(cells, names::RidgeType, 0, 5);
  const vtkIdType* crest = this->CrestOnly ? reader.Ids(cells, names::Crest, 0, 2) : nullptr;
  struct Threshold
  {
    const char* name;
    double minimum;
    const double* values;
  };
  Threshold thresholds[] = { { names::Sharpness, this->MinimumSharpness, nullptr },
    { names::Strength, this->MinimumStrength, nullptr },
    { names::Length, this->MinimumLength, nullptr } };
  for (Threshold& threshold : thresholds)
  {
    if (threshold.minimum > 0.0)
    {
      threshold.values = reader.FiniteDoubles(cells, threshold.name);
    }
  }
  reader.CheckLines(input);
  const std::string faults = reader.GetFaults();
  if (!faults.empty())
  {
    vtkErrorMacro("The input is not an output of vtkRidgeExtraction: " << faults << ".");
    return 0;
  }

  LineCopier copier(input, output);
  for (vtkIdType line = 0; line < input->GetNumberOfLines(); ++line)
  {
    const vtkIdType cell = input->GetNumberOfVerts() + line;
    bool keeps = this->KeepsType(static_cast<int>(type[cell])) && (!crest || crest[cell] != 0);
    for (const Threshold& threshold : thresholds)
    {
      keeps = keeps && (!threshold.values || threshold.values[cell] >= threshold.minimum);
    }
    if (keeps)
    {
      copier.Copy(line, cell);
    }
  }
  copier.Finish();
  return 1;
}

void vtkRidgeSharpnessFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto onOff = [](bool flag) { return flag ? "On\n" : "Off\n"; };
  os << indent << "MinimumSharpness: " << this->MinimumSharpness << "\n";
  os << indent << "MinimumStrength: " << this->MinimumStrength << "\n";
  os << indent << "MinimumLength: " << this->MinimumLength << "\n";
  os << indent << "KeepMaximumElliptic: " << onOff(this->KeepMaximumElliptic);
  os << indent << "KeepMaximumHyperbolic: " << onOff(this->KeepMaximumHyperbolic);
  os << indent << "KeepMinimumElliptic: " << onOff(this->KeepMinimumElliptic);
  os << indent << "KeepMinimumHyperbolic: " << onOff(this->KeepMinimumHyperbolic);
  os << indent << "KeepUndecided: " << onOff(this->KeepUndecided);
  os << indent << "CrestOnly: " << onOff(this->CrestOnly);
}
