# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
include("${CMAKE_CURRENT_LIST_DIR}/RunProgram.cmake")

# A smooth mesh gets the complete picture unless salient lines are asked for.
run(0 --frequency 30 --no-picture --write-mesh --output smooth)
if (output MATCHES "\nlines ")
  message(SEND_ERROR "without a mesh there is nothing to choose:\n${output}")
endif ()
run(0 smooth-mesh.vtp --no-picture --output all)
expect("${output}" "lines +complete: [^\n]+--salient" "maximum, hyperbolic +green" "filter [0-9.]+")
run(0 smooth-mesh.vtp --no-picture --output main --salient)
expect("${output}" "salient lines +lines" "valley +blue" "crest +red"
  "umbilics \\+1/2" "salient lines [0-9.]+"
  "written +main-ridges.vtp\n +main-umbilics.vtp\n$")
file(READ "${DIRECTORY}/main-ridges.vtp" ridges)
expect("${ridges}" "FoldMass" "ArcLength")
# An option of one of both decides as well.
run(0 smooth-mesh.vtp --no-picture --output main --fold-angle 30)
expect("${output}" "salient lines +lines")
run(0 smooth-mesh.vtp --no-picture --output all --degree 4)
expect("${output}" "hyperbolic +green")

# A roof has nothing to offer but its crest.
foreach (i RANGE 20)
  foreach (j RANGE 20)
    if (i GREATER 10)
      math(EXPR height "20 - ${i}")
    else ()
      set(height ${i})
    endif ()
    string(APPEND points "${i} ${j} ${height}\n")
    if (i LESS 20 AND j LESS 20)
      math(EXPR a "${i} * 21 + ${j}")
      math(EXPR b "${a} + 21")
      math(EXPR c "${a} + 22")
      math(EXPR d "${a} + 1")
      string(APPEND faces "3 ${a} ${b} ${c}\n3 ${a} ${c} ${d}\n")
    endif ()
  endforeach ()
endforeach ()
file(WRITE "${DIRECTORY}/roof.off" "OFF 441 800 0\n${points}${faces}")
run(0 roof.off --no-picture)
expect("${output}" "lines +salient: [^\n]+--complete" "crest +red +1 ")
run(0 roof.off --no-picture --complete)
expect("${output}" "minimum, elliptic +red")

# A closed surface that is inside out is reported, whatever the lines, and --orient turns it.
file(WRITE "${DIRECTORY}/inwards.off"
  "OFF 6 8 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n0 0 1\n0 0 -1\n"
  "3 0 4 1\n3 1 4 2\n3 2 4 3\n3 3 4 0\n3 1 5 0\n3 2 5 1\n3 3 5 2\n3 0 5 3\n")
foreach (lines IN ITEMS --complete --salient)
  run(0 inwards.off --no-picture ${lines})
  string(REGEX MATCHALL "inside out" all "${errors}")
  list(LENGTH all count)
  if (NOT count EQUAL 1)
    message(SEND_ERROR "${lines} does not report once that the mesh is inside out:\n${errors}")
  endif ()
  expect("${errors}" "add --orient")
  run(0 inwards.off --no-picture --orient ${lines})
  if (errors MATCHES "inside out")
    message(SEND_ERROR "--orient does not turn the surface:\n${errors}")
  endif ()
endforeach ()
