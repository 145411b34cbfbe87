// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_JetFunction_h
#define ridges_JetFunction_h

#include "Formula/FormulaProgram.h"
#include "Formula/Lanes.h"
#include "Formula/Taylor3.h"

#include <array>
#include <utility>

namespace ridges
{

using LaneVector3 = std::array<Lanes, 3>;

/// A function f(x, y, z) of which the Taylor polynomials are known, at several points at once.
class JetFunction
{
public:
  using Jet1 = Taylor3<1, Lanes>;
  using Jet4 = Taylor3<4, Lanes>;

  JetFunction() = default;
  virtual ~JetFunction() = default;
  JetFunction(const JetFunction&) = delete;
  JetFunction& operator=(const JetFunction&) = delete;

  /// Value and gradient.
  virtual Jet1 Linear(const LaneVector3& x) const = 0;

  /// f(x + u axes[0] + v axes[1] + w axes[2]) as a polynomial in u, v and w.
  virtual Jet4 Full(const LaneVector3& x, const std::array<LaneVector3, 3>& axes) const = 0;
};

/// Given by a formula: f(x, y, z), or g(x, y) as f = z - g.
class FormulaFunction : public JetFunction
{
public:
  enum class Kind
  {
    Implicit,
    Graph
  };

  FormulaFunction(FormulaProgram program, Kind kind)
    : Program_(std::move(program))
    , Kind_(kind)
  {
  }

  Jet1 Linear(const LaneVector3& x) const override
  {
    const Lanes zero(0.0);
    const Lanes one(1.0);
    return this->Evaluate(std::array<Jet1, 3>{ Jet1::Linear(x[0], one, zero, zero),
      Jet1::Linear(x[1], zero, one, zero), Jet1::Linear(x[2], zero, zero, one) });
  }

  Jet4 Full(const LaneVector3& x, const std::array<LaneVector3, 3>& axes) const override
  {
    std::array<Jet4, 3> variables;
    for (int i = 0; i < 3; ++i)
    {
      variables[i] = Jet4::Linear(x[i], axes[0][i], axes[1][i], axes[2][i]);
    }
    return this->Evaluate(variables);
  }

  /// f of three polynomials, with any type of number.
  template <int Degree, typename Number>
  Taylor3<Degree, Number> Evaluate(const std::array<Taylor3<Degree, Number>, 3>& variables) const
  {
    Taylor3<Degree, Number> value = this->Program_.Evaluate(variables.data());
    return this->Kind_ == Kind::Implicit ? value : variables[2] - value;
  }

private:
  FormulaProgram Program_;
  Kind Kind_;
};

} // namespace ridges

#endif
