// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesSharedInput.h"

#include "Core/Base/RankGathering.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace
{

std::string Describe(const char* kind, vtkDataSetAttributes* data)
{
  std::vector<std::string> lines;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    // Those of some pieces may have ghosts, and those of others none.
    if (name != vtkDataSetAttributes::GhostArrayName())
    {
      std::ostringstream text;
      text << name << " (" << kind << ", " << array->GetNumberOfComponents() << " x "
           << array->GetDataTypeAsString() << ")";
      lines.push_back(text.str());
    }
  }
  std::sort(lines.begin(), lines.end());
  std::string all;
  for (const std::string& line : lines)
  {
    all += (all.empty() ? "" : ", ") + line;
  }
  return all;
}

/// What two ranks have that is not the same; empty if all have the same. Those without any say do
/// not count.
std::string Difference(ridges::Ranks& ranks, const std::string& text, bool hasSay, const char* what)
{
  const std::vector<char> says = ridges::GatherAllOne<char>(ranks, hasSay ? 1 : 0);
  const std::vector<std::string> texts = ridges::GatherAllTexts(ranks, text);
  const auto textOf = [&texts](std::size_t rank) {
    return "rank " + std::to_string(rank) + " has " + (texts[rank].empty() ? "none" : texts[rank]);
  };
  std::size_t first = texts.size();
  for (std::size_t rank = 0; rank < texts.size(); ++rank)
  {
    if (says[rank] == 0)
    {
      continue;
    }
    first = std::min(first, rank);
    if (texts[rank] != texts[first])
    {
      return std::string(what) + " differ between ranks: " + textOf(first) + "; " + textOf(rank);
    }
  }
  return {};
}

} // namespace

vtkPolyData* vtkRidgesGetPiece(
  const ridges::Ranks& ranks, vtkInformationVector* input, std::string& faults)
{
  faults = ranks.Fault();
  vtkDataObject* object = input->GetNumberOfInformationObjects() > 0 && faults.empty()
    ? vtkDataObject::GetData(input)
    : nullptr;
  auto* piece = vtkPolyData::SafeDownCast(object);
  if (!piece && faults.empty())
  {
    faults = object
      ? "the piece is a " + std::string(object->GetClassName()) + ", not a vtkPolyData"
      : "there is no piece";
  }
  return piece;
}

bool vtkRidgesAgree(vtkAlgorithm* filter, ridges::Ranks& ranks, const std::string& faults)
{
  const std::string text = ridges::TextOfRanks(ranks, faults);
  if (!text.empty())
  {
    vtkErrorWithObjectMacro(filter, "The mesh cannot be used: " << text << ".");
  }
  return text.empty();
}

bool vtkRidgesAgree(vtkAlgorithm* filter, ridges::Ranks& ranks, vtkPolyData* piece,
  const std::string& properties, const std::string& faults)
{
  if (!vtkRidgesAgree(filter, ranks, faults))
  {
    return false;
  }
  std::string difference = Difference(ranks, properties, true, "the properties of the filter");
  if (difference.empty())
  {
    difference = Difference(
      ranks, vtkRidgesDescribeArrays(piece), piece->GetNumberOfPoints() > 0, "the arrays");
  }
  return vtkRidgesAgree(filter, ranks, difference);
}

std::string vtkRidgesDescribeArrays(vtkPolyData* piece)
{
  const std::string points = Describe("points", piece->GetPointData());
  const std::string cells = Describe("cells", piece->GetCellData());
  return points + (points.empty() || cells.empty() ? "" : ", ") + cells;
}
