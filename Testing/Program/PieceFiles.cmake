# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# For the tests beside: writes a mesh in pieces, pieces.pvtp.

# write_piece(<name> <first row> <last row>): rows of a grid with 16 points each, over which a surface
# with ridges is the graph of a polynomial.
function (write_piece name first last)
  set(rows 0)
  foreach (i RANGE ${first} ${last})
    foreach (j RANGE 15)
      math(EXPR x "${i} - 8")
      math(EXPR y "${j} - 8")
      math(EXPR height "40 * ${x} * ${x} - 25 * ${y} * ${y} + 2 * ${x} * ${x} * ${x} + ${x} * ${y} * ${y}")
      string(APPEND points "${x} ${y} ${height}e-3\n")
      math(EXPR a "${rows} * 16 + ${j}")
      math(EXPR b "${a} + 16")
      if (i LESS last AND j LESS 15)
        math(EXPR c "${b} + 1")
        math(EXPR d "${a} + 1")
        string(APPEND corners "${a} ${b} ${c} ${a} ${c} ${d}\n")
      endif ()
    endforeach ()
    math(EXPR rows "${rows} + 1")
  endforeach ()
  math(EXPR number_of_points "${rows} * 16")
  math(EXPR triangles "(${rows} - 1) * 30")
  foreach (i RANGE 1 ${triangles})
    math(EXPR end "3 * ${i}")
    string(APPEND offsets "${end} ")
  endforeach ()
  file(WRITE "${DIRECTORY}/${name}" "<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData>
<Piece NumberOfPoints=\"${number_of_points}\" NumberOfPolys=\"${triangles}\">
<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">
${points}</DataArray></Points>
<Polys><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">
${corners}</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">
${offsets}</DataArray></Polys></Piece></PolyData></VTKFile>\n")
endfunction ()

write_piece(a.vtp 0 5)
write_piece(b.vtp 5 8)
write_piece(c.vtp 8 15)
file(WRITE "${DIRECTORY}/pieces.pvtp" "<VTKFile type=\"PPolyData\"><PPolyData>
<Piece Source=\"a.vtp\"/><Piece Source=\"b.vtp\"/><Piece Source=\"c.vtp\"/></PPolyData></VTKFile>\n")
