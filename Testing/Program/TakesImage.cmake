# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
include("${CMAKE_CURRENT_LIST_DIR}/RunProgram.cmake")

# 25 x^2 + 49 y^2 + 121 z^2: the ellipsoid 2500 with half axes of 10, 7.1 and 4.5 samples, which
# smoothing makes smaller and leaves an ellipsoid.
set(values "")
foreach (z RANGE -12 12)
  foreach (y RANGE -12 12)
    math(EXPR of_row "49 * ${y} * ${y} + 121 * ${z} * ${z}")
    foreach (x RANGE -12 12)
      math(EXPR value "25 * ${x} * ${x} + ${of_row}")
      string(APPEND values "${value} ")
    endforeach ()
    string(APPEND values "\n")
  endforeach ()
endforeach ()
string(CONCAT begin "<VTKFile type=\"ImageData\" version=\"0.1\">"
  "<ImageData WholeExtent=\"0 24 0 24 0 24\" Origin=\"-6 -6 -6\" Spacing=\"0.5 0.5 0.5\">"
  "<Piece Extent=\"0 24 0 24 0 24\"><PointData Scalars=\"f\">"
  "<DataArray type=\"Int32\" Name=\"f\" format=\"ascii\">\n")
set(end "</DataArray></PointData></Piece></ImageData></VTKFile>\n")
file(WRITE "${DIRECTORY}/image.vti" "${begin}${values}${end}")
set(image --image image.vti --isovalue 2500)

# The four umbilics and six ridges of an ellipsoid, on the program's own mesh and on that given.
run(0 ${image} --no-picture --write-mesh --check)
expect("${output}" "mesh of the isosurface [0-9.]+" "forms of the image [0-9.]+"
  "umbilics [+]1/2: 4, -1/2: 0")
expect_files(image-mesh.vtp image-ridges.vtp image-umbilics.vtp image.vti)
run(0 image-mesh.vtp ${image} --no-picture --output given)
expect("${output}" "umbilics [+]1/2: 4, -1/2: 0")
run(0 ${image} --edge-length 0.5 --sigma 0.6 --no-picture --output finer)
expect("${output}" "umbilics [+]1/2: 4, -1/2: 0")
run(0 ${image} --salient --no-picture --output salient)
expect_files(finer-ridges.vtp finer-umbilics.vtp given-ridges.vtp given-umbilics.vtp
  image-mesh.vtp image-ridges.vtp image-umbilics.vtp image.vti salient-ridges.vtp
  salient-umbilics.vtp)
foreach (name finer given image salient)
  file(REMOVE "${DIRECTORY}/${name}-ridges.vtp" "${DIRECTORY}/${name}-umbilics.vtp")
endforeach ()
file(REMOVE "${DIRECTORY}/image-mesh.vtp")

# What does not go together
expect_failure(2 "--image needs --isovalue" --image image.vti)
expect_failure(2 "--isovalue requires --image" --isovalue 1)
expect_failure(2 "--formula excludes --image" ${image} --formula "x")
expect_failure(2 "--degree has no effect with --image" ${image} --degree 3)
expect_failure(2 "--bounds has no effect without --formula" ${image} --bounds -1,1,-1,1,-1,1)

# One line
expect_failure(1 "no-such.vti does not exist" --image no-such.vti --isovalue 1 --no-picture)
expect_failure(1 "surface is empty: within the image" --image image.vti --isovalue -7 --no-picture)
file(WRITE "${DIRECTORY}/text.vti" "no image\n")
expect_failure(1 "text.vti is not an image that VTK can read" --image text.vti --isovalue 1 --no-picture)
file(WRITE "${DIRECTORY}/cut.vti" "${begin}${values}")
expect_failure(1 "cut.vti" --image cut.vti --isovalue 1 --no-picture)
file(REMOVE "${DIRECTORY}/image.vti" "${DIRECTORY}/text.vti" "${DIRECTORY}/cut.vti")
expect_files()
