// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesPiece_h
#define vtkRidgesPiece_h

#include "Core/Shares/SharedPoints.h"

#include <cstdint>
#include <vector>

class vtkRidgesMesh;

/// A piece of a mesh as the numerics want it, private to the module. The mesh has to stay.
class vtkRidgesPiece
{
public:
  explicit vtkRidgesPiece(const vtkRidgesMesh& mesh);

  const ridges::MeshPiece& GetView() const { return this->View; }

private:
  std::vector<std::int64_t> GlobalIds; ///< Empty if the points have none.
  ridges::MeshPiece View;
};

#endif
