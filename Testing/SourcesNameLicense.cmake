# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# Lists the sources, scripts and CMake files under DIRECTORY that do not begin with both SPDX lines.
set(patterns "*.h" "*.cxx" "*.h.in" "*.py" "*.py.in" "*.sh" "*.cmake" "*.cmake.in" "*.module"
  "*.plugin" "CMakeLists.txt")
set(files "${DIRECTORY}/CMakeLists.txt" "${DIRECTORY}/vtk.module")
file(GLOB scripts "${DIRECTORY}/.ci/*")
list(APPEND files ${scripts})
foreach (folder Examples Filters Testing Wrapping)
  foreach (pattern IN LISTS patterns)
    file(GLOB_RECURSE found "${DIRECTORY}/${folder}/${pattern}")
    list(APPEND files ${found})
  endforeach ()
endforeach ()
list(LENGTH files count)
if (count LESS 300)
  message(SEND_ERROR "only ${count} files found in ${DIRECTORY}")
endif ()
foreach (file IN LISTS files)
  file(STRINGS "${file}" lines LIMIT_COUNT 3)
  if (NOT lines MATCHES "SPDX-FileCopyrightText: Copyright \\(c\\) vtkRidges contributors;"
      OR NOT lines MATCHES "SPDX-License-Identifier: BSD-3-Clause")
    message(SEND_ERROR "${file} does not begin with the two SPDX lines")
  endif ()
endforeach ()
