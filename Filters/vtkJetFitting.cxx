// SPDX-License-Identifier: BSD-3-Clause
#include "vtkJetFitting.h"

#include "Core/JetBatch.h"
#include "Core/JetBatchFiller.h"
#include "Core/JetFit.h"
#include "Core/MongeForm.h"
#include "Core/OrderedRings.h"
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

/// The arrays that come out, one tuple per point, each point to be stored once.
class MongeOutput
{
public:
  MongeOutput(vtkIdType count, int order)
  {
    this->Add(this->Normals, names::Normals, 3, count, order >= 1);
    this->Add(this->MaximumCurvature, names::MaximumCurvature, 1, count, order >= 2);
    this->Add(this->MinimumCurvature, names::MinimumCurvature, 1, count, order >= 2);
    this->Add(this->MaximumDirection, names::MaximumDirection, 3, count, order >= 2);
    this->Add(this->MinimumDirection, names::MinimumDirection, 3, count, order >= 2);
    this->Add(this->ThirdOrder, names::ThirdOrder, 4, count, order >= 3, "b");
    this->Add(this->FourthOrder, names::FourthOrder, 5, count, order >= 4, "c");
    this->Add(this->P1, names::P1, 1, count, order >= 4);
    this->Add(this->P2, names::P2, 1, count, order >= 4);
    this->Add(this->ConditionNumber, names::FitConditionNumber, 1, count, true);
    this->Add(this->Residual, names::FitResidual, 1, count, true);
    this->StatusArray->SetName(names::FitStatus);
    this->StatusArray->SetNumberOfTuples(count);
    this->Status = this->StatusArray->GetPointer(0);
  }

  void Store(
    vtkIdType p, const ridges::MongeForm& form, double conditionNumber, double residual, int status)
  {
    Put(this->Normals, p, form.n);
    Put(this->MaximumDirection, p, form.d1);
    Put(this->MinimumDirection, p, form.d2);
    Put(this->ThirdOrder, p, form.b);
    Put(this->FourthOrder, p, form.c);
    Put(this->MaximumCurvature, p, form.k1);
    Put(this->MinimumCurvature, p, form.k2);
    Put(this->P1, p, form.P1());
    Put(this->P2, p, form.P2());
    Put(this->ConditionNumber, p, conditionNumber);
    Put(this->Residual, p, residual);
    this->Status[p] = status;
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
    for (const auto& array : this->Arrays)
    {
      pointData->AddArray(array);
    }
    pointData->AddArray(this->StatusArray);
    pointData->SetActiveNormals(names::Normals);
  }

  vtkIntArray* GetStatus() { return this->StatusArray; }

private:
  void Add(double*& values, const char* name, int components, vtkIdType count, bool wanted,
    const char* componentPrefix = nullptr)
  {
    values = nullptr;
    if (wanted)
    {
      vtkNew<vtkDoubleArray> array;
      array->SetName(name);
      array->SetNumberOfComponents(components);
      for (int i = 0; componentPrefix && i < components; ++i)
      {
        array->SetComponentName(i, (componentPrefix + std::to_string(i)).c_str());
      }
      array->SetNumberOfTuples(count);
      values = array->GetPointer(0);
      this->Arrays.emplace_back(array);
    }
  }

  template <typename Tuple>
  static void Put(double* values, vtkIdType p, const Tuple& tuple)
  {
    if (values)
    {
      const auto size = static_cast<vtkIdType>(tuple.size());
      std::copy_n(tuple.data(), size, values + p * size);
    }
  }
  static void Put(double* values, vtkIdType p, double value)
  {
    if (values)
    {
      values[p] = value;
    }
  }

  double *Normals, *MaximumCurvature, *MinimumCurvature, *MaximumDirection, *MinimumDirection,
    *ThirdOrder, *FourthOrder, *P1, *P2, *ConditionNumber, *Residual;
  int* Status;
  std::vector<vtkSmartPointer<vtkDoubleArray>> Arrays;
  vtkNew<vtkIntArray> StatusArray;
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

struct BuildRings
{
  ridges::OrderedRings& Rings;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    this->Rings.Build(static_cast<ridges::Id>(begin), static_cast<ridges::Id>(end));
  }
};

class FitPoints
{
public:
  FitPoints(const ridges::TriangleMesh& mesh, const ridges::OrderedRings& rings,
    const ridges::NeighborhoodRule& rule, int degree, MongeOutput& output)
    : Mesh(mesh)
    , Rings(rings)
    , Rule(rule)
    , Degree(degree)
    , Output(output)
  {
    // The batches know degrees 2 to 4; whatever they cannot do is done point by point.
    const std::vector<ridges::JetBatchKernel>& kernels = ridges::JetBatchKernels();
    if (degree >= 2 && !kernels.empty())
    {
      this->Kernel = &kernels.front();
    }
  }

  void operator()(vtkIdType begin, vtkIdType end)
  {
    std::shared_ptr<Scratch>& scratch = this->PerThread.Local();
    if (!scratch)
    {
      scratch = std::make_shared<Scratch>(*this);
    }
    for (vtkIdType p = begin; p < end; ++p)
    {
      this->Take(static_cast<ridges::Id>(p), *scratch);
    }
    this->FitBatch(*scratch);
  }

private:
  struct Scratch
  {
    explicit Scratch(const FitPoints& fit)
      : Neighborhood(fit.Mesh, fit.Rings)
      , Batch(fit.Degree, fit.Kernel ? fit.Kernel->lanes : 1)
    {
    }
    ridges::RingNeighborhood Neighborhood;
    ridges::JetFitter Fitter;
    ridges::JetBatchFiller Batch;
    Eigen::Matrix3Xd Offsets;
  };

  /// Into the batch with it if it fits there, else it is fitted at once.
  void Take(ridges::Id p, Scratch& scratch)
  {
    const auto points = scratch.Neighborhood.Gather(p, this->Rule);
    if (!this->Kernel || !scratch.Batch.Add(this->Mesh, p, points))
    {
      this->FitAlone(p, scratch);
    }
    else if (scratch.Batch.IsFull())
    {
      this->FitBatch(scratch);
    }
  }

  void FitBatch(Scratch& scratch)
  {
    if (scratch.Batch.IsEmpty())
    {
      return;
    }
    this->Kernel->fit(scratch.Batch.Complete());
    for (int lane = 0; lane < scratch.Batch.Size(); ++lane)
    {
      const ridges::Id p = scratch.Batch.Vertex(lane);
      ridges::MongeForm form;
      double conditionNumber = 0.0;
      double residual = 0.0;
      const bool good = scratch.Batch.Result(lane, form, conditionNumber, residual);
      if (good && conditionNumber <= GrowAbove)
      {
        this->Store(p, form, conditionNumber, residual, ridges::FitGood);
      }
      else
      {
        this->FitAlone(p, scratch);
      }
    }
    scratch.Batch.Clear();
  }

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

  void FitAlone(ridges::Id p, Scratch& scratch)
  {
    // One-sided neighbourhoods may hold enough points in too few rows: a few rings more help.
    // Where the user has said how many rings, or how far, it stays at that.
    constexpr int mostRingsAdded = 4;
    ridges::JetFit fit = this->Fit(p, scratch.Neighborhood.Gather(p, this->Rule), scratch);
    const bool mayGrow = this->Rule.kind == ridges::NeighborhoodRule::Kind::PointCount;
    for (int added = 0; mayGrow && added < mostRingsAdded && fit.conditionNumber > GrowAbove;
         ++added)
    {
      fit = this->Fit(p, scratch.Neighborhood.Grow(), scratch);
    }

    // Less than a quadric says nothing of curvature, unless a plane was all that was asked for.
    int status = fit.status;
    if (fit.degree < std::min(2, this->Degree))
    {
      status |= ridges::FitInvalid;
    }
    ridges::MongeForm form;
    if (!(status & ridges::FitInvalid))
    {
      form = ridges::MongeFormOfHeightJet(fit.jet, fit.frame);
    }
    this->Store(p, form, fit.conditionNumber, fit.residual, status);
  }

  void Store(ridges::Id p, const ridges::MongeForm& form, double conditionNumber, double residual,
    int status)
  {
    status |= this->Rings.OnBorder(p) ? ridges::FitBoundary : 0;
    if (!(status & ridges::FitInvalid) && IsFinite(form) && std::isfinite(residual))
    {
      this->Output.Store(p, form, conditionNumber, residual, status);
    }
    else
    {
      this->Output.Store(p, ridges::MongeForm(), 0.0, 0.0, status | ridges::FitInvalid);
    }
  }

  static constexpr double GrowAbove = 2000.0;

  const ridges::TriangleMesh& Mesh;
  const ridges::OrderedRings& Rings;
  ridges::NeighborhoodRule Rule;
  int Degree;
  MongeOutput& Output;
  const ridges::JetBatchKernel* Kernel = nullptr;
  // Shared, as vtkSMPThreadLocal copies the (empty) value it starts from.
  vtkSMPThreadLocal<std::shared_ptr<Scratch>> PerThread;
};

/// One text for all that is wrong with the mesh or the fits; empty if all is well.
std::string Complaint(vtkRidgesMesh& mesh, const ridges::OrderedRings& rings, vtkIntArray* status)
{
  // Edges are at fault only where fans are.
  const ridges::TriangleMesh& triangles = mesh.GetTriangles();
  if (rings.HasIrregular())
  {
    mesh.BuildEdges();
  }
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
  if (!mesh.Build(input, {}, ridges::TriangleMesh::Edges::NotBuilt))
  {
    vtkErrorMacro("The mesh has more points or triangles than 32-bit numbering allows.");
    return 0;
  }
  const vtkIdType count = mesh.GetPolyData()->GetNumberOfPoints();
  MongeOutput arrays(count, std::min(this->MongeOrder, this->Degree));
  ridges::OrderedRings rings(mesh.GetTriangles());
  BuildRings buildRings{ rings };
  FitPoints fitPoints(mesh.GetTriangles(), rings, rule, this->Degree, arrays);
  if (!vtkRidgesForBatches(this, count, 0.1, 0.2, buildRings) ||
    !vtkRidgesForBatches(this, count, 0.2, 1.0, fitPoints))
  {
    return 1;
  }
  const std::string complaint = Complaint(mesh, rings, arrays.GetStatus());
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
