// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Console.h
 * How the program speaks while it works: failures and VTK's messages in one line each, a progress
 * bar on terminals, and the time that each stage took.
 */

#ifndef Console_h
#define Console_h

#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;

namespace program
{

/// The job cannot go on. The text is "<what> : <what to do>".
class Failure : public std::runtime_error
{
public:
  Failure(const std::string& what, const std::string& whatToDo)
    : std::runtime_error(what + " : " + whatToDo)
  {
  }
};

/// A message of VTK without the source line, the address of the object and line breaks.
std::string PlainMessage(const std::string& message);

/**
 * Runs the stages of the job. From its first use on, VTK's messages go through it instead of to
 * the terminal: warnings come out in one line each, an error ends the job.
 */
class Stages
{
public:
  using Duration = std::pair<std::string, double>;

  /// Quiet: neither progress nor warnings.
  explicit Stages(bool quiet);

  /// What the user of the program should read where a filter advises to use a class of VTK: the
  /// parenthesis that names the class is replaced.
  void SetHint(const std::string& className, const std::string& hint);

  /**
   * Runs a job under a name; the algorithm, if there is one, reports the progress. Throws Failure
   * with the first error that VTK reports meanwhile, and prints its warnings. The advice says what
   * to do about either; a function is asked for it after the job.
   */
  void Run(const std::string& name, const std::string& advice, vtkAlgorithm* algorithm,
    const std::function<void()>& job);
  void Run(const std::string& name, const std::function<std::string()>& advice,
    vtkAlgorithm* algorithm, const std::function<void()>& job);

  /// The same, but a warning ends the job too.
  void RunStrictly(
    const std::string& name, const std::string& advice, const std::function<void()>& job);

  /// Prints a warning of the program itself, as all warnings only once.
  void Warn(const std::string& warning, const std::string& advice);

  /// Keeps warnings from now on, until it is known whether they are wanted.
  void HoldWarnings();
  void ReleaseWarnings(bool areWanted);

  /// Name and seconds of the stages run so far.
  const std::vector<Duration>& GetDurations() const { return this->Durations; }

private:
  void Time(const std::string& name, vtkAlgorithm* algorithm, const std::function<void()>& job);

  std::string InOptions(std::string text) const;

  std::set<std::string> Warned;                          ///< The warnings so far.
  std::vector<std::pair<std::string, std::string>> Held; ///< Warnings with their advice.
  bool HoldsBack = false;
  std::map<std::string, std::string> Hints; ///< By the name of a class.
  bool Quiet;
  bool ShowProgress;
  std::vector<Duration> Durations;
};

} // namespace program

#endif
