// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Salience/TensorSmoothing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ridges
{
namespace
{

/// Number of the component of a symmetric tensor of order three with these indices.
constexpr int ThirdOrderIndex[3][3][3] = { { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } },
  { { 1, 3, 4 }, { 3, 6, 7 }, { 4, 7, 8 } }, { { 2, 4, 5 }, { 4, 7, 8 }, { 5, 8, 9 } } };

void AddNormalAndSecondOrder(const MongeField& field, Id p, double* values)
{
  const Eigen::Vector3d d1 = field.D1(p);
  const Eigen::Vector3d d2 = field.D2(p);
  const Eigen::Vector3d n = d1.cross(d2);
  for (int i = 0; i < 3; ++i)
  {
    values[i] = n[i];
  }
  int at = 3;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i; j < 3; ++j)
    {
      values[at++] = field.k1[p] * d1[i] * d1[j] + field.k2[p] * d2[i] * d2[j];
    }
  }
}

bool FrameFromSpace(const double* values, MongeForm& form)
{
  const Eigen::Vector3d sum(values[0], values[1], values[2]);
  const double length = sum.norm();
  if (!(length > 0.0))
  {
    return false;
  }
  form.n = sum / length;
  Eigen::Matrix3d T;
  T << values[3], values[4], values[5], values[4], values[6], values[7], values[5], values[7],
    values[8];
  const Eigen::Vector3d u = form.n.unitOrthogonal();
  const Eigen::Vector3d v = form.n.cross(u);
  const double uu = u.dot(T * u);
  const double uv = u.dot(T * v);
  const double vv = v.dot(T * v);
  const double mean = 0.5 * (uu + vv);
  const double along = 0.5 * (uu - vv);
  const double deviation = std::hypot(along, uv);
  // Half the angle of (along, uv), without cancellation.
  double cosine = along >= 0.0 ? deviation + along : std::abs(uv);
  double sine = along >= 0.0 ? uv : std::copysign(deviation - along, uv);
  const double norm = std::hypot(cosine, sine);
  cosine = norm > 0.0 ? cosine / norm : 1.0;
  sine = norm > 0.0 ? sine / norm : 0.0;
  form.d1 = cosine * u + sine * v;
  form.d2 = form.n.cross(form.d1);
  form.k1 = mean + deviation;
  form.k2 = mean - deviation;
  return true;
}

double Contract(const double* tensor, const Eigen::Vector3d& u, const Eigen::Vector3d& v,
  const Eigen::Vector3d& w)
{
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      for (int k = 0; k < 3; ++k)
      {
        sum += tensor[ThirdOrderIndex[i][j][k]] * u[i] * v[j] * w[k];
      }
    }
  }
  return sum;
}

} // namespace

SecondOrderValues SecondOrderToSpace(const MongeField& field, Id p)
{
  SecondOrderValues values{};
  AddNormalAndSecondOrder(field, p, values.data());
  return values;
}

ThirdOrderValues ThirdOrderToSpace(const MongeField& field, Id p)
{
  ThirdOrderValues values{};
  AddNormalAndSecondOrder(field, p, values.data());
  const Eigen::Vector3d d1 = field.D1(p);
  const Eigen::Vector3d d2 = field.D2(p);
  const double* b = field.ThirdOrder(p);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i; j < 3; ++j)
    {
      for (int k = j; k < 3; ++k)
      {
        values[9 + ThirdOrderIndex[i][j][k]] = b[0] * d1[i] * d1[j] * d1[k] +
          b[1] * (d1[i] * d1[j] * d2[k] + d1[i] * d2[j] * d1[k] + d2[i] * d1[j] * d1[k]) +
          b[2] * (d1[i] * d2[j] * d2[k] + d2[i] * d1[j] * d2[k] + d2[i] * d2[j] * d1[k]) +
          b[3] * d2[i] * d2[j] * d2[k];
      }
    }
  }
  if (field.c)
  {
    MongeForm form;
    form.k1 = field.k1[p];
    form.k2 = field.k2[p];
    std::copy_n(b, 4, form.b.begin());
    std::copy_n(field.c + 5 * static_cast<std::size_t>(p), 5, form.c.begin());
    values[19] = form.P1();
    values[20] = form.P2();
  }
  else
  {
    values[19] = field.P(Color::Blue, p);
    values[20] = field.P(Color::Red, p);
  }
  return values;
}

bool SecondOrderFromSpace(const SecondOrderValues& values, MongeForm& form)
{
  return FrameFromSpace(values.data(), form);
}

bool ThirdOrderFromSpace(const ThirdOrderValues& values, MongeForm& form)
{
  if (!FrameFromSpace(values.data(), form))
  {
    return false;
  }
  const double* tensor = values.data() + 9;
  form.b = { Contract(tensor, form.d1, form.d1, form.d1),
    Contract(tensor, form.d1, form.d1, form.d2), Contract(tensor, form.d1, form.d2, form.d2),
    Contract(tensor, form.d2, form.d2, form.d2) };
  return true;
}

SmoothingPlan::SmoothingPlan(const OneRings& rings, const double* fitScale, double sigma)
  : Rings_(rings)
  , FitScale_(fitScale)
  , Variance_(sigma * sigma)
{
  std::vector<double> steps;
  for (Id p = 0; p < rings.Mesh().NumberOfPoints(); ++p)
  {
    if (rings.Around(p).size() > 0)
    {
      steps.push_back(this->StepsFor(p));
    }
  }
  if (!steps.empty())
  {
    // A few tiny triangles must not make all others wait for them.
    constexpr double part = 0.95;
    const auto which =
      steps.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(steps.size() - 1));
    std::nth_element(steps.begin(), which, steps.end());
    // So written that what is not finite is cut as well.
    this->IsCut_ = !(*which <= MostSteps);
    this->Steps_ =
      this->IsCut_ ? MostSteps : std::max(LeastSteps, static_cast<int>(std::ceil(*which)));
  }
}

double SmoothingPlan::FitVariance(Id p) const
{
  const double sigma = this->FitScale_ ? SigmaPerRadius * this->FitScale_[p] : 0.0;
  return sigma * sigma;
}

double SmoothingPlan::StepsFor(Id p) const
{
  const double missing = this->Variance_ - this->FitVariance(p);
  const double perStep = this->Rings_.Variance(p);
  return missing > 0.0 && perStep > 0.0 ? missing / perStep : 0.0;
}

double SmoothingPlan::Share(Id p) const
{
  return std::min(1.0, std::max<double>(LeastSteps, this->StepsFor(p)) / this->Steps_);
}

double SmoothingPlan::Sigma(Id p) const
{
  return std::sqrt(this->FitVariance(p) + this->Steps_ * this->Share(p) * this->Rings_.Variance(p));
}

} // namespace ridges
