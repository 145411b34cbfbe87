// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// How soon each filter ends that is aborted, and whether its progress only rises, on an ellipsoid
// of 10 FREQUENCY^2 + 2 points with noise of 0.01 edges; see abort.sh.
//
//   RidgesAbort FREQUENCY [--check | CLASS]
//
// The filters of all classes are tried, or those of one. Each runs once to its end. Then an abort
// is asked for at the beginning of the longest time without an event of progress, and after half of
// the time; the filter learns of it at its next event, as from an observer. With --check, the test,
// at more moments and without times. The exit code is 0 if progress never fell, aborted filters
// left their outputs empty, and another run gives the same again. Seconds are of the processor:
// with one thread, those of a machine that does nothing else.

#include "FilterTestTools.h"
#include "ImageSamples.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCertifiedRidges.h"
#include "vtkCompliantRefinement.h"
#include "vtkImageMongeForm.h"
#include "vtkImageSurfaceMesh.h"
#include "vtkImplicitMongeForm.h"
#include "vtkImplicitSurfaceMesh.h"
#include "vtkJetFitting.h"
#include "vtkMongeSmoothing.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPrincipalFoliation.h"
#include "vtkRidgeCoherence.h"
#include "vtkRidgeExampleSource.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgeSharpnessFilter.h"
#include "vtkRidgesAndUmbilics.h"
#include "vtkSalientRidges.h"
#include "vtkSmartPointer.h"
#include "vtkUmbilicDetection.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

using namespace ridges::testing;

namespace
{

constexpr const char* Formula = "x^2/1.96 + y^2 + z^2/0.36 - 1";

//------------------------------------------------------------------------------
double SecondsSince(std::clock_t begin)
{
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

//------------------------------------------------------------------------------
struct Event
{
  double progress;
  double time; // since the beginning, in seconds
};

//------------------------------------------------------------------------------
struct Observed
{
  std::vector<Event> events;
  double seconds = 0.0;       // until the update returned
  double abortProgress = 2.0; // from which on an abort is asked for
  double askedAt = -1.0;      // seconds
  std::clock_t begin = std::clock();
};

//------------------------------------------------------------------------------
void Watch(vtkObject* caller, unsigned long, void* data, void*)
{
  auto* algorithm = static_cast<vtkAlgorithm*>(caller);
  auto* seen = static_cast<Observed*>(data);
  const double time = SecondsSince(seen->begin);
  if (seen->askedAt >= 0.0)
  {
    algorithm->SetAbortExecute(1);
  }
  else if (algorithm->GetProgress() >= seen->abortProgress)
  {
    seen->askedAt = time;
  }
  seen->events.push_back({ algorithm->GetProgress(), time });
}

//------------------------------------------------------------------------------
Observed Update(vtkAlgorithm* algorithm, double abortProgress)
{
  Observed seen;
  seen.abortProgress = abortProgress;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&seen);
  command->SetCallback(Watch);
  const unsigned long tag = algorithm->AddObserver(vtkCommand::ProgressEvent, command);
  algorithm->Modified();
  seen.begin = std::clock();
  algorithm->Update();
  seen.seconds = SecondsSince(seen.begin);
  algorithm->RemoveObserver(tag);
  algorithm->SetAbortExecute(0);
  return seen;
}

//------------------------------------------------------------------------------
// Of all outputs together.
vtkIdType NumberOfElements(vtkAlgorithm* algorithm)
{
  vtkIdType sum = 0;
  for (int port = 0; port < algorithm->GetNumberOfOutputPorts(); ++port)
  {
    for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::ROW })
    {
      sum += algorithm->GetOutputDataObject(port)->GetNumberOfElements(kind);
    }
  }
  return sum;
}

//------------------------------------------------------------------------------
bool NeverFalls(const std::vector<Event>& events)
{
  const bool isSorted = std::is_sorted(events.begin(), events.end(),
    [](const Event& a, const Event& b) { return a.progress < b.progress; });
  return isSorted && !events.empty() && events.front().progress >= 0.0 &&
    events.back().progress == 1.0;
}

//------------------------------------------------------------------------------
struct Gap
{
  double progress = 0.0; // at its beginning
  double seconds = 0.0;
};

//------------------------------------------------------------------------------
Gap LongestGap(const Observed& seen)
{
  Gap longest;
  for (std::size_t i = 0; i + 1 < seen.events.size(); ++i)
  {
    const double seconds = seen.events[i + 1].time - seen.events[i].time;
    if (seconds > longest.seconds)
    {
      longest = { seen.events[i].progress, seconds };
    }
  }
  return longest;
}

//------------------------------------------------------------------------------
class Trials
{
public:
  Trials(bool check, std::string only)
    : IsCheck(check)
    , Only(std::move(only))
  {
    if (!check)
    {
      std::printf("| filter | points | whole run, s | longest time without progress, s | "
                  "ends after an abort within, s | progress |\n"
                  "|--------|-------:|-------------:|---------------------------------:|"
                  "------------------------------:|----------|\n");
    }
  }

  template <typename Filter>
  void Try(Filter* filter, vtkIdType points)
  {
    if (!this->Only.empty() && this->Only != filter->GetClassName())
    {
      return;
    }
    const Observed whole = Update(filter, 2.0);
    const vtkIdType elements = NumberOfElements(filter);
    const Gap gap = LongestGap(whole);
    std::string fault = NeverFalls(whole.events) ? "" : ", falls";
    fault += elements > 0 ? "" : ", no output";
    std::vector<double> moments{ gap.progress, ProgressAt(whole, 0.5) };
    if (this->IsCheck)
    {
      moments.insert(moments.end(), { 0.0, ProgressAt(whole, 0.1), ProgressAt(whole, 0.9) });
    }
    double latest = 0.0;
    for (const double moment : moments)
    {
      const Observed aborted = Update(filter, moment);
      // The last event is that of the pipeline, after the filter.
      const bool wasInTime = aborted.askedAt >= 0.0 && aborted.events.back().progress < 1.0;
      latest = std::max(latest, aborted.seconds - std::max(0.0, aborted.askedAt));
      fault += wasInTime && NumberOfElements(filter) > 0 ? ", output in spite of an abort" : "";
    }
    if (this->IsCheck)
    {
      Update(filter, 2.0);
      fault += NumberOfElements(filter) == elements ? "" : ", another output afterwards";
    }
    this->hasFault = this->hasFault || !fault.empty();
    const std::string text = fault.empty() ? "only rises" : fault.substr(2);
    if (this->IsCheck)
    {
      std::printf("%s: %s\n", filter->GetClassName(), text.c_str());
    }
    else
    {
      std::printf("| `%s` | %lld | %.1f | %.2f | %.2f | %s |\n", filter->GetClassName(),
        static_cast<long long>(points), whole.seconds, gap.seconds, latest, text.c_str());
    }
    std::fflush(stdout);
  }

  bool hasFault = false;

private:
  // The first at or after a share of the whole time.
  static double ProgressAt(const Observed& seen, double share)
  {
    const auto found = std::find_if(seen.events.begin(), seen.events.end(),
      [&seen, share](const Event& event) { return event.time >= share * seen.seconds; });
    return found == seen.events.end() ? 0.0 : found->progress;
  }

  bool IsCheck;
  std::string Only; ///< Empty: all.
};

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeImage(int size)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, size);
  image->SetOrigin(-1.6, -1.6, -1.6);
  image->SetSpacing(3.2 / (size - 1), 3.2 / (size - 1), 3.2 / (size - 1));
  Sample(
    image, [](double x, double y, double z) { return x * x / 1.96 + y * y + z * z / 0.36 - 1.0; });
  return image;
}

//------------------------------------------------------------------------------
void TryStages(Trials& trials, vtkPolyData* mesh)
{
  const vtkIdType points = mesh->GetNumberOfPoints();
  vtkNew<vtkJetFitting> jets;
  jets->SetInputData(mesh);
  trials.Try(jets.Get(), points);
  jets->Update();
  const vtkSmartPointer<vtkPolyData> fitted = jets->GetOutput();
  {
    vtkNew<vtkMongeSmoothing> smoothing;
    smoothing->SetInputData(fitted);
    trials.Try(smoothing.Get(), points);
  }
  {
    vtkNew<vtkPrincipalFoliation> foliation;
    foliation->SetInputData(fitted);
    trials.Try(foliation.Get(), points);
  }
  vtkNew<vtkUmbilicDetection> umbilics;
  umbilics->SetInputData(fitted);
  trials.Try(umbilics.Get(), points);
  vtkNew<vtkRidgeExtraction> ridges;
  ridges->SetInputConnection(umbilics->GetOutputPort());
  umbilics->Update();
  trials.Try(ridges.Get(), points);
  ridges->Update();
  vtkNew<vtkRidgeSharpnessFilter> sharpness;
  sharpness->SetInputConnection(ridges->GetOutputPort());
  trials.Try(sharpness.Get(), points);
  vtkNew<vtkRidgeCoherence> coherence;
  coherence->SetInputConnection(0, ridges->GetOutputPort(2));
  coherence->SetInputConnection(1, ridges->GetOutputPort());
  coherence->SetInputConnection(2, umbilics->GetOutputPort(1));
  trials.Try(coherence.Get(), points);
}

//------------------------------------------------------------------------------
void TryAllInOne(Trials& trials, vtkPolyData* mesh)
{
  vtkNew<vtkRidgesAndUmbilics> all;
  all->SetInputData(mesh);
  trials.Try(all.Get(), mesh->GetNumberOfPoints());
  vtkNew<vtkSalientRidges> salient;
  salient->SetInputData(mesh);
  trials.Try(salient.Get(), mesh->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
void TryExact(Trials& trials, vtkPolyData* mesh, int frequency)
{
  const vtkIdType points = mesh->GetNumberOfPoints();
  {
    vtkNew<vtkImplicitMongeForm> exact;
    exact->SetFormula(Formula);
    exact->SetInputData(mesh);
    trials.Try(exact.Get(), points);
  }
  const auto image = MakeImage(std::min(std::max(32, frequency), 256));
  {
    vtkNew<vtkImageMongeForm> forms;
    forms->SetInputData(0, mesh);
    forms->SetInputData(1, image);
    trials.Try(forms.Get(), points);
  }
  {
    vtkNew<vtkImageSurfaceMesh> surface;
    surface->SetInputData(image);
    surface->Update();
    trials.Try(surface.Get(), surface->GetOutput()->GetNumberOfPoints());
  }
  vtkNew<vtkImplicitSurfaceMesh> surface;
  surface->SetFormula(Formula);
  surface->SetBounds(-1.5, 1.5, -1.1, 1.1, -0.7, 0.7);
  // Of 300,000 points at most: the grid grows with the third power.
  surface->SetEdgeLength(1.15 / std::min(frequency, 170));
  surface->Update();
  trials.Try(surface.Get(), surface->GetOutput()->GetNumberOfPoints());
  vtkNew<vtkRidgeExampleSource> source;
  source->SetFrequency(frequency);
  trials.Try(source.Get(), points);
}

//------------------------------------------------------------------------------
// They refine a mesh of 642 points up to a number of points.
template <typename Filter>
void TryCertificate(Trials& trials, vtkIdType points)
{
  vtkNew<Filter> filter;
  filter->SetFormula(Formula);
  filter->SetMaximumNumberOfPoints(points);
  filter->SetInputData(ToPolyData(ToMesh(EllipsoidData(8))));
  trials.Try(filter.Get(), points);
}

} // namespace

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const int frequency = argc > 1 ? std::atoi(argv[1]) : 0;
  const bool isCheck = argc > 2 && argv[2] == std::string("--check");
  if (frequency < 4 || frequency > 2000 || argc > 3)
  {
    std::fprintf(stderr, "%s FREQUENCY [--check | CLASS], 4 to 2000\n", argv[0]);
    return 2;
  }
  const Mesh even = ToMesh(EllipsoidData(frequency));
  const auto mesh = ToPolyData(AddNormalNoise(even, 0.01 * MeanEdgeLength(even), 1));
  Trials trials(isCheck, argc > 2 && !isCheck ? argv[2] : "");
  TryStages(trials, mesh);
  TryAllInOne(trials, mesh);
  TryExact(trials, mesh, frequency);
  if (!isCheck) // proofs take seconds
  {
    TryCertificate<vtkCompliantRefinement>(trials, 20000);
    TryCertificate<vtkCertifiedRidges>(trials, 20000);
  }
  return trials.hasFault ? 1 : 0;
}
