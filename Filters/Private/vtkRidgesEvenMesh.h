// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesEvenMesh_h
#define vtkRidgesEvenMesh_h

#include "Core/Formula/ExactSurface.h"
#include "vtkRidgesContour.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * An even triangle mesh of a surface f = 0 in a box, oriented to where f > 0. Private to the
 * module.
 */
class vtkRidgesEvenMesh
{
public:
  /// False if the user aborted, or if something is wrong: see `contour`. The function, and `rough`,
  /// its surface, need not be more exact than a contour.
  bool Make(vtkAlgorithm* filter, const ridges::JetFunction& function,
    const ridges::ExactSurface& rough, const ridges::ExactSurface& surface, const double bounds[6],
    double edgeLength);

  ridges::EditableMesh& GetMesh() { return this->contour.mesh; }

  /// Points and triangles.
  void Store(vtkPolyData* output) const;

  /// Tells the user of the filter what is to be known of the mesh. `whatCuts` begins the sentence
  /// "... the surface".
  void Warn(vtkAlgorithm* filter, const char* whatCuts) const;

  vtkRidgesContour contour;

private:
  double EdgeLength = 0.0;
  ridges::Id NumberOfSharpPoints = 0; ///< Without a Monge form, or bent within an edge.
  ridges::Id FirstSharpPoint = 0;
  ridges::Id NumberOfBorderEdges = 0;
};

#endif
