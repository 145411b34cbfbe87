// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesMongeOutput.h"

#include "Core/Salience/TensorSmoothing.h"
#include "vtkRidgesArrayNames.h"

#include <algorithm>
#include <array>

namespace names = vtkRidgesArrayNames;

namespace
{

template <typename Tuple>
void Put(double* values, vtkIdType p, const Tuple& tuple)
{
  if (values)
  {
    const auto size = static_cast<vtkIdType>(tuple.size());
    std::copy_n(tuple.data(), size, values + p * size);
  }
}

void Put(double* values, vtkIdType p, double value)
{
  if (values)
  {
    values[p] = value;
  }
}

/// Asks for memory that is going to be written some batches later. What comes out goes into a
/// dozen arrays: that is more than the processor follows by itself.
void Announce(const double* values)
{
#ifdef __GNUC__
  __builtin_prefetch(values, 1);
#else
  static_cast<void>(values);
#endif
}

/// Values of all lanes of a batch, component after component, `lanes` apart.
template <int Components>
void Put(double* values, ridges::Span<ridges::Id> points, const double* batch, int lanes)
{
  constexpr int ahead = 32;
  for (int lane = 0; values && lane < points.size(); ++lane)
  {
    double* tuple = values + Components * static_cast<vtkIdType>(points[lane]);
    if (Components > 1 || lane == 0)
    {
      Announce(tuple + ahead * Components);
    }
    for (int i = 0; i < Components; ++i)
    {
      tuple[i] = batch[i * lanes + lane];
    }
  }
}

double Mean(double a, double b, double shareOfB)
{
  return (1.0 - shareOfB) * a + shareOfB * b; // exactly one of them for 0 and 1
}

template <std::size_t Size>
std::array<double, Size> Mean(
  const std::array<double, Size>& a, const std::array<double, Size>& b, double shareOfB)
{
  std::array<double, Size> mean;
  for (std::size_t i = 0; i < Size; ++i)
  {
    mean[i] = Mean(a[i], b[i], shareOfB);
  }
  return mean;
}

struct Errors
{
  double* own;
  const double* others;
  int components;
};

} // namespace

vtkRidgesMongeOutput::vtkRidgesMongeOutput(vtkIdType count, int order, bool standardErrors)
{
  this->Add(this->Normals, names::Normals, 3, order >= 1);
  this->Add(this->MaximumCurvature, names::MaximumCurvature, 1, order >= 2);
  this->Add(this->MinimumCurvature, names::MinimumCurvature, 1, order >= 2);
  this->Add(this->MaximumDirection, names::MaximumDirection, 3, order >= 2);
  this->Add(this->MinimumDirection, names::MinimumDirection, 3, order >= 2);
  this->Add(this->ThirdOrder, names::ThirdOrder, 4, order >= 3, "b");
  this->Add(this->FourthOrder, names::FourthOrder, 5, order >= 4, "c");
  this->Add(this->P1, names::P1, 1, order >= 4);
  this->Add(this->P2, names::P2, 1, order >= 4);

  const bool errors = standardErrors;
  this->Add(this->MaximumCurvatureError, names::MaximumCurvatureError, 1, errors && order >= 2);
  this->Add(this->MinimumCurvatureError, names::MinimumCurvatureError, 1, errors && order >= 2);
  this->Add(this->ThirdOrderError, names::ThirdOrderError, 4, errors && order >= 3, "b");
  this->Add(this->P1Error, names::P1Error, 1, errors && order >= 4);
  this->Add(this->P2Error, names::P2Error, 1, errors && order >= 4);

  this->Add(this->ConditionNumber, names::FitConditionNumber, 1, true);
  this->Add(this->Residual, names::FitResidual, 1, true);
  this->Add(this->Scale, names::FitScale, 1, true);
  this->Add(this->NoiseGain, names::FitNoiseGain, 1, order >= 3);
  this->Allocate(count);
}

void vtkRidgesMongeOutput::Store(vtkIdType p, const ridges::MongeForm& form, const Quality& quality)
{
  Put(this->Normals, p, form.n);
  Put(this->MaximumDirection, p, form.d1);
  Put(this->MinimumDirection, p, form.d2);
  Put(this->ThirdOrder, p, form.b);
  Put(this->FourthOrder, p, form.c);
  Put(this->MaximumCurvature, p, form.k1);
  Put(this->MinimumCurvature, p, form.k2);
  Put(this->P1, p, form.P1());
  Put(this->P2, p, form.P2());
  this->StoreQuality(p, quality);
}

void vtkRidgesMongeOutput::StoreQuality(vtkIdType p, const Quality& quality)
{
  Put(this->ConditionNumber, p, quality.conditionNumber);
  Put(this->Residual, p, quality.residual);
  Put(this->Scale, p, quality.radius);
  Put(this->NoiseGain, p, quality.noiseGain);
  this->Status[p] = quality.status;
}

void vtkRidgesMongeOutput::Store(
  ridges::Span<ridges::Id> points, const ridges::JetBatch& batch, int lanes)
{
  Put<3>(this->Normals, points, batch.n, lanes);
  Put<3>(this->MaximumDirection, points, batch.d1, lanes);
  Put<3>(this->MinimumDirection, points, batch.d2, lanes);
  Put<4>(this->ThirdOrder, points, batch.b, lanes);
  Put<5>(this->FourthOrder, points, batch.c, lanes);
  Put<1>(this->MaximumCurvature, points, batch.k1, lanes);
  Put<1>(this->MinimumCurvature, points, batch.k2, lanes);
  Put<1>(this->P1, points, batch.P1, lanes);
  Put<1>(this->P2, points, batch.P2, lanes);
  Put<1>(this->ConditionNumber, points, batch.conditionNumber, lanes);
  Put<1>(this->Residual, points, batch.residual, lanes);
  Put<1>(this->Scale, points, batch.radius, lanes);
  Put<1>(this->NoiseGain, points, batch.noiseGain, lanes);
  if (!batch.standardErrors)
  {
    return;
  }
  Put<1>(this->MaximumCurvatureError, points, batch.errors, lanes);
  Put<1>(this->MinimumCurvatureError, points, batch.errors + lanes, lanes);
  Put<4>(this->ThirdOrderError, points, batch.errors + 2 * lanes, lanes);
  Put<1>(this->P1Error, points, batch.errors + 6 * lanes, lanes);
  Put<1>(this->P2Error, points, batch.errors + 7 * lanes, lanes);
}

ridges::MongeField vtkRidgesMongeOutput::View() const
{
  ridges::MongeField field;
  field.k1 = this->MaximumCurvature;
  field.k2 = this->MinimumCurvature;
  field.d1 = this->MaximumDirection;
  field.d2 = this->MinimumDirection;
  field.b = this->ThirdOrder;
  field.c = this->FourthOrder;
  field.P1 = this->P1;
  field.P2 = this->P2;
  return field;
}

vtkRidgesMongeOutput::Quality vtkRidgesMongeOutput::GetQuality(vtkIdType p) const
{
  return { this->ConditionNumber[p], this->Residual[p], this->Scale[p],
    this->NoiseGain ? this->NoiseGain[p] : 0.0, this->Status[p] };
}

vtkRidgesMongeOutput::Quality vtkRidgesMongeOutput::Blended(
  const Quality* fits, const double* shares, int count)
{
  Quality mean;
  double error = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const Quality& fit = fits[i];
    mean.conditionNumber += shares[i] * fit.conditionNumber;
    mean.radius += shares[i] * fit.radius;
    mean.noiseGain += shares[i] * fit.noiseGain;
    error += fit.radius > 0.0
      ? shares[i] * (fit.noiseGain * fit.residual / (fit.radius * fit.radius))
      : 0.0;
  }
  // So that it is still true what it says of the error of the third order, with the gain.
  mean.residual = mean.noiseGain > 0.0 ? error * mean.radius * mean.radius / mean.noiseGain : 0.0;
  mean.status = fits[std::max_element(shares, shares + count) - shares].status;
  return mean;
}

void vtkRidgesMongeOutput::Blend(vtkIdType p, const vtkRidgesMongeOutput& other, double share)
{
  const auto id = static_cast<ridges::Id>(p);
  const ridges::MongeField own = this->View();
  const ridges::MongeField from = other.View();
  ridges::MongeForm form;
  const bool isBlended = this->FourthOrder
    ? ridges::FourthOrderFromSpace(
        Mean(ridges::FourthOrderToSpace(own, id), ridges::FourthOrderToSpace(from, id), share),
        form)
    : ridges::ThirdOrderFromSpace(
        Mean(ridges::ThirdOrderToSpace(own, id), ridges::ThirdOrderToSpace(from, id), share), form);
  if (!isBlended)
  {
    return;
  }
  const Quality fits[] = { this->GetQuality(p), other.GetQuality(p) };
  const double shares[] = { 1.0 - share, share };
  this->Store(p, form, Blended(fits, shares, 2));
  for (const auto& [errors, others, components] :
    { Errors{ this->MaximumCurvatureError, other.MaximumCurvatureError, 1 },
      Errors{ this->MinimumCurvatureError, other.MinimumCurvatureError, 1 },
      Errors{ this->ThirdOrderError, other.ThirdOrderError, 4 },
      Errors{ this->P1Error, other.P1Error, 1 }, Errors{ this->P2Error, other.P2Error, 1 } })
  {
    for (vtkIdType i = components * p; errors && i < components * (p + 1); ++i)
    {
      // Negative: unknown.
      errors[i] = errors[i] < 0.0 || others[i] < 0.0 ? (share > 0.5 ? others[i] : errors[i])
                                                     : Mean(errors[i], others[i], share);
    }
  }
}

void vtkRidgesMongeOutput::StoreErrors(vtkIdType p, const ridges::JetErrors& errors)
{
  Put(this->MaximumCurvatureError, p, errors.k1);
  Put(this->MinimumCurvatureError, p, errors.k2);
  Put(this->ThirdOrderError, p, errors.b);
  Put(this->P1Error, p, errors.P1);
  Put(this->P2Error, p, errors.P2);
}
