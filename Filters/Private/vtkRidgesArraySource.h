// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesArraySource_h
#define vtkRidgesArraySource_h

#include "vtkDataArray.h"
#include "vtkFieldData.h"

#include <string>

/**
 * Where arrays come from that a filter needs, private to the module.
 */
class vtkRidgesArraySource
{
public:
  const char* name;     ///< Of the input, for messages.
  vtkFieldData* arrays; ///< Its point, cell or field data.
  vtkIdType tuples;     ///< That each array has at least.

  /// Null, and its name added to those of the faults, if an array is missing or of another shape.
  vtkDataArray* Fetch(const char* array, std::string& faults, int components = 1) const
  {
    vtkDataArray* found = this->arrays->GetArray(array);
    const bool good = found && found->GetNumberOfComponents() == components &&
      found->GetNumberOfTuples() >= this->tuples;
    if (!good)
    {
      faults += (faults.empty() ? "" : ", ") + std::string(array) + " of " + this->name;
    }
    return good ? found : nullptr;
  }
};

/// A value of an array of ids or small numbers; -1 for what cannot be one.
inline vtkIdType vtkRidgesIdAt(vtkDataArray* array, vtkIdType tuple)
{
  // Beyond this a double does not hold every number.
  constexpr double end = 9007199254740992.0;
  const double value = array->GetComponent(tuple, 0);
  return value >= 0.0 && value < end ? static_cast<vtkIdType>(value) : -1;
}

#endif
