# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# The library, its development files, the Python package and the program.
set(series "${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION}")
math(EXPR next "${VTK_MINOR_VERSION} + 1")
set(next "${VTK_MAJOR_VERSION}.${next}")

ridges_debian_package(runtime libvtkridges
  SECTION libs
  SUMMARY "ridges and umbilics of triangle meshes, as VTK filters"
  DESCRIPTION "This package has the library, for VTK ${series}.")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_SOURCE_DIR}/library/triggers")

ridges_debian_package(development libvtkridges-dev
  SECTION libdevel
  DEPENDS "libvtkridges (= ${version}), libvtk9-dev (>= ${series}), libvtk9-dev (<< ${next}~)"
  SUMMARY "ridges and umbilics of triangle meshes, development files"
  DESCRIPTION "This package has the headers and the CMake package vtkRidges.")

find_package(Python3 REQUIRED COMPONENTS Interpreter)
math(EXPR following "${Python3_VERSION_MINOR} + 1")
string(CONCAT python_depends "libvtkridges (= ${version}), python3-numpy, "
  "python3-vtk9 (>= ${series}), python3-vtk9 (<< ${next}~), "
  "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${following})")
ridges_debian_package(python python3-vtkridges
  SECTION python
  DEPENDS "${python_depends}"
  SUMMARY "ridges and umbilics of triangle meshes, for Python"
  DESCRIPTION "This package has the Python package, for VTK, numpy and PyVista.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pyvista")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  "${CMAKE_CURRENT_SOURCE_DIR}/python/postinst;${CMAKE_CURRENT_SOURCE_DIR}/python/prerm")

ridges_debian_package(program vtkridges
  DEPENDS "libvtkridges (= ${version})"
  SUMMARY "ridges and umbilics of triangle meshes, a program"
  DESCRIPTION "This package has the program, which makes lines and a picture of a mesh.")

set(CPACK_COMPONENTS_ALL runtime development python program)
