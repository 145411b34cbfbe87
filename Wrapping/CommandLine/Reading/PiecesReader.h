// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PiecesReader_h
#define PiecesReader_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace program
{

/// Whether the name is that of a .pvtp, a file that names the files of the pieces of a mesh.
bool IsOfPieces(const std::string& fileName);

/// The files of the pieces. Throws Failure where the .pvtp cannot be read.
std::vector<std::string> PiecesOf(const std::string& fileName);

/// One rank's share of the pieces, side by side in one data set, which is empty if it has none.
/// Throws Failure with the name of the file that cannot be read.
vtkSmartPointer<vtkPolyData> ReadPieces(const std::string& fileName, int rank, int ranks);

} // namespace program

#endif
