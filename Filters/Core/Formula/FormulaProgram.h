// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_FormulaProgram_h
#define ridges_FormulaProgram_h

#include "Formula/FormulaOperations.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace ridges
{

/**
 * A formula as instructions for a machine with a stack. Constants are folded into the instructions,
 * so that only what depends on a variable is on the stack. Evaluates with any type of number that
 * has the operators and functions: double, or Taylor polynomials of one point or of several.
 */
class FormulaProgram
{
public:
  struct Instruction
  {
    FormulaOperation operation;
    double constant; ///< The constant operand, if there is one.
    int index;       ///< Of the variable, or the integer exponent.
    int place;       ///< Where it is in the text of the formula, from 0.
  };

  void Add(const Instruction& instruction)
  {
    const FormulaOperation operation = instruction.operation;
    this->Depth_ += operation == FormulaOperation::Variable ? 1 : IsBinary(operation) ? -1 : 0;
    this->Deepest_ = this->Depth_ > this->Deepest_ ? this->Depth_ : this->Deepest_;
    this->Instructions_.push_back(instruction);
  }

  bool IsEmpty() const { return this->Instructions_.empty(); }

  /// The value at variables[0], variables[1], ...; not of an empty program.
  template <typename T>
  T Evaluate(const T* variables) const
  {
    return this->Run(variables, [](const Instruction&, const T&) { return true; });
  }

  /// The first instruction whose result is not as `isGood` demands; null if there is none.
  template <typename T, typename IsGood>
  const Instruction* FirstFault(const T* variables, const IsGood& isGood) const
  {
    const Instruction* fault = nullptr;
    this->Run(variables,
      [&fault, &isGood](const Instruction& instruction, const T& value)
      {
        fault = isGood(value) ? nullptr : &instruction;
        return fault == nullptr;
      });
    return fault;
  }

private:
  template <typename T, typename GoesOn>
  T Run(const T* variables, const GoesOn& goesOn) const
  {
    std::vector<T> stack(static_cast<std::size_t>(this->Deepest_));
    T* top = stack.data() - 1;
    for (const Instruction& instruction : this->Instructions_)
    {
      if (instruction.operation == FormulaOperation::Variable)
      {
        *++top = variables[instruction.index];
      }
      else if (IsBinary(instruction.operation))
      {
        --top;
        ApplyBinary(instruction.operation, *top, top[1]);
      }
      else if (HasConstant(instruction.operation))
      {
        ApplyWithConstant(instruction.operation, *top, instruction.constant, instruction.index);
      }
      else
      {
        ApplyFunction(instruction.operation, *top);
      }
      if (!goesOn(instruction, *top))
      {
        break;
      }
    }
    return std::move(*top);
  }

  std::vector<Instruction> Instructions_;
  int Depth_ = 0;
  int Deepest_ = 0;
};

} // namespace ridges

#endif
