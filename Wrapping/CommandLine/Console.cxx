// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Console.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <mutex>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace program
{
namespace
{

bool IsErrorOnTerminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(STDERR_FILENO) != 0;
#endif
}

// --------------------------------------------------------------------------------- VTK's messages

/// Keeps what VTK would print. Messages may come from any thread.
class MessageLog : public vtkOutputWindow
{
public:
  static MessageLog* New();
  vtkTypeMacro(MessageLog, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override { this->Add(this->Errors, text); }
  void DisplayWarningText(const char* text) override { this->Add(this->Warnings, text); }
  void DisplayGenericWarningText(const char* text) override { this->Add(this->Warnings, text); }

  std::vector<std::string> TakeErrors() { return this->Take(this->Errors); }
  std::vector<std::string> TakeWarnings() { return this->Take(this->Warnings); }

private:
  void Add(std::vector<std::string>& list, const char* text)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    list.push_back(PlainMessage(text));
  }

  std::vector<std::string> Take(std::vector<std::string>& list)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return std::exchange(list, {});
  }

  std::mutex Mutex;
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};
vtkStandardNewMacro(MessageLog);

MessageLog* InstalledLog()
{
  static vtkNew<MessageLog> log;
  vtkOutputWindow::SetInstance(log);
  // It would print the same beside the window.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  return log;
}

/// The first error, other than those of the pipeline, which only say that there was one. Some
/// readers call their errors warnings.
std::string Cause(const std::vector<std::string>& errors, const std::vector<std::string>& warnings)
{
  for (const std::vector<std::string>* list : { &errors, &warnings })
  {
    for (const std::string& message : *list)
    {
      if (message.find("returned failure for request") == std::string::npos)
      {
        return message;
      }
    }
  }
  return "VTK gives no reason";
}

// --------------------------------------------------------------------------------------- progress

class ProgressBar
{
public:
  ProgressBar(std::string name, vtkAlgorithm* algorithm)
    : Name(std::move(name))
    , Algorithm(algorithm)
  {
    this->Show(0.0);
    if (this->Algorithm)
    {
      this->Observer->SetClientData(this);
      this->Observer->SetCallback(
        [](vtkObject* caller, unsigned long, void* bar, void*) {
          static_cast<ProgressBar*>(bar)->Show(vtkAlgorithm::SafeDownCast(caller)->GetProgress());
        });
      this->Algorithm->AddObserver(vtkCommand::ProgressEvent, this->Observer);
    }
  }

  ~ProgressBar()
  {
    if (this->Algorithm)
    {
      this->Algorithm->RemoveObserver(this->Observer);
    }
    std::fputs("\r\033[K", stderr);
  }

  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

private:
  void Show(double progress)
  {
    constexpr int width = 40;
    const int percent = static_cast<int>(std::lround(100.0 * progress));
    if (percent == this->Shown || percent < 0 || percent > 100)
    {
      return;
    }
    this->Shown = percent;
    const std::string done(static_cast<std::size_t>(percent * width / 100), '#');
    std::fprintf(stderr, "\r%-12s [%-*s] %3d %%", this->Name.c_str(), width, done.c_str(), percent);
  }

  std::string Name;
  vtkAlgorithm* Algorithm;
  vtkNew<vtkCallbackCommand> Observer;
  int Shown = -1;
};

} // namespace

std::string PlainMessage(const std::string& message)
{
  std::string text = message;
  // "ERROR: In file.cxx, line 1", then on the next line "vtkClass (0x1234): message".
  const auto in = text.find(": In ");
  const auto lineEnd = text.find('\n');
  if (in != std::string::npos && lineEnd != std::string::npos && in < lineEnd)
  {
    text.erase(0, lineEnd + 1);
  }
  const auto address = text.find("(0x");
  const auto colon = text.find("): ");
  if (address != std::string::npos && colon != std::string::npos && address < colon &&
    text.find(' ') >= address - 1)
  {
    text.erase(0, colon + 3);
  }
  std::string line;
  for (const char c : text)
  {
    const bool space = c == ' ' || c == '\n' || c == '\r' || c == '\t';
    if (!space)
    {
      line += c >= '!' && c <= '~' ? c : '?';
    }
    else if (!line.empty() && line.back() != ' ')
    {
      line += ' ';
    }
  }
  while (!line.empty() && (line.back() == ' ' || line.back() == '.'))
  {
    line.pop_back();
  }
  return line;
}

Stages::Stages(bool quiet)
  : Quiet(quiet)
  , ShowProgress(!quiet && IsErrorOnTerminal())
{
  InstalledLog();
}

void Stages::Time(
  const std::string& name, vtkAlgorithm* algorithm, const std::function<void()>& job)
{
  const auto begin = std::chrono::steady_clock::now();
  if (this->ShowProgress)
  {
    const ProgressBar bar(name, algorithm);
    job();
  }
  else
  {
    job();
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  this->Durations.emplace_back(name, seconds.count());
}

void Stages::SetHint(const std::string& className, const std::string& hint)
{
  this->Hints[className] = hint;
}

/// The filters advise in terms of VTK's classes; the user of the program has options.
std::string Stages::InOptions(std::string text) const
{
  for (const auto& [className, hint] : this->Hints)
  {
    const auto name = text.find(className);
    const auto open = name == std::string::npos ? name : text.rfind('(', name);
    const auto close = name == std::string::npos ? name : text.find(')', name);
    if (open != std::string::npos && close != std::string::npos)
    {
      text.replace(open + 1, close - open - 1, hint);
    }
  }
  return text;
}

void Stages::Run(const std::string& name, const std::function<std::string()>& advice,
  vtkAlgorithm* algorithm, const std::function<void()>& job)
{
  MessageLog* log = InstalledLog();
  this->Time(name, algorithm, job);
  const std::vector<std::string> errors = log->TakeErrors();
  const std::vector<std::string> warnings = log->TakeWarnings();
  if (!errors.empty())
  {
    throw Failure(name + " failed: " + this->InOptions(Cause(errors, warnings)), advice());
  }
  for (const std::string& warning : warnings)
  {
    this->Warn(this->InOptions(warning), advice());
  }
}

void Stages::Run(const std::string& name, const std::string& advice, vtkAlgorithm* algorithm,
  const std::function<void()>& job)
{
  this->Run(
    name, [&advice] { return advice; }, algorithm, job);
}

void Stages::RunStrictly(
  const std::string& name, const std::string& advice, const std::function<void()>& job)
{
  MessageLog* log = InstalledLog();
  this->Time(name, nullptr, job);
  const std::vector<std::string> errors = log->TakeErrors();
  const std::vector<std::string> warnings = log->TakeWarnings();
  if (!errors.empty() || !warnings.empty())
  {
    throw Failure(name + " failed: " + Cause(errors, warnings), advice);
  }
}

void Stages::Warn(const std::string& warning, const std::string& advice)
{
  if (this->HoldsBack)
  {
    this->Held.emplace_back(warning, advice);
  }
  else if (!this->Quiet && this->Warned.insert(warning).second)
  {
    std::cerr << "vtkridges: warning, " << warning << " : " << advice << "\n";
  }
}

void Stages::HoldWarnings()
{
  this->HoldsBack = true;
}

void Stages::ReleaseWarnings(bool areWanted)
{
  this->HoldsBack = false;
  for (const auto& [warning, advice] : std::exchange(this->Held, {}))
  {
    if (areWanted)
    {
      this->Warn(warning, advice);
    }
  }
}

} // namespace program
