// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRidgeExampleSource
 * @brief   meshes of surfaces whose ridges and umbilics are known
 *
 * Two closed smooth surfaces, triangulated with their points on the surface to round-off:
 *
 * - the blend of two ellipsoids of RR-5294, Fig. 25: 1 - exp(-0.7 (A - 1)) - exp(-0.7 (B - 1)) = 0
 *   with A = x²/0.15² + y²/0.25² + z²/0.35² and
 *   B = (x-0.25)²/0.1² + (y-0.1)²/0.2² + (z-0.1)²/0.3², which has six umbilics of index +1/2 and
 *   two of index -1/2;
 * - an ellipsoid, Figs. 1 and 2: four umbilics of index +1/2, ridges in the planes of symmetry.
 *
 * Output port 0: 10 Frequency² + 2 points in double precision, 20 Frequency² triangles, oriented
 * outward, without arrays. Triangles are of even size on the blend, and smaller where it is more
 * curved on the ellipsoid (a sphere's mesh, stretched). No point lies in a plane of symmetry, where
 * ridges would pass exactly through it.
 *
 * @sa
 * vtkJetFitting
 */

#ifndef vtkRidgeExampleSource_h
#define vtkRidgeExampleSource_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesCompatibility.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSRIDGES_EXPORT vtkRidgeExampleSource : public vtkPolyDataAlgorithm
{
public:
  static vtkRidgeExampleSource* New();
  vtkTypeMacro(vtkRidgeExampleSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SurfaceType
  {
    BLEND = 0,
    ELLIPSOID = 1
  };

  ///@{
  /**
   * The surface. Default: the blend.
   */
  vtkSetClampMacro(Surface, int, BLEND, ELLIPSOID);
  vtkGetMacro(Surface, int);
  void SetSurfaceToBlend() { this->SetSurface(BLEND); }
  void SetSurfaceToEllipsoid() { this->SetSurface(ELLIPSOID); }
  ///@}

  ///@{
  /**
   * Number of parts into which each edge of the underlying icosahedron is divided, 1 to 2000.
   * Default 63, which gives 39,692 points, as many as in Fig. 25; 32 gives 10,242.
   */
  vtkSetClampMacro(Frequency, int, 1, 2000);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * Semi-axes of the ellipsoid along x, y and z, all positive. Default 1.4, 1, 0.6: umbilics are
   * isolated only if all three differ.
   */
  vtkSetVector3Macro(SemiAxes, double);
  vtkGetVector3Macro(SemiAxes, double);
  ///@}

protected:
  vtkRidgeExampleSource();
  ~vtkRidgeExampleSource() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Surface = BLEND;
  int Frequency = 63;
  double SemiAxes[3] = { 1.4, 1.0, 0.6 };

private:
  vtkRidgeExampleSource(const vtkRidgeExampleSource&) = delete;
  void operator=(const vtkRidgeExampleSource&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
