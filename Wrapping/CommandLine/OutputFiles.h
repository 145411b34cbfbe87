// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OutputFiles_h
#define OutputFiles_h

#include <string>
#include <utility>
#include <vector>

namespace program
{

/// Fails before the long job if a file cannot be written, without leaving a trace.
void CheckWritable(const std::string& fileName);

/**
 * Files that are written all or none, and each as a whole: first under another name beside it, and
 * under its own name once all are complete.
 */
class OutputFiles
{
public:
  OutputFiles() = default;
  /// Removes what was not completed.
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Throws Failure, with the reason, if the bytes cannot be written.
  void Add(const std::string& fileName, const char* bytes, std::size_t size);

  /// All files get their names.
  void Complete();

private:
  std::vector<std::pair<std::string, std::string>> Pending; ///< Name for now, name in the end.
};

} // namespace program

#endif
