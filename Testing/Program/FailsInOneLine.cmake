# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
include("${CMAKE_CURRENT_LIST_DIR}/RunProgram.cmake")

# Meshes that cannot be read
expect_failure(1 "missing.off does not exist" missing.off --no-picture)
expect_failure(1 "is a directory" "${DIRECTORY}" --no-picture)
foreach (extension IN ITEMS off obj ply stl vtk vtp txt)
  file(WRITE "${DIRECTORY}/junk.${extension}" "junk\n")
  expect_failure(1 "junk.${extension}" junk.${extension} --no-picture)
  file(REMOVE "${DIRECTORY}/junk.${extension}")
endforeach ()
file(WRITE "${DIRECTORY}/mesh.off" "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")
expect_failure(1 "mesh.off, line 6: there is no vertex 7" mesh.off --no-picture)
file(WRITE "${DIRECTORY}/mesh.off" "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n")
expect_failure(1 "mesh.off has no triangles" mesh.off --no-picture)
file(REMOVE "${DIRECTORY}/mesh.off")

# Meshes on which nothing can be found
file(WRITE "${DIRECTORY}/mesh.off" "OFF 4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n3 0 1 2\n3 2 1 3\n")
expect_failure(1 "no polynomial can be fitted at any of the 4 points: [^\n]* in 2 triangles"
  mesh.off --no-picture)
file(WRITE "${DIRECTORY}/mesh.off" "OFF 3 2 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n3 1 1 0\n")
expect_failure(1 "mesh.off has no face with three different corners at finite places"
  mesh.off --no-picture)
file(REMOVE "${DIRECTORY}/mesh.off")

set(example --frequency 10 --no-picture)

# Files that cannot be written
expect_failure(1 "there is no directory nowhere" ${example} --output nowhere/x)
expect_files()
file(MAKE_DIRECTORY "${DIRECTORY}/x-umbilics.vtp")
expect_failure(1 "x-umbilics.vtp cannot be written" ${example} --output x)
expect_files(x-umbilics.vtp)
file(REMOVE_RECURSE "${DIRECTORY}/x-umbilics.vtp")
if (EXISTS /dev/full)
  file(CREATE_LINK /dev/full "${DIRECTORY}/x-ridges.vtp" SYMBOLIC)
  expect_failure(1 "x-ridges.vtp cannot be written" ${example} --output x)
  file(REMOVE "${DIRECTORY}/x-ridges.vtp")
endif ()
# No file may grow beyond 4 kB, as on a disk that becomes full: none is left, not even a part.
find_program(SHELL sh)
if (SHELL)
  set(LAUNCHER "${SHELL}" -c "ulimit -f 8 && exec \"$0\" \"$@\"")
  expect_failure(1 "x-ridges.vtp cannot be written [(]File too large[)]" ${example} --output x)
  unset(LAUNCHER)
  expect_files()
endif ()
file(WRITE "${DIRECTORY}/x-mesh.vtp" "")
expect_failure(1 "would overwrite the mesh" x-mesh.vtp --no-picture --output x --write-mesh)
file(REMOVE "${DIRECTORY}/x-mesh.vtp")
expect_files()
