// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesFitSettings.h"

#include "Core/Fit/JetFit.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{

/// Where none is set, and none is chosen.
constexpr int DefaultDegree = 4;

} // namespace

vtkRidgesFitPoints::Settings vtkRidgesFitSettings(vtkJetFitting* filter)
{
  using Kind = ridges::NeighborhoodRule::Kind;
  constexpr Kind kinds[] = { Kind::PointCount, Kind::Rings, Kind::Radius,
    Kind::RingsAndPointCount };
  vtkRidgesFitPoints::Settings settings;
  settings.degree = filter->GetDegree() > 0 ? filter->GetDegree() : DefaultDegree;
  settings.weighting = filter->GetWeighting() == vtkJetFitting::GAUSSIAN
    ? ridges::Weighting::Gaussian
    : ridges::Weighting::Uniform;
  settings.standardErrors = filter->GetStandardErrors();
  settings.rule.kind = kinds[filter->GetNeighborhood()];
  settings.rule.minimumNumberOfPoints =
    std::max(filter->GetMinimumNumberOfPoints(), ridges::JetFitter::FewestPoints(settings.degree));
  settings.rule.numberOfRings = filter->GetNumberOfRings();
  settings.rule.radius = filter->GetRadius();
  return settings;
}

std::vector<vtkRidgesFitPoints::Settings> vtkRidgesFitSettings(
  vtkJetFitting* filter, const ridges::JetChoice& choice)
{
  std::vector<vtkRidgesFitPoints::Settings> fits;
  const auto add = [filter, &fits, &choice](int degree, int numberOfRings)
  {
    vtkRidgesFitPoints::Settings settings = vtkRidgesFitSettings(filter);
    settings.degree = degree;
    settings.exactGain = !choice.blend.empty();
    settings.rule.numberOfRings = numberOfRings;
    settings.rule.minimumNumberOfPoints =
      std::max(filter->GetMinimumNumberOfPoints(), ridges::JetFitter::FewestPoints(degree));
    fits.push_back(settings);
  };
  for (const ridges::BlendedJet& jet : choice.blend)
  {
    add(jet.degree, jet.numberOfRings);
  }
  if (fits.empty())
  {
    add(choice.degree, choice.numberOfRings);
  }
  return fits;
}

int vtkRidgesFitOrder(vtkJetFitting* filter)
{
  const bool isChosen =
    filter->GetNeighborhood() == vtkJetFitting::AUTOMATIC && filter->GetDegree() == 0;
  return isChosen ? filter->GetMongeOrder()
                  : std::min(filter->GetMongeOrder(), vtkRidgesFitSettings(filter).degree);
}

std::string vtkRidgesFitSettingsFault(vtkJetFitting* filter)
{
  const double radius = filter->GetRadius();
  if (filter->GetNeighborhood() != vtkJetFitting::BY_RADIUS ||
    (radius > 0.0 && std::isfinite(radius)))
  {
    return {};
  }
  std::ostringstream text;
  text << "Neighborhood is by radius, but Radius is " << radius << ": set a positive one";
  return text.str();
}
