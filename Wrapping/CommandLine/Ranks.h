// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Ranks_h
#define Ranks_h

#include <functional>
#include <memory>
#include <vector>

class vtkIdTypeArray;
class vtkMultiProcessController;

namespace program
{

/**
 * The processes that mpirun has started, of which this is one, each with a number, its rank. There
 * is one without mpirun, and MPI is not started then. The first alone prints.
 */
class Ranks
{
public:
  /// Throws Failure where mpirun has started several, but the program was built without MPI.
  Ranks(int& argc, char**& argv);
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int Rank() const { return this->Own; }
  int Size() const { return this->Number; }
  bool IsFirst() const { return this->Own == 0; }
  bool AreSeveral() const { return this->Number > 1; }

  /// Runs a job, in which no rank waits for another, on all ranks: if it fails on one, each throws
  /// the Failure.
  void Together(const std::function<void()>& job) const;

  /// The values of all ranks, which are as many on each, one rank after the other.
  std::vector<long long> GatherAll(const std::vector<long long>& values) const;

  /// The values of all ranks on the first, where there are several.
  void GatherOnFirst(vtkIdTypeArray* values, vtkIdTypeArray* all) const;

private:
  class Session;
  std::unique_ptr<Session> Mpi; ///< Null without mpirun.
  vtkMultiProcessController* Controller = nullptr;
  int Own = 0;
  int Number = 1;
};

} // namespace program

#endif
