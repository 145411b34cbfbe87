// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesGathering_h
#define vtkRidgesGathering_h

#include "Core/Shares/SharedPoints.h"
#include "vtkRidgesMesh.h"

#include "vtkSmartPointer.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * A mesh that ranks have in pieces, made one on the first of them, and what was found there, given
 * back to the pieces. Private to the module. All ranks have to call each function.
 */
class vtkRidgesGathering
{
public:
  /// On rank 0 the mesh with the triangles of all pieces, the arrays of their points, and the field
  /// data of its own piece; elsewhere null. Pieces are outputs of vtkJetFitting.
  vtkSmartPointer<vtkPolyData> Gather(ridges::Ranks& ranks, vtkPolyData* piece);

  /// The piece with the cell arrays that `whole`, on rank 0, has more than the gathered mesh had,
  /// its field data, and the ids in the gathered mesh. Cells that were not gathered have -1.
  void GiveBack(ridges::Ranks& ranks, vtkPolyData* whole, vtkPolyData* output);

private:
  void Pack(ridges::Bytes& message) const;
  vtkSmartPointer<vtkPolyData> Join(
    const std::vector<ridges::Bytes>& messages, std::vector<std::vector<vtkIdType>>& ids) const;

  vtkRidgesMesh Piece;
  ridges::SharedPoints Points;
  std::vector<vtkIdType> PointIds; ///< Of the points of the piece, in the gathered mesh.
  std::vector<vtkIdType> First;    ///< Triangle of each rank, and how many there are.
};

#endif
