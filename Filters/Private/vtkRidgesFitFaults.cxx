// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesFitFaults.h"

#include "vtkJetFitting.h"
#include "vtkRidgesMesh.h"

#include "vtkIntArray.h"

#include <algorithm>
#include <sstream>

vtkRidgesFitFaults& vtkRidgesFitFaults::operator+=(const vtkRidgesFitFaults& other)
{
  this->triangulatedCells += other.triangulatedCells;
  this->unusableTriangles += other.unusableTriangles;
  this->nonManifoldEdges += other.nonManifoldEdges;
  this->inconsistentEdges += other.inconsistentEdges;
  this->invalid += other.invalid;
  this->tooFew += other.tooFew;
  this->folded += other.folded;
  this->illConditioned += other.illConditioned;
  this->coincident += other.coincident;
  this->points += other.points;
  this->triangles += other.triangles;
  return *this;
}

void vtkRidgesFitFaults::CountPoints(vtkIntArray* status, const vtkRidgesMesh* hiddenPoints)
{
  const int* statuses = status->GetPointer(0);
  const vtkIdType count = status->GetNumberOfTuples();
  int anyBits = 0;
  for (vtkIdType p = 0; p < count; ++p)
  {
    anyBits |= statuses[p];
  }
  const auto sumOf = [statuses, count, anyBits, hiddenPoints](int bit)
  {
    vtkIdType sum = 0;
    for (vtkIdType p = 0; (anyBits & bit) && p < count; ++p)
    {
      const bool isHidden = hiddenPoints && hiddenPoints->IsHidden(static_cast<ridges::Id>(p));
      sum += (statuses[p] & bit) && !isHidden ? 1 : 0;
    }
    return sum;
  };
  this->points += count;
  this->invalid += sumOf(vtkJetFitting::FIT_INVALID);
  this->tooFew += sumOf(vtkJetFitting::FIT_TOO_FEW_POINTS);
  this->folded += sumOf(vtkJetFitting::FIT_FOLDED);
  this->illConditioned += sumOf(vtkJetFitting::FIT_ILL_CONDITIONED);
}

std::string vtkRidgesFitFaults::GetText() const
{
  std::ostringstream text;
  const auto say = [&text](std::int64_t number, const char* what)
  {
    if (number > 0)
    {
      text << (text.tellp() > 0 ? "; " : "") << number << " " << what;
    }
  };
  say(this->triangulatedCells, "polygons or strips were triangulated");
  say(this->unusableTriangles,
    "triangles were left out (a repeated corner, or a point that is missing or not finite)");
  say(this->nonManifoldEdges, "edges with more than two triangles were taken as borders");
  say(this->inconsistentEdges,
    "edges lie between triangles of opposite orientation (vtkPolyDataNormals can fix that)");
  say(this->invalid,
    "points have no fit (isolated, or too few or collinear neighbours): their values are 0");
  say(this->tooFew, "points have fewer neighbours than coefficients");
  say(this->folded, "points lie where the surface folds over within their neighbourhood");
  say(this->illConditioned, "points are ill conditioned");
  if (this->MayBeFromCoincidentPoints())
  {
    say(this->coincident, "points coincide with another (vtkStaticCleanPolyData merges them)");
    if (this->coincident == 0 && this->folded > 0)
    {
      text << " (a finer mesh there helps)";
    }
    else if (this->coincident == 0 && 2 * std::max(this->invalid, this->tooFew) > this->points)
    {
      text << "; " << this->triangles << " triangles are too few: refine the mesh";
    }
  }
  return text.str();
}

vtkRidgesFitFaults vtkRidgesCountFitFaults(
  vtkRidgesMesh& mesh, const ridges::OrderedRings& rings, vtkIntArray* status)
{
  vtkRidgesFitFaults faults;
  faults.triangulatedCells = mesh.GetNumberOfTriangulatedCells();
  faults.unusableTriangles = mesh.GetNumberOfUnusableTriangles();
  const ridges::TriangleMesh& triangles = mesh.GetTriangles();
  // Edges are at fault only where fans are.
  if (rings.HasIrregular())
  {
    mesh.BuildEdges();
    faults.nonManifoldEdges = triangles.NumberOfNonManifoldEdges();
    faults.inconsistentEdges = triangles.NumberOfInconsistentEdges();
  }
  faults.CountPoints(status, &mesh);
  faults.triangles = triangles.NumberOfTriangles();
  if (faults.MayBeFromCoincidentPoints())
  {
    faults.coincident = mesh.CountCoincidentPoints();
  }
  return faults;
}
