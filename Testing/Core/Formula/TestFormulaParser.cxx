// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/FormulaParser.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace ridges;

namespace
{

double ValueAt(const std::string& formula, double x, double y)
{
  const ParsedFormula parsed = ParseFormula(formula, { "x", "y" });
  EXPECT_EQ(parsed.error, "") << formula;
  const double variables[] = { x, y };
  return parsed.program.IsEmpty() ? 0.0 : parsed.program.Evaluate(variables);
}

std::string ErrorOf(const std::string& formula)
{
  return ParseFormula(formula, { "x", "y" }).error;
}

} // namespace

TEST(FormulaParser, HasTheUsualPrecedence)
{
  EXPECT_EQ(ValueAt("x+2*y", 3, 5), 13);
  EXPECT_EQ(ValueAt("x-2-y", 3, 5), -4);
  EXPECT_EQ(ValueAt("y/2/x", 4, 16), 2);
  EXPECT_EQ(ValueAt("-x^2", 3, 0), -9);
  EXPECT_EQ(ValueAt("x^-1", 4, 0), 0.25);
  EXPECT_EQ(ValueAt("x*2^3^2", 1, 0), 512);
  EXPECT_EQ(ValueAt("(x^2)^3", 2, 0), 64);
  EXPECT_EQ(ValueAt(" +x - -y\n", 3, 5), 8);
  EXPECT_EQ(ValueAt("2*(x+y)*(x-y)", 3, 5), -32);
}

TEST(FormulaParser, ConstantsMayStandAnywhere)
{
  EXPECT_EQ(ValueAt("3-x", 1, 0), 2);
  EXPECT_EQ(ValueAt("x-3", 1, 0), -2);
  EXPECT_EQ(ValueAt("3/x", 2, 0), 1.5);
  EXPECT_EQ(ValueAt("x/4", 2, 0), 0.5);
  EXPECT_NEAR(ValueAt("2^x", 3, 0), 8, 1e-14);
  EXPECT_NEAR(ValueAt("x^y", 2, 3), 8, 1e-14);
  EXPECT_NEAR(ValueAt("x^0.5", 2, 0), std::sqrt(2.0), 1e-15);
  EXPECT_EQ(ValueAt("x + 1.5e2 + .5 + 2.", 0, 0), 152.5);
  EXPECT_NEAR(ValueAt("x + cos(pi) + 2*3 - 4/2 + 2^3", 0, 0), 11, 1e-15);
  EXPECT_EQ(ValueAt("x^0", 7, 0), 1);
}

TEST(FormulaParser, KnowsItsFunctions)
{
  const double x = 0.4;
  EXPECT_DOUBLE_EQ(ValueAt("exp(x)+log(x)+sqrt(x)+cbrt(x)", x, 0),
    std::exp(x) + std::log(x) + std::sqrt(x) + std::cbrt(x));
  EXPECT_DOUBLE_EQ(ValueAt("sin(x)+cos(x)+tan(x)", x, 0), std::sin(x) + std::cos(x) + std::tan(x));
  EXPECT_DOUBLE_EQ(
    ValueAt("asin(x)+acos(x)+atan(x)", x, 0), std::asin(x) + std::acos(x) + std::atan(x));
  EXPECT_DOUBLE_EQ(
    ValueAt("sinh(x)+cosh(x)+tanh(x)", x, 0), std::sinh(x) + std::cosh(x) + std::tanh(x));
}

TEST(FormulaParser, ErrorsNameThePlaceInOneLine)
{
  EXPECT_EQ(ErrorOf(""), "the formula is empty");
  EXPECT_EQ(ErrorOf(" \n"), "the formula is empty");
  EXPECT_EQ(ErrorOf("x)"), "unexpected text at character 2, \")\"");
  EXPECT_EQ(ErrorOf("2x"), "unexpected text at character 2, \"x\"");
  EXPECT_EQ(ErrorOf("x + * y"), "unexpected text at character 5, \"* y\"");
  EXPECT_EQ(ErrorOf("x^2+(y"), "an open parenthesis at character 5, \"(y\"");
  EXPECT_EQ(ErrorOf("sin x"), "sin needs its argument in parentheses at character 1, \"sin x\"");
  EXPECT_EQ(ErrorOf("x + 1/0"), "a constant that is not finite at character 6, \"/0\"");
  EXPECT_EQ(ErrorOf("x + 1e999"), "a number out of range at character 5, \"1e999\"");
  EXPECT_EQ(ErrorOf("1+2"), "the formula is constant: it depends on none of x y");
  EXPECT_EQ(ErrorOf("x+"), "the formula ends where a number, a name or a parenthesis is missing");
  EXPECT_EQ(
    ErrorOf("1 - abs(x) + something long behind").find("unknown name (known are x y pi"), 0u);
  EXPECT_NE(ErrorOf("1 - abs(x) + something long behind")
              .find("at character 5, \"abs(x) + something long ...\""),
    std::string::npos);
  const std::string deep = std::string(100000, '(') + "x" + std::string(100000, ')');
  EXPECT_EQ(ErrorOf(deep).find("the formula is nested too deeply at character 201"), 0u);
  EXPECT_EQ(ErrorOf(std::string(100000, '-') + "x").find("the formula is nested too deeply"), 0u);
  EXPECT_EQ(ErrorOf("x\ny"), "unexpected text at character 3, \"y\"");
}

TEST(FormulaParser, AConstantCanBeAllowed)
{
  const ParsedFormula parsed = ParseFormula("2*3", { "u", "v" }, true);
  EXPECT_EQ(parsed.error, "");
  const double variables[] = { 7.0, 8.0 };
  EXPECT_EQ(parsed.program.Evaluate(variables), 6.0);
}

TEST(FormulaProgram, FindsTheFirstFault)
{
  const std::string text = "x + sqrt(y-2) + log(x)";
  const ParsedFormula parsed = ParseFormula(text, { "x", "y" });
  const auto isFinite = [](double value) { return std::isfinite(value); };
  const double good[] = { 1.0, 3.0 };
  EXPECT_EQ(parsed.program.FirstFault(good, isFinite), nullptr);
  const double bad[] = { -1.0, 1.0 };
  const auto* fault = parsed.program.FirstFault(bad, isFinite);
  ASSERT_NE(fault, nullptr);
  EXPECT_EQ(FormulaPlace(text, fault->place), "character 5, \"sqrt(y-2) + log(x)\"");
}
