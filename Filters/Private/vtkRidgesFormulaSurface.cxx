// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesFormulaSurface.h"

#include "Core/Formula/FormulaParser.h"
#include "Core/Formula/PointwiseFunction.h"
#include "vtkJetFunction.h"

#include <algorithm>
#include <cmath>

namespace
{

/// What a subclass of vtkJetFunction evaluates.
class UserFunction : public ridges::PointwiseFunction
{
public:
  explicit UserFunction(vtkJetFunction* function)
    : Function(function)
  {
  }

protected:
  void Evaluate(const Eigen::Vector3d& x, int order, double* coefficients) const override
  {
    this->Function->EvaluateJet(x.data(), order, coefficients);
  }

private:
  vtkJetFunction* Function;
};

} // namespace

std::string vtkRidgesFormulaSurface::SetImplicit(const std::string& formula)
{
  std::string error = this->Parse("Formula", formula, { "x", "y", "z" }, false);
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
  std::string error = this->Parse("Formula", formula, { "x", "y" }, true);
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
    std::string error = this->Parse(properties[i], formulas[i], { "u", "v" }, true);
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
