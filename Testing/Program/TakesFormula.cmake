# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
include("${CMAKE_CURRENT_LIST_DIR}/RunProgram.cmake")

set(formula --formula "x^2/1.96 + y^2 + z^2/0.36 - 1")
set(box --bounds -1.5,1.5,-1.1,1.1,-0.7,0.7)

# The four umbilics of an ellipsoid, on the program's own mesh and on that mesh given.
run(0 ${formula} ${box} --edge-length 0.08 --no-picture --output own --write-mesh --check)
expect("${output}" "exact forms [0-9.]+" "umbilics [+]1/2: 4, -1/2: 0")
expect_files(own-mesh.vtp own-ridges.vtp own-umbilics.vtp)
run(0 own-mesh.vtp ${formula} --no-picture --output given)
expect("${output}" "umbilics [+]1/2: 4, -1/2: 0")
expect_files(given-ridges.vtp given-umbilics.vtp own-mesh.vtp own-ridges.vtp own-umbilics.vtp)
file(REMOVE "${DIRECTORY}/own-ridges.vtp" "${DIRECTORY}/own-umbilics.vtp"
  "${DIRECTORY}/given-ridges.vtp" "${DIRECTORY}/given-umbilics.vtp")

# With a proof, and without one where there is none.
run(0 ${formula} ${box} --edge-length 0.15 --certify --no-picture --output certified)
expect("${output}" "umbilics [+]1/2: 4, -1/2: 0" "\n  S1 +5[.]2[.]1 +proved\n" "\n  2[.]2d[.]ii +6[.]3 +proved\n")
run(3 --formula "x^2 + y^2 + z^2 - 1" --bounds -1.1,1.1,-1.1,1.1,-1.1,1.1 --edge-length 0.4 --certify
  --no-picture --output certified)
expect("${output}" "\n  D1 +5[.]2[.]1 +failed: the surface is not generic there\n")
expect("${errors}" "hypotheses are not proved : see the table")
file(REMOVE "${DIRECTORY}/certified-ridges.vtp" "${DIRECTORY}/certified-umbilics.vtp")
expect_failure(2 "--certify has no effect without --formula" --certify)
expect_failure(2 "--check has no effect with --certify" ${formula} ${box} --certify --check)
expect_failure(2 "--type-rule has no effect with --certify"
  ${formula} ${box} --certify --type-rule third-order)

# What does not go together
expect_failure(2 "--formula needs --bounds" ${formula})
expect_failure(2 "--bounds has no effect without --formula, or with MESH" ${box})
expect_failure(2 "--bounds has no effect without --formula, or with MESH" own-mesh.vtp ${formula} ${box})
expect_failure(2 "--edge-length has no effect" --edge-length 1)
expect_failure(2 "--degree has no effect with --formula" ${formula} ${box} --degree 3)
expect_failure(2 "--formula gives exact ridges" ${formula} ${box} --salient)

# One line, with the place in the formula
expect_failure(1 "at character 7, .foo[(]y[)]" --formula "x^2 + foo(y)" ${box} --no-picture)
expect_failure(1 "surface is empty" --formula "x^2+1" ${box} --no-picture)
expect_failure(1 "at character 1, .log[(]y[)]" --formula "log(y)+x" ${box} --no-picture)
expect_failure(1 "where no point of the surface was found nearby"
  own-mesh.vtp --formula "x^2+1" --no-picture)
file(REMOVE "${DIRECTORY}/own-mesh.vtp")
expect_files()
