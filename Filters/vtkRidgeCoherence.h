// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRidgeCoherence
 * @brief   check that ridges and umbilics make one coherent picture
 *
 * Ridges and umbilics of a smooth generic surface are bound to each other (RR-5294): their numbers
 * follow from the topology of the surface, ridges are loops or join umbilics, and change their type
 * in pairs. What was computed on a mesh is held against that, in one table.
 *
 * Input port 0: the mesh with Monge arrays and the marks of vtkUmbilicDetection, its output 0.
 * Input port 1: all ridges, output 0 of vtkRidgeExtraction.
 * Input port 2, optional: the umbilics, output 1 of vtkUmbilicDetection. Without it they are taken
 * from the field data of the mesh.
 *
 * Output port 0: a table with a row per check and the columns
 *
 * | column             | meaning                                                              |
 * |--------------------|----------------------------------------------------------------------|
 * | Check              | name of the check, as below                                          |
 * | Section            | of the paper, where it is from                                       |
 * | Expected, Found    | in words                                                             |
 * | Applies            | 0: there is nothing to check, as the index of an open mesh           |
 * | Passed             | 1: nothing speaks against it, or it does not apply                   |
 * | NumberOfOffenders  | of what speaks against it                                            |
 * | OffenderKind       | what these are, as below                                             |
 * | Offenders          | ids of the first 20 of them; an edge is a pair of points: 17-42      |
 * | OffenderPosition   | (3) where the first of them is                                       |
 *
 * | check                 | demands that                                          | offenders   |
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
 * | ridges inside patches | there is none but from the umbilic to the border      | ridge       |
 * | patch contours        | RidgeCount ridges of each colour cross one            | umbilic     |
 * | right angles          | maximum directions at the ends of an edge do not make | edge        |
 * |                       | one, outside patches                                  |             |
 * | double crossings      | outside patches a colour crosses an edge once at most | edge        |
 * | points on edges       | points are where their edges and parameters say       | ridge point |
 * | crossings             | outside patches all those of the acute rule are in a  | edge        |
 * |                       | ridge, or in a loop around at most 64 points          |             |
 *
 * Outside patches also means outside the regions of CancelledUmbilics. Most checks are about how
 * well filters did. That about right angles is about the mesh: it is too coarse, or the surface too
 * little generic, to be sure about signs there. Patch contours tell whether ridges and third-order
 * forms agree about an umbilic: patches may be too small or too large, the mesh too coarse.
 *
 * @warning
 * The whole picture is checked: ridges of one colour, crest lines alone, ridges by the Gaussian
 * extremality or those that vtkRidgeSharpnessFilter has kept fail.
 *
 * Where a formula of the surface is known more can be demanded: that the acute rule orients every
 * edge as continuity does (definition 5) and that exact ridges cross an edge once at most (2.2d).
 * This is not checked.
 *
 * @sa
 * vtkUmbilicDetection vtkRidgeExtraction
 */

#ifndef vtkRidgeCoherence_h
#define vtkRidgeCoherence_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkTableAlgorithm.h"

class VTKFILTERSRIDGES_EXPORT vtkRidgeCoherence : public vtkTableAlgorithm
{
public:
  static vtkRidgeCoherence* New();
  vtkTypeMacro(vtkRidgeCoherence, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Cosine of the angle between two directions below which it counts as a right one, 0 to 1.
   * Default 0.001: fits leave errors of that size in directions, so that signs may be wrong there.
   */
  vtkSetClampMacro(RightAngleCosine, double, 0.0, 1.0);
  vtkGetMacro(RightAngleCosine, double);
  ///@}

protected:
  vtkRidgeCoherence();
  ~vtkRidgeCoherence() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double RightAngleCosine = 0.001;

private:
  vtkRidgeCoherence(const vtkRidgeCoherence&) = delete;
  void operator=(const vtkRidgeCoherence&) = delete;
};

#endif
