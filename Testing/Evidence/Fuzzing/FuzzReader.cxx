// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Bytes as a file in the format RIDGES_FUZZ_FORMAT ("off", ...): read and repaired, or refused with
// a Failure, in every way the program may repair it.

#include "Console.h"
#include "FuzzTarget.h"
#include "MeshFiles.h"
#include "Reading/MeshReader.h"
#include "Repair/RepairMesh.h"

namespace
{

const std::string Extension = std::string(".") + RIDGES_FUZZ_FORMAT;

} // namespace

//------------------------------------------------------------------------------
std::vector<std::string> FuzzSeeds()
{
  std::vector<std::string> seeds;
  for (const MeshBytes& file : WriteInAllFormats(Ellipsoid(1)))
  {
    if (file.name.size() > Extension.size() &&
      file.name.compare(file.name.size() - Extension.size(), Extension.size(), Extension) == 0)
    {
      seeds.push_back(file.bytes);
    }
  }
  return seeds;
}

//------------------------------------------------------------------------------
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0)
  {
    return 0;
  }
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try
  {
    const program::MeshFile file = program::ParseMesh(bytes, "mesh" + Extension);
    for (const auto joining :
      { program::Joining::None, program::Joining::Borders, program::Joining::All })
    {
      program::PolygonMesh mesh = file.mesh;
      program::RepairOptions options;
      options.joining = joining;
      options.orient = true;
      program::RepairMesh(mesh, options);
      mesh.ToPolyData();
    }
  }
  catch (const program::Failure&)
  {
    // A reason was given.
  }
  return 0;
}
