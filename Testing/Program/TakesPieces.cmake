# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# What the program does with --pieces: what it does with the whole mesh.
include("${CMAKE_CURRENT_LIST_DIR}/RunProgram.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/PieceFiles.cmake")

set(report "256 points, 450 triangles, with a border of 60 edges")
run(0 pieces.pvtp --complete --no-picture --output whole)
expect("${output}" ${report})
foreach (number IN ITEMS 2 3 5)
  run(0 pieces.pvtp --pieces ${number} --output parts)
  expect("${output}" ${report} "all ridges, as always in pieces .${number} here"
    "written +parts-ridges.vtp\n +parts-umbilics.vtp\n$")
  expect_same_lines(parts whole)
endforeach ()

expect_failure(2 "--pieces needs a MESH that is in pieces" a.vtp --pieces 3)
expect_failure(2 "--salient does not work with --pieces" pieces.pvtp --pieces 3 --salient)
expect_failure(2 "--write-mesh does not work with --pieces" pieces.pvtp --pieces 3 --write-mesh)
expect_failure(2 "--orient does not work with --pieces" pieces.pvtp --pieces 3 --orient)
file(WRITE "${DIRECTORY}/b.vtp" "junk\n")
expect_failure(1 "b.vtp" pieces.pvtp --pieces 3)
file(REMOVE "${DIRECTORY}/b.vtp")
expect_failure(1 "b.vtp does not exist" pieces.pvtp --pieces 3)
