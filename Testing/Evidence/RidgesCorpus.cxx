// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// One file through all filters with their default properties, for corpus.py:
//
//   RidgesCorpus FILE
//
// Reads and repairs the file as the program does, finds its ridges, umbilics and salient lines, and
// checks them. Prints lines of a name, a tab and a value. The exit code is 0 if the file is refused
// with a reason, or if nothing is wrong with the output.

#include "ClosedManifold.h"
#include "Console.h"
#include "FilterTestTools.h"
#include "MessageRecorder.h"
#include "NotFinite.h"
#include "Reading/MeshReader.h"
#include "Repair/RepairMesh.h"

#include "vtkFieldData.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgeCoherence.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgeSharpnessFilter.h"
#include "vtkRidgesArrayNames.h"
#include "vtkSalientRidges.h"
#include "vtkTable.h"
#include "vtkUmbilicDetection.h"
#include "vtkVariant.h"

#include <array>
#include <cstdio>
#include <string>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

//------------------------------------------------------------------------------
void Print(const char* name, const std::string& text)
{
  std::string line = text;
  for (char& c : line)
  {
    c = c == '\n' || c == '\t' ? ' ' : c;
  }
  std::printf("%s\t%s\n", name, line.c_str());
}

//------------------------------------------------------------------------------
void Print(const char* name, vtkIdType count)
{
  Print(name, std::to_string(count));
}

//------------------------------------------------------------------------------
// Points with each bit of FitStatus.
void PrintFlags(vtkPolyData* fitted)
{
  const struct
  {
    const char* name;
    int bit;
  } flags[] = { { "border", vtkJetFitting::FIT_BOUNDARY },
    { "few", vtkJetFitting::FIT_TOO_FEW_POINTS }, { "ill", vtkJetFitting::FIT_ILL_CONDITIONED },
    { "invalid", vtkJetFitting::FIT_INVALID }, { "folded", vtkJetFitting::FIT_FOLDED } };
  for (const auto& flag : flags)
  {
    vtkIdType count = 0;
    for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
    {
      const int status = static_cast<int>(Value(fitted->GetPointData(), names::FitStatus, p));
      count += (status & flag.bit) != 0 ? 1 : 0;
    }
    Print(flag.name, count);
  }
}

//------------------------------------------------------------------------------
class Run
{
public:
  explicit Run(vtkPolyData* mesh)
  {
    this->Jets->SetInputData(mesh);
    this->Umbilics->SetInputConnection(this->Jets->GetOutputPort());
    this->Ridges->SetInputConnection(this->Umbilics->GetOutputPort());
    this->Sharpness->SetInputConnection(this->Ridges->GetOutputPort());
    this->Coherence->SetInputConnection(0, this->Ridges->GetOutputPort(2));
    this->Coherence->SetInputConnection(1, this->Ridges->GetOutputPort());
    this->Coherence->SetInputConnection(2, this->Umbilics->GetOutputPort(1));
    this->Salient->SetInputData(mesh);
  }

  // What is wrong, in words, or nothing.
  std::string Execute();

private:
  std::array<vtkAlgorithm*, 6> Filters()
  {
    return { this->Jets, this->Umbilics, this->Ridges, this->Sharpness, this->Coherence,
      this->Salient };
  }
  std::string WrongIndexSum();
  std::string WrongNumbers();
  std::string FailedChecks();

  vtkNew<vtkJetFitting> Jets;
  vtkNew<vtkUmbilicDetection> Umbilics;
  vtkNew<vtkRidgeExtraction> Ridges;
  vtkNew<vtkRidgeSharpnessFilter> Sharpness;
  vtkNew<vtkRidgeCoherence> Coherence;
  vtkNew<vtkSalientRidges> Salient;
};

//------------------------------------------------------------------------------
std::string Run::Execute()
{
  std::string errors;
  std::string warnings;
  for (vtkAlgorithm* filter : this->Filters())
  {
    const MessageRecorder recorder(filter);
    filter->Update();
    errors += recorder.ErrorText() + recorder.ExecutiveErrorText();
    warnings += recorder.WarningText();
  }
  Print("warnings", program::PlainMessage(warnings));
  if (!errors.empty())
  {
    return "error: " + program::PlainMessage(errors);
  }
  PrintFlags(this->Jets->GetOutput());
  Print("umbilics", this->Umbilics->GetOutput(1)->GetNumberOfPoints());
  Print("ridges", this->Sharpness->GetOutput()->GetNumberOfLines());
  Print("salient", this->Salient->GetOutput()->GetNumberOfLines());
  return this->WrongIndexSum() + this->WrongNumbers() + this->FailedChecks();
}

//------------------------------------------------------------------------------
std::string Run::WrongIndexSum()
{
  vtkPolyData* marked = this->Umbilics->GetOutput();
  vtkFieldData* field = marked->GetFieldData();
  const double sum = Value(field, names::UmbilicIndexSum, 0);
  const double euler = Value(field, names::EulerCharacteristic, 0);
  const bool isClosed = IsClosedManifold(marked);
  char text[100];
  std::snprintf(text, sizeof text, "%g", sum);
  Print("sum", text);
  std::snprintf(text, sizeof text, "%g", euler);
  Print("euler", isClosed ? text : "");
  return isClosed && sum != euler ? "index sum; " : "";
}

//------------------------------------------------------------------------------
std::string Run::WrongNumbers()
{
  std::string found;
  for (vtkAlgorithm* filter : this->Filters())
  {
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      const std::string names = NotFinite(filter->GetOutputDataObject(port));
      found += names.empty() ? "" : std::string("not finite in ") + filter->GetClassName() + names;
    }
  }
  return found;
}

//------------------------------------------------------------------------------
// Of those, what noise cannot explain.
std::string Run::FailedChecks()
{
  vtkTable* table = this->Coherence->GetOutput();
  std::string doubtful;
  std::string wrong;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const int severity = table->GetValueByName(row, names::Severity).ToInt();
    const std::string check = " " + table->GetValueByName(row, names::Check).ToString() + ";";
    wrong += severity > 1 ? check : "";
    doubtful += severity == 1 ? check : "";
  }
  Print("doubtful", doubtful);
  return wrong.empty() ? "" : "wrong:" + wrong;
}

} // namespace

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::fprintf(stderr, "usage: RidgesCorpus FILE\n");
    return 2;
  }
  try
  {
    program::MeshFile file = program::ReadMesh(argv[1]);
    program::RepairOptions repair;
    if (!file.hasNeighbours)
    {
      repair.joining = program::Joining::All;
    }
    program::RepairMesh(file.mesh, repair);
    const auto mesh = file.mesh.ToPolyData();
    Print("points", mesh->GetNumberOfPoints());
    Print("faces", mesh->GetNumberOfPolys());
    const std::string wrong = Run(mesh).Execute();
    Print("outcome", wrong.empty() ? "done" : wrong);
    return wrong.empty() ? 0 : 1;
  }
  catch (const program::Failure& failure)
  {
    Print("outcome", std::string("refused: ") + failure.what());
    return 0;
  }
}
