// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesExactForms.h"

#include "Core/Fit/JetFit.h"
#include "Core/Mesh/Regions.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesMongeOutput.h"
#include "vtkRidgesUmbilicMarks.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <utility>

using ridges::ExactFault;
using ridges::Id;

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
  constexpr vtkIdType batch = 1 << 14; // images take their time
  return vtkRidgesForBatches(filter, count, from, to, range, batch);
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
std::vector<std::uint8_t> FindReversed(const ridges::TriangleMesh& mesh, const PointStates& states)
{
  std::vector<std::uint8_t> reversed(states.faults.size(), 0);
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

bool StoreForms(vtkAlgorithm* filter, const vtkRidgesExactForms& known, PointStates& states,
  const std::vector<std::uint8_t>& reversed, vtkRidgesMongeOutput& arrays)
{
  const auto store = [&known, &states, &reversed, &arrays](vtkIdType begin, vtkIdType end)
  {
    ridges::SurfacePoints points = states.Get(begin, end);
    states.surface.Differentiate(points);
    for (int lane = 0; lane < points.count; ++lane)
    {
      const vtkIdType p = begin + lane;
      const bool isGood = points.fault[lane] == ExactFault::None;
      const ridges::MongeForm seen = isGood ? points.form[lane] : ridges::MongeForm();
      const ridges::MongeForm form = reversed[p] ? ridges::Flipped(seen) : seen;
      vtkRidgesMongeOutput::Quality quality;
      quality.conditionNumber = isGood ? 1.0 : 0.0;
      quality.status = isGood ? 0 : ridges::FitInvalid;
      const Eigen::Vector3d& x = points.position[lane];
      if (known.statusAt && x.allFinite())
      {
        quality.status |= known.statusAt(x);
      }
      arrays.Store(p, form, quality);
      if (known.errorsOf)
      {
        arrays.StoreErrors(
          p, isGood ? known.errorsOf(form, points.steepness[lane]) : ridges::JetErrors());
      }
      states.faults[p] = points.fault[lane];
    }
  };
  return ForLanes(filter, static_cast<vtkIdType>(states.faults.size()), 0.6, 1.0, store);
}

/// One text about all points without a form; empty if there are none.
std::string FaultText(
  const PointStates& states, const std::function<std::string(const double*)>& placeOfFault)
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
    const std::string place = fault == ExactFault::NotFinite && isFinite && placeOfFault
      ? placeOfFault(variables.data())
      : std::string();
    text << (place.empty() ? "" : "; in the formula at " + place) << ")";
  }
  return text.str();
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

int vtkRidgesExactForms::Run(vtkAlgorithm* filter, const vtkRidgesMesh& mesh, vtkPolyData* output)
{
  vtkPolyData* triangulated = mesh.GetPolyData();
  const vtkIdType count = triangulated->GetNumberOfPoints();
  const vtkSmartPointer<vtkPoints> points = CopyPoints(triangulated);
  PointStates states{ this->Surface, static_cast<double*>(points->GetVoidPointer(0)),
    this->parameters, {}, {} };
  states.normals.assign(static_cast<std::size_t>(count), Eigen::Vector3d::Zero());
  states.faults.assign(static_cast<std::size_t>(count), ExactFault::None);
  if (!LocatePoints(filter, states))
  {
    return 1; // aborted
  }
  const std::vector<std::uint8_t> reversed = FindReversed(mesh.GetTriangles(), states);
  if (this->located)
  {
    this->located({ states.positions, states.positions + 3 * count });
  }
  constexpr int order = 4;
  vtkRidgesMongeOutput arrays(count, order, static_cast<bool>(this->errorsOf));
  if (!StoreForms(filter, *this, states, reversed, arrays))
  {
    return 1;
  }
  const std::string faults = FaultText(states, this->placeOfFault);
  if (count > 0 &&
    std::find(states.faults.begin(), states.faults.end(), ExactFault::None) == states.faults.end())
  {
    vtkErrorWithObjectMacro(filter, "No point has a Monge form: " << faults << ".");
    return 0;
  }
  if (!faults.empty())
  {
    vtkWarningWithObjectMacro(filter, "Points without a Monge form: " << faults << ".");
  }
  output->ShallowCopy(triangulated);
  output->SetPoints(points);
  arrays.AddTo(output->GetPointData());
  vtkRidgesUmbilicMarks::RemoveFrom(output);
  return 1;
}
