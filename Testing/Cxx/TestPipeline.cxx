// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The filters one after the other in a pipeline: threads, execution again, progress and abort.

#include "FilterTestTools.h"
#include "MessageRecorder.h"

#include "vtkCallbackCommand.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgeExampleSource.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgeSharpnessFilter.h"
#include "vtkRidgesArrayNames.h"
#include "vtkSMPTools.h"
#include "vtkUmbilicDetection.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

/// Default ports, default properties.
struct Chain
{
  Chain()
  {
    this->umbilics->SetInputConnection(this->jets->GetOutputPort());
    this->ridges->SetInputConnection(this->umbilics->GetOutputPort());
    this->sharpness->SetInputConnection(this->ridges->GetOutputPort());
  }

  std::string Bytes()
  {
    this->sharpness->Update();
    return BytesOf(this->jets->GetOutput()) + BytesOf(this->umbilics->GetOutput(0)) +
      BytesOf(this->umbilics->GetOutput(1)) + BytesOf(this->ridges->GetOutput()) +
      BytesOf(this->sharpness->GetOutput());
  }

  std::vector<vtkAlgorithm*> Filters() const
  {
    return { this->jets, this->umbilics, this->ridges, this->sharpness };
  }

  vtkNew<vtkJetFitting> jets;
  vtkNew<vtkUmbilicDetection> umbilics;
  vtkNew<vtkRidgeExtraction> ridges;
  vtkNew<vtkRidgeSharpnessFilter> sharpness;
};

/// The SMP backend and number of threads as they were, again.
class BackendRestorer
{
public:
  BackendRestorer()
    : Backend(vtkSMPTools::GetBackend())
  {
  }
  ~BackendRestorer()
  {
    vtkSMPTools::SetBackend(this->Backend.c_str());
    vtkSMPTools::Initialize(0);
  }
  BackendRestorer(const BackendRestorer&) = delete;
  BackendRestorer& operator=(const BackendRestorer&) = delete;

private:
  std::string Backend;
};

/// What an algorithm reports; aborted at an event, if wanted.
std::vector<double> ProgressOf(vtkAlgorithm* algorithm, std::size_t abortAt = 1000000)
{
  struct Record
  {
    std::vector<double> reported;
    std::size_t abortAt;
  } record{ {}, abortAt };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&record);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* seen = static_cast<Record*>(data);
      auto* reporting = static_cast<vtkAlgorithm*>(caller);
      if (seen->reported.size() == seen->abortAt)
      {
        reporting->SetAbortExecute(1);
      }
      seen->reported.push_back(reporting->GetProgress());
    });
  const unsigned long tag = algorithm->AddObserver(vtkCommand::ProgressEvent, command);
  algorithm->Modified();
  algorithm->Update();
  algorithm->RemoveObserver(tag);
  return record.reported;
}

/// Aborts the algorithm at its first progress event.
void AbortAtOnce(vtkAlgorithm* algorithm)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const unsigned long tag = algorithm->AddObserver(vtkCommand::ProgressEvent, command);
  algorithm->Modified();
  algorithm->Update();
  algorithm->RemoveObserver(tag);
}

} // namespace

TEST(Pipeline, RunsWithDefaultPortsAndProperties)
{
  vtkNew<vtkRidgeExampleSource> source;
  Chain chain;
  chain.jets->SetInputConnection(source->GetOutputPort());
  std::string messages;
  {
    const MessageRecorder jets(chain.jets);
    const MessageRecorder umbilics(chain.umbilics);
    const MessageRecorder ridges(chain.ridges);
    const MessageRecorder sharpness(chain.sharpness);
    chain.sharpness->Update();
    for (const MessageRecorder* recorder : { &jets, &umbilics, &ridges, &sharpness })
    {
      messages += recorder->ErrorText() + recorder->WarningText();
    }
  }
  EXPECT_EQ(messages, "");
  EXPECT_EQ(chain.umbilics->GetOutput(1)->GetNumberOfPoints(), 8);
  EXPECT_GT(chain.sharpness->GetOutput()->GetNumberOfLines(), 0);
  EXPECT_LE(chain.sharpness->GetOutput()->GetNumberOfLines(),
    chain.ridges->GetOutput()->GetNumberOfLines());
}

// More than one batch of 32,768 points, more than two of triangles.
TEST(Pipeline, GivesTheSameBytesWithAnyBackendAndNumberOfThreads)
{
  const BackendRestorer restorer;
  const auto mesh = BlendData(63);
  std::string expected;
  int runs = 0;
  for (const char* backend : { "Sequential", "STDThread", "TBB" })
  {
    if (!vtkSMPTools::SetBackend(backend))
    {
      continue;
    }
    for (const int threads : { 1, 2 })
    {
      vtkSMPTools::Initialize(threads);
      Chain chain;
      chain.jets->SetInputData(mesh);
      const std::string bytes = chain.Bytes();
      expected = runs == 0 ? bytes : expected;
      EXPECT_TRUE(bytes == expected) << backend << " with " << threads;
      ++runs;
    }
  }
  EXPECT_GE(runs, 4); // VTK always has Sequential and STDThread
}

TEST(Pipeline, GivesTheSameBytesEveryTime)
{
  const auto mesh = EllipsoidData(16);
  Chain first;
  first.jets->SetInputData(mesh);
  Chain second;
  second.jets->SetInputData(mesh);
  const std::string bytes = first.Bytes();
  EXPECT_TRUE(bytes == second.Bytes());
  first.jets->Modified();
  EXPECT_TRUE(bytes == first.Bytes());
}

TEST(Pipeline, ChangedPropertyGivesTheSameAsANewPipeline)
{
  const auto mesh = BlendData(24);
  Chain changed;
  changed.jets->SetInputData(mesh);
  changed.Bytes();
  const auto setAll = [](Chain& chain)
  {
    chain.jets->SetMinimumNumberOfPoints(30);
    chain.umbilics->SetPatchSize(3.0);
    chain.ridges->ExtractMinimumOff();
    chain.ridges->SetTypeRuleToThirdOrder();
    chain.sharpness->SetMinimumSharpness(10.0);
  };
  setAll(changed);
  Chain fresh;
  fresh.jets->SetInputData(mesh);
  setAll(fresh);
  EXPECT_TRUE(changed.Bytes() == fresh.Bytes());

  // And back to fewer arrays, of which none may be left over.
  changed.ridges->ExtractMinimumOn();
  changed.sharpness->SetMinimumSharpness(0.0);
  changed.jets->SetMongeOrder(3);
  changed.sharpness->Update();
  EXPECT_FALSE(changed.jets->GetOutput()->GetPointData()->HasArray(names::P1));
  EXPECT_EQ(changed.ridges->GetOutput()->GetPointData()->GetNumberOfArrays(), 6);
}

TEST(Pipeline, AnotherInputGivesTheSameAsANewPipeline)
{
  Chain changed;
  changed.jets->SetInputData(BlendData(24));
  changed.Bytes();
  const auto mesh = EllipsoidData(12);
  changed.jets->SetInputData(mesh);
  Chain fresh;
  fresh.jets->SetInputData(mesh);
  EXPECT_TRUE(changed.Bytes() == fresh.Bytes());
}

TEST(Pipeline, ProgressRisesToTheEnd)
{
  const auto mesh = BlendData(63);
  Chain chain;
  chain.jets->SetInputData(mesh);
  chain.sharpness->Update();
  for (vtkAlgorithm* filter : chain.Filters())
  {
    const std::vector<double> reported = ProgressOf(filter);
    ASSERT_FALSE(reported.empty()) << filter->GetClassName();
    for (std::size_t i = 0; i < reported.size(); ++i)
    {
      EXPECT_GE(reported[i], i == 0 ? 0.0 : reported[i - 1]) << filter->GetClassName();
      EXPECT_LE(reported[i], 1.0) << filter->GetClassName();
    }
    EXPECT_EQ(reported.back(), 1.0) << filter->GetClassName();
  }
  EXPECT_GT(ProgressOf(chain.jets).size(), 3u) << "nothing between the beginning and the end";
}

TEST(Pipeline, AbortGivesEmptyOutputAndTheNextRunIsComplete)
{
  const auto mesh = BlendData(63);
  Chain chain;
  chain.jets->SetInputData(mesh);
  const std::string whole = chain.Bytes();
  for (vtkPolyDataAlgorithm* filter : { static_cast<vtkPolyDataAlgorithm*>(chain.jets),
         static_cast<vtkPolyDataAlgorithm*>(chain.umbilics),
         static_cast<vtkPolyDataAlgorithm*>(chain.ridges) })
  {
    AbortAtOnce(filter);
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      EXPECT_TRUE(IsEmpty(filter->GetOutput(port))) << filter->GetClassName() << " " << port;
    }
    filter->SetAbortExecute(0); // VTK after 9.1 leaves it to those who have set it
    filter->Modified();
    EXPECT_TRUE(chain.Bytes() == whole) << filter->GetClassName();
  }
}

// Noise: there are pairs to cancel, many umbilics and many ridges.
TEST(Pipeline, AbortAtAnyProgressStopsAtOnceAndGivesEmptyOutput)
{
  const auto mesh = ToPolyData(AddNormalNoise(EllipsoidMesh(24, 1.0, 0.8, 0.6), 0.01, 3));
  Chain chain;
  chain.jets->SetInputData(mesh);
  chain.sharpness->Update();
  vtkNew<vtkUmbilicDetection> minima;
  minima->SetMethodToMinima();
  minima->SetInputConnection(chain.jets->GetOutputPort());
  for (vtkPolyDataAlgorithm* filter :
    std::array<vtkPolyDataAlgorithm*, 4>{ chain.jets, chain.umbilics, minima, chain.ridges })
  {
    const std::vector<double> whole = ProgressOf(filter);
    // The first event and the last are those of the pipeline, before and after the filter.
    ASSERT_GT(whole.size(), 3u) << filter->GetClassName();
    for (std::size_t i = 1; i + 1 < whole.size(); ++i)
    {
      const std::vector<double> reported = ProgressOf(filter, i);
      // One more than those may be on its way.
      EXPECT_LE(reported.size(), i + 3) << filter->GetClassName() << " at " << whole[i];
      for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
      {
        EXPECT_TRUE(IsEmpty(filter->GetOutput(port))) << filter->GetClassName() << " " << whole[i];
      }
      filter->SetAbortExecute(0);
    }
    filter->Modified();
    filter->Update();
    EXPECT_FALSE(IsEmpty(filter->GetOutput()));
  }
}

TEST(Pipeline, AbortedFitGivesEmptyOutputDownstream)
{
  Chain chain;
  chain.jets->SetInputData(BlendData(63));
  AbortAtOnce(chain.jets);
  const MessageRecorder recorder(chain.umbilics);
  chain.sharpness->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 0u) << recorder.ErrorText();
  EXPECT_TRUE(IsEmpty(chain.sharpness->GetOutput()));
}
