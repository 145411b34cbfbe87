# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# What is different in a wheel. Included after VTK is found, when scikit-build-core builds.

file(STRINGS "${PROJECT_SOURCE_DIR}/pyproject.toml" requirement REGEX "\"vtk==[0-9.*]+\"")
string(REGEX REPLACE ".*\"vtk==([0-9]+\\.[0-9]+)\\.\\*\".*" "\\1" required "${requirement}")
if (NOT "${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION}" STREQUAL required)
  message(FATAL_ERROR
    "pyproject.toml requires vtk ${required}, but the VTK found is ${VTK_VERSION}, in ${VTK_DIR}.")
endif ()

# All in the package, which is installed beside vtkmodules. The library has no other users and so no
# version: a wheel cannot hold links.
set(ridges_python_destination ".")
set(CMAKE_INSTALL_LIBDIR "vtkridges")
set(CMAKE_INSTALL_RPATH "$ORIGIN;$ORIGIN/../vtkmodules")
set(ridges_library_version)
set(ridges_module_suffix SOABI "${Python3_SOABI}")

# The vtk of PyPI for x86_64 is compiled with the older of the two C++ ABIs of libstdc++.
if (CMAKE_SYSTEM_NAME STREQUAL "Linux" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  add_compile_definitions(_GLIBCXX_USE_CXX11_ABI=0)
endif ()
