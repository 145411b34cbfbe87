# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
include("${CMAKE_CURRENT_LIST_DIR}/RunProgram.cmake")

# Without a display the program says so before the job, instead of aborting. Where VTK does not
# draw through X it needs none, and draws.
set(display "$ENV{DISPLAY}")
unset(ENV{DISPLAY})
execute_process(
  COMMAND "${PROGRAM}" --frequency 8 --picture-size 100x100
  WORKING_DIRECTORY "${DIRECTORY}"
  RESULT_VARIABLE code
  ERROR_VARIABLE errors)
if (code EQUAL 1)
  expect("${errors}" "^vtkridges: there is no X display [^\n]* : [^\n]*--no-picture\n$")
  expect_files()
  if (XVFB_RUN)
    set(LAUNCHER "${XVFB_RUN}" -a -s "-screen 0 1280x1024x24 -noreset")
  elseif (NOT display STREQUAL "")
    set(ENV{DISPLAY} "${display}")
  else ()
    message("Skipped: neither xvfb-run nor a display is there")
    return ()
  endif ()
elseif (NOT code EQUAL 0)
  message(FATAL_ERROR "exit code ${code} without a display:\n${errors}")
endif ()

run(0 --frequency 20 --output picture --picture-size 400x300 --view 1,-1,0.5 --up 0,0,1)
expect("${output}" "picture [0-9.]+" "picture.png\n$")
expect_files(picture-ridges.vtp picture-umbilics.vtp picture.png)

# A blank picture of this size takes about 1 kB; shades, lines and letters take more.
file(SIZE "${DIRECTORY}/picture.png" size)
if (size LESS 8000)
  message(SEND_ERROR "the picture takes ${size} bytes: it is blank")
endif ()
# The size stands in the header, in hexadecimal.
file(READ "${DIRECTORY}/picture.png" header LIMIT 24 HEX)
expect("${header}" "^89504e470d0a1a0a0000000d49484452000001900000012c$")
