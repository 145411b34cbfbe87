// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesMesh_h
#define vtkRidgesMesh_h

#include "Core/Mesh/TriangleMesh.h"
#include "vtkRidgesCompatibility.h"
#include "vtkRidgesGhosts.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkInformationObjectBaseKey;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * The triangles of a vtkPolyData as the numerics want them, private to the module. Polygons and
 * strips are triangulated; triangles that cannot be used are left out here (not in the data set)
 * and counted, those that vtkGhostType hides without being counted. Verts and lines stay where they
 * are.
 *
 * Filters hand the mesh on with their output, so that those behind them need not build it again.
 * It is known there only, not in copies of the output, and taken only as long as the points, the
 * polys and their arrays are the very ones it was built from, and not modified since.
 */
class vtkRidgesMesh
{
public:
  /// Whether cells stay that vtkGhostType marks as duplicates of cells in other pieces.
  enum class Duplicates
  {
    Kept,
    LeftOut
  };

  /**
   * Triangles with a point p for which usable[p] is 0 are left out as well; an empty vector means
   * that all points may be used. The result is what is wrong with the mesh; empty if nothing is.
   */
  std::string Build(vtkPolyData* input, const std::vector<std::uint8_t>& usable = {},
    ridges::TriangleMesh::Edges edges = ridges::TriangleMesh::Edges::Built,
    Duplicates duplicates = Duplicates::Kept);

  /// Takes triangles that were made elsewhere: all polys of the data, whose points are doubles, and
  /// the same in memory.
  void Adopt(vtkPolyData* data, ridges::TriangleMesh triangles);

  /// Numbers the edges, if that has not been done yet.
  void BuildEdges();

  /// For the filters that take `output`, a shallow copy of GetPolyData(); but not if triangles were
  /// left out that others may use.
  void HandOnWith(vtkPolyData* output) const;

  /// The input itself or, if it holds polygons or strips, its triangulation.
  vtkPolyData* GetPolyData() const { return this->PolyData; }

  const ridges::TriangleMesh& GetTriangles() const { return *this->Triangles; }

  /// The cell of the data set that a triangle is.
  vtkIdType GetCellId(ridges::Id triangle) const
  {
    return this->FirstPoly + (this->PolyIds->empty() ? triangle : (*this->PolyIds)[triangle]);
  }

  /// Cells that were triangulated: polygons of more than three points, and strips.
  vtkIdType GetNumberOfTriangulatedCells() const { return this->NumberOfTriangulatedCells; }

  /// Triangles left out as two of their corners are one point, or a point is not finite or missing.
  vtkIdType GetNumberOfUnusableTriangles() const;

  /// Whether there are duplicates of triangles in other pieces.
  bool HasDuplicates() const { return this->Ghosts.HasDuplicates(); }

  /// Whether a triangle belongs to this piece. One that does not only serves its neighbours.
  bool IsOwned(ridges::Id triangle) const
  {
    return !this->HasDuplicates() || !this->Ghosts.IsDuplicateCell(this->GetCellId(triangle));
  }

  /// Whether a point has no triangles because these, or the point itself, are hidden.
  bool IsHidden(ridges::Id point) const;

  /// Says that this is a part of a larger mesh, or null: of none. The caller keeps it.
  void SetPart(const ridges::MeshPart* part);

  /// Of the triangles, as TriangleMesh has it; of those of the larger mesh, if it is a part of one.
  int GetEulerCharacteristic() const;

  /// Points that coincide with another one: a seam that merging them would close.
  vtkIdType CountCoincidentPoints() const;

private:
  struct Adjacency;
  class Carrier;

  /// Where the information of an output holds a Carrier.
  static vtkInformationObjectBaseKey* MESH();

  bool TakeHandedOn(vtkPolyData* input, const std::vector<std::uint8_t>& usable);
  std::string BuildAnew(
    vtkPolyData* input, const std::vector<std::uint8_t>& usable, Duplicates duplicates);
  void Take(std::shared_ptr<Adjacency> adjacency);

  vtkSmartPointer<vtkPolyData> PolyData;
  vtkRidgesGhosts Ghosts; ///< Of PolyData.
  std::shared_ptr<Adjacency> Shared;
  const ridges::TriangleMesh* Triangles = nullptr;  ///< Of Shared, as PolyIds.
  const std::vector<ridges::Id>* PolyIds = nullptr; ///< Empty where all polys are triangles.
  vtkIdType FirstPoly = 0;
  vtkIdType NumberOfTriangulatedCells = 0;
};

/// Of the points before `end`, those that have triangles and coincide with another one.
vtkIdType vtkRidgesCountCoincidentPoints(const ridges::TriangleMesh& mesh, ridges::Id end);

/// Shares of the triangles for TriangleMesh to be built from on all threads: memory is taken for
/// each.
ridges::Id vtkRidgesSharesOfThreads();

#endif
