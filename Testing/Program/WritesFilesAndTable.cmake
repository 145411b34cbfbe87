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

# write_grid(<file> <corners>): a paraboloid over a grid of 6 x 6 points. The corners are those of
# the second triangle in each cell a b c d, after a: "c;d", or "d;c" to turn it.
function (write_grid name corners)
  foreach (i RANGE 5)
    foreach (j RANGE 5)
      math(EXPR height "${i} * ${i} + 3 * ${j} * ${j}")
      string(APPEND points "${i} ${j} ${height}e-3\n")
    endforeach ()
  endforeach ()
  foreach (i RANGE 4)
    foreach (j RANGE 4)
      math(EXPR a "${i} * 6 + ${j}")
      math(EXPR b "${a} + 6")
      math(EXPR c "${a} + 7")
      math(EXPR d "${a} + 1")
      list(GET corners 0 second)
      list(GET corners 1 third)
      string(APPEND faces "3 ${a} ${b} ${c}\n3 ${a} ${${second}} ${${third}}\n")
    endforeach ()
  endforeach ()
  file(WRITE "${DIRECTORY}/${name}" "OFF 36 50 0\n${points}${faces}")
endfunction ()

# The report counts degraded points and the border, and warnings come in one line.
write_grid(grid.off "c;d")
run(0 grid.off --no-picture)
expect("${output}" "36 points, 50 triangles, with a border of 20 edges"
  "degraded points 20 on the border")
write_grid(turned.off "d;c")
run(0 turned.off --no-picture)
expect("${errors}" "^vtkridges: warning, [^\n]+opposite orientation .add --orient.[^\n]* : [^\n]+\n$")
run(0 turned.off --no-picture --orient)
if (errors MATCHES "orientation")
  message(SEND_ERROR "--orient does not orient:\n${errors}")
endif ()

# Automatic neighbourhoods are reported, and a quiet program is quiet with any number of threads.
run(0 --surface ellipsoid --frequency 12 --no-picture)
expect("${output}" "fit +degree [468] on [2-6] rings, for ")
run(0 --surface ellipsoid --frequency 12 --no-picture --quiet --threads 1000)
if (NOT "${output}${errors}" STREQUAL "")
  message(SEND_ERROR "--quiet prints:\n${output}${errors}")
endif ()
