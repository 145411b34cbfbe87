# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause

# Fails if a file in DIRECTORY includes one of a room above its own. The rooms from the lowest up,
# as Filters/Core/README.md lists them; a folder in a room is above that room.
set(rooms
  Base
  Mesh
  Shares
  Monge
  Formula
  Fit
  Fit/Batch
  Umbilics
  Foliation
  Ridges
  Ridges/Patch
  Salience
  Coherence
  Certification)

file(GLOB_RECURSE files RELATIVE "${DIRECTORY}" "${DIRECTORY}/*.h" "${DIRECTORY}/*.cxx")
if (NOT files)
  message(SEND_ERROR "no sources in ${DIRECTORY}")
endif ()
foreach (file IN LISTS files)
  get_filename_component(room "${file}" DIRECTORY)
  list(FIND rooms "${room}" floor)
  if (floor EQUAL -1)
    message(SEND_ERROR "${file}: '${room}' is no room of this list")
    continue ()
  endif ()
  file(STRINGS "${DIRECTORY}/${file}" includes REGEX "^[ \t]*#[ \t]*include[ \t]*\"")
  foreach (include IN LISTS includes)
    string(REGEX REPLACE "^[^\"]*\"([^\"]*)\".*$" "\\1" included "${include}")
    get_filename_component(included_room "${included}" DIRECTORY)
    list(FIND rooms "${included_room}" included_floor)
    if (included_floor EQUAL -1)
      message(SEND_ERROR "${file} includes \"${included}\", which does not begin with a room")
    elseif (included_floor GREATER floor)
      message(SEND_ERROR "${file} includes \"${included}\", which is in a room above")
    endif ()
  endforeach ()
endforeach ()
