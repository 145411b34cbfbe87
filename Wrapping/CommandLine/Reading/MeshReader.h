// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshReader_h
#define MeshReader_h

#include "Reading/PolygonMesh.h"

#include <string>

namespace program
{

/// What a file holds.
struct MeshFile
{
  PolygonMesh mesh;
  vtkSmartPointer<vtkPolyData> data; ///< The same with its arrays, if the format has arrays.
  bool hasNeighbours = true;         ///< False: each triangle has points of its own, as in STL.
};

/// The extensions that ReadMesh knows, for messages.
const char* ReadableExtensions();

/**
 * Reads a mesh in the format that the extension of the name stands for, in upper or lower case.
 * Throws Failure if there is no such file or format, if the file is not complete and correct, or
 * if it has no faces. What VTK reports meanwhile goes to vtkOutputWindow.
 */
MeshFile ReadMesh(const std::string& fileName);

/// The same from the bytes of a file, whose name gives the format; not of a .pvtp, which only names
/// others.
MeshFile ParseMesh(const std::string& bytes, const std::string& fileName);

/// What a rank has of the pieces of a .pvtp; maybe nothing.
MeshFile ReadPiecesOfRank(const std::string& fileName, int rank, int ranks);

} // namespace program

#endif
