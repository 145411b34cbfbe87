// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesCertifier_h
#define vtkRidgesCertifier_h

#include "Core/Certification/CompliantMesh.h"
#include "vtkRidgesCompatibility.h"
#include "vtkRidgesFormulaSurface.h"

#include <memory>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkCertificationAlgorithm;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * Checks a mesh against the surface that it is of, and refines it: what vtkCertifiedRidges and
 * vtkCompliantRefinement have in common. Private to the module.
 */
class vtkRidgesCertifier
{
public:
  /// As the properties of the filter say. False after one error of it; IsDone is false then, and if
  /// the user aborted.
  bool Run(vtkCertificationAlgorithm* filter, vtkPolyData* input);

  bool IsDone() const { return this->Done; }
  bool IsProof() const { return this->Proof; }
  const ridges::CompliantMesh& GetMesh() const { return *this->Mesh; }
  const ridges::MeshCertificate& GetCertificate() const { return this->Certificate; }
  const std::string& GetFormula() const { return this->Formula; }

private:
  std::string SetSurface(vtkCertificationAlgorithm* filter, vtkPolyData* input);
  std::string SetMesh(vtkPolyData* input);
  void Certify(vtkAlgorithm* filter, double begin, double end);

  vtkRidgesFormulaSurface Surface;
  std::string Formula;
  bool Proof = false;
  bool Done = false;
  std::unique_ptr<ridges::SurfaceBounds> Bounds;
  std::unique_ptr<ridges::CompliantMesh> Mesh;
  ridges::MeshCertificate Certificate;
};

#endif
