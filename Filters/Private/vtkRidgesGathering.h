// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesGathering_h
#define vtkRidgesGathering_h

#include "Core/Mesh/MeshPart.h"
#include "Core/Shares/PieceSeams.h"
#include "Core/Shares/SharedSurface.h"
#include "Core/Umbilics/TriangleContent.h"
#include "vtkRidgesMesh.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkFieldData;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * The part of a mesh that is needed to find umbilics and ridges, from the pieces that ranks have of
 * it to the first of them, and what was found there, given back to the pieces. Private to the
 * module. All ranks have to call each function.
 *
 * The part are the triangles in which something may be, by what is known at their corners, and
 * rings around them. Points and triangles are numbered as in a mesh gathered from all pieces, one
 * after the other; in the part, they come in this order.
 */
class vtkRidgesGathering
{
public:
  vtkRidgesGathering() = default;
  virtual ~vtkRidgesGathering() = default;
  vtkRidgesGathering(const vtkRidgesGathering&) = delete;
  void operator=(const vtkRidgesGathering&) = delete;

  /// How much of the mesh.
  struct Extent
  {
    bool isAll = false;
    double significance = 0.0; ///< Of umbilics.
    int ringsOfUmbilics = 10;  ///< Around triangles that may have an umbilic,
    int ringsOfRidges = 3;     ///< and around others that ridges cross.

    /// The next larger one.
    void Enlarge();
    bool operator==(const Extent& other) const;
  };

  /// Takes pieces that are outputs of vtkJetFitting.
  void Take(ridges::Ranks& ranks, vtkPolyData* piece, ridges::SharedSurface& surface);

  /// Whether a part may do: some of what is rare takes the whole mesh.
  bool MayBePart() const { return this->PartMayDo; }

  /// On rank 0 the part, with the arrays of its points, and the field data of its own piece;
  /// elsewhere null. The arrays to look at are those that the filter reads.
  vtkSmartPointer<vtkPolyData> Gather(
    ridges::Ranks& ranks, vtkAlgorithm* filter, const Extent& extent);

  /// What is known of the mesh, on rank 0; null if it was gathered as a whole.
  const ridges::MeshPart* GetPart() const { return this->Part.get(); }

  /// The piece with the cell arrays that `part`, on rank 0, has more than the gathered one had, its
  /// field data, and the ids in the gathered mesh. Cells that were not gathered have -1.
  void GiveBack(ridges::Ranks& ranks, vtkPolyData* part, vtkPolyData* output);

  /// On rank 0: ids in the part become ids in the gathered mesh. The array is replaced.
  void NumberPoints(vtkFieldData* data, const char* name) const;
  void NumberTriangles(vtkFieldData* data, const char* name) const;

protected:
  using Contents = std::vector<ridges::TriangleContent>;

  /// Takes what is known of the whole surface, if a part may do. `radii` may be null.
  void Know(ridges::Ranks& ranks, const ridges::SharedSurface& surface,
    const std::vector<std::uint8_t>& onBorder, const double* radii);

  /// The most that may be in any triangle at each point of the piece.
  virtual Contents ContentsOf(vtkAlgorithm* filter, const Extent& extent);

  /// The same by the arrays of a mesh. `rounding` is that of FitErrorSource.
  static Contents ContentsOf(vtkAlgorithm* filter, vtkPolyData* data,
    ridges::Span<ridges::Triangle> triangles, const Extent& extent, double rounding);

  /// Some points of the piece: see vtkRidgesPackPoints.
  virtual void PackPoints(ridges::Bytes& message, const std::vector<ridges::Id>& points);

  virtual void AddFieldData(vtkPolyData* part);

  const std::vector<std::int64_t>& GetPointsOfPart() const { return this->PointsOfPart; }
  const std::vector<std::int64_t>& GetTrianglesOfPart() const { return this->TrianglesOfPart; }

  const ridges::TriangleMesh* Mesh = nullptr; ///< The triangles of the piece.
  std::vector<std::int64_t> First;            ///< Triangle of each rank, and how many there are.
  bool PartMayDo = true;

private:
  bool Choose(ridges::Ranks& ranks, vtkAlgorithm* filter, const Extent& extent);
  void ChooseAll();
  std::vector<ridges::Id> ChosenPoints() const;
  void GatherTriangles(
    ridges::Ranks& ranks, const std::vector<ridges::Id>& points, vtkPolyData* part);
  void GatherPoints(ridges::Ranks& ranks, const std::vector<ridges::Id>& points, vtkPolyData* part);
  vtkIdType IdInPart(std::int64_t number) const;

  /// The id of a point of the piece.
  std::int64_t NumberOf(ridges::Id p) const
  {
    return this->PointIds.empty() ? p : this->PointIds[p];
  }

  vtkRidgesMesh Piece;
  ridges::PieceSeams Seams;
  std::vector<std::int64_t> PointIds;    ///< Of the points of the piece; empty: their numbers.
  std::vector<std::uint8_t> BorderStrip; ///< Of the piece.
  bool IsClosed = true;
  std::int64_t EulerCharacteristic = 0;
  double EnclosingRadius = 0.0;
  ridges::CoordinateRounding CoordinateRounding;

  // What was gathered.
  std::vector<std::uint8_t> Levels;  ///< Of the points of the piece: rings that they lack,
  int HighestLevel = 0;              ///< of so many.
  std::vector<ridges::Id> Triangles; ///< Of the piece.
  std::unique_ptr<ridges::MeshPart> Part;
  std::vector<std::vector<vtkIdType>> PointsFrom; ///< On rank 0: those of each rank, in the part.
  std::vector<std::int64_t> PointsOfPart;         ///< On rank 0: their ids, ascending.
  std::vector<std::int64_t> TrianglesOfPart;
  std::vector<vtkIdType> FirstOfPart; ///< Triangle of each rank, and how many there are.
};

#endif
