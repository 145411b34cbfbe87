// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesGhosts.h"

#include "Core/Fit/JetSelection.h"

#include "vtkJetFitting.h"
#include "vtkRidgesArrayReader.h"
#include "vtkUmbilicDetection.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>

namespace
{

// A refined cell is covered by others: what shows the surface leaves it out, too.
constexpr int HiddenCell = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;

/// Empty where there are no flags, or all are 0.
std::vector<std::uint8_t> ReadFlags(
  vtkRidgesArrayReader& reader, const vtkRidgesArrayReader::Source& source)
{
  const vtkIdType* values = reader.Ids(source, vtkDataSetAttributes::GhostArrayName(), 0, 256,
    vtkRidgesArrayReader::Presence::Optional);
  std::vector<std::uint8_t> flags;
  if (values && std::any_of(values, values + source.tuples, [](vtkIdType v) { return v != 0; }))
  {
    flags.assign(values, values + source.tuples);
  }
  return flags;
}

bool HasBits(const std::vector<std::uint8_t>& flags, vtkIdType i, int bits)
{
  return !flags.empty() && (flags[static_cast<std::size_t>(i)] & bits) != 0;
}

bool AnyHasBits(const std::vector<std::uint8_t>& flags, int bits)
{
  return std::any_of(
    flags.begin(), flags.end(), [bits](std::uint8_t flag) { return (flag & bits) != 0; });
}

} // namespace

std::string vtkRidgesGhosts::Read(vtkPolyData* data)
{
  vtkRidgesArrayReader reader;
  this->CellFlags = ReadFlags(
    reader, { data->GetCellData(), data->GetNumberOfCells(), "the cell data of the mesh" });
  this->PointFlags = ReadFlags(
    reader, { data->GetPointData(), data->GetNumberOfPoints(), "the point data of the mesh" });
  this->AnyHidden = AnyHasBits(this->CellFlags, HiddenCell) ||
    AnyHasBits(this->PointFlags, vtkDataSetAttributes::HIDDENPOINT);
  this->AnyDuplicate = AnyHasBits(this->CellFlags, vtkDataSetAttributes::DUPLICATECELL);
  return reader.GetFaults();
}

bool vtkRidgesGhosts::IsHiddenCell(vtkIdType cell) const
{
  return HasBits(this->CellFlags, cell, HiddenCell);
}

bool vtkRidgesGhosts::IsDuplicateCell(vtkIdType cell) const
{
  return HasBits(this->CellFlags, cell, vtkDataSetAttributes::DUPLICATECELL);
}

bool vtkRidgesGhosts::IsHiddenPoint(vtkIdType point) const
{
  return HasBits(this->PointFlags, point, vtkDataSetAttributes::HIDDENPOINT);
}

// As many rings as a neighbourhood has: exactly, or in general. A radius may reach farther.
int vtkRidgesGhostLevelsOf(vtkJetFitting* filter)
{
  switch (filter->GetNeighborhood())
  {
    case vtkJetFitting::BY_RINGS:
      return filter->GetNumberOfRings();
    case vtkJetFitting::BY_POINT_COUNT:
      // n rings of a regular mesh have 3 n (n + 1) + 1 points; one more for irregular ones.
      return static_cast<int>(std::ceil(std::sqrt(filter->GetMinimumNumberOfPoints() / 3.0))) + 1;
    default:
      return ridges::JetSelection::MostRings + ridges::JetSelection::MostAverages;
  }
}

// A patch may grow to twice its size, which is counted in triangles, about.
int vtkRidgesGhostLevelsOf(vtkUmbilicDetection* filter)
{
  const double size = filter->GetPatchSize();
  return std::isnan(size) ? 0 : static_cast<int>(2.0 * size) + 1;
}

int vtkRidgesGhostLevelsOf(vtkRidgeExtraction*)
{
  return 1;
}

void vtkRidgesRequestGhostLevels(vtkInformationVector* input, int levels)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int i = 0; i < input->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* info = input->GetInformationObject(i);
    if (info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1)
    {
      const int asked = info->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
      info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), asked + levels);
    }
  }
}

void vtkRidgesWarnOfMissingGhosts(vtkAlgorithm* filter, vtkInformationVector* input)
{
  vtkInformation* info = input->GetInformationObject(0);
  vtkPolyData* data = vtkPolyData::GetData(info);
  if (info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()) > 1 && data &&
    data->GetNumberOfCells() > 0 &&
    !data->GetCellData()->HasArray(vtkDataSetAttributes::GhostArrayName()))
  {
    vtkWarningWithObjectMacro(filter,
      "The mesh is one of several pieces and has no ghost cells (vtkGhostType): points near the "
      "border of the piece are fitted like points on the border of the surface.");
  }
}
