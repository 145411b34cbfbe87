// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzData.h"

#include "NotFinite.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace names = vtkRidgesArrayNames;

namespace fuzz
{
namespace
{

struct Polygons
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<vtkIdType>> faces;
};

//------------------------------------------------------------------------------
// A curved sheet, or a torus if it is closed both ways.
Polygons MakeGrid(FuzzBytes& bytes)
{
  Polygons mesh;
  const int columns = 3 + bytes.Below(8);
  const int rows = 3 + bytes.Below(8);
  const bool isTorus = bytes.Flag();
  const bool hasQuads = bytes.Flag();
  const double bend = bytes.Number();
  for (int i = 0; i < columns; ++i)
  {
    for (int j = 0; j < rows; ++j)
    {
      const double u = 6.283185307179586 * i / columns;
      const double v = 6.283185307179586 * j / rows;
      if (isTorus)
      {
        const double radius = 2.0 + std::cos(v);
        mesh.points.push_back({ radius * std::cos(u), radius * std::sin(u), std::sin(v) });
      }
      else
      {
        mesh.points.push_back({ u, v, bend * std::sin(u) * std::cos(1.3 * v) });
      }
    }
  }
  for (int i = 0; i < (isTorus ? columns : columns - 1); ++i)
  {
    for (int j = 0; j < (isTorus ? rows : rows - 1); ++j)
    {
      const vtkIdType a = i * rows + j;
      const vtkIdType b = (i + 1) % columns * rows + j;
      const vtkIdType c = (i + 1) % columns * rows + (j + 1) % rows;
      const vtkIdType d = i * rows + (j + 1) % rows;
      if (hasQuads)
      {
        mesh.faces.push_back({ a, b, c, d });
      }
      else
      {
        mesh.faces.push_back({ a, b, c });
        mesh.faces.push_back({ a, c, d });
      }
    }
  }
  return mesh;
}

//------------------------------------------------------------------------------
Polygons MakeSoup(FuzzBytes& bytes)
{
  Polygons mesh;
  const int points = bytes.Below(40);
  for (int i = 0; i < points; ++i)
  {
    mesh.points.push_back({ bytes.Number(), bytes.Number(), bytes.Number() });
  }
  const int faces = points > 0 ? bytes.Below(80) : 0;
  for (int i = 0; i < faces; ++i)
  {
    std::vector<vtkIdType> face(bytes.Below(10) == 0 ? bytes.Below(6) : 3);
    for (vtkIdType& id : face)
    {
      id = bytes.Below(points);
    }
    mesh.faces.push_back(face);
  }
  return mesh;
}

//------------------------------------------------------------------------------
void Damage(Polygons& mesh, FuzzBytes& bytes)
{
  for (int changes = bytes.Below(8); changes > 0 && !mesh.points.empty(); --changes)
  {
    const std::size_t point = bytes.Byte() % mesh.points.size();
    std::vector<vtkIdType>* face =
      mesh.faces.empty() ? nullptr : &mesh.faces[bytes.Byte() % mesh.faces.size()];
    switch (bytes.Below(5))
    {
      case 0:
        mesh.points[point][bytes.Below(3)] = bytes.Number();
        break;
      case 1:
        mesh.points[point] = mesh.points[bytes.Byte() % mesh.points.size()];
        break;
      case 2:
        if (face && !face->empty())
        {
          (*face)[bytes.Byte() % face->size()] = static_cast<vtkIdType>(point);
        }
        break;
      case 3:
        if (face)
        {
          mesh.faces.push_back(*face);
        }
        break;
      default:
        if (face)
        {
          face->clear();
        }
        break;
    }
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> MakeArray(
  const char* name, int components, vtkIdType tuples, FuzzBytes& bytes)
{
  constexpr int types[] = { VTK_DOUBLE, VTK_DOUBLE, VTK_FLOAT, VTK_INT, VTK_UNSIGNED_CHAR,
    VTK_ID_TYPE };
  const int type = types[bytes.Below(6)];
  auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  const bool isReal = type == VTK_DOUBLE || type == VTK_FLOAT;
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int j = 0; j < components; ++j)
    {
      // What integers make of numbers beyond their range is undefined.
      double value = bytes.Number();
      if (type == VTK_FLOAT && std::isfinite(value))
      {
        value = std::fmax(-1e38, std::fmin(1e38, value));
      }
      array->SetComponent(i, j, isReal ? value : bytes.Byte());
    }
  }
  return array;
}

//------------------------------------------------------------------------------
struct Expected
{
  const char* name;
  int components;
};
constexpr Expected PointArrays[] = { { names::MaximumCurvature, 1 }, { names::MinimumCurvature, 1 },
  { names::MaximumDirection, 3 }, { names::MinimumDirection, 3 }, { names::Normals, 3 },
  { names::ThirdOrder, 4 }, { names::FourthOrder, 5 }, { names::P1, 1 }, { names::P2, 1 },
  { names::FitStatus, 1 }, { names::FitResidual, 1 }, { names::FitScale, 1 },
  { names::FitNoiseGain, 1 }, { names::MaximumCurvatureError, 1 },
  { names::MinimumCurvatureError, 1 }, { names::ThirdOrderError, 1 }, { names::P1Error, 1 } };

//------------------------------------------------------------------------------
// Orthonormal frames as a fit has them, and other numbers of order 1.
void AddSensibleArrays(vtkPolyData* mesh, FuzzBytes& bytes)
{
  for (const Expected& expected : PointArrays)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(expected.name);
    array->SetNumberOfComponents(expected.components);
    array->SetNumberOfTuples(mesh->GetNumberOfPoints());
    array->Fill(0.0);
    mesh->GetPointData()->AddArray(array);
  }
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    const double angle = bytes.Byte() * 0.0245;
    const double d1[3] = { std::cos(angle), std::sin(angle), 0.0 };
    const double d2[3] = { -d1[1], d1[0], 0.0 };
    const double n[3] = { 0.0, 0.0, 1.0 };
    const auto set = [&](const char* name, const double* values)
    { mesh->GetPointData()->GetArray(name)->SetTuple(p, values); };
    const auto signedByte = [&bytes] { return bytes.Byte() / 128.0 - 1.0; };
    const double k2 = signedByte();
    const double k1 = k2 + bytes.Byte() / 256.0;
    const double b[4] = { signedByte(), signedByte(), signedByte(), signedByte() };
    const double P = signedByte();
    set(names::MaximumDirection, d1);
    set(names::MinimumDirection, d2);
    set(names::Normals, n);
    set(names::MaximumCurvature, &k1);
    set(names::MinimumCurvature, &k2);
    set(names::ThirdOrder, b);
    set(names::P1, &P);
    set(names::P2, &P);
  }
}

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeMesh(FuzzBytes& bytes)
{
  Polygons mesh = bytes.Below(3) == 0 ? MakeSoup(bytes) : MakeGrid(bytes);
  Damage(mesh, bytes);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(bytes.Flag() ? VTK_DOUBLE : VTK_FLOAT);
  for (const auto& point : mesh.points)
  {
    double clamped[3];
    for (int i = 0; i < 3; ++i)
    {
      const bool fits = points->GetDataType() == VTK_DOUBLE || !std::isfinite(point[i]);
      clamped[i] = fits ? point[i] : std::fmax(-1e38, std::fmin(1e38, point[i]));
    }
    points->InsertNextPoint(clamped);
  }
  vtkNew<vtkCellArray> faces;
  for (const auto& face : mesh.faces)
  {
    faces->InsertNextCell(static_cast<vtkIdType>(face.size()), face.data());
  }
  data->SetPoints(points);
  (bytes.Below(16) == 0 ? data->SetStrips(faces) : data->SetPolys(faces));
  if (bytes.Below(8) == 0)
  {
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
    {
      ghosts->InsertNextValue(bytes.Below(4) == 0 ? bytes.Byte() : 0);
    }
    data->GetCellData()->AddArray(ghosts);
  }
  return data;
}

//------------------------------------------------------------------------------
void AddMongeArrays(vtkPolyData* mesh, FuzzBytes& bytes)
{
  AddSensibleArrays(mesh, bytes);
  for (int changes = bytes.Below(6); changes > 0; --changes)
  {
    const Expected& expected = PointArrays[bytes.Below(static_cast<int>(std::size(PointArrays)))];
    const int kind = bytes.Below(6);
    vtkDataArray* array = mesh->GetPointData()->GetArray(expected.name);
    if (kind < 3 && array && array->GetNumberOfValues() > 0)
    {
      array->SetComponent(bytes.Byte() % array->GetNumberOfTuples(),
        bytes.Below(array->GetNumberOfComponents()),
        array->GetDataType() == VTK_DOUBLE ? bytes.Number() : bytes.Byte());
      continue;
    }
    mesh->GetPointData()->RemoveArray(expected.name);
    if (kind < 5)
    {
      mesh->GetPointData()->AddArray(
        MakeArray(expected.name, bytes.Below(8) == 0 ? 1 + bytes.Below(9) : expected.components,
          bytes.Below(8) == 0 ? bytes.Byte() : mesh->GetNumberOfPoints(), bytes));
    }
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeImage(FuzzBytes& bytes)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(1 + bytes.Below(10), 1 + bytes.Below(10), 1 + bytes.Below(10));
  image->SetOrigin(bytes.Number(), bytes.Number(), bytes.Number());
  image->SetSpacing(bytes.Number(), bytes.Number(), bytes.Number());
  image->GetPointData()->SetScalars(MakeArray("Value", 1, image->GetNumberOfPoints(), bytes));
  return image;
}

//------------------------------------------------------------------------------
void Run(vtkAlgorithm* filter, vtkDataObject* input)
{
  filter->Update();
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    const std::string found = output ? ridges::testing::NotFinite(output, input) : "";
    if (!found.empty())
    {
      std::fprintf(
        stderr, "%s, output %d is not finite:%s\n", filter->GetClassName(), port, found.c_str());
      std::abort();
    }
  }
}

} // namespace fuzz
