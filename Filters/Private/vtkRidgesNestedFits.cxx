// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesNestedFits.h"

#include "Core/Fit/JetBlend.h"

#include <algorithm>

namespace
{

ridges::NeighborhoodRule InRings(int numberOfRings)
{
  ridges::NeighborhoodRule rule;
  rule.kind = ridges::NeighborhoodRule::Kind::Rings;
  rule.numberOfRings = numberOfRings;
  return rule;
}

} // namespace

bool vtkRidgesNestedFits::Can(const Settings& fits)
{
  if (fits.size() != Fits || ridges::NestedJetKernels().empty())
  {
    return false;
  }
  int before = 0;
  for (int i = 0; i < Fits; ++i)
  {
    const vtkRidgesFitPoints::Settings& fit = fits[i];
    const bool isNested = fit.degree == ridges::NestedJetBatch::Degrees[i] &&
      fit.rule.kind == ridges::NeighborhoodRule::Kind::RingsAndPointCount &&
      fit.rule.numberOfRings > before;
    if (!isNested || fit.weighting != ridges::Weighting::Uniform)
    {
      return false;
    }
    before = fit.rule.numberOfRings;
  }
  return true;
}

vtkRidgesNestedFits::Scratch::Scratch(const vtkRidgesNestedFits& fit)
  : fitter(fit.Mesh, fit.Rings, InRings(fit.NumberOfRings[0]),
      ridges::NestedJetBatch::Degrees[Fits - 1], ridges::Weighting::Uniform)
  , batches(fit.Mesh, fit.Rings)
{
}

vtkRidgesNestedFits::vtkRidgesNestedFits(const ridges::TriangleMesh& mesh,
  const ridges::OrderedRings& rings, const Settings& fits, double noise,
  vtkRidgesMongeOutput& output)
  : Mesh(mesh)
  , Rings(rings)
  , Kernel(ridges::NestedJetKernels().front())
  , Noise(noise)
  , Output(output)
{
  for (int i = 0; i < Fits; ++i)
  {
    this->NumberOfRings[i] = fits[i].rule.numberOfRings;
    this->FewestPoints[i] = fits[i].rule.minimumNumberOfPoints;
  }
}

void vtkRidgesNestedFits::operator()(vtkIdType begin, vtkIdType end)
{
  Scratch& scratch = this->PerThread.Get([this] { return std::make_shared<Scratch>(*this); });
  for (vtkIdType p = begin; p < end; ++p)
  {
    this->Take(static_cast<ridges::Id>(p), scratch);
  }
  this->FitBatches(scratch);
}

void vtkRidgesNestedFits::Take(ridges::Id p, Scratch& scratch)
{
  ridges::NestedJetFiller::Counts counts;
  ridges::Span<ridges::Id> points = scratch.fitter.Gather(p);
  bool isPlain = scratch.fitter.IsInRings();
  for (int i = 0; i < Fits; ++i)
  {
    for (int ring = i == 0 ? 0 : this->NumberOfRings[i - 1]; i > 0 && ring < this->NumberOfRings[i];
         ++ring)
    {
      points = scratch.fitter.Grow();
    }
    counts[i] = points.size();
    isPlain = isPlain && scratch.fitter.IsInRings() && counts[i] >= this->FewestPoints[i];
  }
  const int reach = scratch.fitter.TakeReach();
  if (this->Reach)
  {
    (*this->Reach)[p] = std::max((*this->Reach)[p], reach);
  }
  if (!isPlain || !scratch.batches.Add(p, points, counts))
  {
    scratch.others.push_back(p);
  }
  else if (scratch.batches.IsFull())
  {
    this->FitBatches(scratch);
  }
}

void vtkRidgesNestedFits::FitBatches(Scratch& scratch)
{
  scratch.batches.Fit(
    this->Kernel,
    [this](ridges::NestedJetBatch& batch, const Vertices&) { this->SetShares(batch); },
    [this, &scratch](const ridges::NestedJetBatch& batch, const Vertices& vertices)
    {
      this->Output.Store(vertices, batch.fits[Fits - 1], this->Kernel.lanes);
      for (int lane = 0; lane < vertices.size(); ++lane)
      {
        const ridges::Id p = vertices[lane];
        if (this->IsPlain(batch, lane, scratch))
        {
          vtkRidgesMongeOutput::Quality quality = this->QualityOf(batch, lane);
          quality.status = this->Rings.OnBorder(p) ? ridges::FitBoundary : ridges::FitGood;
          this->Output.StoreQuality(p, quality);
        }
        else
        {
          scratch.others.push_back(p);
        }
      }
    });
}

void vtkRidgesNestedFits::SetShares(ridges::NestedJetBatch& batch) const
{
  const int lanes = this->Kernel.lanes;
  for (int lane = 0; lane < lanes; ++lane)
  {
    std::array<double, Fits> weights;
    double sum = 0.0;
    for (int i = 0; i < Fits; ++i)
    {
      const ridges::JetBatch& fit = batch.fits[i];
      weights[i] = ridges::WeightInNoisyBlend({ fit.degree, this->NumberOfRings[i] }, this->Noise,
        fit.residual[lane], fit.radius[lane], fit.noiseGain[lane]);
      sum += weights[i];
    }
    for (int i = 0; i < Fits; ++i)
    {
      batch.shares[i * lanes + lane] = weights[i] / sum;
    }
  }
}

vtkRidgesMongeOutput::Quality vtkRidgesNestedFits::QualityOf(
  const ridges::NestedJetBatch& batch, int lane) const
{
  std::array<vtkRidgesMongeOutput::Quality, Fits> fits;
  std::array<double, Fits> shares;
  for (int i = 0; i < Fits; ++i)
  {
    const ridges::JetBatch& fit = batch.fits[i];
    fits[i] = { fit.conditionNumber[lane], fit.residual[lane], fit.radius[lane],
      fit.noiseGain[lane], ridges::FitGood };
    shares[i] = batch.shares[i * this->Kernel.lanes + lane];
  }
  return vtkRidgesMongeOutput::Blended(fits.data(), shares.data(), Fits);
}

bool vtkRidgesNestedFits::IsPlain(
  const ridges::NestedJetBatch& batch, int lane, Scratch& scratch) const
{
  const int lanes = this->Kernel.lanes;
  const double* n = batch.fits[Fits - 1].n + lane;
  const Eigen::Vector3d normal(n[0], n[lanes], n[2 * lanes]);
  return std::all_of(std::begin(batch.fits), std::end(batch.fits),
    [&](const ridges::JetBatch& fit)
    {
      return vtkRidgesFitPoints::Judge(fit, lane, normal, scratch.fitter) ==
        vtkRidgesFitPoints::Verdict::Good;
    });
}

std::vector<ridges::Id> vtkRidgesNestedFits::GetOthers()
{
  std::vector<ridges::Id> others;
  this->PerThread.ForEach([&others](const Scratch& scratch)
    { others.insert(others.end(), scratch.others.begin(), scratch.others.end()); });
  std::sort(others.begin(), others.end());
  return others;
}
