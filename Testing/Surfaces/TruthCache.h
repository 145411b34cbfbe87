// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RIDGES_TESTING_TRUTH_CACHE_H
#define RIDGES_TESTING_TRUTH_CACHE_H

#include "TrueRidges.h"

#include <string>

namespace ridges
{
namespace testing
{

struct Truth
{
  std::vector<ExactUmbilic> umbilics;
  std::vector<TrueRidge> ridges;
};

// Meshes and true ridges of a surface, which take a while, kept as files in a directory; computed
// each time if that is empty. Files are told apart by the surface's name only: remove them when a
// surface or the computation changes.
class TruthCache
{
public:
  TruthCache(const ClosedSurface& closed, const std::string& directory);

  Mesh MeshWith(int points) const;
  Truth TruthWith(int points) const;

private:
  std::string FileName(const char* kind, int points) const;

  const ClosedSurface& Closed;
  std::string Directory;
};

} // namespace testing
} // namespace ridges

#endif
