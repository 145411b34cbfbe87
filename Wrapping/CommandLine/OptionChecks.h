// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OptionChecks_h
#define OptionChecks_h

#include "Options.h"

#include <CLI/CLI.hpp>

namespace program
{

/// Options that are valid each for itself, but not together.
class Contradiction : public CLI::Error
{
public:
  explicit Contradiction(const std::string& text)
    : CLI::Error("Contradiction", text)
  {
  }
};

/// Throws Contradiction if options exclude each other, or if one has no effect with the others.
/// Sets which lines are wanted if the options say so.
void CheckOptions(const CLI::App& app, Options& options, const Filters& filters);

} // namespace program

#endif
