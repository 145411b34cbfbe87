// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesCheckTable.h"

#include "Core/Certification/Hypothesis.h"
#include "Core/Coherence/Severity.h"
#include "vtkRidgesArrayReader.h"
#include "vtkRidgesCheckText.h"
#include "vtkRidgesHypotheses.h"
#include "vtkRidgesOffenderText.h"

#include "vtkCellData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>

namespace names = vtkRidgesArrayNames;
using ridges::Id;

namespace
{

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
  return vtkRidgesOffenderText(check.offenders.size(),
    [&mesh, &check](std::size_t i)
    {
      const auto& ids = check.offenders[i].ids;
      switch (check.offenderKind)
      {
        case ridges::OffenderKind::Triangle:
          return std::to_string(mesh.GetCellId(ids[0]));
        case ridges::OffenderKind::Edge:
          return std::to_string(ids[0]) + "-" + std::to_string(ids[1]);
        default:
          return std::to_string(ids[0]);
      }
    });
}

} // namespace

void vtkRidgesCheckTable::Add(
  const std::vector<ridges::CoherenceCheck>& checks, const ridges::RidgePicture& picture)
{
  for (const ridges::CoherenceCheck& check : checks)
  {
    const vtkRidgesCheckText text(check);
    Row row;
    row.name = text.name;
    row.section = text.section;
    row.expected = text.expected;
    row.found = text.found;
    row.applies = check.applies;
    row.severity = static_cast<int>(ridges::SeverityOf(check, picture));
    row.numberOfOffenders = static_cast<vtkIdType>(check.offenders.size());
    row.offenderKind = KindName(check.offenderKind);
    row.offenders = OffenderText(this->Mesh, check);
    if (!check.offenders.empty())
    {
      row.place = check.offenders.front().position;
    }
    this->Add(row);
  }
}

std::string vtkRidgesCheckTable::AddCertificate()
{
  vtkPolyData* mesh = this->Mesh.GetPolyData();
  vtkRidgesArrayReader reader;
  const vtkRidgesArrayReader::Source cells{ mesh->GetCellData(), mesh->GetNumberOfCells(),
    "the cell data of the mesh" };
  constexpr vtkIdType verdicts = 3;
  constexpr vtkIdType allBits = 1 << 16;
  constexpr auto optional = vtkRidgesArrayReader::Presence::Optional;
  const vtkIdType* verdict = reader.Ids(cells, names::Certificate, 0, verdicts, optional);
  const vtkIdType* failed = reader.Ids(cells, names::FailedHypotheses, 0, allBits, optional);
  if (!verdict || !failed)
  {
    return reader.GetFaults();
  }
  const ridges::TriangleMesh& triangles = this->Mesh.GetTriangles();
  int highest = 0; // that of all cells with a good verdict
  for (Id t = 0; t < triangles.NumberOfTriangles(); ++t)
  {
    highest = std::max(highest, static_cast<int>(verdict[this->Mesh.GetCellId(t)]));
  }
  for (const vtkRidgesHypothesis& hypothesis : vtkRidgesHypotheses())
  {
    std::vector<Id> offenders;
    bool isGeneric = true;
    for (Id t = 0; t < triangles.NumberOfTriangles(); ++t)
    {
      const auto bits = static_cast<std::uint16_t>(failed[this->Mesh.GetCellId(t)]);
      if ((bits & hypothesis.bit) != 0)
      {
        offenders.push_back(t);
        isGeneric = isGeneric && (bits & ridges::NotGeneric) == 0;
      }
    }
    Row row;
    row.name = std::string("hypothesis ") + hypothesis.name;
    row.section = hypothesis.section;
    row.expected = hypothesis.expected;
    row.found = highest == 2 ? "proved" : "checked";
    row.numberOfOffenders = static_cast<vtkIdType>(offenders.size());
    if (!offenders.empty())
    {
      row.found = "fails in " + std::to_string(offenders.size()) + " of " +
        std::to_string(triangles.NumberOfTriangles()) + " triangles" +
        (isGeneric ? "" : ": the surface is not generic there");
      row.severity = static_cast<int>(ridges::Severity::Uncertain);
      row.offenders = vtkRidgesOffenderText(offenders.size(),
        [this, &offenders](std::size_t i)
        { return std::to_string(this->Mesh.GetCellId(offenders[i])); });
      row.place = triangles.Centroid(offenders.front());
    }
    this->Add(row);
  }
  return {};
}

void vtkRidgesCheckTable::Add(const Row& row)
{
  this->Check->InsertNextValue(row.name);
  this->Section->InsertNextValue(row.section);
  this->Expected->InsertNextValue(row.expected);
  this->Found->InsertNextValue(row.found);
  this->Applies->InsertNextValue(row.applies ? 1 : 0);
  this->Passed->InsertNextValue(row.numberOfOffenders == 0 ? 1 : 0);
  this->Severity->InsertNextValue(row.severity);
  this->Number->InsertNextValue(row.numberOfOffenders);
  this->Kind->InsertNextValue(row.offenderKind);
  this->Offenders->InsertNextValue(row.offenders);
  this->Place->InsertNextTuple(row.place.data());
}

void vtkRidgesCheckTable::Store(vtkTable* output) const
{
  vtkNew<vtkTable> table;
  for (vtkAbstractArray* column : std::initializer_list<vtkAbstractArray*>{ this->Check,
         this->Section, this->Expected, this->Found, this->Applies, this->Passed, this->Severity,
         this->Number, this->Kind, this->Offenders, this->Place })
  {
    table->AddColumn(column);
  }
  output->ShallowCopy(table);
}
