// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged files in every format: cut, with other bytes, with false counts, with parts missing or
// twice. The program reads them or says in one line why not, whatever the damage.
//
// RIDGES_MUTANTS in the environment sets how many of each kind of file are tried, and has the
// slowest one printed and those that make the process take 50 MB more.

#include "MeshFiles.h"
#include "Program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>

#ifndef _WIN32
#include <sys/resource.h>
#endif

namespace
{

namespace fs = std::filesystem;
using Random = std::mt19937;

/// Below the limit. Not by a distribution, whose numbers differ between libraries.
std::size_t Below(std::size_t limit, Random& random)
{
  return limit == 0 ? 0 : random() % limit;
}

void ChangeBytes(std::string& bytes, Random& random)
{
  // With the zero that ends it.
  constexpr char likely[] = "\x01\x7f\x80\xff 0-9.,eE#/\n\r\t<>\"";
  for (std::size_t i = 1 + Below(8, random); i > 0; --i)
  {
    char& byte = bytes[Below(bytes.size(), random)];
    byte = Below(2, random) == 0 ? likely[Below(sizeof(likely), random)]
                                 : static_cast<char>(byte ^ (1 << Below(8, random)));
  }
}

/// Another number in the place of one in the first lines, or of four bytes.
void ChangeCount(std::string& bytes, Random& random)
{
  constexpr std::size_t head = 600;
  const char* counts[] = { "0", "1", "-1", "41", "43", "79", "81", "255", "256", "65536",
    "2147483647", "2147483648", "4294967295", "4294967296", "99999999999", "9223372036854775807",
    "18446744073709551615", "1e9", "nan" };
  constexpr const char* digits = "0123456789";
  std::size_t at = bytes.find_first_of(digits, Below(std::min(head, bytes.size()), random));
  if (at == std::string::npos || Below(4, random) == 0)
  {
    at = Below(bytes.size(), random);
    for (std::size_t i = 0; i < 4 && at + i < bytes.size(); ++i)
    {
      bytes[at + i] = static_cast<char>(Below(3, random) == 0 ? 0 : random());
    }
    return;
  }
  const std::size_t end = std::min(bytes.find_first_not_of(digits, at), bytes.size());
  bytes.replace(at, end - at, counts[Below(std::size(counts), random)]);
}

void MoveParts(std::string& bytes, Random& random)
{
  const std::size_t begin = Below(bytes.size(), random);
  const std::size_t size = 1 + Below(std::min<std::size_t>(bytes.size() - begin, 300), random);
  const std::string part = bytes.substr(begin, size);
  if (Below(2, random) == 0)
  {
    bytes.erase(begin, size);
  }
  if (Below(2, random) == 0)
  {
    bytes.insert(Below(bytes.size(), random), part);
  }
}

std::string Mutant(const std::string& original, std::size_t number)
{
  std::string bytes = original;
  if (number < 9)
  {
    bytes.resize(bytes.size() * (number + 1) / 10);
    return bytes;
  }
  Random random(static_cast<Random::result_type>(number));
  switch (Below(5, random))
  {
    case 0:
      bytes.resize(Below(bytes.size(), random));
      break;
    case 1:
      MoveParts(bytes, random);
      break;
    case 2:
      ChangeCount(bytes, random);
      break;
    default:
      ChangeBytes(bytes, random);
      break;
  }
  return bytes;
}

/// The most memory that the process has had, in MB.
long PeakMemory()
{
#ifdef _WIN32
  return 0;
#else
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
#endif
}

struct Outcome
{
  int exitCode;
  std::string errors;
};

Outcome RunOn(const fs::path& mesh)
{
  std::string arguments[] = { "vtkridges", mesh.string(), "--no-picture", "--quiet", "--output",
    (mesh.parent_path() / "out").string() };
  std::vector<char*> argv;
  for (std::string& argument : arguments)
  {
    argv.push_back(argument.data());
  }
  testing::internal::CaptureStderr();
  const int exitCode = program::RunProgram(static_cast<int>(argv.size()), argv.data());
  return { exitCode, testing::internal::GetCapturedStderr() };
}

/// One line: "vtkridges: <what> : <what to do>".
bool IsOneLine(const std::string& text)
{
  return text.find("vtkridges: ") == 0 && text.find(" : ") != std::string::npos &&
    text.find('\n') == text.size() - 1 &&
    std::all_of(text.begin(), text.end() - 1, [](char c) { return c >= ' ' && c <= '~'; });
}

class MutatedFiles : public testing::TestWithParam<std::size_t>
{
};

TEST_P(MutatedFiles, AreReadOrRejectedInOneLine)
{
  const char* wanted = std::getenv("RIDGES_MUTANTS");
  const std::size_t count = wanted ? std::strtoul(wanted, nullptr, 10) : 40;
  const MeshBytes file = WriteInAllFormats(Ellipsoid(2))[this->GetParam()];
  const fs::path directory = ScratchPath("mutants-" + file.name);
  fs::create_directory(directory);
  const fs::path path = directory / file.name;
  std::size_t accepted = 0;
  std::pair<double, std::size_t> slowest;
  long memory = PeakMemory();
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::string bytes = Mutant(file.bytes, i);
    std::ofstream(path, std::ios::binary) << bytes;
    const auto begin = std::chrono::steady_clock::now();
    const Outcome outcome = RunOn(path);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    slowest = std::max(slowest, { seconds.count(), i });
    if (wanted && PeakMemory() > memory + 50)
    {
      std::cout << file.name << ", mutant " << i << ": from " << memory << " to " << PeakMemory()
                << " MB\n";
    }
    memory = std::max(memory, PeakMemory());
    EXPECT_TRUE(outcome.exitCode == 0 || outcome.exitCode == 1) << "mutant " << i;
    EXPECT_TRUE(outcome.exitCode == 0 ? outcome.errors.empty() : IsOneLine(outcome.errors))
      << "mutant " << i << ": " << outcome.errors;
    accepted += outcome.exitCode == 0 ? 1 : 0;
    // A file that is cut is never taken for a whole one. In OBJ nothing says where the end is.
    if (i < 9 && file.name != "mesh.obj")
    {
      EXPECT_EQ(outcome.exitCode, 1) << "cut at " << i + 1 << " tenths";
    }
  }
  fs::remove_all(directory);
  if (wanted)
  {
    std::cout << file.name << ": " << count << " mutants, " << accepted << " accepted, slowest "
              << slowest.first << " s (mutant " << slowest.second << "), memory " << memory
              << " MB\n";
  }
}

std::string NameOf(const testing::TestParamInfo<std::size_t>& info)
{
  std::string name = WriteInAllFormats(Ellipsoid(1))[info.param].name;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Formats, MutatedFiles, testing::Range<std::size_t>(0, 16), NameOf);

} // namespace
