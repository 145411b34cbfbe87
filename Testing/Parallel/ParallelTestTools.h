// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// What the tests on several ranks share: all ranks run the same tests, each with its piece.

#ifndef ParallelTestTools_h
#define ParallelTestTools_h

#include "TestMeshes.h"
#include "ThreadRanks.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkFieldData;
class vtkMultiProcessController;

namespace ridges
{
namespace testing
{

vtkMultiProcessController* Controller();

/// What rank 0 makes, on all ranks.
vtkSmartPointer<vtkPolyData> FromFirstRank(
  const std::function<vtkSmartPointer<vtkPolyData>()>& make);

/// This rank's piece of a mesh, without any points if it has none.
struct RankPiece
{
  PieceOfMesh piece;
  vtkSmartPointer<vtkPolyData> data;
};
RankPiece PieceOfRank(const Mesh& mesh, Partition partition);

/// The first array of `expected` whose values at ids[i] are not, byte for byte, those at i in
/// `actual`, or that is not there; empty if there is none.
std::string FirstOtherRow(
  vtkFieldData* expected, vtkFieldData* actual, const std::vector<std::int32_t>& ids);

/// All ids below a number.
std::vector<std::int32_t> AllOf(vtkIdType count);

/// A shallow copy without some arrays of points and field data.
vtkSmartPointer<vtkPolyData> Without(vtkPolyData* data, const std::vector<const char*>& arrayNames);

/// That ridges are the same, byte for byte, but for ids of points, which have these names.
void ExpectTheSameLines(
  vtkPolyData* expected, vtkPolyData* actual, const std::vector<vtkIdType>& pointNames);

/// That the triangles of umbilics in field data are the same, by their names.
void ExpectTheSameTriangles(
  vtkFieldData* expected, vtkFieldData* actual, const std::vector<vtkIdType>& cellNames);

/// That umbilics are, but for ids of triangles.
void ExpectTheSameUmbilics(
  vtkPolyData* expected, vtkPolyData* actual, const std::vector<vtkIdType>& cellNames);

/// Warnings without what VTK puts before the text of each.
std::string Bare(const std::string& messages);

/// Meshes that are small, but of all kinds.
struct NamedMesh
{
  const char* name;
  Mesh mesh;
};
std::vector<NamedMesh> SmallMeshes();

} // namespace testing
} // namespace ridges

#endif
