// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef XmlVtkChecks_h
#define XmlVtkChecks_h

#include <string>
#include <string_view>

namespace program
{

/**
 * Checks of a file in VTK's XML format that VTK's reader does not make: that the file is complete,
 * and that what it announces is possible for its size, as the reader allocates what it is told to.
 * Throws Failure with the name of the file and the reason. Returns the most bytes that an array of
 * the file can have.
 */
double CheckXmlVtk(std::string_view bytes, const std::string& fileName);

} // namespace program

#endif
