# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
include("${CMAKE_CURRENT_LIST_DIR}/RunProgram.cmake")

# A picture without fault, also strictly.
run(0 --surface ellipsoid --frequency 20 --no-picture --check --strict)
expect("${output}" "checks +section +result +found\n  index sum +8\\.2 +passed +2\n"
  "ridges at umbilics +3 +passed" "crossings +5\\.2\\.2 +passed" "seconds [^\n]+ checks [0-9.]+")
if (output MATCHES "failed")
  message(SEND_ERROR "a check fails:\n${output}")
endif ()

# Without being asked it checks nothing.
run(0 --surface ellipsoid --frequency 20 --no-picture)
if (output MATCHES "passed")
  message(SEND_ERROR "it checks without --check:\n${output}")
endif ()

# Far too coarse a mesh: the place is printed, but it fails no check, strictly or not.
set(coarse --surface blend --frequency 3 --no-picture --check)
run(0 ${coarse})
expect("${output}"
  "patch contours +6\\.3, 2\\.2\\(c\\) +uncertain  [^\n]+\n +expected: 1 or 3 [^\n]+\n"
  "\n +umbilic [0-9, ]+ : at [-0-9.e]+ [-0-9.e]+ [-0-9.e]+\n" "uncertain: noise or a coarse mesh")
run(0 ${coarse} --strict --quiet)
if (NOT "${output}${errors}" STREQUAL "")
  message(SEND_ERROR "--quiet prints:\n${output}${errors}")
endif ()
expect_files(ridges-ridges.vtp ridges-umbilics.vtp)

# What the filter leaves out was there to be checked.
run(0 --surface ellipsoid --frequency 20 --no-picture --check --strict --keep blue)
