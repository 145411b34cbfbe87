// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRidgeCoherence
 * @brief   check that ridges and umbilics are consistent
 *
 * The ridges and umbilics of a smooth generic surface obey rules (RR-5294): the indices of umbilics
 * follow from the topology of the surface, ridges are loops or join umbilics, and their type
 * changes an even number of times. This filter checks the result on a mesh against these rules.
 *
 * Input port 0: the mesh with Monge arrays and the marks of vtkUmbilicDetection, its output 0, or
 * output 2 of vtkRidgeExtraction, which knows of ridges that are left out in zones.
 * Input port 1: all ridges, output 0 of vtkRidgeExtraction.
 * Input port 2, optional: the umbilics, output 1 of vtkUmbilicDetection. Without it they are read
 * from the field data of the mesh.
 *
 * Composite inputs must have the same structure; the output is then a composite data set, too, with
 * a table per block: GetOutputDataObject(0), while GetOutput() is null. The names of the mesh's
 * arrays can be chosen (SetInputArrayToProcess, see Documentation/Arrays.md).
 *
 * Output port 0: a table with a row per check and the columns
 *
 * | column             | meaning                                                              |
 * |--------------------|----------------------------------------------------------------------|
 * | Check              | name of the check, as below                                          |
 * | Section            | of the paper, where it is from                                       |
 * | Expected, Found    | in words                                                             |
 * | Applies            | 0: there is nothing to check, such as the index sum of an open mesh  |
 * | Passed             | 1: nothing contradicts it, or it does not apply                      |
 * | Severity           | 0: passed; 1: noise or a coarse mesh explain it; 2: it is wrong      |
 * | NumberOfOffenders  | number of what contradicts it                                        |
 * | OffenderKind       | what these are, as below                                             |
 * | Offenders          | ids of the first 20 of them; an edge is a pair of points: 17-42      |
 * | OffenderPosition   | (3) position of the first of them                                    |
 *
 * | check                 | requires that                                         | offenders   |
 * |-----------------------|-------------------------------------------------------|-------------|
 * | index sum             | on each closed part of the mesh the indices sum to    | cell        |
 * |                       | its Euler characteristic                              |             |
 * | umbilics per triangle | there is at most one                                  | cell        |
 * | ridges at umbilics    | RidgeCount ridges of each colour end at an umbilic;   | umbilic     |
 * |                       | one that comes back to it counts twice                |             |
 * | types at umbilics     | ridges are hyperbolic there                           | ridge       |
 * | ridge ends            | a ridge is one chain of one colour that is a loop or  | ridge       |
 * |                       | ends at umbilics, borders or non-manifold edges       |             |
 * | turning points        | loops and ridges between umbilics have an even number | ridge       |
 * | intersections         | ridges of one colour do not cross                     | cell        |
 * | patches               | each is a disk and contains its umbilic               | umbilic     |
 * | ridges inside patches | the only ones run from the umbilic to the contour or, | ridge       |
 * |                       | if RidgeCount is 3, back to the umbilic               |             |
 * | patch contours        | RidgeCount ridges of each colour cross one, or two    | umbilic     |
 * |                       | fewer for one that leads back to the umbilic inside   |             |
 * | right angles          | maximum directions at the ends of an edge do not make | edge        |
 * |                       | one, outside patches                                  |             |
 * | double crossings      | outside patches a colour crosses an edge once at most | edge        |
 * | points on edges       | points are where their edges and parameters place them| ridge point |
 * | crossings             | outside patches all those of the acute rule are in a  | edge        |
 * |                       | ridge, or in a loop around at most 64 points          |             |
 *
 * Outside patches also means outside the regions of CancelledUmbilics. Most checks concern the
 * filters. Right angles concern the mesh: it is too coarse, or the surface not generic enough, to
 * be sure about signs there. Patch contours show whether ridges and third-order forms agree about
 * an umbilic; if not, its patch may be too small or too large, or the mesh too coarse.
 *
 * A failed check is wrong (Severity 2) where the filters guarantee the rule on any mesh and with
 * any noise: index sum, types at umbilics, ridge ends, turning points, double crossings, points on
 * edges and crossings; also intersections, outside patches. The other rules compare independent
 * estimates or need a fine mesh: noise makes them fail on a sound result (Severity 1).
 *
 * @warning
 * The checks need all ridges: ridges of one colour, crest lines alone, ridges by the Gaussian
 * extremality or the output of vtkRidgeSharpnessFilter fail them.
 *
 * Two rules need a formula of the surface and are not checked: that the acute rule orients every
 * edge as continuity does (definition 5), and that exact ridges cross an edge at most once (2.2d).
 * vtkCertifiedRidges checks them. If the mesh is its output, there are twelve more rows, hypothesis
 * S1 and so on, whose Found is proved, checked, or in how many triangles the hypothesis fails
 * (Severity 1: there the result is not certain); points on edges then does not apply, as points are
 * on the surface.
 *
 * @sa
 * vtkUmbilicDetection vtkRidgeExtraction
 */

#ifndef vtkRidgeCoherence_h
#define vtkRidgeCoherence_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkRidgesCompatibility.h" // For the ABI namespace
#include "vtkTableAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSRIDGES_EXPORT vtkRidgeCoherence : public vtkTableAlgorithm
{
public:
  static vtkRidgeCoherence* New();
  vtkTypeMacro(vtkRidgeCoherence, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  ///@{
  /**
   * Cosine of the angle between two directions below which it counts as a right angle, 0 to 1.
   * Default 0.001: directions have errors of that size, so signs may be wrong there.
   */
  vtkSetClampMacro(RightAngleCosine, double, 0.0, 1.0);
  vtkGetMacro(RightAngleCosine, double);
  ///@}

protected:
  vtkRidgeCoherence();
  ~vtkRidgeCoherence() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double RightAngleCosine = 0.001;

private:
  vtkRidgeCoherence(const vtkRidgeCoherence&) = delete;
  void operator=(const vtkRidgeCoherence&) = delete;

  int RequestDataObject(vtkInformationVector* meshVector, vtkInformationVector* outputVector);
};
VTK_ABI_NAMESPACE_END

#endif
