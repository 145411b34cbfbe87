# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# For the tests beside: runs the program and says what is wrong with its answer.

file(REMOVE_RECURSE "${DIRECTORY}")
file(MAKE_DIRECTORY "${DIRECTORY}")

# run(<exit code> [<argument>...]) sets `output` and `errors`. LAUNCHER is put before the program.
macro (run expected_code)
  execute_process(
    COMMAND ${LAUNCHER} "${PROGRAM}" ${ARGN}
    WORKING_DIRECTORY "${DIRECTORY}"
    RESULT_VARIABLE code
    OUTPUT_VARIABLE output
    ERROR_VARIABLE errors)
  if (NOT "${code}" STREQUAL "${expected_code}")
    message(SEND_ERROR
      "vtkridges ${ARGN}: exit code ${code} instead of ${expected_code}\n${output}${errors}")
  endif ()
endmacro ()

# expect(<text> <regular expression>...)
function (expect text)
  foreach (expression IN LISTS ARGN)
    if (NOT text MATCHES "${expression}")
      message(SEND_ERROR "'${expression}' is missing in:\n${text}")
    endif ()
  endforeach ()
endfunction ()

# Fails with one line of the form "vtkridges: <what> : <what to do>", and prints nothing else.
function (expect_failure expected_code expression)
  run(${expected_code} ${ARGN})
  expect("${errors}" "^vtkridges: [^\n]+ : [^\n]+\n$" "${expression}")
  if (NOT output STREQUAL "")
    message(SEND_ERROR "vtkridges ${ARGN} failed but printed\n${output}")
  endif ()
endfunction ()

# expect_same_lines(<output> <expected>): ridges and umbilics in the files of two outputs.
function (expect_same_lines output expected)
  foreach (kind IN ITEMS ridges umbilics)
    file(SHA256 "${DIRECTORY}/${output}-${kind}.vtp" found)
    file(SHA256 "${DIRECTORY}/${expected}-${kind}.vtp" wanted)
    if (NOT found STREQUAL wanted)
      message(SEND_ERROR "${output}-${kind}.vtp is not what is in ${expected}-${kind}.vtp")
    endif ()
  endforeach ()
endfunction ()

# expect_files([<name>...]): these are in the directory, and nothing else.
function (expect_files)
  file(GLOB found RELATIVE "${DIRECTORY}" "${DIRECTORY}/*")
  list(SORT found)
  if (NOT "${found}" STREQUAL "${ARGN}")
    message(SEND_ERROR "there is '${found}' instead of '${ARGN}'")
  endif ()
endfunction ()
