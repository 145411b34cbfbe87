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

#include <algorithm>
#include <array>
#include <numeric>
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

/// A value of lines and the least that is kept.
struct Measure
{
  const char* name;
  double minimum;
  const double* values = nullptr; ///< Of the lines; null where nothing depends on them.
};

/// Lines that are kept or left out as one: each for itself, or those of one ridge.
class LineGroups
{
public:
  /// Each line for itself, or by the id of its ridge.
  LineGroups(vtkIdType lines, const vtkIdType* ridgeIds)
    : GroupOf(static_cast<std::size_t>(lines))
  {
    std::iota(this->GroupOf.begin(), this->GroupOf.end(), 0);
    if (ridgeIds)
    {
      std::vector<vtkIdType> ids(ridgeIds, ridgeIds + lines);
      std::sort(ids.begin(), ids.end());
      ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
      std::transform(ridgeIds, ridgeIds + lines, this->GroupOf.begin(),
        [&ids](vtkIdType id)
        { return std::lower_bound(ids.begin(), ids.end(), id) - ids.begin(); });
    }
  }

  /// The sum over the lines of each group that are wanted, in their order.
  std::vector<double> Sums(const std::vector<bool>& isWanted, const double* values) const
  {
    std::vector<double> sums(this->GroupOf.size(), 0.0);
    for (std::size_t line = 0; line < this->GroupOf.size(); ++line)
    {
      sums[this->GroupOf[line]] += isWanted[line] ? values[line] : 0.0;
    }
    return sums;
  }

  /// Takes the wish back for lines whose group is not kept.
  void Restrict(std::vector<bool>& isWanted, const std::vector<bool>& isKept) const
  {
    for (std::size_t line = 0; line < this->GroupOf.size(); ++line)
    {
      isWanted[line] = isWanted[line] && isKept[this->GroupOf[line]];
    }
  }

  /// Keeps the groups of the lines wanted with the greatest sums, of equal ones those whose first
  /// line comes first.
  void KeepGreatest(std::vector<bool>& isWanted, const double* values, std::size_t number) const
  {
    const std::vector<double> sums = this->Sums(isWanted, values);
    std::vector<std::size_t> order;
    std::vector<bool> isListed(this->GroupOf.size(), false);
    for (std::size_t line = 0; line < this->GroupOf.size(); ++line)
    {
      const std::size_t group = this->GroupOf[line];
      if (isWanted[line] && !isListed[group])
      {
        isListed[group] = true;
        order.push_back(group);
      }
    }
    std::stable_sort(order.begin(), order.end(),
      [&sums](std::size_t a, std::size_t b) { return sums[a] > sums[b]; });
    std::vector<bool> isKept(this->GroupOf.size(), false);
    for (std::size_t i = 0; i < std::min(number, order.size()); ++i)
    {
      isKept[order[i]] = true;
    }
    this->Restrict(isWanted, isKept);
  }

private:
  std::vector<std::size_t> GroupOf;
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
  const vtkIdType* ridgeIds =
    this->WholeRidges ? reader.Ids(cells, names::RidgeId, 0, VTK_ID_MAX) : nullptr;
  std::array<Measure, 3> measures{ { { names::Sharpness, this->MinimumSharpness },
    { names::Strength, this->MinimumStrength }, { names::Length, this->MinimumLength } } };
  const Measure& rank = measures[this->RankBy];
  for (Measure& measure : measures)
  {
    if (measure.minimum > 0.0 || (this->MaximumNumber > 0 && &measure == &rank))
    {
      measure.values = reader.FiniteDoubles(cells, measure.name);
    }
  }
  reader.CheckLines(input);
  const std::string faults = reader.GetFaults();
  if (!faults.empty())
  {
    vtkErrorMacro("The input is not an output of vtkRidgeExtraction: " << faults << ".");
    return 0;
  }

  const vtkIdType lines = input->GetNumberOfLines();
  const vtkIdType first = input->GetNumberOfVerts(); // lines come behind verts among the cells
  std::vector<bool> isWanted(static_cast<std::size_t>(lines));
  for (vtkIdType line = 0; line < lines; ++line)
  {
    isWanted[line] =
      this->KeepsType(static_cast<int>(type[first + line])) && (!crest || crest[first + line] != 0);
  }
  const LineGroups groups(lines, ridgeIds ? ridgeIds + first : nullptr);
  const std::vector<bool> isOfType = isWanted;
  for (const Measure& measure : measures)
  {
    if (measure.minimum > 0.0)
    {
      const std::vector<double> sums = groups.Sums(isOfType, measure.values + first);
      std::vector<bool> isKept(sums.size());
      std::transform(sums.begin(), sums.end(), isKept.begin(),
        [&measure](double sum) { return sum >= measure.minimum; });
      groups.Restrict(isWanted, isKept);
    }
  }
  if (this->MaximumNumber > 0)
  {
    groups.KeepGreatest(
      isWanted, rank.values + first, static_cast<std::size_t>(this->MaximumNumber));
  }
  LineCopier copier(input, output);
  for (vtkIdType line = 0; line < lines; ++line)
  {
    if (isWanted[line])
    {
      copier.Copy(line, first + line);
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
  os << indent << "WholeRidges: " << onOff(this->WholeRidges);
  os << indent << "MaximumNumber: " << this->MaximumNumber << "\n";
  os << indent << "RankBy: " << this->RankBy << "\n";
}
