// SPDX-License-Identifier: BSD-3-Clause
#include "vtkJetFitting.h"

#include "Core/JetFit.h"
#include "Core/MongeForm.h"
#include "Core/RingNeighborhood.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesMesh.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

namespace names = vtkRidgesArrayNames;

vtkStandardNewMacro(vtkJetFitting);

static_assert(static_cast<int>(vtkJetFitting::FIT_BOUNDARY) == ridges::FitBoundary &&
    static_cast<int>(vtkJetFitting::FIT_TOO_FEW_POINTS) == ridges::FitTooFewPoints &&
    static_cast<int>(vtkJetFitting::FIT_ILL_CONDITIONED) == ridges::FitIllConditioned &&
    static_cast<int>(vtkJetFitting::FIT_INVALID) == ridges::FitInvalid,
  "FitStatusBits repeats ridges::FitStatus");

namespace
{

/// The arrays that come out, one tuple per point.
struct MongeOutput
{
  explicit MongeOutput(vtkIdType count, int order)
    : Order(order)
  {
    this->Prepare(this->Normals, names::Normals, 3, count);
    if (order >= 2)
    {
      this->Prepare(this->MaximumCurvature, names::MaximumCurvature, 1, count);
      this->Prepare(this->MinimumCurvature, names::MinimumCurvature, 1, count);
      this->Prepare(this->MaximumDirection, names::MaximumDirection, 3, count);
      this->Prepare(this->MinimumDirection, names::MinimumDirection, 3, count);
    }
    if (order >= 3)
    {
      this->Prepare(this->ThirdOrder, names::ThirdOrder, 4, count, "b");
    }
    if (order >= 4)
    {
      this->Prepare(this->FourthOrder, names::FourthOrder, 5, count, "c");
      this->Prepare(this->P1, names::P1, 1, count);
      this->Prepare(this->P2, names::P2, 1, count);
    }
    this->Prepare(this->ConditionNumber, names::FitConditionNumber, 1, count);
    this->Prepare(this->Residual, names::FitResidual, 1, count);
    this->Status->SetName(names::FitStatus);
    this->Status->SetNumberOfTuples(count);
    this->Status->Fill(vtkJetFitting::FIT_INVALID);
  }

  void Store(vtkIdType p, const ridges::MongeForm& form)
  {
    this->Normals->SetTuple(p, form.n.data());
    if (this->Order >= 2)
    {
      this->MaximumCurvature->SetValue(p, form.k1);
      this->MinimumCurvature->SetValue(p, form.k2);
      this->MaximumDirection->SetTuple(p, form.d1.data());
      this->MinimumDirection->SetTuple(p, form.d2.data());
    }
    if (this->Order >= 3)
    {
      this->ThirdOrder->SetTuple(p, form.b.data());
    }
    if (this->Order >= 4)
    {
      this->FourthOrder->SetTuple(p, form.c.data());
      this->P1->SetValue(p, form.P1());
      this->P2->SetValue(p, form.P2());
    }
  }

  void AddTo(vtkPointData* pointData)
  {
    // What an earlier fit of higher order may have left would not belong to this one.
    for (const char* name :
      { names::Normals, names::MaximumCurvature, names::MinimumCurvature, names::MaximumDirection,
        names::MinimumDirection, names::ThirdOrder, names::FourthOrder, names::P1, names::P2 })
    {
      pointData->RemoveArray(name);
    }
    for (const auto& array : this->Prepared)
    {
      pointData->AddArray(array);
    }
    pointData->AddArray(this->Status);
    pointData->SetActiveNormals(names::Normals);
  }

  vtkNew<vtkDoubleArray> Normals, MaximumCurvature, MinimumCurvature, MaximumDirection,
    MinimumDirection, ThirdOrder, FourthOrder, P1, P2, ConditionNumber, Residual;
  vtkNew<vtkIntArray> Status;

private:
  void Prepare(vtkDoubleArray* array, const char* name, int components, vtkIdType count,
    const char* componentPrefix = nullptr)
  {
    array->SetName(name);
    array->SetNumberOfComponents(components);
    for (int i = 0; componentPrefix && i < components; ++i)
    {
      array->SetComponentName(i, (componentPrefix + std::to_string(i)).c_str());
    }
    array->SetNumberOfTuples(count);
    array->Fill(0.0);
    this->Prepared.emplace_back(array);
  }

  int Order;
  std::vector<vtkSmartPointer<vtkDoubleArray>> Prepared;
};

/// Marks of an earlier vtkUmbilicDetection do not belong to this fit.
void RemoveUmbilics(vtkPolyData* mesh)
{
  mesh->GetCellData()->RemoveArray(names::UmbilicPatch);
  // The field data is still the input's own, which is not ours to change.
  vtkNew<vtkFieldData> field;
  field->ShallowCopy(mesh->GetFieldData());
  for (const char* name : { names::UmbilicPosition, names::UmbilicIndex, names::UmbilicRidgeCount,
         names::UmbilicIndexSum, names::EulerCharacteristic })
  {
    field->RemoveArray(name);
  }
  mesh->SetFieldData(field);
}

bool IsFinite(const ridges::MongeForm& form)
{
  const auto finite = [](double value) { return std::isfinite(value); };
  return finite(form.k1) && finite(form.k2) && finite(form.P1()) && finite(form.P2()) &&
    form.n.allFinite() && form.d1.allFinite() && form.d2.allFinite() &&
    std::all_of(form.b.begin(), form.b.end(), finite) &&
    std::all_of(form.c.begin(), form.c.end(), finite);
}

struct FitPoints
{
  FitPoints(const ridges::TriangleMesh& mesh, const ridges::NeighborhoodRule& rule, int degree,
    MongeOutput& output)
    : Mesh(mesh)
    , Rule(rule)
    , Degree(degree)
    , Output(output)
  {
  }

  void operator()(vtkIdType begin, vtkIdType end)
  {
    std::shared_ptr<Scratch>& scratch = this->PerThread.Local();
    if (!scratch)
    {
      scratch = std::make_shared<Scratch>(this->Mesh);
    }
    for (vtkIdType p = begin; p < end; ++p)
    {
      this->FitPoint(static_cast<ridges::Id>(p), *scratch);
    }
  }

private:
  struct Scratch
  {
    explicit Scratch(const ridges::TriangleMesh& mesh)
      : Neighborhood(mesh)
    {
    }
    ridges::RingNeighborhood Neighborhood;
    ridges::JetFitter Fitter;
    Eigen::Matrix3Xd Offsets;
  };

  ridges::JetFit Fit(ridges::Id p, ridges::Span<ridges::Id> points, Scratch& scratch) const
  {
    const Eigen::Vector3d origin = this->Mesh.Point(p);
    scratch.Offsets.resize(3, points.size());
    for (ridges::Id i = 0; i < points.size(); ++i)
    {
      scratch.Offsets.col(i) = this->Mesh.Point(points[i]) - origin;
    }
    return scratch.Fitter.Fit(scratch.Offsets, this->Degree, this->Mesh.PointNormal(p));
  }

  void FitPoint(ridges::Id p, Scratch& scratch)
  {
    // One-sided neighbourhoods may hold enough points in too few rows: a few rings more help.
    // Where the user has said how many rings, or how far, it stays at that.
    constexpr double growAbove = 2000.0;
    constexpr int mostRingsAdded = 4;
    ridges::JetFit fit = this->Fit(p, scratch.Neighborhood.Gather(p, this->Rule), scratch);
    const bool mayGrow = this->Rule.kind == ridges::NeighborhoodRule::Kind::PointCount;
    for (int added = 0; mayGrow && added < mostRingsAdded && fit.conditionNumber > growAbove;
         ++added)
    {
      fit = this->Fit(p, scratch.Neighborhood.Grow(), scratch);
    }

    int status = fit.status | (this->Mesh.OnBorder(p) ? ridges::FitBoundary : 0);
    // Less than a quadric says nothing of curvature, unless a plane was all that was asked for.
    if (fit.degree < std::min(2, this->Degree))
    {
      status |= ridges::FitInvalid;
    }
    if (!(status & ridges::FitInvalid))
    {
      const ridges::MongeForm form = ridges::MongeFormOfHeightJet(fit.jet, fit.frame);
      if (IsFinite(form) && std::isfinite(fit.residual))
      {
        this->Output.Store(p, form);
        this->Output.ConditionNumber->SetValue(p, fit.conditionNumber);
        this->Output.Residual->SetValue(p, fit.residual);
      }
      else
      {
        status |= ridges::FitInvalid;
      }
    }
    this->Output.Status->SetValue(p, status);
  }

  const ridges::TriangleMesh& Mesh;
  ridges::NeighborhoodRule Rule;
  int Degree;
  MongeOutput& Output;
  // Shared, as vtkSMPThreadLocal copies the (empty) value it starts from.
  vtkSMPThreadLocal<std::shared_ptr<Scratch>> PerThread;
};

/// One text for all that is wrong with the mesh or the fits; empty if all is well.
std::string Complaint(const vtkRidgesMesh& mesh, vtkIntArray* status)
{
  const ridges::TriangleMesh& triangles = mesh.GetTriangles();
  const auto count = [status](int bit)
  {
    vtkIdType sum = 0;
    for (vtkIdType p = 0; p < status->GetNumberOfTuples(); ++p)
    {
      sum += (status->GetValue(p) & bit) ? 1 : 0;
    }
    return sum;
  };
  std::ostringstream text;
  const auto say = [&text](vtkIdType number, const char* what)
  {
    if (number > 0)
    {
      text << (text.tellp() > 0 ? "; " : "") << number << " " << what;
    }
  };
  const vtkIdType invalid = count(vtkJetFitting::FIT_INVALID);
  const vtkIdType tooFew = count(vtkJetFitting::FIT_TOO_FEW_POINTS);
  say(mesh.GetNumberOfTriangulatedCells(), "polygons or strips were triangulated");
  say(mesh.GetNumberOfUnusableTriangles(),
    "triangles were left out (a repeated corner, or a point that is missing or not finite)");
  say(triangles.NumberOfNonManifoldEdges(),
    "edges with more than two triangles were taken as borders");
  say(triangles.NumberOfInconsistentEdges(),
    "edges lie between triangles of opposite orientation (vtkPolyDataNormals can mend that)");
  say(invalid,
    "points have no fit (isolated, or too few or collinear neighbours): their values are 0");
  say(tooFew, "points have fewer neighbours than coefficients");
  say(count(vtkJetFitting::FIT_ILL_CONDITIONED), "points are ill conditioned");
  if (invalid > 0 || tooFew > 0)
  {
    say(mesh.CountCoincidentPoints(),
      "points coincide with another (vtkStaticCleanPolyData merges them)");
  }
  return text.str();
}

} // namespace

const char* vtkJetFitting::GetNeighborhoodAsString() const
{
  switch (this->Neighborhood)
  {
    case BY_RINGS:
      return "Rings";
    case BY_RADIUS:
      return "Radius";
    default:
      return "PointCount";
  }
}

int vtkJetFitting::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);

  if (this->Neighborhood == BY_RADIUS && !(this->Radius > 0.0 && std::isfinite(this->Radius)))
  {
    vtkErrorMacro(
      "Neighborhood is by radius, but Radius is " << this->Radius << ": set a positive one.");
    return 0;
  }
  ridges::NeighborhoodRule rule;
  rule.kind = this->Neighborhood == BY_RINGS
    ? ridges::NeighborhoodRule::Kind::Rings
    : (this->Neighborhood == BY_RADIUS ? ridges::NeighborhoodRule::Kind::Radius
                                       : ridges::NeighborhoodRule::Kind::PointCount);
  rule.minimumNumberOfPoints =
    std::max(this->MinimumNumberOfPoints, ridges::HeightJet::Size(this->Degree));
  rule.numberOfRings = this->NumberOfRings;
  rule.radius = this->Radius;

  vtkRidgesMesh mesh;
  if (!mesh.Build(input))
  {
    vtkErrorMacro("The mesh has more points or triangles than 32-bit numbering allows.");
    return 0;
  }
  const vtkIdType count = mesh.GetPolyData()->GetNumberOfPoints();
  MongeOutput arrays(count, std::min(this->MongeOrder, this->Degree));
  FitPoints fitPoints(mesh.GetTriangles(), rule, this->Degree, arrays);
  if (!vtkRidgesForBatches(this, count, 0.1, 1.0, fitPoints))
  {
    return 1;
  }
  const std::string complaint = Complaint(mesh, arrays.Status);
  if (!complaint.empty())
  {
    vtkWarningMacro(<< complaint << ".");
  }

  output->ShallowCopy(mesh.GetPolyData());
  arrays.AddTo(output->GetPointData());
  RemoveUmbilics(output);
  return 1;
}

void vtkJetFitting::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Degree: " << this->Degree << "\n";
  os << indent << "MongeOrder: " << this->MongeOrder << "\n";
  os << indent << "Neighborhood: " << this->GetNeighborhoodAsString() << "\n";
  os << indent << "MinimumNumberOfPoints: " << this->MinimumNumberOfPoints << "\n";
  os << indent << "NumberOfRings: " << this->NumberOfRings << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
}
