# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
# The plugin, in one package.
set(series "${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}")
math(EXPR next "${ParaView_VERSION_MINOR} + 1")
set(next "${ParaView_VERSION_MAJOR}.${next}")

ridges_debian_package(runtime paraview-ridges
  DEPENDS "paraview (>= ${series}), paraview (<< ${next}~)"
  SUMMARY "ridges and umbilics of triangle meshes, in ParaView"
  DESCRIPTION "This package has the plugin, and paraview-ridges to start ParaView with it.")

set(plugin_path "/usr/${CMAKE_INSTALL_LIBDIR}/paraview-${series}/plugins/Ridges")
configure_file(paraview-ridges.in paraview-ridges @ONLY)
install(PROGRAMS "${CMAKE_CURRENT_BINARY_DIR}/paraview-ridges"
  DESTINATION "${CMAKE_INSTALL_BINDIR}"
  COMPONENT runtime)
set(CPACK_COMPONENTS_ALL runtime)
