// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ThreadRanks.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <random>
#include <stdexcept>
#include <thread>
#include <utility>

namespace ridges
{
namespace testing
{
namespace
{

/// What all threads see. One that fails frees those that wait for it.
class Table
{
public:
  explicit Table(int count)
    : messages(count, std::vector<Bytes>(count))
    , Count_(count)
  {
  }

  void Wait()
  {
    std::unique_lock<std::mutex> lock(this->Mutex_);
    const std::uint64_t round = this->Round_;
    if (++this->Waiting_ == this->Count_)
    {
      this->Waiting_ = 0;
      ++this->Round_;
      this->Changed_.notify_all();
    }
    this->Changed_.wait(lock, [this, round] { return this->Round_ != round || this->HasFailed_; });
    if (this->HasFailed_)
    {
      throw std::runtime_error("another rank has failed");
    }
  }

  void Fail(std::exception_ptr error)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex_);
    this->first = this->HasFailed_ ? this->first : std::move(error);
    this->HasFailed_ = true;
    this->Changed_.notify_all();
  }

  std::vector<std::vector<Bytes>> messages; // [from][to]
  std::exception_ptr first;

private:
  int Count_;
  int Waiting_ = 0;
  std::uint64_t Round_ = 0;
  bool HasFailed_ = false;
  std::mutex Mutex_;
  std::condition_variable Changed_;
};

class ThreadRanks : public Ranks
{
public:
  ThreadRanks(Table& table, int rank, int size)
    : Table_(table)
    , Rank_(rank)
    , Size_(size)
  {
  }

  int Rank() const override { return this->Rank_; }
  int Size() const override { return this->Size_; }

  std::vector<Bytes> Exchange(std::vector<Bytes> messages) override
  {
    this->Table_.messages[this->Rank_] = std::move(messages);
    this->Table_.Wait();
    std::vector<Bytes> received;
    received.reserve(this->Size_);
    for (int from = 0; from < this->Size_; ++from)
    {
      received.push_back(this->Table_.messages[from].at(this->Rank_));
    }
    this->Table_.Wait();
    return received;
  }

  std::vector<Bytes> GatherAll(Bytes message) override
  {
    return this->Exchange(std::vector<Bytes>(this->Size_, message));
  }

private:
  Table& Table_;
  int Rank_;
  int Size_;
};

} // namespace

void OnThreadRanks(int count, const std::function<void(Ranks&)>& body)
{
  Table table(count);
  std::vector<std::thread> threads;
  threads.reserve(count);
  for (int rank = 0; rank < count; ++rank)
  {
    threads.emplace_back(
      [&table, &body, rank, count]
      {
        try
        {
          ThreadRanks ranks(table, rank, count);
          body(ranks);
        }
        catch (...)
        {
          table.Fail(std::current_exception());
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  if (table.first)
  {
    std::rethrow_exception(table.first);
  }
}

std::vector<int> PartsOf(const Mesh& mesh, Partition partition, int ranks)
{
  std::mt19937_64 generator(7);
  const std::size_t count = mesh.TriangleCount();
  const double width = 2.0 * MeanEdgeLength(mesh);
  std::vector<int> parts(count, 0);
  for (std::size_t t = 0; t < count; ++t)
  {
    const int blocks = partition == Partition::LastIsEmpty ? std::max(1, ranks - 1) : ranks;
    switch (partition)
    {
      case Partition::Strips:
      {
        const double x = mesh.Point(mesh.triangles[3 * t])[0];
        parts[t] = static_cast<int>(static_cast<long>(std::floor(x / width) + 1e6) % ranks);
        break;
      }
      case Partition::Random:
        parts[t] = static_cast<int>(generator() % static_cast<std::uint64_t>(ranks));
        break;
      case Partition::AllOnFirst:
        break;
      default:
        parts[t] = static_cast<int>(t * static_cast<std::size_t>(blocks) / count);
    }
  }
  return parts;
}

PieceOfMesh PieceOf(const Mesh& mesh, const std::vector<int>& parts, int part)
{
  PieceOfMesh piece;
  std::vector<std::int32_t> newNames(mesh.PointCount(), -1);
  for (std::size_t t = 0; t < mesh.TriangleCount(); ++t)
  {
    if (parts[t] != part)
    {
      continue;
    }
    piece.triangles.push_back(static_cast<std::int32_t>(t));
    for (int i = 0; i < 3; ++i)
    {
      const std::int32_t p = mesh.triangles[3 * t + i];
      if (newNames[p] < 0)
      {
        newNames[p] = static_cast<std::int32_t>(piece.points.size());
        piece.points.push_back(p);
        piece.mesh.AddPoint(mesh.Point(p));
      }
      piece.mesh.triangles.push_back(newNames[p]);
    }
  }
  return piece;
}

} // namespace testing
} // namespace ridges
