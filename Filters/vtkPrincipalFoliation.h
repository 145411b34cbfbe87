// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPrincipalFoliation
 * @brief   draw evenly spaced curvature lines on a mesh with Monge arrays
 *
 * A curvature line follows a principal direction. The lines of one direction form a foliation of
 * the surface without its umbilics (RR-5294, section 3 and Fig. 1). This filter draws some of them,
 * about one Separation apart, whatever the mesh.
 *
 * Input: a mesh with the point arrays MaximumCurvature, MinimumCurvature, MaximumDirection and
 * MinimumDirection of vtkJetFitting; FitStatus, if present, marks invalid points, whose
 * triangles are left out. Lines end at the cell array UmbilicPatch of vtkUmbilicDetection, if
 * present.
 * Arrays of other names can be chosen (SetInputArrayToProcess). For these, composite data and ghost
 * cells see Documentation/Arrays.md.
 *
 * Output port 0: a polyline per curvature line; a loop comes back to its first point.
 *
 * | array              | on     | meaning                                              | unit |
 * |--------------------|--------|------------------------------------------------------|------|
 * | PrincipalDirection | cells  | 0: line of the maximum curvature (blue), 1: minimum  |      |
 * | Closed             | cells  | 1: the line is a loop                                |      |
 * | Length             | cells  | length of the polyline                               | L    |
 * | Curvature          | points | the curvature whose line it is: k1 (0) or k2 (1)     | 1/L  |
 *
 * Method: the traceless second fundamental form is interpolated linearly over each triangle, in
 * the triangle's plane, and with it the principal direction, whose sign then follows the acute rule
 * of the paper. Lines are traced through it by the midpoint rule, from edge to edge, and folded
 * over the edge. They are second-order accurate in the length of the edges, as the mesh is.
 *
 * Lines are placed after Jobard and Lefer (1997): a new line starts at the Separation from existing
 * ones, beside the longest first, and ends where it is nearer than LeastDistance separations to
 * another line or to itself. Further lines start wherever the surface is farther than the
 * Separation from all lines, in order of decreasing k1 - k2. Distances are straight-line distances,
 * but only to lines on the same sheet of the surface: near points are found over the mesh, so a
 * line on one side of a thin wall does not stop one on the other, as a point locator in space
 * would.
 *
 * Lines end at singular triangles, each of which holds an umbilic, at umbilic patches, borders,
 * non-manifold edges, unusable triangles, and near other lines. A line that returns to its seed
 * within a quarter of the mean edge or of the least distance is closed: a gap that small is within
 * the error.
 *
 * Guarantees: every point is inside a triangle or on an edge, up to round-off, and every segment
 * in one triangle (the last one of a loop up to the gap); output has no NaN; it is the same, to the
 * byte, for any number of threads (only one is used), any numbering of points and cells, and any
 * signs of the directions.
 *
 * @warning
 * On spheres and planes, where k1 = k2 everywhere, curvature lines mean nothing. Where two
 * candidates for a line differ only by round-off, as on a surface with symmetries, moving or
 * scaling it may select the other one.
 *
 * @sa
 * vtkJetFitting vtkUmbilicDetection vtkRidgeExtraction
 */

#ifndef vtkPrincipalFoliation_h
#define vtkPrincipalFoliation_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesCompatibility.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSRIDGES_EXPORT vtkPrincipalFoliation : public vtkPolyDataAlgorithm
{
public:
  static vtkPrincipalFoliation* New();
  vtkTypeMacro(vtkPrincipalFoliation, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of the PrincipalDirection array, too, except BOTH.
  enum Directions
  {
    MAXIMUM = 0,
    MINIMUM = 1,
    BOTH = 2
  };

  ///@{
  /**
   * Which lines to draw: those of the maximum curvature (blue), of the minimum (red), or both, blue
   * first, each spaced among themselves. Default MAXIMUM: a picture usually shows one foliation.
   */
  vtkSetClampMacro(Direction, int, MAXIMUM, BOTH);
  vtkGetMacro(Direction, int);
  void SetDirectionToMaximum() { this->SetDirection(MAXIMUM); }
  void SetDirectionToMinimum() { this->SetDirection(MINIMUM); }
  void SetDirectionToBoth() { this->SetDirection(BOTH); }
  ///@}

  ///@{
  /**
   * Distance between neighbouring lines, as a fraction of the model size, 0.0001 to 1. Default
   * 0.05, about twenty lines from one side of a picture to the other. It does not refer to the
   * mesh, so a finer mesh gives the same picture. Less than a tenth of the mean edge is out of
   * reach of the mesh, takes long, and is warned of.
   */
  vtkSetClampMacro(Separation, double, 0.0001, 1.0);
  vtkGetMacro(Separation, double);
  ///@}

  ///@{
  /**
   * Distance from another line at which a line ends, as a fraction of the separation, 0.05 to 0.9.
   * Default 0.5, after Jobard and Lefer: values near 1 give more even, but shorter lines.
   */
  vtkSetClampMacro(LeastDistance, double, 0.05, 0.9);
  vtkGetMacro(LeastDistance, double);
  ///@}

  ///@{
  /**
   * Length below which lines are left out, as a multiple of the separation, 0 or more. Default 2:
   * shorter ones look like dots. Their places stay empty.
   */
  vtkSetClampMacro(MinimumLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumLength, double);
  ///@}

  ///@{
  /**
   * Length at which lines are cut, as a multiple of the model size, 0 or more. Default 0, no cut:
   * lines keep away from themselves, so none is endless.
   */
  vtkSetClampMacro(MaximumLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumLength, double);
  ///@}

  ///@{
  /**
   * Longest step inside a triangle, as a fraction of the separation, 0.001 to 1. Default 0.2.
   * Steps end at edges anyway and are shortened where the direction turns, so this matters only
   * where triangles are larger.
   */
  vtkSetClampMacro(StepSize, double, 0.001, 1.0);
  vtkGetMacro(StepSize, double);
  ///@}

  ///@{
  /**
   * Whether lines end at the umbilic patches that vtkUmbilicDetection marks. Default on: inside,
   * directions are uncertain on noisy meshes. Off, only singular triangles end them, so lines come
   * nearer to umbilics on clean meshes.
   */
  vtkSetMacro(StopAtUmbilicPatches, bool);
  vtkGetMacro(StopAtUmbilicPatches, bool);
  vtkBooleanMacro(StopAtUmbilicPatches, bool);
  ///@}

  ///@{
  /**
   * The length that Separation and MaximumLength refer to, 0 or more. Default 0: the radius of the
   * smallest enclosing sphere of the mesh.
   */
  vtkSetClampMacro(ModelSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ModelSize, double);
  ///@}

protected:
  vtkPrincipalFoliation();
  ~vtkPrincipalFoliation() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Direction = MAXIMUM;
  double Separation = 0.05;
  double LeastDistance = 0.5;
  double MinimumLength = 2.0;
  double MaximumLength = 0.0;
  double StepSize = 0.2;
  bool StopAtUmbilicPatches = true;
  double ModelSize = 0.0;

private:
  vtkPrincipalFoliation(const vtkPrincipalFoliation&) = delete;
  void operator=(const vtkPrincipalFoliation&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
