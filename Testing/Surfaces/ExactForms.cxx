// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExactForms.h"

#include "FilterTestTools.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"

namespace ridges
{
namespace testing
{

namespace names = vtkRidgesArrayNames;
using Eigen::Vector3d;

namespace
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDoubleArray> AddArray(vtkPolyData* mesh, const char* name, int components)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(mesh->GetNumberOfPoints());
  mesh->GetPointData()->AddArray(array);
  return array;
}

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> WithExactForms(
  vtkPolyData* mesh, const AnalyticSurface& surface, const Eigen::Matrix3d& rotation)
{
  auto exact = vtkSmartPointer<vtkPolyData>::New();
  exact->ShallowCopy(mesh);
  const auto k1 = AddArray(exact, names::MaximumCurvature, 1);
  const auto k2 = AddArray(exact, names::MinimumCurvature, 1);
  const auto d1 = AddArray(exact, names::MaximumDirection, 3);
  const auto d2 = AddArray(exact, names::MinimumDirection, 3);
  const auto normals = AddArray(exact, names::Normals, 3);
  const auto b = AddArray(exact, names::ThirdOrder, 4);
  const auto c = AddArray(exact, names::FourthOrder, 5);
  const auto P1 = AddArray(exact, names::P1, 1);
  const auto P2 = AddArray(exact, names::P2, 1);
  const Eigen::Matrix3d back = rotation.transpose();
  for (vtkIdType p = 0; p < exact->GetNumberOfPoints(); ++p)
  {
    const ExactMonge monge = surface.Monge(surface.Project(back * PointAt(exact, p)));
    const Vector3d directions[3] = { rotation * monge.d1, rotation * monge.d2, rotation * monge.n };
    k1->SetValue(p, monge.k1);
    k2->SetValue(p, monge.k2);
    d1->SetTuple(p, directions[0].data());
    d2->SetTuple(p, directions[1].data());
    normals->SetTuple(p, directions[2].data());
    b->SetTuple(p, monge.b.data());
    c->SetTuple(p, monge.c.data());
    P1->SetValue(p, monge.P1);
    P2->SetValue(p, monge.P2);
  }
  return exact;
}

} // namespace testing
} // namespace ridges
