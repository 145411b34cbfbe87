// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesCertificateOutput.h"

#include "Core/Umbilics/Umbilic.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesFieldData.h"
#include "vtkRidgesHypotheses.h"
#include "vtkRidgesMakeArray.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesMongeOutput.h"
#include "vtkRidgesOffenderText.h"
#include "vtkRidgesUmbilicOutput.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace names = vtkRidgesArrayNames;
using ridges::Id;

namespace
{

vtkSmartPointer<vtkPoints> PointsOf(const ridges::CompliantMesh& mesh)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.NumberOfPoints());
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    points->SetPoint(p, mesh.Points().data() + 3 * static_cast<std::size_t>(p));
  }
  return points;
}

void AddMongeArrays(const ridges::CompliantMesh& mesh, vtkPolyData* output)
{
  constexpr int order = 4;
  vtkRidgesMongeOutput arrays(mesh.NumberOfPoints(), order, false);
  vtkRidgesMongeOutput::Quality quality;
  quality.conditionNumber = 1.0;
  for (Id p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    arrays.Store(p, mesh.Forms()[static_cast<std::size_t>(p)], quality);
  }
  arrays.AddTo(output->GetPointData());
}

/// 0: a hypothesis fails, 1: all are checked, 2: all are proved.
int VerdictOf(std::uint16_t failed, bool isProof)
{
  return failed != 0 ? 0 : isProof ? 2 : 1;
}

/// Where a hypothesis fails.
struct Offenders
{
  std::vector<std::string> ids;
  const char* kind = "edge";
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  bool isNotGeneric = false;

  void Add(
    const char* what, const std::string& id, const Eigen::Vector3d& where, std::uint16_t failed)
  {
    if (this->ids.empty())
    {
      this->kind = what;
      this->place = where;
    }
    this->ids.push_back(std::string(what) == this->kind ? id : what + (" " + id));
    this->isNotGeneric = this->isNotGeneric || (failed & ridges::NotGeneric) != 0;
  }

  std::string Text() const
  {
    return vtkRidgesOffenderText(this->ids.size(), [this](std::size_t i) { return this->ids[i]; });
  }
};

Offenders OffendersOf(const vtkRidgesCertifier& certifier, std::uint16_t hypothesis)
{
  const ridges::MeshCertificate& certificate = certifier.GetCertificate();
  const ridges::TriangleMesh& mesh = certifier.GetMesh().Mesh();
  Offenders found;
  for (std::size_t i = 0; i < certificate.patches.size(); ++i)
  {
    const ridges::PatchCertificate& patch = certificate.patches[i];
    if ((patch.failed & hypothesis) != 0)
    {
      found.Add("umbilic", std::to_string(i), patch.umbilic.position, patch.failed);
    }
  }
  for (Id t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const auto& triangle = certificate.triangles[t];
    if (triangle && (triangle->failed & hypothesis) != 0)
    {
      found.Add("cell", std::to_string(t), triangle->place, triangle->failed);
    }
  }
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    const auto& edge = certificate.edges[e];
    if (edge && (edge->failed & hypothesis) != 0)
    {
      const ridges::Edge& ends = mesh.EdgeAt(e);
      found.Add(
        "edge", std::to_string(ends.v0) + "-" + std::to_string(ends.v1), edge->place, edge->failed);
    }
  }
  return found;
}

/// The columns of the table.
class TableRows
{
public:
  void Add(const vtkRidgesHypothesis& row, const char* verdict, const Offenders& offenders)
  {
    this->Check->InsertNextValue(row.name);
    this->Section->InsertNextValue(row.section);
    this->Expected->InsertNextValue(row.expected);
    this->Verdict->InsertNextValue(verdict);
    this->Passed->InsertNextValue(offenders.ids.empty() ? 1 : 0);
    this->Number->InsertNextValue(static_cast<vtkIdType>(offenders.ids.size()));
    this->Kind->InsertNextValue(offenders.kind);
    this->Ids->InsertNextValue(offenders.Text());
    this->Place->InsertNextTuple(offenders.place.data());
  }

  void Store(vtkTable* output)
  {
    vtkNew<vtkTable> table;
    for (vtkAbstractArray* column :
      std::initializer_list<vtkAbstractArray*>{ this->Check, this->Section, this->Expected,
        this->Verdict, this->Passed, this->Number, this->Kind, this->Ids, this->Place })
    {
      table->AddColumn(column);
    }
    output->ShallowCopy(table);
  }

private:
  vtkNew<vtkStringArray> Check = vtkRidgesMakeArray<vtkStringArray>(names::Check);
  vtkNew<vtkStringArray> Section = vtkRidgesMakeArray<vtkStringArray>(names::Section);
  vtkNew<vtkStringArray> Expected = vtkRidgesMakeArray<vtkStringArray>(names::Expected);
  vtkNew<vtkStringArray> Verdict = vtkRidgesMakeArray<vtkStringArray>(names::Verdict);
  vtkNew<vtkIntArray> Passed = vtkRidgesMakeArray<vtkIntArray>(names::Passed);
  vtkNew<vtkIdTypeArray> Number = vtkRidgesMakeArray<vtkIdTypeArray>(names::NumberOfOffenders);
  vtkNew<vtkStringArray> Kind = vtkRidgesMakeArray<vtkStringArray>(names::OffenderKind);
  vtkNew<vtkStringArray> Ids = vtkRidgesMakeArray<vtkStringArray>(names::Offenders);
  vtkNew<vtkDoubleArray> Place = vtkRidgesMakeArray<vtkDoubleArray>(names::OffenderPosition, 3);
};

/// The indices of the umbilics of a closed mesh sum to its Euler characteristic.
Offenders WrongIndexSum(const vtkRidgesCertifier& certifier)
{
  const ridges::TriangleMesh& mesh = certifier.GetMesh().Mesh();
  Offenders offenders;
  double sum = 0.0;
  for (const ridges::PatchCertificate& patch : certifier.GetCertificate().patches)
  {
    sum += patch.umbilic.index;
  }
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    if (mesh.EdgeAt(e).t1 < 0)
    {
      return offenders; // open: says nothing
    }
  }
  if (sum != mesh.EulerCharacteristic() && mesh.NumberOfTriangles() > 0)
  {
    offenders.Add("cell", "0", mesh.Point(mesh.Corners(0)[0]), 0);
  }
  return offenders;
}

} // namespace

std::string vtkRidgesCertificateOutput::StoreMesh(vtkPolyData* mesh, vtkPolyData* umbilics) const
{
  const ridges::CompliantMesh& found = this->Certifier.GetMesh();
  const ridges::MeshCertificate& certificate = this->Certifier.GetCertificate();
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(PointsOf(found));
  vtkNew<vtkCellArray> triangles;
  for (const ridges::Triangle& corners : found.Triangles())
  {
    const vtkIdType ids[3] = { corners[0], corners[1], corners[2] };
    triangles->InsertNextCell(3, ids);
  }
  bare->SetPolys(triangles);
  AddMongeArrays(found, bare);
  auto verdict = vtkRidgesMakeArray<vtkIntArray>(names::Certificate);
  auto failures = vtkRidgesMakeArray<vtkIntArray>(names::FailedHypotheses);
  for (Id t = 0; t < found.Mesh().NumberOfTriangles(); ++t)
  {
    const std::uint16_t failed = certificate.FailedAt(found.Mesh(), t);
    verdict->InsertNextValue(VerdictOf(failed, this->Certifier.IsProof()));
    failures->InsertNextValue(failed);
  }
  bare->GetCellData()->AddArray(verdict);
  bare->GetCellData()->AddArray(failures);
  if (!this->Certifier.GetFormula().empty())
  {
    auto formula = vtkRidgesMakeArray<vtkStringArray>(names::Formula);
    formula->InsertNextValue(this->Certifier.GetFormula());
    bare->GetFieldData()->AddArray(formula);
  }

  vtkRidgesMesh built;
  std::string faults = built.Build(bare);
  if (!faults.empty())
  {
    return faults;
  }
  vtkRidgesUmbilicOutput output;
  output.eulerCharacteristic = built.GetEulerCharacteristic();
  for (const ridges::PatchCertificate& patch : certificate.patches)
  {
    ridges::Umbilic umbilic = ridges::MakeUmbilic(
      found.Mesh(), found.Field(), patch.triangle, patch.umbilic.index, patch.patch);
    umbilic.position = patch.umbilic.position;
    if (patch.umbilic.radius > 0.0)
    {
      umbilic.ridgeCount = patch.umbilic.ridgeCount[0];
    }
    output.umbilics.push_back(umbilic);
  }
  if (mesh)
  {
    output.MarkOnMesh(built, mesh);
  }
  if (umbilics)
  {
    output.StoreVertices(built, umbilics);
  }
  return {};
}

void vtkRidgesCertificateOutput::StoreEdges(vtkPolyData* output) const
{
  const ridges::TriangleMesh& mesh = this->Certifier.GetMesh().Mesh();
  const ridges::MeshCertificate& certificate = this->Certifier.GetCertificate();
  vtkNew<vtkCellArray> lines;
  auto verdict = vtkRidgesMakeArray<vtkIntArray>(names::Certificate);
  auto failures = vtkRidgesMakeArray<vtkIntArray>(names::FailedHypotheses);
  auto blue = vtkRidgesMakeArray<vtkIntArray>(names::MaximumCrossings);
  auto red = vtkRidgesMakeArray<vtkIntArray>(names::MinimumCrossings);
  for (Id e = 0; e < mesh.NumberOfEdges(); ++e)
  {
    const auto& edge = certificate.edges[e];
    if (edge)
    {
      const vtkIdType ends[2] = { mesh.EdgeAt(e).v0, mesh.EdgeAt(e).v1 };
      lines->InsertNextCell(2, ends);
      verdict->InsertNextValue(VerdictOf(edge->failed, this->Certifier.IsProof()));
      failures->InsertNextValue(edge->failed);
      blue->InsertNextValue(edge->crossings[0]);
      red->InsertNextValue(edge->crossings[1]);
    }
  }
  output->SetPoints(PointsOf(this->Certifier.GetMesh()));
  output->SetLines(lines);
  for (vtkIntArray* array : std::initializer_list<vtkIntArray*>{ verdict, failures, blue, red })
  {
    output->GetCellData()->AddArray(array);
  }
}

void vtkRidgesCertificateOutput::StoreTable(vtkTable* output) const
{
  const char* const holds = this->Certifier.IsProof() ? "proved" : "checked";
  TableRows rows;
  for (const vtkRidgesHypothesis& row : vtkRidgesHypotheses())
  {
    const Offenders offenders = OffendersOf(this->Certifier, row.bit);
    const char* const verdict = offenders.ids.empty() ? holds
      : offenders.isNotGeneric                        ? "failed: the surface is not generic there"
                                                      : "failed";
    rows.Add(row, verdict, offenders);
  }
  const Offenders wrong = WrongIndexSum(this->Certifier);
  rows.Add({ "index sum", "8.2", 0,
             "indices of umbilics sum to the Euler characteristic of a closed mesh" },
    wrong.ids.empty() ? holds : "failed", wrong);
  rows.Store(output);
}

void vtkRidgesCertificateOutput::PlaceOnRidges(vtkPolyData* ridgeLines) const
{
  vtkPointData* data = ridgeLines->GetPointData();
  auto* end0 = vtkIdTypeArray::SafeDownCast(data->GetArray(names::EdgePoint0));
  auto* end1 = vtkIdTypeArray::SafeDownCast(data->GetArray(names::EdgePoint1));
  auto* parameter = vtkDoubleArray::SafeDownCast(data->GetArray(names::EdgeParameter));
  vtkDataArray* type = ridgeLines->GetCellData()->GetArray(names::RidgeType);
  if (!end0 || !end1 || !parameter || !type || ridgeLines->GetNumberOfLines() == 0)
  {
    return;
  }
  const ridges::TriangleMesh& mesh = this->Certifier.GetMesh().Mesh();
  const ridges::MeshCertificate& certificate = this->Certifier.GetCertificate();
  const auto edgeBetween = [&mesh](Id p, Id q)
  {
    for (const Id t : mesh.TrianglesAround(p))
    {
      for (int side = 0; side < 3; ++side)
      {
        const ridges::Edge& edge = mesh.EdgeAt(mesh.EdgeOf(t, side));
        if (edge.v0 == p && edge.v1 == q)
        {
          return mesh.EdgeOf(t, side);
        }
      }
    }
    return Id(-1);
  };
  const auto lines = vtk::TakeSmartPointer(ridgeLines->GetLines()->NewIterator());
  for (lines->GoToFirstCell(); !lines->IsDoneWithTraversal(); lines->GoToNextCell())
  {
    const double ofLine = type->GetComponent(lines->GetCurrentCellId(), 0);
    if (ofLine == vtkRidgeExtraction::UNDECIDED)
    {
      continue;
    }
    const int color = ofLine <= vtkRidgeExtraction::MAXIMUM_HYPERBOLIC ? 0 : 1;
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    lines->GetCurrentCell(count, points);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const vtkIdType p = points[i];
      const Id e = end0->GetValue(p) < 0
        ? -1
        : edgeBetween(static_cast<Id>(end0->GetValue(p)), static_cast<Id>(end1->GetValue(p)));
      if (e >= 0 && certificate.edges[e] && certificate.edges[e]->crossings[color] == 1)
      {
        ridgeLines->GetPoints()->SetPoint(p, certificate.edges[e]->position[color].data());
        parameter->SetValue(p, certificate.edges[e]->parameter[color]);
      }
    }
  }
}
