// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesFitPoints.h"

#include "Core/Fit/JetErrors.h"

#include <algorithm>
#include <cmath>

namespace
{

/// Batches only estimate condition numbers, by experience within a factor of two up to degree 4,
/// and of four, rarely eight, above. Between these limits PointFitter decides whether another ring
/// is needed.
constexpr double GoodBelow = 0.5 * ridges::PointFitter::GrowAbove;
constexpr double GrowAbove = 2.0 * ridges::PointFitter::GrowAbove;

bool IsFinite(const ridges::MongeForm& form)
{
  const auto finite = [](double value) { return std::isfinite(value); };
  return finite(form.k1) && finite(form.k2) && finite(form.P1()) && finite(form.P2()) &&
    form.n.allFinite() && form.d1.allFinite() && form.d2.allFinite() &&
    std::all_of(form.b.begin(), form.b.end(), finite) &&
    std::all_of(form.c.begin(), form.c.end(), finite);
}

} // namespace

vtkRidgesFitPoints::Scratch::Scratch(const vtkRidgesFitPoints& fit)
  : fitter(fit.Mesh, fit.Rings, fit.Wanted.rule, fit.Wanted.degree, fit.Wanted.weighting)
  , batches(fit.Mesh, fit.Rings, fit.Wanted.degree, fit.Wanted.weighting, fit.Wanted.standardErrors,
      fit.Wanted.exactGain)
{
}

vtkRidgesFitPoints::vtkRidgesFitPoints(const ridges::TriangleMesh& mesh,
  const ridges::OrderedRings& rings, const Settings& settings, vtkRidgesMongeOutput& output)
  : Mesh(mesh)
  , Rings(rings)
  , Wanted(settings)
  , Output(output)
{
  // The batches know degrees 2 to 8; whatever they cannot do is done point by point.
  const std::vector<ridges::JetBatchKernel>& kernels = ridges::JetBatchKernels();
  if (settings.degree >= 2 && !kernels.empty())
  {
    this->Kernel = &kernels.front();
  }
}

void vtkRidgesFitPoints::operator()(vtkIdType begin, vtkIdType end)
{
  Scratch& scratch = this->PerThread.Get([this] { return std::make_shared<Scratch>(*this); });
  for (vtkIdType i = begin; i < end; ++i)
  {
    this->Take(this->Selected ? (*this->Selected)[i] : static_cast<ridges::Id>(i), 0, scratch);
  }
  this->FitBatches(scratch);
  this->GrowIllConditioned(scratch);
}

/// Into the batches with it if it fits there, else it is fitted at once.
void vtkRidgesFitPoints::Take(ridges::Id p, int ringsAdded, Scratch& scratch)
{
  const auto points = scratch.fitter.Gather(p, ringsAdded);
  this->Note(p, scratch);
  const bool wholeRings =
    this->Wanted.rule.kind != ridges::NeighborhoodRule::Kind::Radius && scratch.fitter.IsInRings();
  if (!this->Kernel || !scratch.batches.Add(p, points, wholeRings))
  {
    this->FitAlone(p, ridges::PointFitter::Growth::Allowed, scratch);
  }
  else if (scratch.batches.IsFull())
  {
    this->FitBatches(scratch);
  }
}

void vtkRidgesFitPoints::Note(ridges::Id p, Scratch& scratch)
{
  const int reach = scratch.fitter.TakeReach();
  if (this->Reach)
  {
    (*this->Reach)[p] = std::max((*this->Reach)[p], reach);
  }
}

void vtkRidgesFitPoints::FitBatches(Scratch& scratch)
{
  if (scratch.batches.IsEmpty())
  {
    return;
  }
  scratch.batches.Fit(*this->Kernel,
    [this, &scratch](const ridges::JetBatch& batch, ridges::Span<ridges::Id> vertices)
    {
      this->Output.Store(vertices, batch, this->Kernel->lanes);
      for (int lane = 0; lane < vertices.size(); ++lane)
      {
        const ridges::Id p = vertices[lane];
        const double* n = batch.n + lane;
        const int lanes = this->Kernel->lanes;
        switch (Judge(batch, lane, { n[0], n[lanes], n[2 * lanes] }, scratch.fitter))
        {
          case Verdict::IllConditioned:
            scratch.illConditioned.push_back(
              { p, batch.conditionNumber[lane] < ridges::JetFitter::IllConditionedAbove });
            break;
          case Verdict::Odd:
            this->FitAlone(p, ridges::PointFitter::Growth::Allowed, scratch);
            break;
          default:
            this->Output.StoreStatus(
              p, this->Rings.OnBorder(p) ? ridges::FitBoundary : ridges::FitGood);
        }
      }
    });
}

/// Of those that are ill conditioned, a few more rings make most well conditioned: ring after ring,
/// as long as there is hope.
void vtkRidgesFitPoints::GrowIllConditioned(Scratch& scratch)
{
  std::vector<IllConditioned> points;
  for (int added = 1; added <= ridges::PointFitter::MostRingsAdded && scratch.fitter.MayGrow();
       ++added)
  {
    points.swap(scratch.illConditioned);
    scratch.illConditioned.clear();
    for (const IllConditioned& point : points)
    {
      this->Take(point.id, added, scratch);
    }
    this->FitBatches(scratch);
  }
  points.swap(scratch.illConditioned);
  scratch.illConditioned.clear();
  using Growth = ridges::PointFitter::Growth;
  for (const IllConditioned& point : points)
  {
    this->FitAlone(point.id, point.isNearlyGood ? Growth::Allowed : Growth::OfNoUse, scratch);
  }
}

vtkRidgesFitPoints::Verdict vtkRidgesFitPoints::Judge(const ridges::JetBatch& batch, int lane,
  const Eigen::Vector3d& normal, ridges::PointFitter& fitter)
{
  if (!(batch.conditionNumber[lane] <= GrowAbove))
  {
    return Verdict::IllConditioned;
  }
  if (batch.good[lane] == 0.0 || batch.conditionNumber[lane] > GoodBelow)
  {
    return Verdict::Odd;
  }
  if (batch.doubtful[lane] == 0.0)
  {
    return Verdict::Good;
  }
  const ridges::Id* first = batch.neighbors[lane];
  const bool isSteep =
    fitter.IsSteep({ first, first + static_cast<int>(batch.counts[lane]) }, normal);
  return isSteep ? Verdict::Odd : Verdict::Good;
}

void vtkRidgesFitPoints::FitAlone(
  ridges::Id p, ridges::PointFitter::Growth growth, Scratch& scratch)
{
  const ridges::JetFit fit = scratch.fitter.Fit(p, growth);
  this->Note(p, scratch);
  // Less than a quadric says nothing of curvature, unless a plane was all that was asked for.
  vtkRidgesMongeOutput::Quality quality{ fit.conditionNumber, fit.residual, fit.radius,
    fit.noiseGain, fit.status };
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
    this->Output.StoreErrors(p, ridges::StandardErrors(scratch.fitter.Fitter(), fit));
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
