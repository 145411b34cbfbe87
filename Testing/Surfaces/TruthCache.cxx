// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TruthCache.h"

#include "EvenMesh.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>

namespace ridges
{
namespace testing
{
namespace
{

//------------------------------------------------------------------------------
template <typename T>
void Write(std::ofstream& file, const std::vector<T>& values)
{
  const auto count = static_cast<std::uint64_t>(values.size());
  file.write(reinterpret_cast<const char*>(&count), sizeof count);
  file.write(
    reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
}

//------------------------------------------------------------------------------
template <typename T>
void Read(std::ifstream& file, std::vector<T>& values)
{
  std::uint64_t count = 0;
  file.read(reinterpret_cast<char*>(&count), sizeof count);
  values.resize(file ? count : 0);
  file.read(
    reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
}

//------------------------------------------------------------------------------
// Under another name until it is whole: several may run at once.
template <typename Writer>
void WriteFile(const std::string& name, const Writer& write)
{
  const std::string part = name + ".part";
  {
    std::ofstream file(part, std::ios::binary);
    write(file);
  }
  std::rename(part.c_str(), name.c_str());
}

} // namespace

//------------------------------------------------------------------------------
TruthCache::TruthCache(const ClosedSurface& closed, const std::string& directory)
  : Closed(closed)
  , Directory(directory)
{
}

//------------------------------------------------------------------------------
std::string TruthCache::FileName(const char* kind, int points) const
{
  std::string name = this->Closed.name;
  std::replace(name.begin(), name.end(), ' ', '-');
  std::replace(name.begin(), name.end(), ':', '-');
  return this->Directory + "/" + name + "-" + std::to_string(points) + "." + kind;
}

//------------------------------------------------------------------------------
Mesh TruthCache::MeshWith(int points) const
{
  const std::string name = this->FileName("mesh", points);
  std::ifstream file(name, std::ios::binary);
  Mesh mesh;
  if (!this->Directory.empty() && file)
  {
    Read(file, mesh.points);
    Read(file, mesh.triangles);
    return mesh;
  }
  mesh = EvenMesh(this->Closed.surface, this->Closed.halfSize, points);
  if (!this->Directory.empty())
  {
    WriteFile(name,
      [&](std::ofstream& to)
      {
        Write(to, mesh.points);
        Write(to, mesh.triangles);
      });
  }
  return mesh;
}

//------------------------------------------------------------------------------
Truth TruthCache::TruthWith(int points) const
{
  Mesh mesh = this->MeshWith(10000);
  Truth truth;
  truth.umbilics = FindUmbilics(this->Closed.surface, mesh);

  const std::string name = this->FileName("ridges", points);
  std::ifstream file(name, std::ios::binary);
  if (!this->Directory.empty() && file)
  {
    std::vector<int> heads;
    Read(file, heads); // four of each ridge
    for (std::size_t i = 0; i + 3 < heads.size(); i += 4)
    {
      TrueRidge ridge;
      ridge.maximum = heads[i] != 0;
      ridge.closed = heads[i + 1] != 0;
      ridge.umbilics = { heads[i + 2], heads[i + 3] };
      std::vector<double> coordinates;
      Read(file, coordinates);
      for (std::size_t j = 0; j + 2 < coordinates.size(); j += 3)
      {
        ridge.points.emplace_back(coordinates[j], coordinates[j + 1], coordinates[j + 2]);
      }
      Read(file, ridge.P);
      truth.ridges.push_back(ridge);
    }
    return truth;
  }

  while (mesh.PointCount() < 0.6 * points)
  {
    mesh = Subdivide(mesh, this->Closed.surface);
  }
  truth.ridges = FindRidges(this->Closed.surface, mesh, truth.umbilics);
  if (!this->Directory.empty())
  {
    WriteFile(name,
      [&](std::ofstream& to)
      {
        std::vector<int> heads;
        for (const TrueRidge& ridge : truth.ridges)
        {
          heads.insert(heads.end(),
            { ridge.maximum ? 1 : 0, ridge.closed ? 1 : 0, ridge.umbilics[0], ridge.umbilics[1] });
        }
        Write(to, heads);
        for (const TrueRidge& ridge : truth.ridges)
        {
          std::vector<double> coordinates;
          for (const Eigen::Vector3d& point : ridge.points)
          {
            coordinates.insert(coordinates.end(), point.data(), point.data() + 3);
          }
          Write(to, coordinates);
          Write(to, ridge.P);
        }
      });
  }
  return truth;
}

} // namespace testing
} // namespace ridges
