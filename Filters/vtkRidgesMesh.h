// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesMesh_h
#define vtkRidgesMesh_h

#include "Core/TriangleMesh.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <vector>

class vtkPolyData;

/**
 * The triangles of a vtkPolyData as the numerics want them, private to the module. Polygons and
 * strips are triangulated; triangles that cannot be used are left out here (not in the data set)
 * and counted. Verts and lines stay where they are.
 */
class vtkRidgesMesh
{
public:
  /**
   * Triangles with a point p for which usable[p] is 0 are left out as well; an empty vector means
   * that all points may be used. False where the mesh is larger than 32-bit numbering allows.
   */
  bool Build(vtkPolyData* input, const std::vector<std::uint8_t>& usable = {},
    ridges::TriangleMesh::Edges edges = ridges::TriangleMesh::Edges::Built);

  /// Numbers the edges, if Build was told not to.
  void BuildEdges();

  /// Turns triangles around where their neighbours run through a common edge in the same sense.
  void OrientConsistently() { this->Triangles.OrientConsistently(); }

  /// The input itself or, if it holds polygons or strips, its triangulation.
  vtkPolyData* GetPolyData() const { return this->PolyData; }

  const ridges::TriangleMesh& GetTriangles() const { return this->Triangles; }

  /// The cell of the data set that a triangle is.
  vtkIdType GetCellId(ridges::Id triangle) const
  {
    return this->FirstPoly + this->PolyIds[triangle];
  }

  /// Cells that were triangulated: polygons of more than three points, and strips.
  vtkIdType GetNumberOfTriangulatedCells() const { return this->NumberOfTriangulatedCells; }

  /// Triangles left out as two of their corners are one point, or a point is not finite or missing.
  vtkIdType GetNumberOfUnusableTriangles() const { return this->NumberOfUnusableTriangles; }

  /// Points that coincide with another one: a seam that merging them would close.
  vtkIdType CountCoincidentPoints() const;

private:
  void FetchPoints();
  void CountTriangulatedCells(vtkPolyData* input);

  vtkSmartPointer<vtkPolyData> PolyData;
  std::vector<double> ConvertedPoints;
  const double* Points = nullptr;
  ridges::TriangleMesh Triangles;
  std::vector<ridges::Id> PolyIds;
  vtkIdType FirstPoly = 0;
  vtkIdType NumberOfTriangulatedCells = 0;
  vtkIdType NumberOfUnusableTriangles = 0;
};

#endif
