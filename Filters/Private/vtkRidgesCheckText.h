// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesCheckText_h
#define vtkRidgesCheckText_h

#include "Core/Coherence/CoherenceCheck.h"

#include <string>

/**
 * The words for a check of coherence, private to the module.
 */
class vtkRidgesCheckText
{
public:
  explicit vtkRidgesCheckText(const ridges::CoherenceCheck& check);

  std::string name;
  std::string section; ///< Of RR-5294.
  std::string expected;
  std::string found;
};

#endif
