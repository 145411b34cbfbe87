# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
include("${CMAKE_CURRENT_LIST_DIR}/RunProgram.cmake")

# find(<option>...) sets what the files hold, `umbilics` and `ridges`, and the number of lines.
macro (find)
  run(0 --no-picture ${ARGN})
  file(SHA256 "${DIRECTORY}/ridges-umbilics.vtp" umbilics)
  file(SHA256 "${DIRECTORY}/ridges-ridges.vtp" ridges)
  set(lines 0)
  string(REGEX MATCHALL "(blue|green|red|yellow) +[0-9]+" rows "${output}")
  foreach (row IN LISTS rows)
    string(REGEX REPLACE "[^0-9]+" "" count "${row}")
    math(EXPR lines "${lines} + ${count}")
  endforeach ()
endmacro ()

# expect_that(<condition>...)
macro (expect_that)
  if (NOT (${ARGN}))
    string(REPLACE ";" " " condition "${ARGN}")
    message(SEND_ERROR "it does not hold that ${condition}:\n${output}")
  endif ()
endmacro ()

# Other values than the default change umbilics, or nothing but ridges; the default changes nothing.
set(blend --frequency 12)
find(${blend})
set(default_umbilics "${umbilics}")
set(default_ridges "${ridges}")
set(default_lines "${lines}")

find(${blend} --umbilic-method indices --umbilic-significance 3 --extremality-rule principal
  --umbilic-joining patches --loop-significance 3 --zone-significance 3 --type-hysteresis 0)
expect_that(umbilics STREQUAL default_umbilics AND ridges STREQUAL default_ridges)

find(${blend} --umbilic-method minima)
expect("${output}" "umbilics \\+1/2: 6, -1/2: 2")
expect_that(NOT umbilics STREQUAL default_umbilics) # They have another order.
set(minima "${umbilics}")
find(${blend} --umbilic-method Minima --patch-size 2)
expect_that(umbilics STREQUAL minima)

find(${blend} --umbilic-joining triangles)
expect_that(umbilics STREQUAL default_umbilics AND NOT ridges STREQUAL default_ridges)

find(${blend} --type-hysteresis 1000)
expect_that(umbilics STREQUAL default_umbilics AND lines LESS default_lines)

find(${blend} --extremality-rule gaussian)
expect("${output}" "undecided +grey +[1-9]") # From colour to colour.
expect_that(umbilics STREQUAL default_umbilics)

# On a sphere only errors make umbilics, and no more are left than its topology demands.
set(sphere --surface ellipsoid --semi-axes 1,1,1 --frequency 12)
find(${sphere})
expect("${output}" "umbilics \\+1/2: 4, -1/2: 0")
find(${sphere} --umbilic-significance 0)
expect("${output}" "umbilics \\+1/2: [1-9][0-9]+, -1/2: [1-9]" "index sum 2 = Euler")

# Nor ridges, unless they are wanted.
find(${sphere})
expect_that(lines EQUAL 0)
find(${sphere} --zone-significance 0)
expect_that(lines GREATER 0)

# On what is almost one errors also make loops.
set(almost --neighborhood point-count --surface ellipsoid --semi-axes 1.0001,1,0.9999 --frequency 12 --zone-significance 0)
find(${almost})
set(default_umbilics "${umbilics}")
set(default_lines "${lines}")
find(${almost} --loop-significance 0)
expect_that(umbilics STREQUAL default_umbilics AND lines GREATER default_lines)
