// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesJetBlend.h"

#include "Core/Fit/JetBlend.h"
#include "vtkJetFitting.h"
#include "vtkRidgesBatches.h"

#include <memory>

namespace
{

/// A functor that blends the fits of one kind into those before.
struct BlendPoints
{
  const vtkRidgesMongeOutput& fits;
  ridges::BlendedJet jet;
  double noise;
  vtkRidgesMongeOutput& blend;
  std::vector<double>& weights; ///< Of the blend so far: 0 where there is no good fit in it.

  void operator()(vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType p = begin; p < end; ++p)
    {
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

} // namespace

bool vtkRidgesFitJets(vtkJetFitting* filter, const vtkRidgesJets& jets, double from, double to,
  vtkRidgesMongeOutput& output, std::vector<int>* reach)
{
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
    if (reach)
    {
      fitPoints.NoteReach(*reach);
    }
    const double fitted = from + 0.9 * step;
    if (!vtkRidgesForBatches(filter, jets.count, from, fitted, fitPoints, fitPoints.BatchSize()))
    {
      return false;
    }
    BlendPoints blend{ fits, { jets.fits[i].degree, jets.fits[i].rule.numberOfRings }, jets.noise,
      output, weights };
    if (isBlend && !vtkRidgesForBatches(filter, jets.count, fitted, from + step, blend))
    {
      return false;
    }
  }
  return true;
}
