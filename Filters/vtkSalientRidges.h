// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSalientRidges
 * @brief   the few long feature lines of a scan or a part, from a plain triangle mesh
 *
 * The complete ridges of a scan are thousands of short lines, most of them noise. This filter keeps
 * what a person would draw: the crests and valleys across which the surface folds by an angle that
 * can be seen, at a scale that is a share of the model's size.
 *
 * Input: a triangle mesh.
 *
 * Output port 0: polylines without branches, the most massive first, with these arrays (L is the
 * length unit of the points; those of vtkRidgeExtraction have the meaning that they have there):
 *
 * | array           | on    | meaning                                                        |
 * |-----------------|-------|----------------------------------------------------------------|
 * | RidgeType       | cells | 1 maximum (blue: valleys), 3 minimum (red: crests)             |
 * | RidgeId         | cells | the ridge that the line is a part of                           |
 * | FoldAngle       | cells | the largest fold angle along the line, degrees                 |
 * | FoldMass        | cells | integral of the fold angle over the model's diameter, degrees  |
 * | Confidence      | cells | share of the length that is elliptic and stands out from noise |
 * | Sharpness, Strength, Length, Crest, Closed | cells | as vtkRidgeExtraction has them           |
 * | FoldAngle       | points| by how much the surface folds across the line, degrees         |
 * | FoldWidth       | points| length across the line of the stretch that folds, L            |
 * | ArcLength       | points| from the start of the line, L                                  |
 * | Curvature, SecondDerivative, EdgePoint0, EdgePoint1, EdgeParameter | points | as there        |
 *
 * and in field data NoiseFloor, the standard deviation of a curvature that is due to noise (1/L).
 * A line may contain gaps that were bridged, which are parts of the same ridge, and begin or end
 * with a straight piece to a point of the mesh: a corner where creases meet.
 *
 * Output port 1: the mesh with the arrays of vtkMongeSmoothing and vtkUmbilicDetection. Output port
 * 2: the umbilics of the smoothed field, as vtkUmbilicDetection outputs them.
 *
 * Method: vtkJetFitting with degree two, vtkMongeSmoothing to the scale, vtkUmbilicDetection, and
 * the ridges of the smoothed field. At each point of an elliptic ridge the surface is followed
 * along the curvature line across it, and the fold angle is the integral of the curvature above
 * that at the foot of the feature, averaged along the ridge over the scale. Hysteresis along whole
 * ridges selects lines. By what noise would fold, estimated from the fits' residuals and one
 * repetition with noise added, a line has to fold more.
 * Guarantees: the same bytes for any number of threads, any SMP back end and any numbering of
 * points and cells.
 *
 * @warning Crests and valleys change places on a surface whose triangles are oriented inwards. On a
 * closed one a warning says so.
 * @sa vtkRidgesAndUmbilics vtkMongeSmoothing
 */

#ifndef vtkSalientRidges_h
#define vtkSalientRidges_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesCompatibility.h" // For the ABI namespace

#include <memory> // For the internals

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSRIDGES_EXPORT vtkSalientRidges : public vtkPolyDataAlgorithm
{
public:
  static vtkSalientRidges* New();
  vtkTypeMacro(vtkSalientRidges, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Output ports.
  enum Ports
  {
    RIDGES = 0,
    MESH = 1,
    UMBILICS = 2
  };

  ///@{
  /**
   * By how much the surface folds somewhere along every line, in degrees, 0 to 180. Default 15: on
   * scans of all kinds wiggles and lines part between 3 and 11 degrees. More gives fewer lines.
   */
  vtkSetClampMacro(FoldAngle, double, 0.0, 180.0);
  vtkGetMacro(FoldAngle, double);
  ///@}

  ///@{
  /**
   * Size of the smallest features, as a share of the model's diameter: the standard deviation of a
   * Gaussian, 0 or more. Default 0.01: eyes and lips of a bust are kept. Detailed statues want
   * 0.005.
   */
  vtkSetClampMacro(RelativeScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(RelativeScale, double);
  ///@}

  ///@{
  /**
   * What a line folds by everywhere, as a share of FoldAngle, 0 to 1. Default 0.5: values from 0.33
   * to 1 give nearly the same lines.
   */
  vtkSetClampMacro(Hysteresis, double, 0.0, 1.0);
  vtkGetMacro(Hysteresis, double);
  ///@}

  ///@{
  /**
   * The longest gap along a ridge that is bridged, in units of the scale, 0 or more. Default 4:
   * lines are twice as long as without, and no shape of that size is lost.
   */
  vtkSetClampMacro(LongestGap, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LongestGap, double);
  ///@}

  ///@{
  /**
   * The least mass of a line, as the length, over the model's diameter, of one that folds by
   * FoldAngle everywhere; 0 or more. Default 0.05: shorter ones are specks.
   */
  vtkSetClampMacro(LeastMass, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LeastMass, double);
  ///@}

  ///@{
  /**
   * Whether only crest lines are kept: ridges whose own curvature is the larger one. Default on: on
   * parts others are false, on scans they hardly matter.
   */
  vtkSetMacro(CrestOnly, bool);
  vtkGetMacro(CrestOnly, bool);
  vtkBooleanMacro(CrestOnly, bool);
  ///@}

  ///@{
  /**
   * How many standard deviations of the curvature that is due to noise count as its height, 0 or
   * more; over the scale that makes the angle by which noise folds the surface. Angles of lines
   * exceed FoldAngle by 0.6 of it, and are at least seven times as large. With 0 noise is not
   * estimated, which saves half of the time. Default 3: spheres, planes, cylinders, cones and tori
   * with noise have no lines then.
   */
  vtkSetClampMacro(NoiseFactor, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(NoiseFactor, double);
  ///@}

  ///@{
  /**
   * How far lines are smoothed, in units of the scale, 0 or more: the standard deviation of a
   * Gaussian along them. Points stay on the surface, but not on edges of the mesh, and ends stay
   * where they are. Default 0: lines are where the ridges are. With 0.5 they no longer zigzag with
   * the edges of the mesh, and keep all shapes that the scale keeps.
   */
  vtkSetClampMacro(LineSmoothing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LineSmoothing, double);
  ///@}

protected:
  vtkSalientRidges();
  ~vtkSalientRidges() override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double FoldAngle = 15.0;
  double RelativeScale = 0.01;
  double Hysteresis = 0.5;
  double LongestGap = 4.0;
  double LeastMass = 0.05;
  bool CrestOnly = true;
  double NoiseFactor = 3.0;
  double LineSmoothing = 0.0;

private:
  vtkSalientRidges(const vtkSalientRidges&) = delete;
  void operator=(const vtkSalientRidges&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};
VTK_ABI_NAMESPACE_END

#endif
