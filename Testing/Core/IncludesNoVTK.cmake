# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
file(GLOB_RECURSE files "${DIRECTORY}/*.h" "${DIRECTORY}/*.cxx")
if (NOT files)
  message(SEND_ERROR "no sources in ${DIRECTORY}")
endif ()
foreach (file IN LISTS files)
  file(STRINGS "${file}" includes REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"](.*/)?vtk")
  foreach (include IN LISTS includes)
    message(SEND_ERROR "${file}: ${include}")
  endforeach ()
endforeach ()
