// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks.h"

#include "Console.h"

#ifdef RIDGES_HAVE_MPI
#include "vtkIdTypeArray.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#endif

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <new>
#include <string>

namespace program
{
#ifdef RIDGES_HAVE_MPI
namespace
{

/// By what the launchers of Open MPI, MPICH, MVAPICH and Slurm tell each process.
bool IsStartedByLauncher()
{
  const auto isSet = [](const char* name) { return std::getenv(name) != nullptr; };
  return isSet("OMPI_COMM_WORLD_SIZE") || isSet("PMI_RANK") || isSet("PMIX_RANK") ||
    isSet("MV2_COMM_WORLD_SIZE");
}

/// What a job throws becomes a text; empty if it does not.
std::string TextOfFailure(const std::function<void()>& job)
{
  try
  {
    job();
  }
  catch (const Failure& failure)
  {
    return failure.what();
  }
  catch (const std::bad_alloc&)
  {
    return "there is not enough memory : give a smaller mesh, or more machines";
  }
  return {};
}

Failure FromText(const std::string& text)
{
  constexpr const char* separator = " : ";
  const auto at = text.rfind(separator);
  return at == std::string::npos ? Failure(text, "see the other ranks")
                                 : Failure(text.substr(0, at), text.substr(at + 3));
}

} // namespace

/// From its beginning to its end there is MPI.
class Ranks::Session
{
public:
  Session(int& argc, char**& argv)
  {
    this->Controller->Initialize(&argc, &argv);
    vtkMultiProcessController::SetGlobalController(this->Controller);
  }
  ~Session()
  {
    vtkMultiProcessController::SetGlobalController(nullptr);
    this->Controller->Finalize();
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  vtkNew<vtkMPIController> Controller;
};

Ranks::Ranks(int& argc, char**& argv)
{
  if (!IsStartedByLauncher())
  {
    return;
  }
  this->Mpi = std::make_unique<Session>(argc, argv);
  this->Controller = this->Mpi->Controller;
  this->Own = this->Controller->GetLocalProcessId();
  this->Number = this->Controller->GetNumberOfProcesses();
  if (!this->IsFirst())
  {
    std::cout.rdbuf(nullptr);
    std::cerr.rdbuf(nullptr);
  }
}

void Ranks::Together(const std::function<void()>& job) const
{
  if (!this->AreSeveral())
  {
    job();
    return;
  }
  std::string text = TextOfFailure(job);
  const int failed = text.empty() ? this->Number : this->Own;
  int firstFailed = 0;
  this->Controller->AllReduce(&failed, &firstFailed, 1, vtkCommunicator::MIN_OP);
  if (firstFailed == this->Number)
  {
    return;
  }
  auto size = static_cast<vtkIdType>(text.size());
  this->Controller->Broadcast(&size, 1, firstFailed);
  text.resize(static_cast<std::size_t>(size));
  this->Controller->Broadcast(text.data(), size, firstFailed);
  throw FromText(text);
}

std::vector<long long> Ranks::GatherAll(const std::vector<long long>& values) const
{
  if (!this->AreSeveral())
  {
    return values;
  }
  std::vector<long long> all(values.size() * static_cast<std::size_t>(this->Number));
  this->Controller->AllGather(values.data(), all.data(), static_cast<vtkIdType>(values.size()));
  return all;
}

void Ranks::GatherOnFirst(vtkIdTypeArray* values, vtkIdTypeArray* all) const
{
  this->Controller->GatherV(values, all, 0);
}

#else

class Ranks::Session
{
};

Ranks::Ranks(int&, char**&)
{
  for (const char* name : { "OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE" })
  {
    const char* size = std::getenv(name);
    if (size && std::atoi(size) > 1)
    {
      throw Failure("this program was built without MPI", "start it without mpirun");
    }
  }
}

void Ranks::Together(const std::function<void()>& job) const
{
  job();
}

std::vector<long long> Ranks::GatherAll(const std::vector<long long>& values) const
{
  return values;
}

#endif

Ranks::~Ranks() = default;

} // namespace program
