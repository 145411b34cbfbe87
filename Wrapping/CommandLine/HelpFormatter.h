// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef HelpFormatter_h
#define HelpFormatter_h

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace program
{

/**
 * Lays out the help in 80 columns: options on the left, what they do wrapped on the right. The help
 * in short lists the options that most users need; --help-all lists all.
 */
class HelpFormatter : public CLI::Formatter
{
public:
  /// The names of the options in the short help, with dashes.
  explicit HelpFormatter(std::vector<std::string> namesInShort);

  std::string make_help(
    const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_option(const CLI::Option* option, bool isPositional) const override;

private:
  std::vector<std::string> NamesInShort;
};

} // namespace program

#endif
