// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesArrayMessages.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <cstring>
#include <string>
#include <vector>

namespace
{

std::string NameOf(vtkAbstractArray* array)
{
  return array->GetName() ? array->GetName() : "";
}

void PackStrings(ridges::Bytes& message, vtkStringArray* strings)
{
  for (vtkIdType i = 0; i < strings->GetNumberOfValues(); ++i)
  {
    ridges::PackText(message, strings->GetValue(i));
  }
}

void PackNumbers(ridges::Bytes& message, vtkDataArray* numbers)
{
  const int width = numbers->GetNumberOfComponents();
  for (int i = 0; i < width; ++i)
  {
    const char* name = numbers->GetComponentName(i);
    ridges::PackText(message, name ? name : "");
  }
  const auto size = static_cast<std::size_t>(numbers->GetNumberOfValues()) *
    static_cast<std::size_t>(numbers->GetDataTypeSize());
  std::vector<char> values(size);
  if (size > 0)
  {
    std::memcpy(values.data(), numbers->GetVoidPointer(0), size);
  }
  ridges::Pack(message, values);
}

vtkSmartPointer<vtkAbstractArray> TakeStrings(
  ridges::Unpacker& message, vtkIdType tuples, int width)
{
  auto strings = vtkSmartPointer<vtkStringArray>::New();
  strings->SetNumberOfComponents(width);
  strings->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < strings->GetNumberOfValues(); ++i)
  {
    strings->SetValue(i, message.TakeText());
  }
  return strings;
}

vtkSmartPointer<vtkAbstractArray> TakeNumbers(
  ridges::Unpacker& message, int type, vtkIdType tuples, int width)
{
  auto numbers = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  numbers->SetNumberOfComponents(width);
  numbers->SetNumberOfTuples(tuples);
  for (int i = 0; i < width; ++i)
  {
    const std::string name = message.TakeText();
    if (!name.empty())
    {
      numbers->SetComponentName(i, name.c_str());
    }
  }
  const std::vector<char> values = message.Take<char>();
  if (!values.empty())
  {
    std::memcpy(numbers->GetVoidPointer(0), values.data(), values.size());
  }
  return numbers;
}

} // namespace

void vtkRidgesPackArrays(ridges::Bytes& message, vtkFieldData* arrays)
{
  std::vector<vtkAbstractArray*> sent;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    const bool isString = vtkStringArray::SafeDownCast(array) != nullptr;
    if (isString || (vtkDataArray::SafeDownCast(array) && array->GetDataTypeSize() > 0))
    {
      sent.push_back(array);
    }
  }
  ridges::Pack(message, std::vector<std::int64_t>{ static_cast<std::int64_t>(sent.size()) });
  for (vtkAbstractArray* array : sent)
  {
    ridges::PackText(message, NameOf(array));
    ridges::Pack(message,
      std::vector<std::int64_t>{
        array->GetDataType(), array->GetNumberOfTuples(), array->GetNumberOfComponents() });
    if (auto* strings = vtkStringArray::SafeDownCast(array))
    {
      PackStrings(message, strings);
    }
    else
    {
      PackNumbers(message, vtkDataArray::SafeDownCast(array));
    }
  }
}

void vtkRidgesTakeArrays(ridges::Unpacker& message, vtkFieldData* arrays)
{
  const std::vector<std::int64_t> count = message.Take<std::int64_t>();
  for (std::int64_t i = 0; !count.empty() && i < count.front(); ++i)
  {
    const std::string name = message.TakeText();
    const std::vector<std::int64_t> shape = message.Take<std::int64_t>();
    const auto type = static_cast<int>(shape[0]);
    const auto width = static_cast<int>(shape[2]);
    const auto array = type == VTK_STRING ? TakeStrings(message, shape[1], width)
                                          : TakeNumbers(message, type, shape[1], width);
    array->SetName(name.c_str());
    arrays->AddArray(array);
  }
}
