// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef HelpFormatter_h
#define HelpFormatter_h

#include <CLI/CLI.hpp>

#include <string>

namespace program
{

/// Lays the help out in 80 columns: options on the left, what they do wrapped on the right.
class HelpFormatter : public CLI::Formatter
{
public:
  std::string make_help(
    const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_option(const CLI::Option* option, bool isPositional) const override;
};

} // namespace program

#endif
