// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The main of a target without libFuzzer, for any compiler:
//
//   FuzzTarget [-runs=N] [FILE]...
//
// Replays the files; without any, the seeds, and N changes of them at random, always the same.

#include "FuzzTarget.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>

extern "C" int LLVMFuzzerInitialize(int*, char***);

namespace
{

//------------------------------------------------------------------------------
void Run(const std::string& bytes)
{
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

//------------------------------------------------------------------------------
// Bytes changed, cut, repeated, or taken from another one.
std::string Changed(const std::vector<std::string>& seeds, std::mt19937& random)
{
  std::string bytes = seeds[random() % seeds.size()];
  for (unsigned change = 1 + random() % 6; change > 0 && !bytes.empty(); --change)
  {
    const std::size_t at = random() % bytes.size();
    const std::size_t count = 1 + random() % 16;
    switch (random() % 6)
    {
      case 0:
        bytes.resize(at);
        break;
      case 1:
        bytes.erase(at, count);
        break;
      case 2:
        bytes.insert(random() % bytes.size(), bytes.substr(at, count));
        break;
      case 3:
      {
        const std::string& other = seeds[random() % seeds.size()];
        const std::size_t from = other.empty() ? 0 : random() % other.size();
        bytes = bytes.substr(0, at) + other.substr(from);
        break;
      }
      default:
        bytes[at] = static_cast<char>(random());
        break;
    }
  }
  return bytes;
}

} // namespace

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  LLVMFuzzerInitialize(&argc, &argv);
  unsigned long runs = 0;
  bool hasFiles = false;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument.rfind("-runs=", 0) == 0)
    {
      runs = std::strtoul(argument.c_str() + 6, nullptr, 10);
      continue;
    }
    std::ifstream file(argument, std::ios::binary);
    Run(std::string(std::istreambuf_iterator<char>(file), {}));
    hasFiles = true;
  }
  if (hasFiles)
  {
    return 0;
  }
  const std::vector<std::string> seeds = FuzzSeeds();
  for (const std::string& seed : seeds)
  {
    Run(seed);
  }
  std::mt19937 random(1);
  for (unsigned long i = 0; i < runs; ++i)
  {
    Run(Changed(seeds, random));
  }
  std::printf("%zu seeds, %lu changes of them\n", seeds.size(), runs);
  return 0;
}
