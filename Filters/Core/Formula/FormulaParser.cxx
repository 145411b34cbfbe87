// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Formula/FormulaParser.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <system_error>

namespace ridges
{
namespace
{

using Operation = FormulaOperation;

constexpr int DeepestNesting = 200;
constexpr int GreatestExponent = 1000;

struct Function
{
  const char* name;
  Operation operation;
};

constexpr Function Functions[] = { { "exp", Operation::Exp }, { "log", Operation::Log },
  { "sqrt", Operation::Sqrt }, { "cbrt", Operation::Cbrt }, { "sin", Operation::Sin },
  { "cos", Operation::Cos }, { "tan", Operation::Tan }, { "asin", Operation::Asin },
  { "acos", Operation::Acos }, { "atan", Operation::Atan }, { "sinh", Operation::Sinh },
  { "cosh", Operation::Cosh }, { "tanh", Operation::Tanh } };

/// A part of the formula that has been read: a constant, or what is on top of the stack.
struct Operand
{
  bool isConstant = false;
  double value = 0.0;
};

class SyntaxError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// Characters by themselves: those of the standard library depend on the locale.
bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

bool IsLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool IsSpace(char c)
{
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

class Parser
{
public:
  Parser(const std::string& text, const std::vector<std::string>& variables)
    : Text_(text)
    , Variables_(variables)
  {
  }

  FormulaProgram Parse(bool mayBeConstant)
  {
    if (this->Peek() == '\0' && this->IsAtEnd())
    {
      throw SyntaxError("the formula is empty");
    }
    const Operand all = this->Sum();
    if (!this->IsAtEnd())
    {
      this->FailAtNext();
    }
    if (all.isConstant && mayBeConstant) // 0 x + c: constants alone are not on the stack
    {
      this->Program_.Add({ Operation::Variable, 0.0, 0, 0 });
      this->Program_.Add({ Operation::Scale, 0.0, 0, 0 });
      this->Program_.Add({ Operation::AddConstant, all.value, 0, 0 });
    }
    else if (all.isConstant)
    {
      throw SyntaxError("the formula is constant: it depends on none of " + this->VariableNames());
    }
    return this->Program_;
  }

private:
  // ------------------------------------------------------------------------------- the grammar

  Operand Sum()
  {
    Operand left = this->Product();
    for (char c = this->Peek(); c == '+' || c == '-'; c = this->Peek())
    {
      const int place = this->Take();
      const Operand right = this->Product();
      left = this->Combine(c == '+' ? Operation::Add : Operation::Subtract, left, right, place);
    }
    return left;
  }

  Operand Product()
  {
    Operand left = this->Signed();
    for (char c = this->Peek(); c == '*' || c == '/'; c = this->Peek())
    {
      const int place = this->Take();
      const Operand right = this->Signed();
      left = this->Combine(c == '*' ? Operation::Multiply : Operation::Divide, left, right, place);
    }
    return left;
  }

  Operand Signed()
  {
    const char c = this->Peek();
    if (c != '+' && c != '-')
    {
      return this->PowerOf();
    }
    const int place = this->Take();
    this->Enter(place);
    const Operand operand = this->Signed();
    --this->Nesting_;
    return c == '+' ? operand : this->WithConstant(Operation::Scale, operand, -1.0, place);
  }

  Operand PowerOf()
  {
    const Operand base = this->Primary();
    if (this->Peek() != '^')
    {
      return base;
    }
    const int place = this->Take();
    this->Enter(place);
    const Operand exponent = this->Signed();
    --this->Nesting_;
    return this->Combine(Operation::Power, base, exponent, place);
  }

  Operand Primary()
  {
    const char c = this->Peek();
    if (IsDigit(c) || c == '.')
    {
      return this->Number();
    }
    if (IsLetter(c))
    {
      return this->Name();
    }
    if (c != '(')
    {
      this->FailAtNext();
    }
    const int place = this->Take();
    return this->InParentheses(place);
  }

  Operand InParentheses(int open)
  {
    this->Enter(open);
    const Operand inside = this->Sum();
    --this->Nesting_;
    if (this->Peek() != ')')
    {
      if (this->IsAtEnd())
      {
        this->Fail("an open parenthesis", open);
      }
      this->FailAtNext();
    }
    this->Take();
    return inside;
  }

  Operand Number()
  {
    const char* begin = this->Text_.data() + this->Next_;
    const char* end = this->Text_.data() + this->Text_.size();
    Operand operand{ true, 0.0 };
    const auto [last, error] = std::from_chars(begin, end, operand.value);
    if (error != std::errc())
    {
      this->Fail("a number out of range", this->Next_);
    }
    this->Next_ += static_cast<int>(last - begin);
    return operand;
  }

  Operand Name()
  {
    const int place = this->Next_;
    const auto begin = this->Text_.begin() + place;
    const auto end =
      std::find_if(begin, this->Text_.end(), [](char c) { return !IsLetter(c) && !IsDigit(c); });
    const std::string name(begin, end);
    this->Next_ += static_cast<int>(name.size());
    const auto variable = std::find(this->Variables_.begin(), this->Variables_.end(), name);
    if (variable != this->Variables_.end())
    {
      const auto index = static_cast<int>(variable - this->Variables_.begin());
      this->Program_.Add({ Operation::Variable, 0.0, index, place });
      return {};
    }
    if (name == "pi")
    {
      return { true, 3.14159265358979323846 };
    }
    const auto* function = std::find_if(std::begin(Functions), std::end(Functions),
      [&name](const Function& candidate) { return name == candidate.name; });
    if (function == std::end(Functions))
    {
      std::string known;
      for (const Function& candidate : Functions)
      {
        known += std::string(" ") + candidate.name;
      }
      this->Fail("unknown name (known are " + this->VariableNames() + " pi" + known + ")", place);
    }
    if (this->Peek() != '(')
    {
      this->Fail(name + " needs its argument in parentheses", place);
    }
    const int open = this->Take();
    return this->Apply(function->operation, this->InParentheses(open), place);
  }

  // ------------------------------------------------------------------- instructions, constants

  Operand Apply(Operation function, Operand operand, int place)
  {
    if (operand.isConstant)
    {
      ApplyFunction(function, operand.value);
      return this->Checked(operand, place);
    }
    this->Program_.Add({ function, 0.0, 0, place });
    return {};
  }

  Operand WithConstant(Operation operation, Operand operand, double constant, int place)
  {
    const auto exponent = operation == Operation::IntegerPower ? static_cast<int>(constant) : 0;
    if (operand.isConstant)
    {
      ApplyWithConstant(operation, operand.value, constant, exponent);
      return this->Checked(operand, place);
    }
    this->Program_.Add({ operation, constant, exponent, place });
    return {};
  }

  Operand Combine(Operation operation, Operand left, const Operand& right, int place)
  {
    if (!left.isConstant && !right.isConstant)
    {
      this->Program_.Add({ operation, 0.0, 0, place });
      return {};
    }
    const bool isPower = operation == Operation::Power;
    if (!right.isConstant && isPower) // c^b = exp(b log c)
    {
      ApplyFunction(Operation::Log, left.value);
      const double logarithm = this->Checked(left, place).value;
      const Operand product = this->WithConstant(Operation::Scale, right, logarithm, place);
      return this->Apply(Operation::Exp, product, place);
    }
    if (right.isConstant && isPower)
    {
      const bool isInteger =
        right.value == std::floor(right.value) && std::abs(right.value) <= GreatestExponent;
      return this->WithConstant(
        isInteger ? Operation::IntegerPower : Operation::ConstantPower, left, right.value, place);
    }
    const bool isRight = right.isConstant;
    const double constant = isRight ? right.value : left.value;
    const Operand& other = isRight ? left : right;
    switch (operation)
    {
      case Operation::Add:
        return this->WithConstant(Operation::AddConstant, other, constant, place);
      case Operation::Subtract:
        return isRight
          ? this->WithConstant(Operation::AddConstant, other, -constant, place)
          : this->WithConstant(Operation::SubtractFromConstant, other, constant, place);
      case Operation::Multiply:
        return this->WithConstant(Operation::Scale, other, constant, place);
      default:
        return this->WithConstant(isRight ? Operation::DivideByConstant : Operation::DivideConstant,
          other, constant, place);
    }
  }

  Operand Checked(const Operand& operand, int place) const
  {
    if (!std::isfinite(operand.value))
    {
      this->Fail("a constant that is not finite", place);
    }
    return operand;
  }

  // ------------------------------------------------------------------------------------ the text

  /// The next character that is no space; 0 at the end.
  char Peek()
  {
    while (!this->IsAtEnd() && IsSpace(this->Text_[this->Next_]))
    {
      ++this->Next_;
    }
    return this->IsAtEnd() ? '\0' : this->Text_[this->Next_];
  }

  /// The place of the next character, which is passed.
  int Take() { return this->Next_++; }

  bool IsAtEnd() const { return this->Next_ >= static_cast<int>(this->Text_.size()); }

  void Enter(int place)
  {
    if (++this->Nesting_ > DeepestNesting)
    {
      this->Fail("the formula is nested too deeply", place);
    }
  }

  std::string VariableNames() const
  {
    std::string names;
    for (const std::string& name : this->Variables_)
    {
      names += (names.empty() ? "" : " ") + name;
    }
    return names;
  }

  [[noreturn]] void Fail(const std::string& what, int place) const
  {
    throw SyntaxError(what + " at " + FormulaPlace(this->Text_, place));
  }

  [[noreturn]] void FailAtNext() const
  {
    if (this->IsAtEnd())
    {
      throw SyntaxError("the formula ends where a number, a name or a parenthesis is missing");
    }
    this->Fail("unexpected text", this->Next_);
  }

  const std::string& Text_;
  const std::vector<std::string>& Variables_;
  FormulaProgram Program_;
  int Next_ = 0;
  int Nesting_ = 0;
};

} // namespace

ParsedFormula ParseFormula(
  const std::string& text, const std::vector<std::string>& variables, bool mayBeConstant)
{
  ParsedFormula parsed;
  try
  {
    parsed.program = Parser(text, variables).Parse(mayBeConstant);
  }
  catch (const SyntaxError& error)
  {
    parsed.error = error.what();
  }
  return parsed;
}

std::string FormulaPlace(const std::string& text, int place)
{
  constexpr std::size_t longest = 24;
  std::string rest = text.substr(static_cast<std::size_t>(place), longest);
  std::replace_if(rest.begin(), rest.end(), IsSpace, ' ');
  const bool isCut = text.size() > static_cast<std::size_t>(place) + longest;
  return "character " + std::to_string(place + 1) + ", \"" + rest + (isCut ? "...\"" : "\"");
}

} // namespace ridges
