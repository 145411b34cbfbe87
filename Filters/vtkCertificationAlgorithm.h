// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCertificationAlgorithm
 * @brief   superclass of the filters that certify the ridges of a known surface
 *
 * Has the properties that say which surface that is, and how it is certified. The last output port
 * is a vtkTable.
 *
 * @sa vtkCompliantRefinement vtkCertifiedRidges
 */

#ifndef vtkCertificationAlgorithm_h
#define vtkCertificationAlgorithm_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesCompatibility.h" // For the ABI namespace
#include "vtkSmartPointer.h"        // For vtkSmartPointer

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkJetFunction;

class VTKFILTERSRIDGES_EXPORT vtkCertificationAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkCertificationAlgorithm, vtkPolyDataAlgorithm);
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
   * 0 leaves it as it is. Default 200000: closed generic surfaces take far less.
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
  vtkCertificationAlgorithm();
  ~vtkCertificationAlgorithm() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;

  int SurfaceType = IMPLICIT;
  std::string Formula;
  int Level = PROVED;
  vtkIdType MaximumNumberOfPoints = 200000;
  vtkSmartPointer<vtkJetFunction> JetFunction;

private:
  vtkCertificationAlgorithm(const vtkCertificationAlgorithm&) = delete;
  void operator=(const vtkCertificationAlgorithm&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
