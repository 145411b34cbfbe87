// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImageMongeForm
 * @brief   curvatures and their derivatives of an isosurface, from the derivatives of its image
 *
 * An isosurface mesh of an image (CT, MR, a simulation) has the staircase of its contouring, which
 * a fit to its points follows. The image knows better: this filter smooths it by a Gaussian and
 * takes the Monge form (RR-5294, equations 1 and 2) of the smoothed image's isosurface from its
 * derivatives to order 4, after Thirion (section 4.2.2). Takes the place of vtkJetFitting.
 *
 * Input port 0: a triangle mesh near the isosurface, such as vtkFlyingEdges3D makes. Input port 1:
 * the vtkImageData that it came from, with scalars of any type; of several components the first is
 * used. Spacing may differ from axis to axis, and the direction matrix is honored.
 *
 * Output port 0: the mesh, triangulated, with its points moved to the isosurface of the smoothed
 * image, and the point arrays of vtkImplicitMongeForm. FitStatus is 0; FIT_BOUNDARY is set where
 * the image ends within 3 Sigma, and FIT_INVALID, with all values 0, where there is no Monge form,
 * as outside the image.
 *
 * Also MaximumCurvatureError, MinimumCurvatureError, ThirdOrderError, P1Error and P2Error: the
 * standard errors that noise of the image causes, to first order, if it is independent from sample
 * to sample. Its standard deviation is the field array ImageNoise, estimated near the surface from
 * second differences along all axes at once. So vtkUmbilicDetection and vtkRidgeExtraction know
 * what noise alone may have made.
 *
 * Method: sums over the samples within 6.5 Sigma, separable, at the points themselves: nothing is
 * interpolated. The weights along an axis are those of the Gaussian's derivatives, corrected so
 * that polynomials of degree 4 are smoothed exactly, at the border of the image as well, where
 * other kernels see an edge. If Sigma is more than about two samples, all samples are smoothed
 * first by what leaves 1.5 samples, which changes nothing but the time. Points are projected as by
 * vtkImplicitMongeForm. Guarantees: the same bytes for any number of threads, any SMP back end and
 * any numbering.
 *
 * The values are exact, to round-off, for the smoothed image. What smoothing changes they do not
 * show: a sphere of radius r loses about Sigma^2 / r of its radius.
 *
 * @sa vtkJetFitting vtkImplicitMongeForm
 */

#ifndef vtkImageMongeForm_h
#define vtkImageMongeForm_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesCompatibility.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSRIDGES_EXPORT vtkImageMongeForm : public vtkPolyDataAlgorithm
{
public:
  static vtkImageMongeForm* New();
  vtkTypeMacro(vtkImageMongeForm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Standard deviation of the Gaussian, in the unit of the image's spacing, 0 or more. Less than a
   * sample hardly smooths along that axis. Default 0: that of the mesh, if its field array
   * ImageSigma says one, as behind vtkImageSurfaceMesh; else what the noise of the image needs, so
   * that at half of the surface the standard error of the third order is a quarter of it. That is
   * 1.5 times the greatest spacing without noise, and four times with noise of 5 % of the contrast.
   */
  vtkSetClampMacro(Sigma, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Sigma, double);
  ///@}

  ///@{
  /**
   * The value of the image on the isosurface. Default 0: that of a signed distance.
   */
  vtkSetMacro(IsoValue, double);
  vtkGetMacro(IsoValue, double);
  ///@}

protected:
  vtkImageMongeForm();
  ~vtkImageMongeForm() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Sigma = 0.0;
  double IsoValue = 0.0;

private:
  vtkImageMongeForm(const vtkImageMongeForm&) = delete;
  void operator=(const vtkImageMongeForm&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
