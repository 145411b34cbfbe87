// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMongeSmoothing
 * @brief   smooth curvatures and their derivatives over a mesh to a scale
 *
 * Ridges are made of third and fourth derivatives, which noise and fine detail of a scan dominate.
 * This filter takes Monge arrays on a mesh and replaces them by those of a smoother field, so that
 * vtkUmbilicDetection and vtkRidgeExtraction find what is there at the scale Sigma.
 *
 * Input: a mesh with the point arrays MaximumCurvature, MinimumCurvature, MaximumDirection and
 * MinimumDirection of vtkJetFitting (or of any other filter that makes them), and FitStatus and
 * FitScale if they are there. Method ALL_ORDERS needs ThirdOrder, and FourthOrder or P1 and P2,
 * too.
 *
 * Output port 0: the mesh, with these point arrays replaced (L is the length unit of the points):
 *
 * | array              | comp. | meaning                                            | unit  |
 * |--------------------|-------|----------------------------------------------------|-------|
 * | MaximumCurvature   | 1     | k1                                                 | 1/L   |
 * | MinimumCurvature   | 1     | k2                                                 | 1/L   |
 * | MaximumDirection   | 3     | d1, unit                                           |       |
 * | MinimumDirection   | 3     | d2, unit                                           |       |
 * | Normals            | 3     | n, unit                                            |       |
 * | ThirdOrder         | 4     | b0 b1 b2 b3                                        | 1/L^2 |
 * | FourthOrder        | 5     | c0 c1 c2 c3 c4                                     | 1/L^3 |
 * | P1, P2             | 1     | as vtkJetFitting has them                          | 1/L^4 |
 * | FitStatus          | 1     | that of the input; invalid also where values are not finite |
 * | FitScale           | 1     | radius whose fit of degree two smooths as much     | L     |
 *
 * Standard errors of the input and marks of umbilics do not belong to the smoothed field and are
 * removed. All other arrays pass.
 *
 * Method: the normals and the second fundamental forms, as tensors in space, are averaged over
 * one-rings, weighted by area so that averages are around the point itself, until the standard
 * deviation of these averages and of the fit together is Sigma. No sign of a direction has to be
 * chosen, and umbilics are nothing special. Points in large triangles take a smaller part of each
 * step, so that the scale is the same everywhere; FitScale reports what was reached. One average is
 * made at least. Where edges are shorter than about a sixth of Sigma, points are joined to larger
 * cells, most of the averages are made of these, and the values are interpolated. At the border
 * averages are one-sided. Invalid points take no part and stay invalid.
 * Guarantees: the same bytes for any number of threads, any SMP back end and any numbering of
 * points and cells. The time is proportional to the number of points, however many there are
 * within Sigma.
 *
 * @sa vtkJetFitting vtkRidgeExtraction vtkSalientRidges
 */

#ifndef vtkMongeSmoothing_h
#define vtkMongeSmoothing_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesCompatibility.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSRIDGES_EXPORT vtkMongeSmoothing : public vtkPolyDataAlgorithm
{
public:
  static vtkMongeSmoothing* New();
  vtkTypeMacro(vtkMongeSmoothing, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// See SetMethod.
  enum MethodType
  {
    SECOND_ORDER = 0,
    ALL_ORDERS = 1
  };

  ///@{
  /**
   * What is averaged: curvatures and directions, whose derivatives then are b and c (default: the
   * derivatives of a smooth field are smooth, and ridges are few and clean), or the forms of all
   * orders that the fit has found, P1 and P2 as numbers if there is no FourthOrder (for the
   * complete ridges of a surface with noise: nothing is differentiated that the fit has
   * differentiated already).
   */
  vtkSetClampMacro(Method, int, SECOND_ORDER, ALL_ORDERS);
  vtkGetMacro(Method, int);
  void SetMethodToSecondOrder() { this->SetMethod(SECOND_ORDER); }
  void SetMethodToAllOrders() { this->SetMethod(ALL_ORDERS); }
  const char* GetMethodAsString() const;
  ///@}

  ///@{
  /**
   * Standard deviation of the Gaussian that fit and smoothing together are, in the unit of the
   * points, 0 or more. Default 0: RelativeSigma is used.
   */
  vtkSetClampMacro(Sigma, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Sigma, double);
  ///@}

  ///@{
  /**
   * The same as a share of the model's diameter (that of the smallest sphere around all points of
   * triangles), 0 or more; used where Sigma is 0. Default 0.01: on a statue of a person eyes and
   * lips are kept, and the grain of the stone is not.
   */
  vtkSetClampMacro(RelativeSigma, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(RelativeSigma, double);
  ///@}

  ///@{
  /**
   * That many averages over one-rings, in all of which each point takes part in full, in place of
   * a scale, weighted by area alone: smoothing in units of edges, which follows the density of the
   * mesh. 0 to 5000. Default 0: as many as Sigma or RelativeSigma needs.
   */
  vtkSetClampMacro(NumberOfSteps, int, 0, 5000);
  vtkGetMacro(NumberOfSteps, int);
  ///@}

protected:
  vtkMongeSmoothing() = default;
  ~vtkMongeSmoothing() override = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Method = SECOND_ORDER;
  double Sigma = 0.0;
  double RelativeSigma = 0.01;
  int NumberOfSteps = 0;

private:
  vtkMongeSmoothing(const vtkMongeSmoothing&) = delete;
  void operator=(const vtkMongeSmoothing&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
