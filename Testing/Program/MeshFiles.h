// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshFiles_h
#define MeshFiles_h

#include "Reading/PolygonMesh.h"

#include <string>
#include <vector>

/// An ellipsoid of 10 frequency^2 + 2 points, closed and oriented outwards.
program::PolygonMesh Ellipsoid(int frequency);

/// The same with points of its own for each face.
program::PolygonMesh Soup(const program::PolygonMesh& mesh);

/// The bytes of a file, and a name with the extension of its format.
struct MeshBytes
{
  std::string name;
  std::string bytes;
};

/// A mesh in every format and encoding that the program reads.
std::vector<MeshBytes> WriteInAllFormats(const program::PolygonMesh& mesh);

/// A path for files of a test, which no test in another process uses.
std::string ScratchPath(const std::string& name);

std::string WritePly(const program::PolygonMesh& mesh, const std::string& format);

/// The text of the failure of ParseMesh, or "none".
std::string FailureOf(const std::string& bytes, const std::string& name);

#endif
