include("${CMAKE_CURRENT_LIST_DIR}/RunProgram.cmake")

run(0 --help)
expect("${output}"
  "Usage: vtkridges \\[MESH\\]" "Input:" "Jet fitting:" "Umbilics:" "Ridges:" "Filter:" "Output:"
  "General:" "Exit codes: 0 done; 1 the job failed")
# Defaults and ranges are those of the filters.
expect("${output}" "--degree N [^-]*\\(1 to[ \n]*4\\) \\[4\\]" "--frequency N [^-]*\\[63\\]")
file(WRITE "${DIRECTORY}/help.txt" "${output}")
file(STRINGS "${DIRECTORY}/help.txt" long_lines LENGTH_MINIMUM 81)
file(REMOVE "${DIRECTORY}/help.txt")
if (long_lines)
  message(SEND_ERROR "lines of the help are longer than 80 columns:\n${long_lines}")
endif ()

run(0 --version)
expect("${output}" "^vtkridges ${VERSION} \\(VTK [0-9.]+\\)\n$")
expect_files()
