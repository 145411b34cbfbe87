// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesArrayReader.h"

#include "Core/Base/Finite.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <sstream>

namespace
{

struct CopyAsDoubles
{
  template <typename Array>
  void operator()(Array* array, double* copy) const
  {
    const auto values = vtk::DataArrayValueRange(array);
    vtkSMPTools::For(0, values.size(),
      [&values, copy](vtkIdType begin, vtkIdType end)
      {
        std::transform(values.begin() + begin, values.begin() + end, copy + begin,
          [](auto value) { return static_cast<double>(value); });
      });
  }
};

/// False for NaN, fractions, and what is out of range, however huge.
bool IsIdIn(double value, vtkIdType least, vtkIdType end)
{
  return value >= static_cast<double>(least) && value < static_cast<double>(end) &&
    value == std::floor(value);
}

/// Copies values as ids, unless `copy` is null, and finds the first one that is out of range: the
/// number of values if there is none.
struct CheckIds
{
  template <typename Array>
  void operator()(
    Array* array, vtkIdType least, vtkIdType end, vtkIdType* copy, vtkIdType& firstWrong) const
  {
    const auto values = vtk::DataArrayValueRange<1>(array);
    std::atomic<bool> good(true);
    vtkSMPTools::For(0, values.size(),
      [&values, least, end, copy, &good](vtkIdType first, vtkIdType last)
      {
        bool allGood = true;
        for (vtkIdType i = first; i < last; ++i)
        {
          const auto value = static_cast<double>(values[i]);
          const bool isGood = IsIdIn(value, least, end);
          allGood = allGood && isGood;
          if (copy)
          {
            copy[i] = isGood ? static_cast<vtkIdType>(value) : least;
          }
        }
        if (!allGood)
        {
          good = false;
        }
      });
    firstWrong = values.size();
    if (!good)
    {
      const auto wrong = std::find_if(values.begin(), values.end(),
        [least, end](auto value) { return !IsIdIn(static_cast<double>(value), least, end); });
      firstWrong = static_cast<vtkIdType>(wrong - values.begin());
    }
  }
};

/// Runs a worker on an array of any of VTK's usual types and storages.
template <typename Worker, typename... Arguments>
bool Dispatch(vtkDataArray* array, const Worker& worker, Arguments&&... arguments)
{
  return vtkArrayDispatch::Dispatch::Execute(array, worker, std::forward<Arguments>(arguments)...);
}

/// The values themselves where the array stores them as T, one after the other.
template <typename T>
T* StoredValues(vtkDataArray* array)
{
  auto* exact = vtkArrayDownCast<vtkAOSDataArrayTemplate<T>>(array);
  return exact ? exact->GetPointer(0) : nullptr;
}

/// An array that no dispatch knows, such as one of bits or an implicit one, tuple by tuple.
void CopyTuples(vtkDataArray* array, double* copy)
{
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->GetTuple(i, copy + i * array->GetNumberOfComponents());
  }
}

std::string ListOf(const std::vector<std::string>& texts)
{
  std::string list;
  for (const std::string& text : texts)
  {
    list += (list.empty() ? "" : "; ") + text;
  }
  return list;
}

} // namespace

const double* vtkRidgesDoubles(vtkDataArray* array, std::vector<double>& copy)
{
  if (const double* stored = StoredValues<double>(array))
  {
    return stored;
  }
  copy.resize(static_cast<std::size_t>(array->GetNumberOfValues()));
  if (!Dispatch(array, CopyAsDoubles{}, copy.data()))
  {
    CopyTuples(array, copy.data());
  }
  return copy.data();
}

vtkDataArray* vtkRidgesArrayReader::Find(
  const Source& source, const char* name, int components, Presence presence)
{
  vtkAbstractArray* any = source.data->GetAbstractArray(name);
  if (!any)
  {
    if (presence == Presence::Required)
    {
      this->AddMissing(source, name);
    }
    return nullptr;
  }
  auto* array = vtkArrayDownCast<vtkDataArray>(any);
  std::ostringstream fault;
  if (!array)
  {
    fault << name << " is a " << any->GetClassName() << ", not an array of numbers";
  }
  else if (array->GetNumberOfComponents() != components)
  {
    fault << name << " has " << array->GetNumberOfComponents() << " components, not " << components;
  }
  else if (array->GetNumberOfTuples() != source.tuples)
  {
    fault << name << " has " << array->GetNumberOfTuples() << " tuples, not " << source.tuples;
  }
  else
  {
    return array;
  }
  this->AddFault(fault.str());
  return nullptr;
}

const double* vtkRidgesArrayReader::Doubles(
  const Source& source, const char* name, int components, Presence presence)
{
  vtkDataArray* array = this->Find(source, name, components, presence);
  if (!array)
  {
    return nullptr;
  }
  this->DoubleCopies.emplace_back();
  return vtkRidgesDoubles(array, this->DoubleCopies.back());
}

const double* vtkRidgesArrayReader::FiniteDoubles(
  const Source& source, const char* name, int components, Presence presence)
{
  const double* values = this->Doubles(source, name, components, presence);
  const double* end = values ? values + components * source.tuples : nullptr;
  if (!values || ridges::AllFinite(values, end))
  {
    return values;
  }
  const double* wrong =
    std::find_if(values, end, [](double value) { return !std::isfinite(value); });
  std::ostringstream fault;
  fault << name << " is not finite in tuple " << (wrong - values) / components;
  this->AddFault(fault.str());
  return nullptr;
}

const vtkIdType* vtkRidgesArrayReader::Ids(
  const Source& source, const char* name, vtkIdType least, vtkIdType end, Presence presence)
{
  vtkDataArray* array = this->Find(source, name, 1, presence);
  if (!array)
  {
    return nullptr;
  }
  const vtkIdType* values = StoredValues<vtkIdType>(array);
  vtkIdType* copy = nullptr;
  if (!values)
  {
    this->IdCopies.emplace_back(static_cast<std::size_t>(source.tuples));
    copy = this->IdCopies.back().data();
    values = copy;
  }
  vtkIdType firstWrong = source.tuples;
  if (!Dispatch(array, CheckIds{}, least, end, copy, firstWrong))
  {
    std::vector<double> tuples(static_cast<std::size_t>(source.tuples));
    CopyTuples(array, tuples.data());
    const auto isWrong = [least, end](double value) { return !IsIdIn(value, least, end); };
    firstWrong = std::find_if(tuples.begin(), tuples.end(), isWrong) - tuples.begin();
    std::copy_n(tuples.begin(), firstWrong, copy);
  }
  if (firstWrong < source.tuples)
  {
    std::ostringstream fault;
    fault << name << " is " << array->GetComponent(firstWrong, 0) << " in tuple " << firstWrong
          << ", not an integer from " << least << " to " << end - 1;
    this->AddFault(fault.str());
    return nullptr;
  }
  return values;
}

void vtkRidgesArrayReader::CheckLines(vtkPolyData* data)
{
  const vtkIdType numberOfPoints = data->GetNumberOfPoints();
  const auto line = vtk::TakeSmartPointer(data->GetLines()->NewIterator());
  for (line->GoToFirstCell(); !line->IsDoneWithTraversal(); line->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    line->GetCurrentCell(size, ids);
    const vtkIdType* wrong = std::find_if(
      ids, ids + size, [numberOfPoints](vtkIdType p) { return p < 0 || p >= numberOfPoints; });
    if (wrong != ids + size)
    {
      std::ostringstream fault;
      fault << "line " << line->GetCurrentCellId() << " has point " << *wrong << " of "
            << numberOfPoints;
      this->AddFault(fault.str());
      return;
    }
  }
}

void vtkRidgesArrayReader::AddMissing(const Source& source, const std::string& name)
{
  const auto list = std::find_if(this->Missing.begin(), this->Missing.end(),
    [&source](const auto& missing) { return missing.first == source.name; });
  if (list == this->Missing.end())
  {
    this->Missing.emplace_back(source.name, name);
  }
  else
  {
    list->second += ", " + name;
  }
}

void vtkRidgesArrayReader::AddFault(const std::string& fault)
{
  this->Faults.push_back(fault);
}

std::string vtkRidgesArrayReader::GetFaults() const
{
  std::vector<std::string> texts;
  for (const auto& [source, names] : this->Missing)
  {
    texts.push_back(source);
    texts.back().append(" lacks ").append(names);
  }
  texts.insert(texts.end(), this->Faults.begin(), this->Faults.end());
  return ListOf(texts);
}
