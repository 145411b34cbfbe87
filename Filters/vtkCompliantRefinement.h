// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCompliantRefinement
 * @brief   refine a mesh of a known surface until its ridges can be certified
 *
 * RR-5294 proves that ridges extracted from a mesh have the topology of those of the surface, if
 * the mesh fulfils hypotheses (sections 5.2.1 and 6.3). This filter checks them, for a surface that
 * is given by a formula, and refines the mesh where one fails or cannot be decided: triangles are
 * bisected by their longest edges, without hanging points, and new points are put on the surface.
 * Nothing moves, except vertices that a ridge goes through.
 *
 * Input: a mesh near the surface, whose points are moved to it. Its own arrays are dropped.
 *
 * Output port 0: the mesh with the point arrays of vtkImplicitMongeForm, the umbilics and patches
 * as vtkUmbilicDetection marks them, so that vtkRidgeExtraction can follow, and the cell arrays
 *
 * | array            | values                                                                 |
 * |------------------|------------------------------------------------------------------------|
 * | Certificate      | 0: a hypothesis fails here; 1: all are checked, 2: proved              |
 * | FailedHypotheses | which: a bit for each row of the table, in order; and 32768 where the  |
 * |                  | surface is not generic, so that no refinement will help                |
 *
 * Output port 1: a vtkTable with a row per hypothesis and the columns Check, Section, Expected,
 * Verdict ("proved", "checked" or "failed"), Passed, NumberOfOffenders, OffenderKind, Offenders
 * (ids of the first 20) and OffenderPosition (3), the first of them on the surface.
 *
 * What is proved, how, and what is not: Documentation/Certificates.md. A surface that is not
 * generic (sphere, torus, any surface of revolution) fails; the table says where and by which
 * hypothesis.
 *
 * @sa vtkCertifiedRidges vtkImplicitSurfaceMesh vtkImplicitMongeForm
 */

#ifndef vtkCompliantRefinement_h
#define vtkCompliantRefinement_h

#include "vtkCertificationAlgorithm.h"
#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkRidgesCompatibility.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSRIDGES_EXPORT vtkCompliantRefinement : public vtkCertificationAlgorithm
{
public:
  static vtkCompliantRefinement* New();
  vtkTypeMacro(vtkCompliantRefinement, vtkCertificationAlgorithm);

protected:
  vtkCompliantRefinement();
  ~vtkCompliantRefinement() override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCompliantRefinement(const vtkCompliantRefinement&) = delete;
  void operator=(const vtkCompliantRefinement&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
