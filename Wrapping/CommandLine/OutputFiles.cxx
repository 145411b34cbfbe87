// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutputFiles.h"

#include "Console.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace program
{
namespace
{

namespace fs = std::filesystem;

[[noreturn]] void FailToWrite(const std::string& fileName, int error)
{
  const std::string reason =
    error != 0 ? " (" + std::generic_category().message(error) + ")" : std::string();
  throw Failure(fileName + " cannot be written" + reason, "check the disk, or change --output");
}

void Write(
  const std::string& fileName, const std::string& nameInEnd, const char* bytes, std::size_t size)
{
  errno = 0;
  std::ofstream file(fileName, std::ios::binary | std::ios::trunc);
  file.write(bytes, static_cast<std::streamsize>(size));
  file.close();
  if (!file)
  {
    FailToWrite(nameInEnd, errno);
  }
}

} // namespace

void CheckWritable(const std::string& fileName)
{
  std::error_code error;
  const bool existed = fs::exists(fileName, error);
  if (fs::is_directory(fileName, error) || !std::ofstream(fileName, std::ios::app))
  {
    throw Failure(fileName + " cannot be written", "check the permissions, or change --output");
  }
  if (!existed)
  {
    fs::remove(fileName, error);
  }
}

OutputFiles::~OutputFiles()
{
  for (const auto& [now, end] : this->Pending)
  {
    std::error_code error;
    fs::remove(now, error);
  }
}

void OutputFiles::Add(const std::string& fileName, const char* bytes, std::size_t size)
{
  std::error_code error;
  const bool exists = fs::exists(fileName, error);
  std::string end = fileName;
  std::string now = fileName;
  if (!exists || fs::is_regular_file(fileName, error))
  {
    // Where a link leads is replaced, rather than the link.
    end = exists ? fs::canonical(fileName, error).string() : fileName;
    now = end + ".part";
    this->Pending.emplace_back(now, end);
  }
  Write(now, fileName, bytes, size);
}

void OutputFiles::Complete()
{
  while (!this->Pending.empty())
  {
    const auto& [now, end] = this->Pending.back();
    std::error_code error;
    fs::rename(now, end, error);
    if (error)
    {
      FailToWrite(end, error.value());
    }
    this->Pending.pop_back();
  }
}

} // namespace program
