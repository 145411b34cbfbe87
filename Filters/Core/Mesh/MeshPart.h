// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_MeshPart_h
#define ridges_MeshPart_h

#include "Base/Types.h"
#include "Mesh/CoordinateRounding.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace ridges
{

/**
 * What a mesh that is a part of a larger one knows of that one. Where the part ends there are no
 * borders: who walks over the mesh from triangle to triangle has to say where he looks, and if he
 * comes there, his result is of no use; a larger part is wanted.
 */
class MeshPart
{
public:
  /// What it takes for the result to be that of the larger mesh.
  enum class Wants
  {
    Nothing,
    Larger,
    All
  };

  /// Of each point, how many rings around it are complete: 0 if triangles at the point are missing.
  std::vector<std::uint8_t> rings;

  // Of the larger mesh.
  Id eulerCharacteristic = 0;
  bool isClosed = true;
  double enclosingRadius = 0.0;
  CoordinateRounding coordinateRounding;
  std::vector<std::uint8_t> borderStrip; ///< For the points of the part: see BorderStrip.h.

  /// Says that so many rings around a point are looked at.
  void LookAt(Id p, int numberOfRings) const
  {
    if (this->rings[p] < numberOfRings)
    {
      this->Want(Wants::Larger);
    }
  }

  void Want(Wants wants) const
  {
    if (this->Wanted_ < wants)
    {
      this->Wanted_ = wants;
    }
  }

  Wants Wanted() const { return this->Wanted_; }

private:
  mutable std::atomic<Wants> Wanted_{ Wants::Nothing };
};

} // namespace ridges

#endif
