// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/FileBytes.h"

#include "Console.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

namespace program
{

void CheckIsFile(const std::string& fileName, const std::string& wanted)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(fileName, error);
  if (!std::filesystem::exists(status))
  {
    throw Failure(fileName + " does not exist", "check the path");
  }
  if (std::filesystem::is_directory(status))
  {
    throw Failure(fileName + " is a directory", wanted);
  }
}

std::string ExtensionOf(const std::string& fileName)
{
  std::string extension = std::filesystem::path(fileName).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::string ReadBytes(const std::string& fileName)
{
  CheckIsFile(fileName, "give a mesh");
  std::ifstream file(fileName, std::ios::binary);
  if (!file)
  {
    throw Failure(fileName + " cannot be opened", "check its permissions");
  }
  std::string bytes;
  constexpr std::size_t block = 1 << 20;
  do
  {
    const std::size_t size = bytes.size();
    bytes.resize(size + block);
    file.read(bytes.data() + size, block);
    bytes.resize(size + static_cast<std::size_t>(file.gcount()));
  } while (file);
  if (!file.eof())
  {
    throw Failure(fileName + " cannot be read to its end", "check the disk");
  }
  if (bytes.empty())
  {
    throw Failure(fileName + " is empty", "give a mesh");
  }
  return bytes;
}

} // namespace program
