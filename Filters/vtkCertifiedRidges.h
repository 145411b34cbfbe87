// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCertifiedRidges
 * @brief   ridges and umbilics of a known surface, with a certificate
 *
 * The certified algorithm of RR-5294 (section 6.5), for a surface that is given by a formula. Each
 * hypothesis of the paper is checked, the mesh is refined where one fails (vtkCompliantRefinement),
 * and ridges are extracted: if all hold, they have the topology of those of the surface, each is
 * there, and none is more. Their points on edges are where the ridge crosses the image of the edge
 * on the surface, by bisection with d1 turned by continuity, not by the acute rule. Umbilics are
 * exact, too.
 *
 * Input: a mesh near the surface, such as the output of vtkImplicitSurfaceMesh.
 *
 * | output port | what                                                                        |
 * |-------------|-----------------------------------------------------------------------------|
 * | RIDGES      | as port 0 of vtkRidgeExtraction                                             |
 * | UMBILICS    | as port 1 of vtkUmbilicDetection                                            |
 * | MESH        | the refined mesh with verdicts, as port 0 of vtkCompliantRefinement         |
 * | EDGES       | a line per edge outside patches or on their borders, with cell arrays       |
 * |             | Certificate, FailedHypotheses, MaximumCrossings and MinimumCrossings: the   |
 * |             | number of ridges that cross its image, -1 if that is unknown                |
 * | TABLE       | a vtkTable, as port 1 of vtkCompliantRefinement                             |
 *
 * The points are on the surface, not on the straight edges of the mesh: the check "points on edges"
 * of vtkRidgeCoherence fails them. Inside patches ridges are paths on the mesh.
 *
 * Where a hypothesis fails, ridges come out as the acute rule gives them, with a warning.
 *
 * @sa vtkCompliantRefinement vtkRidgeExtraction
 */

#ifndef vtkCertifiedRidges_h
#define vtkCertifiedRidges_h

#include "vtkCertificationAlgorithm.h"
#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkRidgesCompatibility.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSRIDGES_EXPORT vtkCertifiedRidges : public vtkCertificationAlgorithm
{
public:
  static vtkCertifiedRidges* New();
  vtkTypeMacro(vtkCertifiedRidges, vtkCertificationAlgorithm);

  /// Output ports.
  enum Ports
  {
    RIDGES = 0,
    UMBILICS = 1,
    MESH = 2,
    EDGES = 3,
    TABLE = 4
  };

protected:
  vtkCertifiedRidges();
  ~vtkCertifiedRidges() override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCertifiedRidges(const vtkCertifiedRidges&) = delete;
  void operator=(const vtkCertifiedRidges&) = delete;

  void StoreRidges(vtkPolyData* mesh, vtkPolyData* output);
};
VTK_ABI_NAMESPACE_END

#endif
