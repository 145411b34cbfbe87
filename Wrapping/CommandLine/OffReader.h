// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OffReader_h
#define OffReader_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace program
{

/**
 * Reads the text of a mesh in Geomview's object file format, OFF. What may vary from writer to
 * writer is accepted: comments and empty lines anywhere, counts beside the keyword, no keyword at
 * all, no count of edges, further numbers behind the coordinates of a vertex (COFF, NOFF, STOFF,
 * ...) and behind the corners of a face, faces of any size, either kind of line end. Faces of less
 * than three corners are passed over. Points are in double precision.
 *
 * Throws Failure with the name of the file and the number of the faulty line.
 */
vtkSmartPointer<vtkPolyData> ParseOff(const std::string& text, const std::string& fileName);

/// The same from a file.
vtkSmartPointer<vtkPolyData> ReadOff(const std::string& fileName);

} // namespace program

#endif
