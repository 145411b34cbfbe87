// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SharedMemory_h
#define ridges_SharedMemory_h

#include <cstddef>

namespace ridges
{

/**
 * One piece of memory for several arrays that are made together but freed one by one, in any order
 * and thread: large pages serve them even where each is small. The piece is given back with the
 * last of them.
 */
class SharedMemory
{
public:
  /// Room for so many arrays with so many bytes in all. Throws std::bad_alloc.
  SharedMemory(std::size_t arrays, std::size_t bytes);
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  /// Memory for the next array, aligned to a cache line, to be given back by Free.
  void* Take(std::size_t bytes);

  static void Free(void* array);

private:
  struct Piece;
  static void Leave(Piece* piece);

  Piece* Piece_;
  char* Next_;
};

} // namespace ridges

#endif
