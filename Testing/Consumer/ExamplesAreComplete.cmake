# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Every public class of DIRECTORY/Filters is used in some example, and the site lists all of them.
file(READ "${DIRECTORY}/Filters/Documentation/Examples.dox" listed)
file(GLOB examples RELATIVE "${DIRECTORY}/Examples"
  "${DIRECTORY}/Examples/Cxx/*.cxx" "${DIRECTORY}/Examples/Python/*.py")
set(text)
foreach (example IN LISTS examples)
  file(READ "${DIRECTORY}/Examples/${example}" content)
  string(APPEND text "${content}\n")
  string(FIND "${listed}" "@example ${example} " place)
  if (place EQUAL -1)
    message(SEND_ERROR "Examples.dox does not list ${example}")
  endif ()
endforeach ()
file(GLOB headers "${DIRECTORY}/Filters/vtk*.h")
list(LENGTH headers count)
if (count LESS 15)
  message(SEND_ERROR "only ${count} headers found in ${DIRECTORY}/Filters")
endif ()
foreach (header IN LISTS headers)
  get_filename_component(class "${header}" NAME_WE)
  # The superclass of two others, constants, what all headers include, and what filters of
  # VTK::FiltersParallelRidges are based on.
  if (class MATCHES "^(vtkCertificationAlgorithm|vtkRidgesArrayNames|vtkRidgesCompatibility|vtkRidgesRanks)$")
    continue ()
  endif ()
  if (NOT text MATCHES "[^A-Za-z]${class}[^A-Za-z]")
    message(SEND_ERROR "no example uses ${class}")
  endif ()
endforeach ()
