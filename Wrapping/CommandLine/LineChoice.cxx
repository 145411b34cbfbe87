// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LineChoice.h"

#include "vtkDataArray.h"
#include "vtkJetFitting.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace names = vtkRidgesArrayNames;

namespace program
{

double ThirdOrderUncertainty(vtkPolyData* fitted)
{
  vtkPointData* data = fitted->GetPointData();
  vtkDataArray* status = data->GetArray(names::FitStatus);
  vtkDataArray* third = data->GetArray(names::ThirdOrder);
  vtkDataArray* residuals = data->GetArray(names::FitResidual);
  vtkDataArray* scales = data->GetArray(names::FitScale);
  vtkDataArray* gains = data->GetArray(names::FitNoiseGain);
  std::vector<double> uncertainties;
  for (vtkIdType i = 0; i < fitted->GetNumberOfPoints(); ++i)
  {
    if ((static_cast<int>(status->GetTuple1(i)) & ~vtkJetFitting::FIT_BOUNDARY) != 0)
    {
      continue;
    }
    double b[4];
    third->GetTuple(i, b);
    const double scale = scales->GetTuple1(i);
    const double times[] = { 1.0, 3.0, 3.0, 1.0 };
    double square = 0.0;
    for (int k = 0; k < 4; ++k)
    {
      square += times[k] * b[k] * b[k];
    }
    const double cubic = std::sqrt(square) * scale * scale;
    uncertainties.push_back(cubic > 0.0 ? gains->GetTuple1(i) * residuals->GetTuple1(i) / cubic
                                        : std::numeric_limits<double>::infinity());
  }
  if (uncertainties.empty())
  {
    return std::numeric_limits<double>::infinity();
  }
  const auto quartile =
    uncertainties.begin() + static_cast<std::ptrdiff_t>(3 * (uncertainties.size() - 1) / 4);
  std::nth_element(uncertainties.begin(), quartile, uncertainties.end());
  return *quartile;
}

LineChoice ChooseLines(vtkPolyData* fitted)
{
  constexpr double greatest = 0.12;
  const double uncertainty = ThirdOrderUncertainty(fitted);
  char percent[32];
  std::snprintf(percent, sizeof(percent), "%.2g %%", 100.0 * uncertainty);
  if (uncertainty <= greatest)
  {
    return { Lines::Complete,
      "complete: the mesh is smooth, third derivatives are exact to " + std::string(percent) +
        " (--salient shows the main lines)" };
  }
  const std::string reason = std::isfinite(uncertainty)
    ? "noise or fine detail makes third derivatives uncertain by " +
      std::string(uncertainty < 1.0 ? percent : "100 % and more")
    : std::string("much of the mesh is flat");
  return { Lines::Salient, "salient: " + reason + " (--complete shows all ridges)" };
}

} // namespace program
