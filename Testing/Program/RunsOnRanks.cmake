# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# What the program does under mpirun; all ranks and the files that they write together.
include("${CMAKE_CURRENT_LIST_DIR}/RunProgram.cmake")

run(0 --surface ellipsoid --frequency 20 --no-picture --write-mesh --output one)
set(report "4002 points, 8000 triangles, closed" "umbilics \\+1/2: 4, -1/2: 0")
expect("${output}" ${report})

# A file is read by the first rank. There is no picture.
set(LAUNCHER ${MPIRUN} 2)
run(0 one-mesh.vtp --output two)
expect("${output}" ${report} "all ridges, as always on several ranks .2 here")
expect_files(one-mesh.vtp one-ridges.vtp one-umbilics.vtp two-ridges.vtp two-umbilics.vtp)

# The ranks share the pieces, whose seams are no borders, and each writes its own.
include("${CMAKE_CURRENT_LIST_DIR}/PieceFiles.cmake")
set(report "256 points, 450 triangles, with a border of 60 edges" "points [0-9]+ on the border")
run(0 pieces.pvtp --output two --write-mesh)
expect("${output}" ${report} "written +two-ridges.vtp\n +two-umbilics.vtp\n +two-mesh.pvtp\n$")
set(LAUNCHER ${MPIRUN} 4)
run(0 two-mesh.pvtp --output four)
expect("${output}" ${report})
set(LAUNCHER)
run(0 pieces.pvtp --output alone --complete --no-picture)
expect("${output}" ${report})
expect_same_lines(two alone)
expect_same_lines(four alone)

# What does not work is said once, and no rank waits for another: mpirun adds lines of its own.
set(LAUNCHER ${MPIRUN} 2)
foreach (option IN ITEMS --salient --image=x.vti)
  run(2 pieces.pvtp ${option})
  expect("${errors}" "vtkridges: --[a-z-]+ does not work on several ranks .mpirun. : see")
  string(REGEX MATCHALL "vtkridges: " told "${errors}")
  list(LENGTH told count)
  if (NOT count EQUAL 1)
    message(SEND_ERROR "it is told ${count} times:\n${errors}")
  endif ()
endforeach ()
file(REMOVE "${DIRECTORY}/b.vtp")
run(1 pieces.pvtp)
expect("${errors}" "vtkridges: b.vtp does not exist : ")
file(WRITE "${DIRECTORY}/b.vtp" "junk\n")
run(1 pieces.pvtp)
expect("${errors}" "vtkridges: [^\n]*b.vtp[^\n]* : ")
