// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_FormulaParser_h
#define ridges_FormulaParser_h

#include "Formula/FormulaProgram.h"

#include <string>
#include <vector>

namespace ridges
{

struct ParsedFormula
{
  FormulaProgram program;
  std::string error; ///< What is wrong and where, in one line; empty if nothing is.
};

/**
 * Reads a formula of variables with the given names: numbers, pi, + - * / ^, parentheses, and the
 * functions exp log sqrt cbrt sin cos tan asin acos atan sinh cosh tanh. As usual -x^2 is -(x^2),
 * and 2^3^2 is 2^(3^2).
 *
 * VTK ships a parser, exprtk, that is a template of its number type. It is not used here: it passes
 * numbers by value through a tree of virtual calls, which with 35 coefficients of eight points
 * would cost more than the arithmetic. It needs an order, a remainder and a truth value of its
 * numbers, which Taylor polynomials do not have. It cannot report where in the formula a value
 * stops being finite. And one file that uses it takes 97 seconds and 1.3 GB to compile (GCC 12).
 */
ParsedFormula ParseFormula(
  const std::string& text, const std::vector<std::string>& variables, bool mayBeConstant = false);

/// For messages: `character 7, "foo(x) + 1"`, where a place from 0 is in a formula.
std::string FormulaPlace(const std::string& text, int place);

} // namespace ridges

#endif
