// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesCertifier_h
#define vtkRidgesCertifier_h

#include "Core/Certification/CompliantMesh.h"
#include "vtkRidgesCompatibility.h"
#include "vtkRidgesFormulaSurface.h"

#include "vtkType.h"

#include <memory>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkJetFunction;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * Checks a mesh against the surface that it is of, and refines it: what vtkCertifiedRidges and
 * vtkCompliantRefinement have in common. Private to the module.
 */
class vtkRidgesCertifier
{
public:
  /// The surface and what to do, as properties of the filters.
  struct Choice
  {
    bool isGraph = false;
    std::string formula; ///< Empty: that of the mesh.
    vtkJetFunction* function = nullptr;
    bool isProof = false;
    vtkIdType mostPoints = 0; ///< No refinement beyond.
  };

  /// False after one error of the filter; IsDone is false then, and if the user aborted.
  bool Run(vtkAlgorithm* filter, vtkPolyData* input, const Choice& choice);

  bool IsDone() const { return this->Done; }
  bool IsProof() const { return this->Proof; }
  const ridges::CompliantMesh& GetMesh() const { return *this->Mesh; }
  const ridges::MeshCertificate& GetCertificate() const { return this->Certificate; }
  const std::string& GetFormula() const { return this->Formula; }

private:
  std::string SetSurface(vtkPolyData* input, const Choice& choice);
  std::string SetMesh(vtkPolyData* input, const Choice& choice);

  vtkRidgesFormulaSurface Surface;
  std::string Formula;
  bool Proof = false;
  bool Done = false;
  std::unique_ptr<ridges::SurfaceBounds> Bounds;
  std::unique_ptr<ridges::CompliantMesh> Mesh;
  ridges::MeshCertificate Certificate;
};

#endif
