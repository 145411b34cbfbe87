// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImplicitSurfaceMesh
 * @brief   an even triangle mesh of a surface f(x, y, z) = 0 given by a formula
 *
 * Output port 0: triangles with their points on the surface to round-off, in double precision,
 * oriented outward, where f > 0. The mesh is closed where the surface is; if the bounds cut it, a
 * warning gives the number of border edges. The field array Formula has the formula, which
 * vtkImplicitMongeForm takes from there. There are no other arrays.
 *
 * Method: f is sampled on a grid as fine as EdgeLength, and vtkFlyingEdges3D contours it. Then the
 * triangles are made even: long edges are divided, short ones contracted, others flipped to
 * Delaunay's rule, and points moved to the middle of their triangles and projected onto the
 * surface, ten times over. Away from the border, edges are 0.65 to 1.4 times as long as asked for,
 * 1.03 times on average, and angles are at least 30 degrees. Parts of the surface that are thinner
 * than EdgeLength may be missed, or joined. Guarantees: the same bytes for any number of threads
 * and any SMP back end.
 *
 * Formulas are those of vtkImplicitMongeForm. Errors are a bad formula, one that is not a number
 * somewhere in the bounds, and one without a zero there.
 *
 * @sa vtkImplicitMongeForm vtkRidgeExampleSource
 */

#ifndef vtkImplicitSurfaceMesh_h
#define vtkImplicitSurfaceMesh_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesCompatibility.h" // For the ABI namespace

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSRIDGES_EXPORT vtkImplicitSurfaceMesh : public vtkPolyDataAlgorithm
{
public:
  static vtkImplicitSurfaceMesh* New();
  vtkTypeMacro(vtkImplicitSurfaceMesh, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * f(x, y, z), negative inside. Default: the blend of two ellipsoids of RR-5294, Fig. 25, as its
   * ridges are known.
   */
  vtkSetStdStringFromCharMacro(Formula);
  vtkGetCharFromStdStringMacro(Formula);
  ///@}

  ///@{
  /**
   * The box in which the surface is looked for: least and greatest x, y and z, in the unit of the
   * formula. Must not be empty. Default: a box around the default surface.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * Length of the edges, in the unit of the formula, 0 or more. Must be short against radii of
   * curvature and distances between sheets of the surface. Default 0: a hundredth of the diagonal
   * of Bounds, as many points as a first look needs.
   */
  vtkSetClampMacro(EdgeLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(EdgeLength, double);
  ///@}

protected:
  vtkImplicitSurfaceMesh();
  ~vtkImplicitSurfaceMesh() override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  std::string Formula;
  double Bounds[6] = { -0.25, 0.45, -0.35, 0.4, -0.5, 0.55 };
  double EdgeLength = 0.0;

private:
  vtkImplicitSurfaceMesh(const vtkImplicitSurfaceMesh&) = delete;
  void operator=(const vtkImplicitSurfaceMesh&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
