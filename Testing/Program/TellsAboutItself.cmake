# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
include("${CMAKE_CURRENT_LIST_DIR}/RunProgram.cmake")

# Two helps: the most important options, and all of them in their groups.
run(0 --help)
expect("${output}" "Usage: vtkridges \\[MESH\\]" "MESH" "--orient" "--keep" "--help-all")
if (output MATCHES "--loop-significance")
  message(SEND_ERROR "the short help lists all options:\n${output}")
endif ()
set(short "${output}")

run(0 --help-all)
expect("${output}"
  "Usage: vtkridges \\[MESH\\]" "Input:" "Jet fitting:" "Umbilics:" "Ridges:" "Filter:" "Output:"
  "General:" "Exit codes: 0 done; 1 the job failed")
# Defaults and ranges are those of the filters.
string(REGEX REPLACE "[ \n]+" " " text "${output}")
expect("${text}" "--degree N [^()]*\\(3 to 8\\)"
  "--frequency N [^()]*points \\(1 to 2000\\) \\[63\\]"
  "--umbilic-method NAME [^()]*: indices, minima \\[indices\\]"
  "--umbilic-significance ERRORS [^()]*\\(0 to 100\\) \\[3\\]"
  "--extremality-rule NAME [^()]*: principal, gaussian \\[principal\\]"
  "--umbilic-joining NAME [^()]*: patches, triangles \\[patches\\]"
  "--loop-significance ERRORS [^()]*\\(0 to 100\\) \\[3\\]"
  "--zone-significance ERRORS [^()]*\\(0 to 100\\) \\[3\\]"
  "--type-significance ERRORS [^()]*\\(0 to 100\\) \\[1\\]"
  "--type-hysteresis EDGES [^()]*\\(0 to 1000\\) \\[0\\]")
file(WRITE "${DIRECTORY}/help.txt" "${short}${output}")
file(STRINGS "${DIRECTORY}/help.txt" long_lines LENGTH_MINIMUM 81)
file(REMOVE "${DIRECTORY}/help.txt")
if (long_lines)
  message(SEND_ERROR "lines of the help are longer than 80 columns:\n${long_lines}")
endif ()

run(0 --version)
expect("${output}" "^vtkridges ${VERSION} \\(VTK [0-9.]+\\)\n$")
expect_files()
