// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesFormulaSurface_h
#define vtkRidgesFormulaSurface_h

#include "Core/Formula/ExactSurface.h"
#include "Core/Formula/FormulaProgram.h"
#include "vtkRidgesCompatibility.h"

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkJetFunction;
VTK_ABI_NAMESPACE_END

/**
 * A surface as the user gave it, by formulas or by a function, ready to be evaluated. Private to
 * the module. The Set methods return what is wrong with a formula, empty if nothing is.
 */
class vtkRidgesFormulaSurface
{
public:
  std::string SetImplicit(const std::string& formula);
  std::string SetGraph(const std::string& formula);
  std::string SetParametric(const std::array<std::string, 3>& formulas);
  void SetFunction(vtkJetFunction* function);

  const ridges::ExactSurface& Get() const { return *this->Surface; }

  /// f, of a surface that is not parametric.
  const ridges::JetFunction& GetFunction() const { return *this->Function; }

  /// Where in a formula a value or a derivative stops to be finite, at x, y, z or u, v; empty if
  /// that cannot be said.
  std::string PlaceOfFault(const double* variables) const;

private:
  std::string Parse(const char* property, const std::string& formula,
    const std::vector<std::string>& variables, bool mayBeConstant);

  std::vector<std::pair<std::string, ridges::FormulaProgram>> Programs; ///< With their texts.
  std::array<ridges::FormulaProgram, 3> Parametric;
  std::unique_ptr<ridges::JetFunction> Function;
  std::unique_ptr<ridges::ExactSurface> Surface;
};

#endif
