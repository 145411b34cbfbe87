// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImplicitMongeForm
 * @brief   exact curvatures and their derivatives at the points of a mesh whose surface is known
 *
 * Case I of RR-5294: the surface is given by a formula, and the Monge form (equations 1 and 2) at
 * each point of the mesh is exact to round-off. Takes the place of vtkJetFitting.
 *
 * Output port 0: the mesh, triangulated, with its points moved to the surface (in double
 * precision), and with the point arrays of vtkJetFitting: MaximumCurvature, MinimumCurvature,
 * MaximumDirection, MinimumDirection, Normals, ThirdOrder, FourthOrder, P1, P2 and FitStatus. Of
 * the arrays about the fit, FitConditionNumber is 1, and FitResidual, FitScale and FitNoiseGain are
 * 0: nothing was fitted. Normals are on the side of the mesh's orientation, by majority in each
 * connected part. FitStatus is 0, at the border too; where there is no Monge form it is
 * vtkJetFitting::FIT_INVALID, all values are 0, the point stays, and one warning counts these
 * points.
 *
 * Formulas are made of numbers, pi, + - * / ^, parentheses and exp log sqrt cbrt sin cos tan asin
 * acos atan sinh cosh tanh. They must be smooth on the surface: there is no abs, min or max.
 *
 * Method: points are projected by Newton's method along the gradient, with halved steps where |f|
 * does not fall. Derivatives to order 4 come from truncated Taylor arithmetic, without finite
 * differences, in a frame of the tangent plane; there the height of the surface follows order by
 * order. Relative errors against references of 50 digits are below 1e-12 for k, 1e-10 for b and
 * 1e-8 for P, away from umbilics. Guarantees: the same bytes for any number of threads, any SMP
 * back end and any numbering of points and cells.
 * @warning A projection can only find the sheet of the surface that the point is near to: the
 * mesh must be closer to it than the surface's radius of curvature.
 *
 * @sa vtkImplicitSurfaceMesh vtkJetFitting vtkJetFunction
 */

#ifndef vtkImplicitMongeForm_h
#define vtkImplicitMongeForm_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesCompatibility.h" // For the ABI namespace
#include "vtkSmartPointer.h"        // For vtkSmartPointer

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkJetFunction;

class VTKFILTERSRIDGES_EXPORT vtkImplicitMongeForm : public vtkPolyDataAlgorithm
{
public:
  static vtkImplicitMongeForm* New();
  vtkTypeMacro(vtkImplicitMongeForm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// See SetSurfaceType.
  enum SurfaceTypes
  {
    IMPLICIT = 0,
    GRAPH = 1,
    PARAMETRIC = 2
  };

  ///@{
  /**
   * What the formulas are. IMPLICIT: Formula is f(x, y, z), and the surface f = 0; inside f < 0.
   * GRAPH: Formula is g(x, y), and the surface z = g. PARAMETRIC: XFormula, YFormula and ZFormula
   * are functions of u and v, at each point given by the texture coordinates of the mesh. Default
   * IMPLICIT: most surfaces of any topology can be written so.
   */
  vtkSetClampMacro(SurfaceType, int, IMPLICIT, PARAMETRIC);
  vtkGetMacro(SurfaceType, int);
  void SetSurfaceTypeToImplicit() { this->SetSurfaceType(IMPLICIT); }
  void SetSurfaceTypeToGraph() { this->SetSurfaceType(GRAPH); }
  void SetSurfaceTypeToParametric() { this->SetSurfaceType(PARAMETRIC); }
  const char* GetSurfaceTypeAsString() const;
  ///@}

  ///@{
  /**
   * f(x, y, z) or g(x, y), such as "x^2/4 + y^2 + z^2/0.36 - 1". Default empty: the formula in the
   * field array Formula of the input, where vtkImplicitSurfaceMesh leaves the one that it meshed.
   */
  vtkSetStdStringFromCharMacro(Formula);
  vtkGetCharFromStdStringMacro(Formula);
  ///@}

  ///@{
  /**
   * The coordinates of a parametric surface as functions of u and v. Default empty: there is no
   * parametric surface that most meshes are of.
   */
  vtkSetStdStringFromCharMacro(XFormula);
  vtkGetCharFromStdStringMacro(XFormula);
  vtkSetStdStringFromCharMacro(YFormula);
  vtkGetCharFromStdStringMacro(YFormula);
  vtkSetStdStringFromCharMacro(ZFormula);
  vtkGetCharFromStdStringMacro(ZFormula);
  ///@}

  ///@{
  /**
   * The parameters u and v at the texture coordinates 0 and 1: u0, u1, v0, v1. Default 0, 1, 0, 1:
   * parameters are texture coordinates. Those of vtkParametricFunctionSource are from 0 to 1 in u
   * and from 1 to 0 in v: for its meshes these are MinimumU, MaximumU, MaximumV and MinimumV of
   * the function.
   */
  vtkSetVector4Macro(ParameterRange, double);
  vtkGetVector4Macro(ParameterRange, double);
  ///@}

#ifndef __VTK_WRAP__ // which only C++ can subclass
  ///@{
  /**
   * A function of your own in place of Formula, for surfaces f = 0. Default none.
   */
  void SetJetFunction(vtkJetFunction* function);
  vtkJetFunction* GetJetFunction() const;
  ///@}
#endif

  /// Later of the filter and its JetFunction.
  vtkMTimeType GetMTime() override;

protected:
  vtkImplicitMongeForm();
  ~vtkImplicitMongeForm() override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int SurfaceType = IMPLICIT;
  std::string Formula;
  std::string XFormula;
  std::string YFormula;
  std::string ZFormula;
  double ParameterRange[4] = { 0.0, 1.0, 0.0, 1.0 };
  vtkSmartPointer<vtkJetFunction> JetFunction;

private:
  vtkImplicitMongeForm(const vtkImplicitMongeForm&) = delete;
  void operator=(const vtkImplicitMongeForm&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
