# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
include("${CMAKE_CURRENT_LIST_DIR}/RunProgram.cmake")

# The blend, whose umbilics are known. At the default frequency its index sum is exact.
run(0 --no-picture)
expect("${output}"
  "39692 points, 79380 triangles, closed"
  "umbilics \\+1/2: 6, -1/2: 2\n +index sum 2 = Euler characteristic"
  "maximum, elliptic +blue" "maximum, hyperbolic +green" "minimum, elliptic +red"
  "minimum, hyperbolic +yellow" "crest lines"
  "seconds +read [0-9.]+, jet fitting [0-9.]+, umbilics [0-9.]+, ridges [0-9.]+, filter [0-9.]+"
  "written +ridges-ridges.vtp\n +ridges-umbilics.vtp\n$")
if (NOT errors STREQUAL "")
  message(SEND_ERROR "there are messages:\n${errors}")
endif ()
expect_files(ridges-ridges.vtp ridges-umbilics.vtp)
file(REMOVE "${DIRECTORY}/ridges-ridges.vtp" "${DIRECTORY}/ridges-umbilics.vtp")

# The ellipsoid, quietly, with the mesh, into a directory.
file(MAKE_DIRECTORY "${DIRECTORY}/to")
run(0 --surface ellipsoid --frequency 20 --no-picture --write-mesh --quiet --threads 2 --output to)
if (NOT "${output}${errors}" STREQUAL "")
  message(SEND_ERROR "--quiet prints:\n${output}${errors}")
endif ()
file(READ "${DIRECTORY}/to/ridges-mesh.vtp" mesh)
expect("${mesh}" "MaximumCurvature" "FitStatus" "UmbilicPatch" "UmbilicIndexSum")
file(READ "${DIRECTORY}/to/ridges-ridges.vtp" ridges)
expect("${ridges}" "RidgeType" "Sharpness")
file(READ "${DIRECTORY}/to/ridges-umbilics.vtp" umbilics)
expect("${umbilics}" "NumberOfPoints=\"4\"" "RidgeCount")

# What it wrote it reads again, and the options reach the filters.
run(0 to/ridges-mesh.vtp --no-picture --extract maximum --keep blue --output again)
expect("${output}" "4002 points, 8000 triangles, closed" "umbilics \\+1/2: 4, -1/2: 0"
  "minimum, elliptic +red +0 " "maximum, hyperbolic +green +0 ")

# Degraded points and the border are told, and warnings come in one line.
file(WRITE "${DIRECTORY}/two.off" "OFF 4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n3 0 1 2\n3 2 1 3\n")
run(0 two.off --no-picture)
expect("${output}" "with a border of 4 edges" "degraded points 4 on the border")
expect("${errors}" "^vtkridges: warning, [^\n]+ : [^\n]+\n$")
