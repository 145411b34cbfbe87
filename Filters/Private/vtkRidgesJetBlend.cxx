// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesJetBlend.h"

#include "Core/Fit/JetBlend.h"
#include "vtkJetFitting.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesNestedFits.h"

#include <memory>

namespace
{

/// A functor that blends the fits of one kind into those before, of all points or of some.
struct BlendPoints
{
  const std::vector<ridges::Id>* selected;
  const vtkRidgesMongeOutput& fits;
  ridges::BlendedJet jet;
  double noise;
  vtkRidgesMongeOutput& blend;
  std::vector<double>& weights; ///< Of the blend so far: 0 where there is no good fit in it.

  void operator()(vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const vtkIdType p = this->selected ? (*this->selected)[i] : i;
      const vtkRidgesMongeOutput::Quality quality = this->fits.GetQuality(p);
      if ((quality.status & ~ridges::FitBoundary) != 0)
      {
        continue;
      }
      const double weight = this->noise > 0.0
        ? ridges::WeightInNoisyBlend(
            this->jet, this->noise, quality.residual, quality.radius, quality.noiseGain)
        : ridges::WeightInBlend(this->jet, quality.residual, quality.radius, quality.noiseGain);
      const double sum = this->weights[p] + weight;
      if (&this->fits != &this->blend)
      {
        this->blend.Blend(p, this->fits, weight / sum);
      }
      this->weights[p] = sum;
    }
  }
};

/// Fit after fit, of all points or of some.
bool FitOneByOne(vtkJetFitting* filter, const vtkRidgesJets& jets,
  const std::vector<ridges::Id>* selected, double from, double to, vtkRidgesMongeOutput& output,
  std::vector<int>* reach)
{
  const vtkIdType count = selected ? static_cast<vtkIdType>(selected->size()) : jets.count;
  const bool isBlend = jets.fits.size() > 1;
  std::vector<double> weights(isBlend ? jets.count : 0, 0.0);
  std::unique_ptr<vtkRidgesMongeOutput> others;
  if (isBlend)
  {
    others = std::make_unique<vtkRidgesMongeOutput>(
      jets.count, jets.order, jets.fits.front().standardErrors);
  }
  const double step = (to - from) / static_cast<double>(jets.fits.size());
  for (std::size_t i = 0; i < jets.fits.size(); ++i, from += step)
  {
    vtkRidgesMongeOutput& fits = i == 0 ? output : *others;
    vtkRidgesFitPoints fitPoints(jets.mesh, jets.rings, jets.fits[i], fits);
    if (selected)
    {
      fitPoints.Select(*selected);
    }
    if (reach)
    {
      fitPoints.NoteReach(*reach);
    }
    const double fitted = from + 0.9 * step;
    if (!vtkRidgesForBatches(filter, count, from, fitted, fitPoints, fitPoints.BatchSize()))
    {
      return false;
    }
    BlendPoints blend{ selected, fits, { jets.fits[i].degree, jets.fits[i].rule.numberOfRings },
      jets.noise, output, weights };
    if (isBlend && !vtkRidgesForBatches(filter, count, fitted, from + step, blend))
    {
      return false;
    }
  }
  return true;
}

} // namespace

bool vtkRidgesFitJets(vtkJetFitting* filter, const vtkRidgesJets& jets, double from, double to,
  vtkRidgesMongeOutput& output, std::vector<int>* reach)
{
  if (!vtkRidgesNestedFits::Can(jets.fits))
  {
    return FitOneByOne(filter, jets, nullptr, from, to, output, reach);
  }
  if (jets.fits.front().standardErrors)
  {
    // Nested fits give none; their forms come in place of these.
    const double fitted = from + 0.6 * (to - from);
    if (!FitOneByOne(filter, jets, nullptr, from, fitted, output, reach))
    {
      return false;
    }
    from = fitted;
  }
  vtkRidgesNestedFits nested(jets.mesh, jets.rings, jets.fits, jets.noise, output);
  if (reach)
  {
    nested.NoteReach(*reach);
  }
  const double middle = from + 0.9 * (to - from);
  if (!vtkRidgesForBatches(filter, jets.count, from, middle, nested, nested.BatchSize()))
  {
    return false;
  }
  const std::vector<ridges::Id> others = nested.GetOthers();
  return others.empty() || FitOneByOne(filter, jets, &others, middle, to, output, reach);
}
