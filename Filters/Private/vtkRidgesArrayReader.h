// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesArrayReader_h
#define vtkRidgesArrayReader_h

#include "vtkRidgesCompatibility.h"

#include "vtkType.h"

#include <deque>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkFieldData;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/// The values of an array as doubles, tuple after tuple: its own memory where it stores just that,
/// else a copy.
const double* vtkRidgesDoubles(vtkDataArray* array, std::vector<double>& copy);

/**
 * Reads data arrays, whatever their type and storage, and checks each: that it is there, holds
 * numbers, and has the right number of components and tuples. What is wrong with all of them
 * becomes one text. Values stay valid as long as the reader and the arrays. Private to the module.
 */
class vtkRidgesArrayReader
{
public:
  /// Where arrays are looked for.
  struct Source
  {
    vtkFieldData* data; ///< Point, cell or field data.
    vtkIdType tuples;   ///< The number that each array must have.
    const char* name;   ///< In messages: "the point data of the mesh".
  };

  /// Whether it is a fault if there is no such array.
  enum class Presence
  {
    Required,
    Optional
  };

  /// Null, and a fault if it is one, where the array is missing or wrong.
  vtkDataArray* Find(const Source& source, const char* name, int components = 1,
    Presence presence = Presence::Required);

  /// Any values; the caller deals with those that are not finite.
  const double* Doubles(const Source& source, const char* name, int components = 1,
    Presence presence = Presence::Required);

  /// A value that is not finite is a fault.
  const double* FiniteDoubles(const Source& source, const char* name, int components = 1,
    Presence presence = Presence::Required);

  /// Integers in [least, end), of any numeric type; another value is a fault.
  const vtkIdType* Ids(const Source& source, const char* name, vtkIdType least, vtkIdType end,
    Presence presence = Presence::Required);

  /// Notes a line of the data set that names a point which is not there.
  void CheckLines(vtkPolyData* data);

  /// Notes that an array is missing, by a name of the caller's choice.
  void AddMissing(const Source& source, const std::string& name);

  /// Notes any other fault.
  void AddFault(const std::string& fault);

  /// All faults as one text without a full stop; empty if there are none.
  std::string GetFaults() const;

private:
  std::deque<std::vector<double>> DoubleCopies; ///< A deque, as values must not move.
  std::deque<std::vector<vtkIdType>> IdCopies;
  std::vector<std::pair<std::string, std::string>> Missing; ///< Source, and names of arrays.
  std::vector<std::string> Faults;
};

#endif
