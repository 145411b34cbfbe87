// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkJetFunction
 * @brief   a function f(x, y, z) with its derivatives up to order 4
 *
 * Subclass it to give vtkImplicitMongeForm a surface f = 0 that no formula describes: a distance
 * to something, a spline, the result of a simulation. f is negative inside, so that its gradient
 * points outward.
 *
 * The jet is given by its Taylor coefficients, derivatives divided by factorials: that of
 * dx^i dy^j dz^k is d^(i+j+k) f / dx^i dy^j dz^k / (i! j! k!). They must be those of one smooth
 * function, exact to round-off: ridges need all of them.
 *
 * @sa vtkImplicitMongeForm
 */

#ifndef vtkJetFunction_h
#define vtkJetFunction_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkObject.h"
#include "vtkRidgesCompatibility.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSRIDGES_EXPORT vtkJetFunction : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkJetFunction, vtkObject);

  /**
   * Coefficients of all terms up to `order`, which is 1 or 4, at a point. Called by several threads
   * at once. May set values that are not finite: the point then has no Monge form.
   */
  virtual void EvaluateJet(const double x[3], int order, double* coefficients) = 0;

  /// How many coefficients there are: 4 for order 1, 35 for order 4.
  static constexpr int NumberOfCoefficients(int order)
  {
    return (order + 1) * (order + 2) * (order + 3) / 6;
  }

  /// Which coefficient belongs to dx^i dy^j dz^k: 0 is the value, 1 to 3 are the gradient.
  static constexpr int Index(int i, int j, int k)
  {
    return NumberOfCoefficients(i + j + k - 1) + (j + k) * (j + k + 1) / 2 + k;
  }

protected:
  vtkJetFunction();
  ~vtkJetFunction() override;

private:
  vtkJetFunction(const vtkJetFunction&) = delete;
  void operator=(const vtkJetFunction&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
