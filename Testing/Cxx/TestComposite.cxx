// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Composite data sets: each block gets what it would get alone.

#include "FilterTestTools.h"
#include "MessageRecorder.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkJetFitting.h"
#include "vtkMongeSmoothing.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPrincipalFoliation.h"
#include "vtkRidgeCoherence.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgeSharpnessFilter.h"
#include "vtkRidgesAndUmbilics.h"
#include "vtkSalientRidges.h"
#include "vtkTable.h"
#include "vtkUmbilicDetection.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

using namespace ridges::testing;

namespace
{

/// A mesh, a hole, and another mesh one level below.
vtkSmartPointer<vtkMultiBlockDataSet> TwoMeshes()
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, EllipsoidData(8));
  blocks->SetBlock(1, nullptr);
  vtkNew<vtkMultiBlockDataSet> nested;
  nested->SetBlock(0, BlendData(12));
  blocks->SetBlock(2, nested);
  return blocks;
}

/// The mesh's place in an output that corresponds to TwoMeshes().
vtkPolyData* BlockOf(vtkAlgorithm* filter, int port, bool nested)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(port));
  if (blocks && nested)
  {
    blocks = vtkMultiBlockDataSet::SafeDownCast(blocks->GetBlock(2));
  }
  return blocks ? vtkPolyData::SafeDownCast(blocks->GetBlock(0)) : nullptr;
}

struct Chain
{
  explicit Chain(vtkDataObject* input)
  {
    this->jets->SetInputDataObject(input);
    this->umbilics->SetInputConnection(this->jets->GetOutputPort());
    this->ridges->SetInputConnection(this->umbilics->GetOutputPort());
    this->selection->SetInputConnection(this->ridges->GetOutputPort());
    this->foliation->SetInputConnection(this->umbilics->GetOutputPort());
    this->foliation->SetSeparation(0.3);
    this->all->SetInputDataObject(input);
    this->smoothing->SetInputConnection(this->jets->GetOutputPort());
    this->salient->SetInputDataObject(input);
    this->selection->Update();
    this->foliation->Update();
    this->all->Update();
    this->smoothing->Update();
    this->salient->Update();
  }

  std::vector<vtkAlgorithm*> Filters() const
  {
    return { this->jets, this->umbilics, this->ridges, this->selection, this->foliation, this->all,
      this->smoothing, this->salient };
  }

  vtkNew<vtkJetFitting> jets;
  vtkNew<vtkUmbilicDetection> umbilics;
  vtkNew<vtkRidgeExtraction> ridges;
  vtkNew<vtkRidgeSharpnessFilter> selection;
  vtkNew<vtkPrincipalFoliation> foliation;
  vtkNew<vtkRidgesAndUmbilics> all;
  vtkNew<vtkMongeSmoothing> smoothing;
  vtkNew<vtkSalientRidges> salient;
};

} // namespace

TEST(Composite, EachBlockGetsWhatItGetsAlone)
{
  const Chain composite(TwoMeshes());
  const Chain alone[] = { Chain(EllipsoidData(8)), Chain(BlendData(12)) };
  for (std::size_t i = 0; i < composite.Filters().size(); ++i)
  {
    vtkAlgorithm* filter = composite.Filters()[i];
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      for (const bool nested : { false, true })
      {
        auto* expected =
          vtkPolyData::SafeDownCast(alone[nested ? 1 : 0].Filters()[i]->GetOutputDataObject(port));
        vtkPolyData* actual = BlockOf(filter, port, nested);
        ASSERT_NE(actual, nullptr) << filter->GetClassName() << " " << port;
        EXPECT_EQ(FirstDifference(actual, expected), "") << filter->GetClassName() << " " << port;
      }
    }
  }
}

TEST(Composite, PartitionsAreTaken)
{
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, EllipsoidData(6));
  partitions->SetPartition(1, EllipsoidData(8));
  vtkNew<vtkRidgesAndUmbilics> filter;
  filter->SetInputDataObject(partitions);
  filter->Update();
  vtkNew<vtkRidgesAndUmbilics> alone;
  alone->SetInputData(EllipsoidData(8));
  alone->Update();
  auto* output = vtkPartitionedDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  ASSERT_EQ(output->GetNumberOfPartitions(), 2u);
  EXPECT_EQ(FirstDifference(
              vtkPolyData::SafeDownCast(output->GetPartitionAsDataObject(1)), alone->GetOutput()),
    "");
}

// VTK runs a filter on every block, whatever it is.
TEST(Composite, BlocksOfAnotherTypeAreErrorsAndTheOthersAreDone)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  const auto addImage = [&image](vtkDataObject* input)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, input);
    blocks->SetBlock(1, image);
    return vtkSmartPointer<vtkMultiBlockDataSet>(blocks);
  };
  const Chain alone(EllipsoidData(8));
  const auto expectError = [&addImage](vtkAlgorithm* filter, vtkDataObject* input)
  {
    const MessageRecorder recorder(filter);
    filter->SetInputDataObject(addImage(input));
    filter->Update();
    EXPECT_EQ(recorder.NumberOfErrors(), 1u) << filter->GetClassName();
    EXPECT_NE(
      recorder.ErrorText().find("A block of the input is a vtkImageData"), std::string::npos)
      << recorder.ErrorText();
    vtkPolyData* done = BlockOf(filter, 0, false);
    EXPECT_TRUE(done && done->GetNumberOfPoints() > 0) << filter->GetClassName();
  };
  vtkNew<vtkJetFitting> jets;
  vtkNew<vtkUmbilicDetection> umbilics;
  vtkNew<vtkRidgeExtraction> ridges;
  vtkNew<vtkRidgeSharpnessFilter> selection;
  vtkNew<vtkPrincipalFoliation> foliation;
  vtkNew<vtkRidgesAndUmbilics> all;
  vtkNew<vtkMongeSmoothing> smoothing;
  vtkNew<vtkSalientRidges> salient;
  expectError(jets, EllipsoidData(8));
  expectError(umbilics, alone.jets->GetOutput());
  expectError(ridges, alone.umbilics->GetOutput());
  expectError(selection, alone.ridges->GetOutput());
  expectError(foliation, alone.umbilics->GetOutput());
  expectError(all, EllipsoidData(8));
  expectError(smoothing, alone.jets->GetOutput());
  expectError(salient, EllipsoidData(8));
}

TEST(Composite, CoherenceIsATablePerBlock)
{
  const Chain composite(TwoMeshes());
  vtkNew<vtkRidgeCoherence> coherence;
  const auto connect = [&coherence](const Chain& chain)
  {
    coherence->SetInputConnection(0, chain.umbilics->GetOutputPort(0));
    coherence->SetInputConnection(1, chain.ridges->GetOutputPort());
    coherence->SetInputConnection(2, chain.umbilics->GetOutputPort(1));
    coherence->Update();
  };
  const auto rowsOf = [](vtkDataObject* object)
  {
    std::string rows;
    auto* table = vtkTable::SafeDownCast(object);
    for (vtkIdType i = 0; table && i < table->GetNumberOfRows(); ++i)
    {
      for (vtkIdType j = 0; j < table->GetNumberOfColumns(); ++j)
      {
        rows += table->GetValue(i, j).ToString() + "|";
      }
    }
    return rows;
  };
  // From tables to blocks of them and back again.
  connect(Chain(EllipsoidData(8)));
  const std::string ofEllipsoid = rowsOf(coherence->GetOutput());
  EXPECT_NE(ofEllipsoid, "");
  connect(composite);
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(coherence->GetOutputDataObject(0));
  ASSERT_NE(blocks, nullptr);
  ASSERT_EQ(blocks->GetNumberOfBlocks(), 3u);
  EXPECT_EQ(rowsOf(blocks->GetBlock(0)), ofEllipsoid);
  EXPECT_EQ(blocks->GetBlock(1), nullptr);
  auto* nested = vtkMultiBlockDataSet::SafeDownCast(blocks->GetBlock(2));
  ASSERT_NE(nested, nullptr);
  const std::string ofBlend = rowsOf(nested->GetBlock(0));
  connect(Chain(BlendData(12)));
  EXPECT_EQ(rowsOf(coherence->GetOutput()), ofBlend);
}

TEST(Composite, CoherenceNamesTheBlockAtFault)
{
  const Chain composite(TwoMeshes());
  vtkNew<vtkRidgeCoherence> coherence;
  const MessageRecorder recorder(coherence);
  coherence->SetInputConnection(0, composite.umbilics->GetOutputPort(0));
  coherence->SetInputData(1, composite.all->GetOutputDataObject(0));
  BlockOf(composite.all, 0, true)->GetCellData()->RemoveArray("RidgeId");
  coherence->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 1u);
  EXPECT_NE(recorder.ErrorText().find("block 4: "), std::string::npos) << recorder.ErrorText();
  EXPECT_NE(recorder.ErrorText().find("RidgeId"), std::string::npos) << recorder.ErrorText();

  coherence->SetInputData(1, EllipsoidData(4));
  coherence->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 2u);
  EXPECT_NE(recorder.ErrorText().find("the mesh is a composite data set, but the ridges"),
    std::string::npos)
    << recorder.ErrorText();
}
