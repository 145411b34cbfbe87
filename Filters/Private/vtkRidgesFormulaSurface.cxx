// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesFormulaSurface.h"

#include "Core/Formula/FormulaParser.h"
#include "vtkJetFunction.h"

#include <algorithm>
#include <cmath>

namespace
{

/// What a subclass of vtkJetFunction evaluates, point by point.
class UserFunction : public ridges::JetFunction
{
public:
  explicit UserFunction(vtkJetFunction* function)
    : Function(function)
  {
  }

  Jet1 Linear(const ridges::LaneVector3& x) const override
  {
    Jet1 result;
    for (int lane = 0; lane < ridges::Lanes::Count; ++lane)
    {
      std::array<double, Jet1::Size> values{};
      this->Evaluate(x, lane, 1, values.data());
      const ridges::Taylor3<1> jet =
        ridges::Taylor3<1>::Linear(values[0], values[1], values[2], values[3]);
      SetLane(result, jet, lane);
    }
    return result;
  }

  Jet4 Full(const ridges::LaneVector3& x,
    const std::array<ridges::LaneVector3, 3>& axes) const override
  {
    Jet4 result;
    for (int lane = 0; lane < ridges::Lanes::Count; ++lane)
    {
      std::array<double, Jet4::Size> values{};
      this->Evaluate(x, lane, 4, values.data());
      std::array<ridges::Taylor3<4>, 3> offset;
      for (int i = 0; i < 3; ++i)
      {
        offset[i] =
          ridges::Taylor3<4>::Linear(0.0, axes[0][i][lane], axes[1][i][lane], axes[2][i][lane]);
      }
      SetLane(result, Substituted(values, offset), lane);
    }
    return result;
  }

private:
  using Jet = ridges::Taylor3<4>;

  void Evaluate(const ridges::LaneVector3& x, int lane, int order, double* values) const
  {
    const double point[3] = { x[0][lane], x[1][lane], x[2][lane] };
    this->Function->EvaluateJet(point, order, values);
  }

  /// The polynomial with these coefficients, of three polynomials: by Horner's rule.
  static Jet Substituted(
    const std::array<double, Jet4::Size>& values, const std::array<Jet, 3>& offset)
  {
    Jet inX;
    for (int i = 4; i >= 0; --i)
    {
      Jet inY;
      for (int j = 4 - i; j >= 0; --j)
      {
        Jet inZ;
        for (int k = 4 - i - j; k >= 0; --k)
        {
          inZ = inZ * offset[2] + Jet(values[Jet::Index(i, j, k)]);
        }
        inY = inY * offset[1] + inZ;
      }
      inX = inX * offset[0] + inY;
    }
    return inX;
  }

  template <int Degree>
  static void SetLane(ridges::Taylor3<Degree, ridges::Lanes>& lanes,
    const ridges::Taylor3<Degree>& jet, int lane)
  {
    for (int i = 0; i <= Degree; ++i)
    {
      for (int j = 0; i + j <= Degree; ++j)
      {
        for (int k = 0; i + j + k <= Degree; ++k)
        {
          ridges::Lanes value = lanes(i, j, k);
          value[lane] = jet(i, j, k);
          lanes.Set(i, j, k, value);
        }
      }
    }
  }

  vtkJetFunction* Function;
};

} // namespace

std::string vtkRidgesFormulaSurface::SetImplicit(const std::string& formula)
{
  const std::string error = this->Parse("Formula", formula, { "x", "y", "z" }, false);
  if (error.empty())
  {
    this->Function = std::make_unique<ridges::FormulaFunction>(
      this->Programs[0].second, ridges::FormulaFunction::Kind::Implicit);
    this->Surface = std::make_unique<ridges::ImplicitExactSurface>(*this->Function);
  }
  return error;
}

std::string vtkRidgesFormulaSurface::SetGraph(const std::string& formula)
{
  const std::string error = this->Parse("Formula", formula, { "x", "y" }, true);
  if (error.empty())
  {
    this->Function = std::make_unique<ridges::FormulaFunction>(
      this->Programs[0].second, ridges::FormulaFunction::Kind::Graph);
    this->Surface = std::make_unique<ridges::ImplicitExactSurface>(*this->Function);
  }
  return error;
}

std::string vtkRidgesFormulaSurface::SetParametric(const std::array<std::string, 3>& formulas)
{
  const char* const properties[] = { "XFormula", "YFormula", "ZFormula" };
  for (int i = 0; i < 3; ++i)
  {
    const std::string error = this->Parse(properties[i], formulas[i], { "u", "v" }, true);
    if (!error.empty())
    {
      return error;
    }
    this->Parametric[i] = this->Programs.back().second;
  }
  this->Surface = std::make_unique<ridges::ParametricExactSurface>(this->Parametric);
  return {};
}

void vtkRidgesFormulaSurface::SetFunction(vtkJetFunction* function)
{
  this->Function = std::make_unique<UserFunction>(function);
  this->Surface = std::make_unique<ridges::ImplicitExactSurface>(*this->Function);
}

std::string vtkRidgesFormulaSurface::PlaceOfFault(const double* variables) const
{
  using Jet = ridges::Taylor3<4>;
  const std::array<Jet, 3> jets{ Jet::Linear(variables[0], 1.0, 0.0, 0.0),
    Jet::Linear(variables[1], 0.0, 1.0, 0.0), Jet::Linear(variables[2], 0.0, 0.0, 1.0) };
  const auto isFinite = [](const Jet& jet)
  {
    return std::all_of(jet.Coefficients().begin(), jet.Coefficients().end(),
      [](double coefficient) { return std::isfinite(coefficient); });
  };
  for (const auto& [text, program] : this->Programs)
  {
    if (const auto* fault = program.FirstFault(jets.data(), isFinite))
    {
      return ridges::FormulaPlace(text, fault->place);
    }
  }
  return {};
}

std::string vtkRidgesFormulaSurface::Parse(const char* property, const std::string& formula,
  const std::vector<std::string>& variables, bool mayBeConstant)
{
  ridges::ParsedFormula parsed = ridges::ParseFormula(formula, variables, mayBeConstant);
  if (!parsed.error.empty())
  {
    return std::string(property) + ": " + parsed.error;
  }
  this->Programs.emplace_back(formula, std::move(parsed.program));
  return {};
}
