// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/SharedMemory.h"

#include "Base/LargeMemory.h"

#include <atomic>
#include <new>

namespace ridges
{
namespace
{

constexpr std::size_t Line = 64;

std::size_t InLines(std::size_t bytes)
{
  return (bytes + Line - 1) / Line * Line;
}

} // namespace

/// What the piece begins with. A line before each array holds where that is.
struct SharedMemory::Piece
{
  std::atomic<std::size_t> users{ 1 };
};

SharedMemory::SharedMemory(std::size_t arrays, std::size_t bytes)
{
  static_assert(sizeof(Piece) <= Line);
  void* memory = AllocateLarge(bytes + (2 * arrays + 1) * Line);
  this->Piece_ = new (memory) Piece;
  this->Next_ = static_cast<char*>(memory) + Line;
}

SharedMemory::~SharedMemory()
{
  Leave(this->Piece_);
}

void* SharedMemory::Take(std::size_t bytes)
{
  char* array = this->Next_ + Line;
  this->Next_ = array + InLines(bytes);
  new (array - Line) Piece*(this->Piece_);
  this->Piece_->users.fetch_add(1, std::memory_order_relaxed);
  return array;
}

void SharedMemory::Free(void* array)
{
  if (array)
  {
    Leave(*reinterpret_cast<Piece**>(static_cast<char*>(array) - Line));
  }
}

void SharedMemory::Leave(Piece* piece)
{
  if (piece->users.fetch_sub(1, std::memory_order_acq_rel) == 1)
  {
    piece->~Piece();
    FreeLarge(piece);
  }
}

} // namespace ridges
