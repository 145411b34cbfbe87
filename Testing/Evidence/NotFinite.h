// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RIDGES_TESTING_NOT_FINITE_H
#define RIDGES_TESTING_NOT_FINITE_H

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointSet.h"

#include <cmath>
#include <string>

namespace ridges
{
namespace testing
{

inline bool IsFinite(vtkDataArray* array)
{
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int j = 0; j < array->GetNumberOfComponents(); ++j)
    {
      if (!std::isfinite(array->GetComponent(i, j)))
      {
        return false;
      }
    }
  }
  return true;
}

// The names of the coordinates or arrays with a NaN or infinity, each with a space before it.
// Left out are those of the same name as one of other data, which may have been so before.
inline std::string NotFinite(vtkDataObject* data, vtkDataObject* before = nullptr)
{
  std::string names;
  auto* points = vtkPointSet::SafeDownCast(data);
  if (points && points->GetPoints() && !before && !IsFinite(points->GetPoints()->GetData()))
  {
    names += " Points";
  }
  for (int kind = 0; kind < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++kind)
  {
    vtkFieldData* field = data->GetAttributesAsFieldData(kind);
    vtkFieldData* old = before ? before->GetAttributesAsFieldData(kind) : nullptr;
    for (int i = 0; field && i < field->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = field->GetArray(i);
      const char* name = array ? array->GetName() : nullptr;
      if (name && !(old && old->HasArray(name)) && !IsFinite(array))
      {
        names += std::string(" ") + name;
      }
    }
  }
  return names;
}

} // namespace testing
} // namespace ridges

#endif
