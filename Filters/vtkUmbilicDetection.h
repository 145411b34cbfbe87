// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkUmbilicDetection
 * @brief   find the umbilics of a mesh with Monge arrays
 *
 * An umbilic is a point where the principal curvatures are equal and around which the principal
 * directions make half a turn: its index is +1/2 or -1/2. On a closed surface the indices add up to
 * the Euler characteristic.
 *
 * Method INDICES, the default: computes the index of every triangle. Their sum is the Euler
 * characteristic on any closed mesh, with any directions. Pairs of opposite index that noise may
 * have caused are cancelled: those connected by a path on which k1 - k2 is within Significance
 * standard errors of zero. A patch is grown around each remaining umbilic.
 *
 * Method MINIMA, RR-5294, section 8: a patch, which stays a topological disk, is grown around each
 * triangle. A triangle is an umbilic if it minimises k1 - k2 over its patch and the directions make
 * half a turn around the patch's contour. The sum of the indices is not constrained.
 *
 * Input: a mesh with the point arrays MaximumCurvature, MinimumCurvature, MaximumDirection,
 * MinimumDirection and ThirdOrder of vtkJetFitting; FitStatus, if present, marks invalid points.
 * The standard error of k1 - k2 is taken from MaximumCurvatureError and MinimumCurvatureError if
 * present, else estimated from FitResidual and FitScale; without these only opposite umbilics in
 * neighbouring triangles are cancelled.
 * Arrays of other names can be chosen (SetInputArrayToProcess). For these, composite data and ghost
 * cells see Documentation/Arrays.md.
 *
 * Output port 0: the mesh with the umbilics marked on it, for vtkRidgeExtraction:
 *
 * | array                    | on    | meaning                                                |
 * |--------------------------|-------|--------------------------------------------------------|
 * | UmbilicPatch             | cells | umbilic whose patch the cell is in, -1 outside         |
 * | CancelledUmbilics        | cells | number of the region, outside all patches, in which    |
 * |                          |       | umbilics have cancelled each other; -1 outside         |
 * | UmbilicZone              | cells | number of the connected region in which k1 - k2 is     |
 * |                          |       | nowhere significant, as on spheres; -1 outside         |
 * | UmbilicPosition (3)      | field | a tuple per umbilic: its position                      |
 * | UmbilicIndex             | field | +0.5 or -0.5 per umbilic                               |
 * | UmbilicRidgeCount        | field | 1 or 3 per umbilic                                     |
 * | UmbilicTriangle          | field | the cell that contains it, per umbilic                 |
 * | UmbilicIndexSum          | field | sum of all indices                                     |
 * | EulerCharacteristic      | field | the value of that sum on a closed mesh                 |
 * | NumberOfCancelledRegions | field | of CancelledUmbilics                                   |
 * | NumberOfUmbilicZones     | field | of UmbilicZone                                         |
 *
 * Output port 1: a vertex per umbilic, with the point arrays
 *
 * | array           | meaning                                                                  |
 * |-----------------|--------------------------------------------------------------------------|
 * | UmbilicId       | 0, 1, 2, ... by x, then y, then z; with MINIMA by growing k1 - k2        |
 * | Index           | turns of the principal directions around it, +0.5 or -0.5                |
 * | RidgeCount      | ridges of each colour that meet there by the third-order form, 1 or 3    |
 * | ThirdOrderIndex | sign of S (section 8.2): that of the index, by third order               |
 * | Pattern         | pattern of curvature lines: 1 lemon, 2 monstar (both of index            |
 * |                 | +0.5), 3 star (-0.5)                                                     |
 * | TouchesBorder   | 1 where its patch is on the border of the mesh                           |
 * | NearBorder      | 1 where fits are one-sided: no farther from the border than FitScale     |
 * | Triangle        | the cell of the mesh that contains it                                    |
 *
 * The position is the zero of the traceless second fundamental form, interpolated over the one
 * triangle of the patch around whose border the directions turn: second-order accurate.
 *
 * Guarantees: patches are disks and do not overlap; the result depends neither on the number of
 * threads nor on the numbering; with INDICES the sum of the indices is the Euler characteristic of
 * every closed connected part of the mesh.
 *
 * @warning
 * Where fits are one-sided an umbilic, and even a pair of them, may be an error of the fits
 * (NearBorder), and an umbilic just beyond the border may be found; the sum of the indices of an
 * open mesh is not constrained. On spheres and planes, where k1 = k2 everywhere, umbilics mean
 * nothing: as many remain as the Euler characteristic demands, inside an UmbilicZone. Where
 * directions make several half turns around one triangle, as on a cube of twelve triangles, it
 * contains several umbilics, and the first has the patch.
 *
 * @sa
 * vtkJetFitting vtkRidgeExtraction
 */

#ifndef vtkUmbilicDetection_h
#define vtkUmbilicDetection_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesCompatibility.h" // For the ABI namespace
#include "vtkRidgesRanks.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSRIDGES_EXPORT vtkUmbilicDetection : public vtkPolyDataAlgorithm
{
public:
  static vtkUmbilicDetection* New();
  vtkTypeMacro(vtkUmbilicDetection, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    INDICES = 0,
    MINIMA = 1
  };

  ///@{
  /**
   * How umbilics are found: from the index of every triangle, or at minima of k1 - k2 as in the
   * paper. Default INDICES, which cannot miss any.
   */
  vtkSetClampMacro(Method, int, INDICES, MINIMA);
  vtkGetMacro(Method, int);
  void SetMethodToIndices() { this->SetMethod(INDICES); }
  void SetMethodToMinima() { this->SetMethod(MINIMA); }
  ///@}

  ///@{
  /**
   * Number of standard errors by which k1 - k2 must differ from zero for directions to be reliable,
   * 0 to 100. Default 3, which is rarely exceeded by chance. With 0 only umbilics in neighbouring
   * triangles cancel; larger values leave fewer umbilics. Not used by MINIMA.
   */
  vtkSetClampMacro(Significance, double, 0.0, 100.0);
  vtkGetMacro(Significance, double);
  ///@}

  ///@{
  /**
   * Size of the patches, as a multiple of the distance from a triangle's centroid to the farthest
   * one among the triangles that touch it; no unit, 1 to 100. Default 2: the smaller of the
   * two sizes that the paper recommends (2 and 3). With MINIMA a larger patch finds fewer
   * umbilics and computes their index farther away from them, where directions are more reliable;
   * the umbilics of INDICES do not depend on it. A patch ends half way to the next umbilic. It may
   * be smaller or up to twice as large, so that as many ridges cross its contour as meet at its
   * umbilic.
   */
  vtkSetClampMacro(PatchSize, double, 1.0, 100.0);
  vtkGetMacro(PatchSize, double);
  ///@}

protected:
  vtkUmbilicDetection();
  ~vtkUmbilicDetection() override = default;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// What is known of the larger mesh that the input is a part of; null: it is all there is.
  virtual const ridges::MeshPart* GetPart() { return nullptr; }

  int Method = INDICES;
  double Significance = 3.0;
  double PatchSize = 2.0;

private:
  vtkUmbilicDetection(const vtkUmbilicDetection&) = delete;
  void operator=(const vtkUmbilicDetection&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
