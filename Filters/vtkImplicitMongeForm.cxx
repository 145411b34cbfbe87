// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImplicitMongeForm.h"

#include "Core/Fit/JetFit.h"
#include "Core/Mesh/Regions.h"
#include "vtkJetFunction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesFormulaSurface.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesMongeOutput.h"
#include "vtkRidgesRequest.h"
#include "vtkRidgesUmbilicMarks.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace names = vtkRidgesArrayNames;
using ridges::ExactFault;
using ridges::Id;

vtkStandardNewMacro(vtkImplicitMongeForm);

vtkImplicitMongeForm::vtkImplicitMongeForm() = default;
vtkImplicitMongeForm::~vtkImplicitMongeForm() = default;

namespace
{

/// What is known of the points on the way from the mesh to the arrays.
struct PointStates
{
  const ridges::ExactSurface& surface;
  double* positions = nullptr;                   ///< Before and after they are moved.
  std::vector<std::array<double, 2>> parameters; ///< Empty unless the surface is parametric.
  std::vector<Eigen::Vector3d> normals;          ///< Of the surface.
  std::vector<ExactFault> faults;

  ridges::SurfacePoints Get(vtkIdType begin, vtkIdType end) const
  {
    ridges::SurfacePoints points;
    points.count = static_cast<int>(end - begin);
    for (int lane = 0; lane < points.count; ++lane)
    {
      const vtkIdType p = begin + lane;
      points.position[lane] = Eigen::Map<const Eigen::Vector3d>(this->positions + 3 * p);
      points.normal[lane] = this->normals[p];
      points.fault[lane] = this->faults[p];
      if (!this->parameters.empty())
      {
        points.parameters[lane] = { this->parameters[p][0], this->parameters[p][1] };
      }
    }
    return points;
  }
};

/// Calls body(begin, end) for all points, as many at once as there are lanes.
template <typename Body>
bool ForLanes(vtkAlgorithm* filter, vtkIdType count, double from, double to, const Body& body)
{
  const auto range = [&body](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType first = begin; first < end; first += ridges::Lanes::Count)
    {
      body(first, std::min<vtkIdType>(first + ridges::Lanes::Count, end));
    }
  };
  return vtkRidgesForBatches(filter, count, from, to, range);
}

bool LocatePoints(vtkAlgorithm* filter, PointStates& states)
{
  const auto locate = [&states](vtkIdType begin, vtkIdType end)
  {
    ridges::SurfacePoints points = states.Get(begin, end);
    states.surface.Locate(points);
    for (int lane = 0; lane < points.count; ++lane)
    {
      const vtkIdType p = begin + lane;
      std::copy_n(points.position[lane].data(), 3, states.positions + 3 * p);
      states.normals[p] = points.normal[lane];
      states.faults[p] = points.fault[lane];
    }
  };
  return ForLanes(filter, static_cast<vtkIdType>(states.faults.size()), 0.1, 0.6, locate);
}

/// Which points are on parts of the mesh that are oriented against the surface's normals.
std::vector<char> FindReversed(const ridges::TriangleMesh& mesh, const PointStates& states)
{
  std::vector<char> reversed(states.faults.size(), 0);
  for (const std::vector<Id>& part : ridges::RegionsWhere(mesh, [](Id) { return true; }))
  {
    vtkIdType agreeing = 0;
    for (const Id triangle : part)
    {
      const ridges::Triangle& corners = mesh.Corners(triangle);
      const auto point = [&states, &corners](int i)
      { return Eigen::Map<const Eigen::Vector3d>(states.positions + 3 * vtkIdType(corners[i])); };
      const Eigen::Vector3d normal = (point(1) - point(0)).cross(point(2) - point(0));
      for (const Id p : corners)
      {
        const double side = normal.dot(states.normals[p]);
        agreeing += side > 0.0 ? 1 : side < 0.0 ? -1 : 0;
      }
    }
    for (const Id triangle : part)
    {
      for (const Id p : mesh.Corners(triangle))
      {
        reversed[p] = agreeing < 0 ? 1 : 0;
      }
    }
  }
  return reversed;
}

bool StoreForms(vtkAlgorithm* filter, PointStates& states, const std::vector<char>& reversed,
  vtkRidgesMongeOutput& arrays)
{
  const auto store = [&states, &reversed, &arrays](vtkIdType begin, vtkIdType end)
  {
    ridges::SurfacePoints points = states.Get(begin, end);
    states.surface.Differentiate(points);
    for (int lane = 0; lane < points.count; ++lane)
    {
      const vtkIdType p = begin + lane;
      const bool isGood = points.fault[lane] == ExactFault::None;
      const ridges::MongeForm form = isGood ? points.form[lane] : ridges::MongeForm();
      vtkRidgesMongeOutput::Quality quality;
      quality.conditionNumber = isGood ? 1.0 : 0.0;
      quality.status = isGood ? 0 : ridges::FitInvalid;
      arrays.Store(p, reversed[p] ? ridges::Flipped(form) : form, quality);
      states.faults[p] = points.fault[lane];
    }
  };
  return ForLanes(filter, static_cast<vtkIdType>(states.faults.size()), 0.6, 1.0, store);
}

/// One text about all points without a form; empty if there are none.
std::string FaultText(const PointStates& states, const vtkRidgesFormulaSurface& surface)
{
  constexpr std::pair<ExactFault, const char*> texts[] = {
    { ExactFault::NotFinite, "the surface or a derivative is not finite" },
    { ExactFault::NoConvergence, "no point of the surface was found nearby" },
    { ExactFault::Singular, "the surface has no normal" }
  };
  std::ostringstream text;
  for (const auto& [fault, what] : texts)
  {
    vtkIdType number = 0;
    vtkIdType first = 0; // at a finite place, if there is one
    bool isFinite = false;
    for (std::size_t p = 0; p < states.faults.size(); ++p)
    {
      if (states.faults[p] == fault)
      {
        const Eigen::Map<const Eigen::Vector3d> x(states.positions + 3 * p);
        first = number++ > 0 && (isFinite || !x.allFinite()) ? first : static_cast<vtkIdType>(p);
        isFinite = isFinite || x.allFinite();
      }
    }
    if (number == 0)
    {
      continue;
    }
    const double* x = states.positions + 3 * first;
    text << (text.tellp() > 0 ? "; " : "") << number << " of " << states.faults.size() << ", where "
         << what << " (the first is at " << x[0] << ", " << x[1] << ", " << x[2];
    const bool isParametric = !states.parameters.empty();
    const std::array<double, 3> variables = isParametric
      ? std::array<double, 3>{ states.parameters[first][0], states.parameters[first][1], 0.0 }
      : std::array<double, 3>{ x[0], x[1], x[2] };
    const std::string place = fault == ExactFault::NotFinite && isFinite
      ? surface.PlaceOfFault(variables.data())
      : std::string();
    text << (place.empty() ? "" : "; in the formula at " + place) << ")";
  }
  return text.str();
}

/// The formula that the source of the mesh has left there.
std::string FormulaOf(vtkPolyData* mesh)
{
  auto* array =
    vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(names::Formula));
  return array && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : std::string();
}

/// Parameters by the texture coordinates of a mesh; empty if it has none.
std::vector<std::array<double, 2>> ParametersOf(vtkPolyData* mesh, const double range[4])
{
  vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
  if (!coordinates || coordinates->GetNumberOfComponents() < 2)
  {
    return {};
  }
  std::vector<std::array<double, 2>> parameters(
    static_cast<std::size_t>(coordinates->GetNumberOfTuples()));
  for (std::size_t p = 0; p < parameters.size(); ++p)
  {
    for (int i = 0; i < 2; ++i)
    {
      const double share = coordinates->GetComponent(static_cast<vtkIdType>(p), i);
      parameters[p][i] = (1.0 - share) * range[2 * i] + share * range[2 * i + 1];
    }
  }
  return parameters;
}

vtkSmartPointer<vtkPoints> CopyPoints(vtkPolyData* mesh)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  if (mesh->GetPoints()) // of any type
  {
    coordinates->DeepCopy(mesh->GetPoints()->GetData());
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(coordinates);
  return points;
}

} // namespace

void vtkImplicitMongeForm::SetJetFunction(vtkJetFunction* function)
{
  if (this->JetFunction != function)
  {
    this->JetFunction = function;
    this->Modified();
  }
}

vtkJetFunction* vtkImplicitMongeForm::GetJetFunction() const
{
  return this->JetFunction;
}

vtkMTimeType vtkImplicitMongeForm::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->JetFunction ? std::max(own, this->JetFunction->GetMTime()) : own;
}

const char* vtkImplicitMongeForm::GetSurfaceTypeAsString() const
{
  switch (this->SurfaceType)
  {
    case GRAPH:
      return "Graph";
    case PARAMETRIC:
      return "Parametric";
    default:
      return "Implicit";
  }
}

int vtkImplicitMongeForm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector[0]);
  if (!input)
  {
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  vtkRidgesMesh mesh;
  std::string faults = mesh.Build(input);
  if (!faults.empty())
  {
    vtkErrorMacro("The mesh cannot be used: " << faults << ".");
    return 0;
  }
  vtkPolyData* triangulated = mesh.GetPolyData();
  const vtkIdType count = triangulated->GetNumberOfPoints();

  vtkRidgesFormulaSurface surface;
  const bool isParametric = this->SurfaceType == PARAMETRIC;
  if (this->JetFunction && !isParametric)
  {
    surface.SetFunction(this->JetFunction);
  }
  else if (isParametric)
  {
    faults = surface.SetParametric({ this->XFormula, this->YFormula, this->ZFormula });
  }
  else
  {
    const std::string& formula = this->Formula.empty() ? FormulaOf(input) : this->Formula;
    faults = this->SurfaceType == GRAPH ? surface.SetGraph(formula) : surface.SetImplicit(formula);
  }
  if (!faults.empty())
  {
    vtkErrorMacro(<< faults << ".");
    return 0;
  }

  const vtkSmartPointer<vtkPoints> points = CopyPoints(triangulated);
  PointStates states{ surface.Get() };
  states.positions = static_cast<double*>(points->GetVoidPointer(0));
  states.normals.assign(static_cast<std::size_t>(count), Eigen::Vector3d::Zero());
  states.faults.assign(static_cast<std::size_t>(count), ExactFault::None);
  if (isParametric)
  {
    states.parameters = ParametersOf(triangulated, this->ParameterRange);
    if (static_cast<vtkIdType>(states.parameters.size()) != count)
    {
      vtkErrorMacro(
        "A parametric surface needs a mesh with texture coordinates of two components.");
      return 0;
    }
  }
  if (!LocatePoints(this, states))
  {
    return 1;
  }
  const std::vector<char> reversed = FindReversed(mesh.GetTriangles(), states);
  vtkRidgesMongeOutput arrays(count, 4, false);
  if (!StoreForms(this, states, reversed, arrays))
  {
    return 1;
  }
  const std::string faultText = FaultText(states, surface);
  const bool hasGood =
    std::find(states.faults.begin(), states.faults.end(), ExactFault::None) != states.faults.end();
  if (count > 0 && !hasGood)
  {
    vtkErrorMacro("No point has a Monge form: " << faultText << ".");
    return 0;
  }
  if (!faultText.empty())
  {
    vtkWarningMacro("Points without a Monge form: " << faultText << ".");
  }
  output->ShallowCopy(triangulated);
  output->SetPoints(points);
  arrays.AddTo(output->GetPointData());
  vtkRidgesUmbilicMarks::RemoveFrom(output);
  return 1;
}

void vtkImplicitMongeForm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SurfaceType: " << this->GetSurfaceTypeAsString() << "\n";
  os << indent << "Formula: " << this->Formula << "\n";
  os << indent << "XFormula: " << this->XFormula << "\n";
  os << indent << "YFormula: " << this->YFormula << "\n";
  os << indent << "ZFormula: " << this->ZFormula << "\n";
  os << indent << "ParameterRange: " << this->ParameterRange[0] << " " << this->ParameterRange[1]
     << " " << this->ParameterRange[2] << " " << this->ParameterRange[3] << "\n";
  os << indent << "JetFunction: " << this->JetFunction.Get() << "\n";
}
