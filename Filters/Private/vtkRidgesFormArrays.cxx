// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesFormArrays.h"

#include "vtkRidgesAllocate.h"
#include "vtkRidgesArrayNames.h"

#include "vtkPointData.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>

namespace names = vtkRidgesArrayNames;

namespace
{

/// The rows of an array, one after the other, as bytes, which are aligned to nothing. What comes
/// after them.
template <typename T>
char* Packed(const T* values, int width, const std::vector<ridges::Id>& rows, char* to)
{
  const std::size_t size = sizeof(T) * width;
  for (const ridges::Id row : rows)
  {
    std::memcpy(to, values + static_cast<std::size_t>(width) * row, size);
    to += size;
  }
  return to;
}

template <typename T>
const char* Unpacked(const char* from, int width, const std::vector<ridges::Id>& rows, T* values)
{
  const std::size_t size = sizeof(T) * width;
  for (const ridges::Id row : rows)
  {
    std::memcpy(values + static_cast<std::size_t>(width) * row, from, size);
    from += size;
  }
  return from;
}

} // namespace

void vtkRidgesFormArrays::StoreAll(
  const vtkRidgesFormArrays& others, const std::vector<ridges::Id>& ids)
{
  for (std::size_t k = 0; k < this->Arrays.size(); ++k)
  {
    const vtkIdType components = this->Arrays[k]->GetNumberOfComponents();
    const double* from = others.Arrays[k]->GetPointer(0);
    double* values = this->Arrays[k]->GetPointer(0);
    for (const ridges::Id id : ids)
    {
      std::copy_n(from, components, values + components * id);
      from += components;
    }
  }
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    this->Status[ids[i]] = others.Status[i];
  }
}

void vtkRidgesFormArrays::PackRows(ridges::Bytes& bytes, const std::vector<ridges::Id>& rows) const
{
  std::size_t size = sizeof(int);
  for (const auto& array : this->Arrays)
  {
    size += sizeof(double) * array->GetNumberOfComponents();
  }
  const std::size_t before = bytes.size();
  bytes.resize(before + size * rows.size());
  char* to = bytes.data() + before;
  for (const auto& array : this->Arrays)
  {
    to = Packed(array->GetPointer(0), array->GetNumberOfComponents(), rows, to);
  }
  Packed(this->Status, 1, rows, to);
}

void vtkRidgesFormArrays::StoreRows(const char* packed, const std::vector<ridges::Id>& ids)
{
  for (const auto& array : this->Arrays)
  {
    packed = Unpacked(packed, array->GetNumberOfComponents(), ids, array->GetPointer(0));
  }
  Unpacked(packed, 1, ids, this->Status);
}

void vtkRidgesFormArrays::AddTo(vtkPointData* pointData)
{
  for (const char* name : { names::Normals, names::MaximumCurvature, names::MinimumCurvature,
         names::MaximumDirection, names::MinimumDirection, names::ThirdOrder, names::FourthOrder,
         names::P1, names::P2, names::MaximumCurvatureError, names::MinimumCurvatureError,
         names::ThirdOrderError, names::P1Error, names::P2Error, names::FitNoiseGain })
  {
    pointData->RemoveArray(name);
  }
  for (const auto& array : this->Arrays)
  {
    pointData->AddArray(array);
  }
  pointData->AddArray(this->StatusArray);
  pointData->SetActiveNormals(names::Normals);
}

void vtkRidgesFormArrays::Add(
  double*& values, const char* name, int components, bool wanted, const char* componentPrefix)
{
  values = nullptr;
  if (!wanted)
  {
    return;
  }
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (int i = 0; componentPrefix && i < components; ++i)
  {
    array->SetComponentName(i, (componentPrefix + std::to_string(i)).c_str());
  }
  this->Arrays.emplace_back(array);
  this->Values.push_back(&values);
}

void vtkRidgesFormArrays::Allocate(vtkIdType count)
{
  this->StatusArray->SetName(names::FitStatus);
  std::vector<vtkDataArray*> arrays(this->Arrays.begin(), this->Arrays.end());
  arrays.push_back(this->StatusArray);
  vtkRidgesAllocate(arrays, count);
  for (std::size_t i = 0; i < this->Arrays.size(); ++i)
  {
    *this->Values[i] = this->Arrays[i]->GetPointer(0);
  }
  this->Status = this->StatusArray->GetPointer(0);
}
