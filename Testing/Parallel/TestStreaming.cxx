// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Pieces that one rank asks for one after the other, against the whole mesh: byte for byte.

#include "FilterTestTools.h"
#include "MessageRecorder.h"
#include "ParallelTestTools.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPJetFitting.h"
#include "vtkPRidgesAndUmbilics.h"
#include "vtkPassThrough.h"
#include "vtkPointData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesArrayNames.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUmbilicDetection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

/// Gives any piece that it is asked for, and counts them.
class PieceSource : public vtkPolyDataAlgorithm
{
public:
  static PieceSource* New() { VTK_STANDARD_NEW_BODY(PieceSource); }

  void SetMesh(const Mesh& mesh, Partition partition)
  {
    this->Whole = mesh;
    this->Cut = partition;
    this->Modified();
  }

  PieceOfMesh Piece(int piece, int pieces) const
  {
    return PieceOf(this->Whole, PartsOf(this->Whole, this->Cut, pieces), piece);
  }

  /// Of a piece, before it is given.
  std::function<void(vtkPolyData* data, int piece)> spoil;

  int missing = -1; ///< A piece that cannot be made.
  int numberOfRequests = 0;

protected:
  PieceSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    outputVector->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
    return 1;
  }

  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkInformation* info = outputVector->GetInformationObject(0);
    const int piece = info->Get(Pipeline::UPDATE_PIECE_NUMBER());
    if (piece == this->missing)
    {
      vtkErrorMacro("there is no such piece");
      return 0;
    }
    const auto data =
      ToPolyData(this->Piece(piece, info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())).mesh);
    if (this->spoil)
    {
      this->spoil(data, piece);
    }
    vtkPolyData::GetData(outputVector)->ShallowCopy(data);
    ++this->numberOfRequests;
    return 1;
  }

private:
  Mesh Whole;
  Partition Cut = Partition::Blocks;
};

bool IsAlone()
{
  return Controller()->GetNumberOfProcesses() == 1;
}

vtkSmartPointer<vtkPolyData> FitWhole(const Mesh& mesh, std::string& warnings)
{
  vtkNew<vtkJetFitting> serial;
  const MessageRecorder recorder(serial);
  serial->SetInputData(ToPolyData(mesh));
  serial->Update();
  warnings = Bare(recorder.WarningText());
  return serial->GetOutput();
}

void ExpectTheSameJets(const NamedMesh& named, Partition partition, int pieces)
{
  SCOPED_TRACE(std::string(named.name) + ", partition " +
    std::to_string(static_cast<int>(partition)) + ", pieces: " + std::to_string(pieces));
  std::string warnings;
  const auto expected = FitWhole(named.mesh, warnings);
  vtkNew<PieceSource> source;
  source->SetMesh(named.mesh, partition);
  vtkNew<vtkPJetFitting> jets;
  const MessageRecorder recorder(jets);
  jets->SetInputConnection(source->GetOutputPort());
  for (int piece = 0; piece < pieces; ++piece)
  {
    jets->UpdatePiece(piece, pieces, 0);
    ASSERT_EQ(recorder.ErrorText(), "");
    const PieceOfMesh own = source->Piece(piece, pieces);
    vtkPolyData* actual = jets->GetOutput();
    EXPECT_EQ(actual->GetNumberOfCells(), static_cast<vtkIdType>(own.triangles.size()));
    EXPECT_EQ(FirstOtherRow(expected->GetPointData(), actual->GetPointData(), own.points), "");
    EXPECT_EQ(FirstOtherRow(expected->GetFieldData(), actual->GetFieldData(), { 0 }), "");
  }
  EXPECT_EQ(Bare(recorder.WarningText()), warnings);
  EXPECT_EQ(source->numberOfRequests, 2 * pieces - 1);
}

/// Which point, or triangle, of a mesh is which in the whole that its pieces make.
std::vector<vtkIdType> NamesOf(
  vtkDataArray* numbers, const std::function<vtkIdType(vtkIdType)>& nameOf)
{
  std::vector<vtkIdType> found;
  for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
  {
    const auto number = static_cast<std::size_t>(numbers->GetTuple1(i));
    found.resize(std::max(found.size(), number + 1), -1);
    found[number] = nameOf(i);
  }
  return found;
}

/// Umbilics and ridges; the mesh is the part with what is known of it.
void ExpectTheSameRidges(
  const NamedMesh& named, Partition partition, int pieces,
  const std::function<void(vtkRidgesAndUmbilics*)>& set = [](vtkRidgesAndUmbilics*) {})
{
  SCOPED_TRACE(std::string(named.name) + ", partition " +
    std::to_string(static_cast<int>(partition)) + ", pieces: " + std::to_string(pieces));
  vtkNew<vtkRidgesAndUmbilics> whole;
  const MessageRecorder wholeRecorder(whole);
  set(whole);
  whole->SetInputData(ToPolyData(named.mesh));
  whole->Update();
  vtkNew<PieceSource> source;
  source->SetMesh(named.mesh, partition);
  vtkNew<vtkPRidgesAndUmbilics> streamed;
  const MessageRecorder recorder(streamed);
  set(streamed);
  streamed->SetNumberOfPieces(pieces);
  streamed->SetInputConnection(source->GetOutputPort());
  streamed->Update();
  ASSERT_EQ(recorder.ErrorText(), "");
  EXPECT_EQ(Bare(recorder.WarningText()), Bare(wholeRecorder.WarningText()));
  EXPECT_EQ(source->numberOfRequests, pieces);

  std::map<std::array<double, 3>, std::int32_t> pointAt;
  for (std::size_t p = 0; p < named.mesh.PointCount(); ++p)
  {
    pointAt[{ named.mesh.points[3 * p], named.mesh.points[3 * p + 1],
      named.mesh.points[3 * p + 2] }] = static_cast<std::int32_t>(p);
  }
  std::map<std::array<vtkIdType, 3>, std::int32_t> triangleOf;
  for (std::size_t t = 0; t < named.mesh.TriangleCount(); ++t)
  {
    const auto* corners = named.mesh.triangles.data() + 3 * t;
    triangleOf[{ corners[0], corners[1], corners[2] }] = static_cast<std::int32_t>(t);
  }
  vtkPolyData* part = streamed->GetOutput(vtkRidgesAndUmbilics::MESH);
  std::vector<std::int32_t> points;
  std::vector<std::int32_t> triangles;
  for (vtkIdType p = 0; p < part->GetNumberOfPoints(); ++p)
  {
    std::array<double, 3> x;
    part->GetPoint(p, x.data());
    points.push_back(pointAt.at(x));
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < part->GetNumberOfCells(); ++t)
  {
    part->GetCellPoints(t, corners);
    triangles.push_back(triangleOf.at(
      { points[corners->GetId(0)], points[corners->GetId(1)], points[corners->GetId(2)] }));
  }
  vtkPolyData* mesh = whole->GetOutput(vtkRidgesAndUmbilics::MESH);
  EXPECT_EQ(FirstOtherRow(mesh->GetPointData(), part->GetPointData(), points), "");
  EXPECT_EQ(FirstOtherRow(mesh->GetCellData(), part->GetCellData(), triangles), "");
  const auto pointNames = NamesOf(part->GetPointData()->GetArray(names::GatheredPointId),
    [&points](vtkIdType p) { return points[p]; });
  const auto cellNames = NamesOf(part->GetCellData()->GetArray(names::GatheredCellId),
    [&triangles](vtkIdType t) { return triangles[t]; });
  ExpectTheSameLines(whole->GetOutput(), streamed->GetOutput(), pointNames);
  ExpectTheSameUmbilics(whole->GetOutput(vtkRidgesAndUmbilics::UMBILICS),
    streamed->GetOutput(vtkRidgesAndUmbilics::UMBILICS), cellNames);
  ExpectTheSameTriangles(
    whole->GetOutput()->GetFieldData(), streamed->GetOutput()->GetFieldData(), cellNames);
  ExpectTheSameTriangles(mesh->GetFieldData(), part->GetFieldData(), cellNames);
}

} // namespace

TEST(Streaming, GivesTheRidgesOfTheWholeMesh)
{
  if (!IsAlone())
  {
    return;
  }
  for (const NamedMesh& named : SmallMeshes())
  {
    ExpectTheSameRidges(named, Partition::Blocks, 8);
  }
  const NamedMesh ellipsoid = { "large ellipsoid", EllipsoidMesh(48, 1.0, 0.8, 0.6) };
  ExpectTheSameRidges(ellipsoid, Partition::Blocks, 8);
  ExpectTheSameRidges(ellipsoid, Partition::Blocks, 64);
  ExpectTheSameRidges(SmallMeshes()[4], Partition::Random, 3);
}

// Which is known before any piece is fitted, or after some of them.
TEST(Streaming, GivesTheRidgesOfTheWholeMeshWhereAllOfItIsNeeded)
{
  if (!IsAlone())
  {
    return;
  }
  const auto byMinima = [](vtkRidgesAndUmbilics* filter)
  { filter->SetMethod(vtkUmbilicDetection::MINIMA); };
  const auto withFolds = [](vtkRidgesAndUmbilics* filter) { filter->SetComputeFoldAngle(true); };
  const NamedMesh ellipsoid = { "ellipsoid", EllipsoidMesh(32, 1.0, 0.8, 0.6) };
  ExpectTheSameRidges(ellipsoid, Partition::Blocks, 8, byMinima);
  ExpectTheSameRidges(ellipsoid, Partition::Blocks, 8, withFolds);
  Mesh spiked = AddNormalNoise(ellipsoid.mesh, 0.0005, 3);
  spiked.AddPoint(1.2 * spiked.Point(spiked.triangles[0])); // a fin, of which is warned
  spiked.AddTriangle(
    spiked.triangles[0], spiked.triangles[1], static_cast<std::int32_t>(spiked.PointCount()) - 1);
  ExpectTheSameRidges({ "noisy ellipsoid with a fin", spiked }, Partition::Blocks, 64);
}

TEST(Streaming, GivesTheJetsOfTheWholeMesh)
{
  if (!IsAlone())
  {
    return;
  }
  for (const NamedMesh& named : SmallMeshes())
  {
    ExpectTheSameJets(named, Partition::Blocks, 8);
  }
  const NamedMesh noisy = SmallMeshes()[1];
  ExpectTheSameJets(noisy, Partition::Blocks, 64);
  ExpectTheSameJets(noisy, Partition::Random, 3);
  ExpectTheSameJets(noisy, Partition::Strips, 8);
  ExpectTheSameJets(noisy, Partition::AllOnFirst, 2);
  ExpectTheSameJets(noisy, Partition::LastIsEmpty, 3);
}

// What is behind the filter asks it for the pieces.
TEST(Streaming, WorksInThePipelineOfAnotherFilter)
{
  if (!IsAlone())
  {
    return;
  }
  const Mesh mesh = EllipsoidMesh(8, 1.0, 0.8, 0.6);
  std::string warnings;
  const auto expected = FitWhole(mesh, warnings);
  vtkNew<PieceSource> source;
  source->SetMesh(mesh, Partition::Blocks);
  vtkNew<vtkPJetFitting> jets;
  jets->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkPassThrough> behind;
  behind->SetInputConnection(jets->GetOutputPort());
  for (int piece = 0; piece < 3; ++piece)
  {
    behind->UpdatePiece(piece, 3, 0);
    EXPECT_EQ(FirstOtherRow(expected->GetPointData(),
                vtkPolyData::SafeDownCast(behind->GetOutputDataObject(0))->GetPointData(),
                source->Piece(piece, 3).points),
      "");
  }
  // And ends where one is missing.
  source->missing = 1;
  source->Modified();
  const MessageRecorder recorder(source);
  behind->UpdatePiece(0, 3, 0);
  EXPECT_EQ(recorder.NumberOfErrors(), 1U);
}

// As data that is set as the input: it would be added up.
TEST(Streaming, RefusesTheWholeMeshInEachPiece)
{
  if (!IsAlone())
  {
    return;
  }
  vtkNew<vtkPJetFitting> jets;
  const MessageRecorder recorder(jets);
  jets->SetInputData(ToPolyData(EllipsoidMesh(8, 1.0, 0.8, 0.6)));
  jets->UpdatePiece(1, 3, 0);
  EXPECT_NE(recorder.ErrorText().find("gives the whole mesh each time"), std::string::npos);
  jets->UpdatePiece(0, 1, 0);
  EXPECT_EQ(recorder.NumberOfErrors(), 1U);
  EXPECT_EQ(jets->GetOutput()->GetNumberOfPoints(), 642);
}

// And works again when the pieces do.
TEST(Streaming, NamesThePieceThatCannotBeUsed)
{
  if (!IsAlone())
  {
    return;
  }
  vtkNew<PieceSource> source;
  source->SetMesh(EllipsoidMesh(8, 1.0, 0.8, 0.6), Partition::Blocks);
  vtkNew<vtkPJetFitting> jets;
  vtkNew<vtkPRidgesAndUmbilics> ridges;
  ridges->SetNumberOfPieces(3);
  for (vtkPolyDataAlgorithm* filter :
    { static_cast<vtkPolyDataAlgorithm*>(jets), static_cast<vtkPolyDataAlgorithm*>(ridges) })
  {
    const MessageRecorder recorder(filter);
    filter->SetInputConnection(source->GetOutputPort());
    const auto update = [filter, &jets] { filter->UpdatePiece(0, filter == jets ? 3 : 1, 0); };
    source->spoil = [](vtkPolyData* data, int piece)
    {
      if (piece == 2)
      {
        AddPointArray(data, "Extra", 1, [](vtkIdType, double* values) { values[0] = 1.0; });
      }
    };
    source->Modified();
    update();
    EXPECT_EQ(recorder.NumberOfErrors(), 1U);
    EXPECT_NE(recorder.ErrorText().find("the arrays differ between pieces"), std::string::npos)
      << recorder.ErrorText();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);

    // A piece that is missing is an error of what should make it.
    source->spoil = nullptr;
    source->missing = 1;
    source->Modified();
    const MessageRecorder sourceRecorder(source);
    update();
    EXPECT_EQ(sourceRecorder.NumberOfErrors(), 1U);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);

    source->missing = -1;
    source->Modified();
    update();
    EXPECT_EQ(recorder.NumberOfErrors(), 1U) << recorder.ErrorText();
    EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(Streaming, GivesNothingOfNothing)
{
  if (!IsAlone())
  {
    return;
  }
  vtkNew<PieceSource> source;
  source->SetMesh(Mesh(), Partition::Blocks);
  vtkNew<vtkPRidgesAndUmbilics> ridges;
  const MessageRecorder recorder(ridges);
  ridges->SetNumberOfPieces(3);
  ridges->SetInputConnection(source->GetOutputPort());
  ridges->Update();
  EXPECT_EQ(recorder.ErrorText(), "");
  EXPECT_TRUE(IsEmpty(ridges->GetOutput()));
}
