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
    this->Umbilics->SetInputConnection(this->Jets->GetOutputPort());
    this->Ridges->SetInputConnection(this->Umbilics->GetOutputPort());
    this->Sharpness->SetInputConnection(this->Ridges->GetOutputPort());
  }

  std::string Bytes()
  {
    this->Sharpness->Update();
    return BytesOf(this->Jets->GetOutput()) + BytesOf(this->Umbilics->GetOutput(0)) +
      BytesOf(this->Umbilics->GetOutput(1)) + BytesOf(this->Ridges->GetOutput()) +
      BytesOf(this->Sharpness->GetOutput());
  }

  std::vector<vtkAlgorithm*> Filters() const
  {
    return { this->Jets, this->Umbilics, this->Ridges, this->Sharpness };
  }

  vtkNew<vtkJetFitting> Jets;
  vtkNew<vtkUmbilicDetection> Umbilics;
  vtkNew<vtkRidgeExtraction> Ridges;
  vtkNew<vtkRidgeSharpnessFilter> Sharpness;
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

std::vector<double> ProgressOf(vtkAlgorithm* algorithm)
{
  std::vector<double> reported;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&reported);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      static_cast<std::vector<double>*>(data)->push_back(
        static_cast<vtkAlgorithm*>(caller)->GetProgress());
    });
  const unsigned long tag = algorithm->AddObserver(vtkCommand::ProgressEvent, command);
  algorithm->Modified();
  algorithm->Update();
  algorithm->RemoveObserver(tag);
  return reported;
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
  chain.Jets->SetInputConnection(source->GetOutputPort());
  std::string messages;
  {
    const MessageRecorder jets(chain.Jets);
    const MessageRecorder umbilics(chain.Umbilics);
    const MessageRecorder ridges(chain.Ridges);
    const MessageRecorder sharpness(chain.Sharpness);
    chain.Sharpness->Update();
    for (const MessageRecorder* recorder : { &jets, &umbilics, &ridges, &sharpness })
    {
      messages += recorder->ErrorText() + recorder->WarningText();
    }
  }
  EXPECT_EQ(messages, "");
  EXPECT_EQ(chain.Umbilics->GetOutput(1)->GetNumberOfPoints(), 8);
  EXPECT_GT(chain.Sharpness->GetOutput()->GetNumberOfLines(), 0);
  EXPECT_LE(chain.Sharpness->GetOutput()->GetNumberOfLines(),
    chain.Ridges->GetOutput()->GetNumberOfLines());
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
      chain.Jets->SetInputData(mesh);
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
  first.Jets->SetInputData(mesh);
  Chain second;
  second.Jets->SetInputData(mesh);
  const std::string bytes = first.Bytes();
  EXPECT_TRUE(bytes == second.Bytes());
  first.Jets->Modified();
  EXPECT_TRUE(bytes == first.Bytes());
}

TEST(Pipeline, ExecutesAgainAfterAnyPropertyChangeAsIfNew)
{
  const auto mesh = BlendData(24);
  Chain changed;
  changed.Jets->SetInputData(mesh);
  changed.Bytes();
  const auto setAll = [](Chain& chain)
  {
    chain.Jets->SetMinimumNumberOfPoints(30);
    chain.Umbilics->SetPatchSize(3.0);
    chain.Ridges->ExtractMinimumOff();
    chain.Ridges->SetTypeRuleToThirdOrder();
    chain.Sharpness->SetMinimumSharpness(10.0);
  };
  setAll(changed);
  Chain fresh;
  fresh.Jets->SetInputData(mesh);
  setAll(fresh);
  EXPECT_TRUE(changed.Bytes() == fresh.Bytes());

  // And back to fewer arrays, of which none may be left over.
  changed.Ridges->ExtractMinimumOn();
  changed.Sharpness->SetMinimumSharpness(0.0);
  changed.Jets->SetMongeOrder(3);
  changed.Sharpness->Update();
  EXPECT_FALSE(changed.Jets->GetOutput()->GetPointData()->HasArray(names::P1));
  EXPECT_EQ(changed.Ridges->GetOutput()->GetPointData()->GetNumberOfArrays(), 6);
}

TEST(Pipeline, TakesAnotherInputAsIfNew)
{
  Chain changed;
  changed.Jets->SetInputData(BlendData(24));
  changed.Bytes();
  const auto mesh = EllipsoidData(12);
  changed.Jets->SetInputData(mesh);
  Chain fresh;
  fresh.Jets->SetInputData(mesh);
  EXPECT_TRUE(changed.Bytes() == fresh.Bytes());
}

TEST(Pipeline, ProgressRisesToTheEnd)
{
  const auto mesh = BlendData(63);
  Chain chain;
  chain.Jets->SetInputData(mesh);
  chain.Sharpness->Update();
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
  EXPECT_GT(ProgressOf(chain.Jets).size(), 3u) << "nothing between the beginning and the end";
}

TEST(Pipeline, AbortLeavesEmptyOutputAndTheNextRunIsWhole)
{
  const auto mesh = BlendData(63);
  Chain chain;
  chain.Jets->SetInputData(mesh);
  const std::string whole = chain.Bytes();
  for (vtkPolyDataAlgorithm* filter : { static_cast<vtkPolyDataAlgorithm*>(chain.Jets),
         static_cast<vtkPolyDataAlgorithm*>(chain.Umbilics),
         static_cast<vtkPolyDataAlgorithm*>(chain.Ridges) })
  {
    AbortAtOnce(filter);
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      EXPECT_TRUE(IsEmpty(filter->GetOutput(port))) << filter->GetClassName() << " " << port;
    }
    filter->Modified();
    EXPECT_TRUE(chain.Bytes() == whole) << filter->GetClassName();
  }
}

TEST(Pipeline, AbortedFitLetsTheRestRunOnNothing)
{
  Chain chain;
  chain.Jets->SetInputData(BlendData(63));
  AbortAtOnce(chain.Jets);
  const MessageRecorder recorder(chain.Umbilics);
  chain.Sharpness->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 0u) << recorder.ErrorText();
  EXPECT_TRUE(IsEmpty(chain.Sharpness->GetOutput()));
}
