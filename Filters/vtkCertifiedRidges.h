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

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesCompatibility.h" // For the ABI namespace
#include "vtkSmartPointer.h"        // For vtkSmartPointer

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkJetFunction;

class VTKFILTERSRIDGES_EXPORT vtkCertifiedRidges : public vtkPolyDataAlgorithm
{
public:
  static vtkCertifiedRidges* New();
  vtkTypeMacro(vtkCertifiedRidges, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Output ports.
  enum Ports
  {
    RIDGES = 0,
    UMBILICS = 1,
    MESH = 2,
    EDGES = 3,
    TABLE = 4
  };

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
  vtkCertifiedRidges();
  ~vtkCertifiedRidges() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int SurfaceType = IMPLICIT;
  std::string Formula;
  int Level = PROVED;
  vtkIdType MaximumNumberOfPoints = 200000;
  vtkSmartPointer<vtkJetFunction> JetFunction;

private:
  vtkCertifiedRidges(const vtkCertifiedRidges&) = delete;
  void operator=(const vtkCertifiedRidges&) = delete;

  void StoreRidges(vtkPolyData* mesh, vtkPolyData* output);
};
VTK_ABI_NAMESPACE_END

#endif
