// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkUmbilicDetection
 * @brief   find the umbilics of a mesh that carries Monge arrays
 *
 * An umbilic is a point where the principal curvatures are equal and the principal directions turn
 * by half a turn around it: its index is +1/2 or -1/2. Method: RR-5294, section 8. A patch, which
 * stays a topological disk, is grown around each triangle; a triangle that minimises k1 - k2 over
 * its patch, and on whose contour the directions turn by half a turn, is an umbilic.
 *
 * Input: a mesh with the point arrays MaximumCurvature, MinimumCurvature, MaximumDirection,
 * MinimumDirection and ThirdOrder of vtkJetFitting; FitStatus, if there, tells invalid points,
 * whose triangles are left out.
 *
 * Output port 0: the mesh with the umbilics marked on it, for vtkRidgeExtraction:
 *
 * | array               | on    | meaning                                                     |
 * |---------------------|-------|-------------------------------------------------------------|
 * | UmbilicPatch        | cells | umbilic whose patch the cell is in, -1 outside              |
 * | UmbilicPosition (3) | field | a tuple per umbilic: where it is                            |
 * | UmbilicIndex        | field | +0.5 or -0.5 per umbilic                                    |
 * | UmbilicRidgeCount   | field | 1 or 3 per umbilic                                          |
 * | UmbilicIndexSum     | field | sum of all indices                                          |
 * | EulerCharacteristic | field | what that sum should be on a closed mesh                    |
 *
 * Output port 1: a vertex per umbilic, with the point arrays
 *
 * | array           | meaning                                                                  |
 * |-----------------|--------------------------------------------------------------------------|
 * | UmbilicId       | 0, 1, 2, ... by growing k1 - k2 of the triangle found                    |
 * | Index           | turns of the principal directions around it, +0.5 or -0.5                |
 * | RidgeCount      | ridges of each colour that meet there by the third-order form, 1 or 3    |
 * | ThirdOrderIndex | sign of S (section 8.2): that of the index, by third order               |
 * | Triangle        | the cell of the mesh that contains it                                    |
 *
 * The position is the zero of the traceless second fundamental form, interpolated over the one
 * triangle of the patch around whose border the directions turn: second-order accurate.
 *
 * Guarantees: patches do not overlap; the result does not depend on the number of threads.
 *
 * @warning
 * On noisy data the sum of the indices may miss the Euler characteristic: compare the two field
 * arrays. On spheres and planes, where k1 = k2 everywhere, umbilics mean nothing.
 *
 * @sa
 * vtkJetFitting vtkRidgeExtraction
 */

#ifndef vtkUmbilicDetection_h
#define vtkUmbilicDetection_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSRIDGES_EXPORT vtkUmbilicDetection : public vtkPolyDataAlgorithm
{
public:
  static vtkUmbilicDetection* New();
  vtkTypeMacro(vtkUmbilicDetection, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Size of the patches, as a multiple of the distance from a triangle's centroid to the farthest
   * one among the triangles that touch it; free of units, 1 to 100. Default 2: the smallest of
   * the two sizes that the paper found good (2 and 3). A larger patch finds fewer umbilics and
   * computes their index farther away from them, where directions are more reliable.
   */
  vtkSetClampMacro(PatchSize, double, 1.0, 100.0);
  vtkGetMacro(PatchSize, double);
  ///@}

protected:
  vtkUmbilicDetection();
  ~vtkUmbilicDetection() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double PatchSize = 2.0;

private:
  vtkUmbilicDetection(const vtkUmbilicDetection&) = delete;
  void operator=(const vtkUmbilicDetection&) = delete;
};

#endif
