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

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesCompatibility.h" // For the ABI namespace
#include "vtkSmartPointer.h"        // For vtkSmartPointer

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkJetFunction;

class VTKFILTERSRIDGES_EXPORT vtkCompliantRefinement : public vtkPolyDataAlgorithm
{
public:
  static vtkCompliantRefinement* New();
  vtkTypeMacro(vtkCompliantRefinement, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// See SetSurfaceType and SetLevel.
  enum SurfaceTypes
  {
    IMPLICIT = 0,
    GRAPH = 1
  };
  enum Levels
  {
    CHECKED = 0,
    PROVED = 1
  };

  ///@{
  /**
   * What Formula is, as in vtkImplicitMongeForm: f(x, y, z) of the surface f = 0, or g(x, y) of
   * z = g. Default IMPLICIT. Parametric surfaces cannot be certified.
   */
  vtkSetClampMacro(SurfaceType, int, IMPLICIT, GRAPH);
  vtkGetMacro(SurfaceType, int);
  void SetSurfaceTypeToImplicit() { this->SetSurfaceType(IMPLICIT); }
  void SetSurfaceTypeToGraph() { this->SetSurfaceType(GRAPH); }
  ///@}

  ///@{
  /**
   * The surface. Default empty: the formula in the field array Formula of the input, where
   * vtkImplicitSurfaceMesh leaves the one that it meshed.
   */
  vtkSetStdStringFromCharMacro(Formula);
  vtkGetCharFromStdStringMacro(Formula);
  ///@}

  ///@{
  /**
   * CHECKED: bounds on derivatives of order 4 in a region are estimated from samples there. PROVED:
   * they come from interval arithmetic, and nothing is estimated. Default PROVED: it takes about
   * the same time. A JetFunction can only be CHECKED.
   */
  vtkSetClampMacro(Level, int, CHECKED, PROVED);
  vtkGetMacro(Level, int);
  void SetLevelToChecked() { this->SetLevel(CHECKED); }
  void SetLevelToProved() { this->SetLevel(PROVED); }
  ///@}

  ///@{
  /**
   * The mesh is refined where a hypothesis fails, until none does or it has this many points.
   * 0 leaves it as it is. Default 200000: closed generic surfaces
   * take far less
   */
  vtkSetClampMacro(MaximumNumberOfPoints, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfPoints, vtkIdType);
  ///@}

#ifndef __VTK_WRAP__ // which only C++ can subclass
  ///@{
  /**
   * A function of your own in place of Formula, for surfaces f = 0. Default none.
   */
  void SetJetFunction(vtkJetFunction* function);
  vtkJetFunction* GetJetFunction() const;
  ///@}
#endif

  /// Later of the filter and its JetFunction.
  vtkMTimeType GetMTime() override;

protected:
  vtkCompliantRefinement();
  ~vtkCompliantRefinement() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int SurfaceType = IMPLICIT;
  std::string Formula;
  int Level = PROVED;
  vtkIdType MaximumNumberOfPoints = 200000;
  vtkSmartPointer<vtkJetFunction> JetFunction;

private:
  vtkCompliantRefinement(const vtkCompliantRefinement&) = delete;
  void operator=(const vtkCompliantRefinement&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
