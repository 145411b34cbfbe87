// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesOffenderText_h
#define vtkRidgesOffenderText_h

#include <cstddef>
#include <string>

/// The texts of the first 20 offenders of a check, of `count`. Private to the module.
template <typename TextOf>
std::string vtkRidgesOffenderText(std::size_t count, const TextOf& textOf)
{
  constexpr std::size_t mostTold = 20;
  std::string text;
  for (std::size_t i = 0; i < count && i < mostTold; ++i)
  {
    text += (i == 0 ? "" : ", ") + textOf(i);
  }
  return text + (count > mostTold ? ", ..." : "");
}

#endif
