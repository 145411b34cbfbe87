// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesHypotheses_h
#define vtkRidgesHypotheses_h

#include <array>
#include <cstdint>

/**
 * A hypothesis of the certified algorithm (6.5 of RR-5294), in words; private to the module.
 */
struct vtkRidgesHypothesis
{
  const char* name;
  const char* section; ///< Of RR-5294.
  std::uint16_t bit;   ///< In FailedHypotheses.
  const char* expected;
};

/// All of them; row i of a table has bit i.
const std::array<vtkRidgesHypothesis, 12>& vtkRidgesHypotheses();

#endif
