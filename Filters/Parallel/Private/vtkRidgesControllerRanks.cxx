// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesControllerRanks.h"

#include "vtkRidgesRanksPipeline.h"

#include "vtkAlgorithm.h"
#include "vtkMultiProcessController.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace
{

constexpr int Tag = 20051;

/// MPI counts in 32 bits.
constexpr std::size_t LargestPart = std::size_t(1) << 30;

} // namespace

void vtkRidgesControllerRanks::SetController(vtkMultiProcessController* controller)
{
  this->Controller = controller;
  auto* pipeline = vtkRidgesRanksPipeline::SafeDownCast(this->Filter->GetExecutive());
  if (pipeline)
  {
    pipeline->SetIsShared(this->Size() > 1);
  }
}

std::string vtkRidgesControllerRanks::Fault() const
{
  auto* pipeline = vtkRidgesRanksPipeline::SafeDownCast(this->Filter->GetExecutive());
  return pipeline ? pipeline->GetFault() : "";
}

int vtkRidgesControllerRanks::Rank() const
{
  return this->Controller ? this->Controller->GetLocalProcessId() : 0;
}

int vtkRidgesControllerRanks::Size() const
{
  return this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
}

void vtkRidgesControllerRanks::Send(const ridges::Bytes& message, int rank)
{
  for (std::size_t begin = 0; begin < message.size(); begin += LargestPart)
  {
    const std::size_t size = std::min(LargestPart, message.size() - begin);
    this->Controller->Send(message.data() + begin, static_cast<vtkIdType>(size), rank, Tag);
  }
}

void vtkRidgesControllerRanks::Receive(ridges::Bytes& message, int rank)
{
  for (std::size_t begin = 0; begin < message.size(); begin += LargestPart)
  {
    const std::size_t size = std::min(LargestPart, message.size() - begin);
    this->Controller->Receive(message.data() + begin, static_cast<vtkIdType>(size), rank, Tag);
  }
}

std::vector<ridges::Bytes> vtkRidgesControllerRanks::Exchange(std::vector<ridges::Bytes> messages)
{
  const int own = this->Rank();
  const int count = this->Size();
  std::vector<long long> sizes(count);
  std::transform(messages.begin(), messages.end(), sizes.begin(),
    [](const ridges::Bytes& message) { return static_cast<long long>(message.size()); });
  std::vector<long long> allSizes(static_cast<std::size_t>(count) * count);
  if (count > 1)
  {
    this->Controller->AllGather(sizes.data(), allSizes.data(), count);
  }

  // In each round all pair up, so that nobody waits for somebody who waits.
  std::vector<ridges::Bytes> received(count);
  for (int round = 0; round < count; ++round)
  {
    const int other = (round - own + count) % count;
    if (other == own)
    {
      received[own] = std::move(messages[own]);
      continue;
    }
    received[other].resize(allSizes[static_cast<std::size_t>(other) * count + own]);
    if (own < other)
    {
      this->Send(messages[other], other);
      this->Receive(received[other], other);
    }
    else
    {
      this->Receive(received[other], other);
      this->Send(messages[other], other);
    }
    messages[other] = {};
  }
  return received;
}

std::vector<ridges::Bytes> vtkRidgesControllerRanks::GatherAll(ridges::Bytes message)
{
  const int count = this->Size();
  if (count == 1)
  {
    return { std::move(message) };
  }
  const auto size = static_cast<vtkIdType>(message.size());
  std::vector<vtkIdType> sizes(count);
  this->Controller->AllGather(&size, sizes.data(), 1);
  std::vector<vtkIdType> offsets(count, 0);
  std::partial_sum(sizes.begin(), sizes.end() - 1, offsets.begin() + 1);
  const vtkIdType total = offsets.back() + sizes.back();
  if (total > static_cast<vtkIdType>(LargestPart))
  {
    return this->Exchange(std::vector<ridges::Bytes>(count, message));
  }
  // One more, so that there is an address.
  ridges::Bytes all(total + 1);
  message.resize(message.size() + 1);
  this->Controller->AllGatherV(message.data(), all.data(), size, sizes.data(), offsets.data());
  std::vector<ridges::Bytes> received;
  for (int rank = 0; rank < count; ++rank)
  {
    const char* begin = all.data() + offsets[rank];
    received.emplace_back(begin, begin + sizes[rank]);
  }
  return received;
}
