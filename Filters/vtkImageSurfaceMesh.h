// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImageSurfaceMesh
 * @brief   an even triangle mesh of an isosurface of a smoothed image
 *
 * Input: vtkImageData with scalars, as for vtkImageMongeForm. Output port 0: triangles whose points
 * are on the isosurface of the image smoothed by a Gaussian, to round-off, in double precision. The
 * mesh is closed where the surface is. It ends 1.5 standard deviations (but at most a quarter of
 * its size) before the image does, where too few samples are known; if that cuts the surface, a
 * warning gives the number of border edges. Triangles face outward: the volume that they enclose,
 * seen from the center of the points, is positive. There are no arrays.
 *
 * A contour of the image has the triangles of its grid, small ones and thin ones, and many more
 * than a smoothed image has detail for. Ridges need triangles that are even, and about as large as
 * the scale of the smoothing: then noise, which is alike within that scale, makes loops around a
 * few points only, which vtkRidgeExtraction recognizes as noise. On an ellipsoid in an image with
 * noise of 5 % of the contrast, all six ridges and nothing else are left with the default
 * EdgeLength; with edges a third as long there are thirty more.
 *
 * Method: as vtkImplicitSurfaceMesh, in the axes of the image. Guarantees: the same bytes for any
 * number of threads and any SMP back end.
 *
 * @sa vtkImageMongeForm vtkImplicitSurfaceMesh
 */

#ifndef vtkImageSurfaceMesh_h
#define vtkImageSurfaceMesh_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesCompatibility.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSRIDGES_EXPORT vtkImageSurfaceMesh : public vtkPolyDataAlgorithm
{
public:
  static vtkImageSurfaceMesh* New();
  vtkTypeMacro(vtkImageSurfaceMesh, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The value of the image on the isosurface. Default 0: that of a signed distance.
   */
  vtkSetMacro(IsoValue, double);
  vtkGetMacro(IsoValue, double);
  ///@}

  ///@{
  /**
   * Standard deviation of the Gaussian, in the unit of the image's spacing, 0 or more. Default 0:
   * what the noise of the image needs, as in vtkImageMongeForm. The field array ImageSigma says
   * what it was.
   */
  vtkSetClampMacro(Sigma, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Sigma, double);
  ///@}

  ///@{
  /**
   * Length of the edges, in the unit of the image's spacing, 0 or more. Default 0: three quarters
   * of the standard deviation, which shows all that the smoothed image has.
   */
  vtkSetClampMacro(EdgeLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(EdgeLength, double);
  ///@}

protected:
  vtkImageSurfaceMesh() = default;
  ~vtkImageSurfaceMesh() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double IsoValue = 0.0;
  double Sigma = 0.0;
  double EdgeLength = 0.0;

private:
  vtkImageSurfaceMesh(const vtkImageSurfaceMesh&) = delete;
  void operator=(const vtkImageSurfaceMesh&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
