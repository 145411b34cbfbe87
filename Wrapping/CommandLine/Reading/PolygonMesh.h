// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PolygonMesh_h
#define PolygonMesh_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

namespace program
{

/// The corners of a face: a range of point ids.
struct Face
{
  const vtkIdType* first;
  const vtkIdType* last;

  const vtkIdType* begin() const { return this->first; }
  const vtkIdType* end() const { return this->last; }
  std::size_t size() const { return static_cast<std::size_t>(this->last - this->first); }
  vtkIdType operator[](std::size_t i) const { return this->first[i]; }
  /// The corner after the i-th, around the face.
  vtkIdType Next(std::size_t i) const { return this->first[i + 1 == this->size() ? 0 : i + 1]; }
};

/// Points and faces as a file gives them: in double precision, with polygons of any size.
struct PolygonMesh
{
  using Point = std::array<double, 3>;

  std::vector<Point> points;
  std::vector<vtkIdType> corners;    ///< Of all faces, one after the other.
  std::vector<std::size_t> faceEnds; ///< End of each face in corners.
  bool isSinglePrecision = false;    ///< Whether the file stores coordinates in 32 bits.

  std::size_t NumberOfFaces() const { return this->faceEnds.size(); }

  Face FaceAt(std::size_t i) const
  {
    const vtkIdType* base = this->corners.data();
    return { base + (i == 0 ? 0 : this->faceEnds[i - 1]), base + this->faceEnds[i] };
  }

  /// Corners that were appended to `corners` become a face; fewer than three are dropped.
  void EndFace();

  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c);

  /// Adds the triangles of a strip, all in the orientation of its first.
  void AddStrip(const std::vector<vtkIdType>& strip);

  vtkSmartPointer<vtkPolyData> ToPolyData() const;
};

} // namespace program

#endif
