// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesCertificateOutput_h
#define vtkRidgesCertificateOutput_h

#include "vtkRidgesCertifier.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkTable;
VTK_ABI_NAMESPACE_END

/**
 * What vtkRidgesCertifier has found, as data sets: private to the module.
 */
class vtkRidgesCertificateOutput
{
public:
  explicit vtkRidgesCertificateOutput(const vtkRidgesCertifier& certifier)
    : Certifier(certifier)
  {
  }

  /// The mesh with Monge arrays, the marks of vtkUmbilicDetection and verdicts, and a vertex per
  /// umbilic. Null: not wanted. Returns what is wrong with the mesh, empty as long as it is ours.
  std::string StoreMesh(vtkPolyData* mesh, vtkPolyData* umbilics) const;

  /// A line per edge that hypotheses are about.
  void StoreEdges(vtkPolyData* output) const;

  /// A row per hypothesis. The last is about umbilics and the topology of the mesh.
  void StoreTable(vtkTable* output) const;

  /// Moves ridge points to where ridges cross edges.
  void PlaceOnRidges(vtkPolyData* ridges) const;

private:
  const vtkRidgesCertifier& Certifier;
};

#endif
