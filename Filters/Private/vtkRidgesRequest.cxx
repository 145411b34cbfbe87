// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesRequest.h"

#include "vtkDataObject.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"

#include <cmath>
#include <string>

vtkPolyData* vtkRidgesGetPolyData(vtkAlgorithm* filter, vtkInformationVector* input)
{
  vtkDataObject* object = vtkDataObject::GetData(input);
  auto* polyData = vtkPolyData::SafeDownCast(object);
  if (!polyData)
  {
    vtkErrorWithObjectMacro(filter,
      "A block of the input is a " << (object ? object->GetClassName() : "null pointer")
                                   << ", not a vtkPolyData.");
  }
  return polyData;
}

bool vtkRidgesAreNumbers(
  vtkAlgorithm* filter, std::initializer_list<std::pair<const char*, double>> properties)
{
  std::string wrong;
  for (const auto& [name, value] : properties)
  {
    if (std::isnan(value))
    {
      wrong += (wrong.empty() ? "" : ", ") + std::string(name);
    }
  }
  if (!wrong.empty())
  {
    vtkErrorWithObjectMacro(filter, "These properties are not numbers: " << wrong << ".");
  }
  return wrong.empty();
}

std::string vtkRidgesBareText(const char* message)
{
  std::string text = message;
  const std::size_t object = text.find("): ");
  text.erase(0, object == std::string::npos ? 0 : object + 3);
  text.erase(text.find_last_not_of(" \n") + 1);
  return text;
}
