// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesFitPoints.h"

#include "Core/Fit/JetErrors.h"

#include <algorithm>
#include <cmath>

namespace
{

/// Condition numbers that one ring more may better.
constexpr double GrowAbove = 2000.0;

/// Batches estimate them lower, mostly by a third.
constexpr double GrowBatchAbove = 0.5 * GrowAbove;

bool IsFinite(const ridges::MongeForm& form)
{
  const auto finite = [](double value) { return std::isfinite(value); };
  return finite(form.k1) && finite(form.k2) && finite(form.P1()) && finite(form.P2()) &&
    form.n.allFinite() && form.d1.allFinite() && form.d2.allFinite() &&
    std::all_of(form.b.begin(), form.b.end(), finite) &&
    std::all_of(form.c.begin(), form.c.end(), finite);
}

} // namespace

vtkRidgesFitPoints::vtkRidgesFitPoints(const ridges::TriangleMesh& mesh,
  const ridges::OrderedRings& rings, const Settings& settings, vtkRidgesMongeOutput& output)
  : Mesh(mesh)
  , Rings(rings)
  , Wanted(settings)
  , Output(output)
{
  // The batches know degrees 2 to 4; whatever they cannot do is done point by point.
  const std::vector<ridges::JetBatchKernel>& kernels = ridges::JetBatchKernels();
  if (settings.degree >= 2 && !kernels.empty())
  {
    this->Kernel = &kernels.front();
  }
}

void vtkRidgesFitPoints::operator()(vtkIdType begin, vtkIdType end)
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
  this->FitBatches(*scratch);
}

/// Into the batches with it if it fits there, else it is fitted at once.
void vtkRidgesFitPoints::Take(ridges::Id p, Scratch& scratch)
{
  const auto points = scratch.neighborhood.Gather(p, this->Wanted.rule);
  const bool wholeRings = this->Wanted.rule.kind != ridges::NeighborhoodRule::Kind::Radius;
  if (!this->Kernel || !scratch.batches.Add(p, points, wholeRings))
  {
    this->FitAlone(p, scratch);
  }
  else if (scratch.batches.IsFull())
  {
    this->FitBatches(scratch);
  }
}

void vtkRidgesFitPoints::FitBatches(Scratch& scratch)
{
  if (scratch.batches.IsEmpty())
  {
    return;
  }
  scratch.batches.Fit(*this->Kernel,
    [&](const ridges::JetBatch& batch, ridges::Span<ridges::Id> vertices)
    {
      this->Output.Store(vertices, batch, this->Kernel->lanes);
      for (int lane = 0; lane < vertices.size(); ++lane)
      {
        const ridges::Id p = vertices[lane];
        if (batch.good[lane] == 0.0 || !(batch.conditionNumber[lane] <= GrowBatchAbove))
        {
          this->FitAlone(p, scratch);
          continue;
        }
        this->Output.StoreStatus(
          p, this->Rings.OnBorder(p) ? ridges::FitBoundary : ridges::FitGood);
        if (this->Wanted.standardErrors)
        {
          // Batches do not keep what errors are made of. All other values stay theirs.
          const ridges::JetFit fit =
            this->Fit(p, scratch.neighborhood.Gather(p, this->Wanted.rule), scratch);
          this->Output.StoreErrors(p, ridges::StandardErrors(scratch.fitter, fit));
        }
      }
    });
}

ridges::JetFit vtkRidgesFitPoints::Fit(
  ridges::Id p, ridges::Span<ridges::Id> points, Scratch& scratch) const
{
  const Eigen::Vector3d origin = this->Mesh.Point(p);
  scratch.offsets.resize(3, points.size());
  for (ridges::Id i = 0; i < points.size(); ++i)
  {
    scratch.offsets.col(i) = this->Mesh.Point(points[i]) - origin;
  }
  return scratch.fitter.Fit(
    scratch.offsets, this->Wanted.degree, this->Mesh.PointNormal(p), this->Wanted.weighting);
}

void vtkRidgesFitPoints::FitAlone(ridges::Id p, Scratch& scratch)
{
  // One-sided neighbourhoods may hold enough points in too few rows: a few rings more help.
  // Where the user has said how many rings, or how far, it stays at that.
  using Kind = ridges::NeighborhoodRule::Kind;
  constexpr int mostRingsAdded = 4;
  const ridges::NeighborhoodRule& rule = this->Wanted.rule;
  ridges::JetFit fit = this->Fit(p, scratch.neighborhood.Gather(p, rule), scratch);
  const bool mayGrow = rule.kind == Kind::PointCount || rule.kind == Kind::RingsAndPointCount;
  for (int added = 0; mayGrow && added < mostRingsAdded && fit.conditionNumber > GrowAbove; ++added)
  {
    fit = this->Fit(p, scratch.neighborhood.Grow(), scratch);
  }

  // Less than a quadric says nothing of curvature, unless a plane was all that was asked for.
  vtkRidgesMongeOutput::Quality quality{ fit.conditionNumber, fit.residual, fit.radius,
    fit.status };
  if (fit.degree < std::min(2, this->Wanted.degree))
  {
    quality.status |= ridges::FitInvalid;
  }
  ridges::MongeForm form;
  if (!(quality.status & ridges::FitInvalid))
  {
    form = ridges::MongeFormOfHeightJet(fit.jet, fit.frame);
  }
  this->Store(p, form, quality);
  if (this->Wanted.standardErrors)
  {
    this->Output.StoreErrors(p, ridges::StandardErrors(scratch.fitter, fit));
  }
}

void vtkRidgesFitPoints::Store(
  ridges::Id p, const ridges::MongeForm& form, const vtkRidgesMongeOutput::Quality& quality)
{
  const int border = this->Rings.OnBorder(p) ? ridges::FitBoundary : 0;
  if (!(quality.status & ridges::FitInvalid) && IsFinite(form) && std::isfinite(quality.residual))
  {
    vtkRidgesMongeOutput::Quality stored = quality;
    stored.status |= border;
    this->Output.Store(p, form, stored);
  }
  else
  {
    vtkRidgesMongeOutput::Quality none;
    none.status = quality.status | border | ridges::FitInvalid;
    this->Output.Store(p, ridges::MongeForm(), none);
  }
}
