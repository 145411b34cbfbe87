// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesCertifier.h"

#include "vtkCertificationAlgorithm.h"
#include "vtkJetFunction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesCompatibility.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesRangeLoop.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace names = vtkRidgesArrayNames;

namespace
{

/// Each bisects the worst triangles: more rounds than that make edges shorter than round-off.
constexpr int MostRounds = 200;

/// The formula that the source of the mesh has left there.
std::string FormulaOf(vtkPolyData* mesh)
{
  auto* array =
    vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(names::Formula));
  return array && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : std::string();
}

} // namespace

std::string vtkRidgesCertifier::SetSurface(vtkCertificationAlgorithm* filter, vtkPolyData* input)
{
  this->Proof = filter->GetLevel() == vtkCertificationAlgorithm::PROVED;
  if (vtkJetFunction* function = filter->GetJetFunction())
  {
    this->Surface.SetFunction(function);
    return this->Proof ? "a proof needs a formula: bounds on a JetFunction are not known"
                       : std::string();
  }
  this->Formula = filter->GetFormula();
  if (this->Formula.empty())
  {
    this->Formula = FormulaOf(input);
  }
  return filter->GetSurfaceType() == vtkCertificationAlgorithm::GRAPH
    ? this->Surface.SetGraph(this->Formula)
    : this->Surface.SetImplicit(this->Formula);
}

std::string vtkRidgesCertifier::SetMesh(vtkPolyData* input)
{
  vtkRidgesMesh mesh;
  const std::string faults = mesh.Build(input);
  if (!faults.empty())
  {
    return "the mesh cannot be used: " + faults;
  }
  const ridges::TriangleMesh& triangles = mesh.GetTriangles();
  std::vector<Eigen::Vector3d> points;
  points.reserve(static_cast<std::size_t>(triangles.NumberOfPoints()));
  for (ridges::Id p = 0; p < triangles.NumberOfPoints(); ++p)
  {
    points.emplace_back(triangles.Point(p));
  }
  std::vector<ridges::Triangle> corners;
  corners.reserve(static_cast<std::size_t>(triangles.NumberOfTriangles()));
  for (ridges::Id t = 0; t < triangles.NumberOfTriangles(); ++t)
  {
    corners.push_back(triangles.Corners(t));
  }
  const int side = ridges::SideOf(this->Surface.Get(), triangles);
  if (side == 0)
  {
    return "parts of the mesh are oriented to different sides of the surface";
  }
  if (this->Proof)
  {
    this->Bounds = std::make_unique<ridges::IntervalBounds>(
      static_cast<const ridges::FormulaFunction&>(this->Surface.GetFunction()), side < 0);
  }
  else
  {
    this->Bounds = std::make_unique<ridges::SampledBounds>(this->Surface.GetFunction(), side < 0);
  }
  this->Mesh = std::make_unique<ridges::CompliantMesh>(
    this->Surface.Get(), *this->Bounds, side < 0, points, std::move(corners));
  if (this->Mesh->NumberOfFaults() > 0)
  {
    std::ostringstream text;
    text << this->Mesh->NumberOfFaults() << " of " << points.size()
         << " points have no Monge form (vtkImplicitMongeForm says why)";
    return text.str();
  }
  return {};
}

// What the loops leave out after an abort has no result, which nobody will look at.
void vtkRidgesCertifier::Certify(vtkAlgorithm* filter, double begin, double end)
{
  constexpr vtkIdType mostInBatch = 1024; // of edges or triangles, which take up to a millisecond
  this->Certificate = this->Mesh->Certify(vtkRidgesAbortableLoop(filter, begin, end, mostInBatch),
    [filter](double) { return !vtkRidgesCompatibility::IsAborted(filter); });
}

bool vtkRidgesCertifier::Run(vtkCertificationAlgorithm* filter, vtkPolyData* input)
{
  std::string faults = this->SetSurface(filter, input);
  if (faults.empty())
  {
    faults = this->SetMesh(input);
  }
  if (!faults.empty())
  {
    vtkErrorWithObjectMacro(filter, << faults << ".");
    return false;
  }
  for (int round = 0; round < MostRounds; ++round)
  {
    const double begin = 1.0 - std::pow(0.8, round); // how many there will be is not known
    const double end = 1.0 - std::pow(0.8, round + 1);
    this->Certify(filter, begin, end);
    if (vtkRidgesCompatibility::IsAborted(filter))
    {
      return true;
    }
    if (this->Mesh->NumberOfPoints() >= filter->GetMaximumNumberOfPoints() ||
      this->Certificate.HoldsEverywhere() || !this->Mesh->Refine(this->Certificate))
    {
      this->Done = true;
      return true;
    }
  }
  this->Certify(filter, 0.99, 1.0);
  this->Done = !vtkRidgesCompatibility::IsAborted(filter);
  return true;
}
