// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "Console.h"
#include "Legend.h"
#include "View.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkLightKit.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRidgesArrayNames.h"
#include "vtkSphereSource.h"
#include "vtkTubeFilter.h"
#include "vtkWindowToImageFilter.h"

#include <cstdlib>
#include <set>

#ifdef RIDGES_HAVE_X11
#include <X11/Xlib.h>
#endif

namespace program
{

const std::array<RidgeStyle, 5> RidgeStyles{ {
  { 1, "maximum, elliptic", "valley", "blue", { 0.05, 0.25, 0.85 } },
  { 2, "maximum, hyperbolic", "", "green", { 0.0, 0.55, 0.15 } },
  { 3, "minimum, elliptic", "crest", "red", { 0.85, 0.05, 0.05 } },
  { 4, "minimum, hyperbolic", "", "yellow", { 0.95, 0.62, 0.0 } },
  { 0, "undecided", "", "grey", { 0.35, 0.35, 0.35 } },
} };

namespace
{

constexpr std::array<double, 3> PositiveUmbilicColor{ 0.0, 0.0, 0.0 };
constexpr std::array<double, 3> NegativeUmbilicColor{ 0.75, 0.0, 0.75 };

bool HasInvalidNormals(vtkDataArray* normals)
{
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    double normal[3];
    normals->GetTuple(i, normal);
    if (normal[0] == 0.0 && normal[1] == 0.0 && normal[2] == 0.0)
    {
      return true;
    }
  }
  return false;
}

/// The bare surface with the fitted normals or, if some points have none, with the triangles' own.
vtkSmartPointer<vtkPolyData> ShadedSurface(vtkPolyData* mesh)
{
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(mesh->GetPoints());
  bare->SetPolys(mesh->GetPolys());
  bare->SetStrips(mesh->GetStrips());
  vtkDataArray* normals = mesh->GetPointData()->GetArray(vtkRidgesArrayNames::Normals);
  if (normals && !HasInvalidNormals(normals))
  {
    bare->GetPointData()->SetNormals(normals);
    return bare;
  }
  vtkNew<vtkPolyDataNormals> filter;
  filter->SetInputData(bare);
  filter->SplittingOff();
  filter->ConsistencyOff();
  filter->Update();
  return filter->GetOutput();
}

void AddSurface(vtkRenderer* renderer, vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(ShadedSurface(mesh));
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.88, 0.88, 0.88);
  actor->GetProperty()->SetAmbient(0.3);
  actor->GetProperty()->SetDiffuse(0.8);
  renderer->AddActor(actor);
}

/// Moves an actor towards the viewer, which a parallel projection does not show.
void Lift(vtkActor* actor, const View& view, double distance)
{
  actor->SetPosition(distance * view.back[0], distance * view.back[1], distance * view.back[2]);
}

void AddRidges(vtkRenderer* renderer, vtkPolyData* ridges, const View& view, double radius)
{
  vtkNew<vtkPolyData> lines;
  lines->SetPoints(ridges->GetPoints());
  lines->SetLines(ridges->GetLines());
  lines->GetCellData()->SetScalars(ridges->GetCellData()->GetArray(vtkRidgesArrayNames::RidgeType));

  vtkNew<vtkLookupTable> colors;
  colors->SetNumberOfTableValues(static_cast<vtkIdType>(RidgeStyles.size()));
  colors->SetTableRange(0.0, static_cast<double>(RidgeStyles.size() - 1));
  for (const RidgeStyle& style : RidgeStyles)
  {
    colors->SetTableValue(style.type, style.color[0], style.color[1], style.color[2]);
  }
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(lines);
  tubes->SetNumberOfSides(10);
  tubes->SetRadius(radius);
  tubes->CappingOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tubes->GetOutputPort());
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  // Not shaded: the colour tells the type.
  actor->GetProperty()->LightingOff();
  Lift(actor, view, radius);
  renderer->AddActor(actor);
}

void AddUmbilics(vtkRenderer* renderer, vtkPolyData* umbilics, const View& view, double radius)
{
  vtkDataArray* index = umbilics->GetPointData()->GetArray(vtkRidgesArrayNames::Index);
  vtkNew<vtkPolyData> centers;
  centers->SetPoints(umbilics->GetPoints());
  centers->GetPointData()->SetScalars(index);

  vtkNew<vtkLookupTable> colors;
  colors->SetNumberOfTableValues(2);
  colors->SetTableRange(-0.5, 0.5);
  colors->SetTableValue(
    0, NegativeUmbilicColor[0], NegativeUmbilicColor[1], NegativeUmbilicColor[2]);
  colors->SetTableValue(
    1, PositiveUmbilicColor[0], PositiveUmbilicColor[1], PositiveUmbilicColor[2]);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(20);
  sphere->SetPhiResolution(14);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(centers);
  mapper->SetSourceConnection(sphere->GetOutputPort());
  mapper->ScalingOff();
  mapper->OrientOff();
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.3);
  actor->GetProperty()->SetDiffuse(0.7);
  Lift(actor, view, radius);
  renderer->AddActor(actor);
}

std::vector<LegendRow> LegendRows(vtkPolyData* ridges, vtkPolyData* umbilics)
{
  const bool areSalient = umbilics == nullptr;
  std::vector<LegendRow> rows;
  std::set<int> types;
  vtkDataArray* type = ridges->GetCellData()->GetArray(vtkRidgesArrayNames::RidgeType);
  for (vtkIdType i = 0; type && i < type->GetNumberOfTuples(); ++i)
  {
    types.insert(static_cast<int>(type->GetTuple1(i)));
  }
  for (const RidgeStyle& style : RidgeStyles)
  {
    if (types.count(style.type) > 0)
    {
      rows.push_back({ areSalient ? style.salientName : style.name, style.color, false });
    }
  }
  std::set<bool> signs;
  vtkDataArray* index =
    areSalient ? nullptr : umbilics->GetPointData()->GetArray(vtkRidgesArrayNames::Index);
  for (vtkIdType i = 0; index && i < index->GetNumberOfTuples(); ++i)
  {
    signs.insert(index->GetTuple1(i) > 0.0);
  }
  if (signs.count(true) > 0)
  {
    rows.push_back({ "umbilic of index +1/2", PositiveUmbilicColor, true });
  }
  if (signs.count(false) > 0)
  {
    rows.push_back({ "umbilic of index -1/2", NegativeUmbilicColor, true });
  }
  return rows;
}

void SetUpCamera(vtkCamera* camera, const View& view)
{
  // The lights turn with the camera, and everything drawn is within twice the depth.
  const double distance = 4.0 * (view.depth + view.scale);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(view.scale);
  camera->SetFocalPoint(view.center[0], view.center[1], view.center[2]);
  camera->SetPosition(view.center[0] + distance * view.back[0],
    view.center[1] + distance * view.back[1], view.center[2] + distance * view.back[2]);
  camera->SetViewUp(view.up[0], view.up[1], view.up[2]);
  const double reach = 1.2 * (view.depth + 0.1 * view.scale);
  camera->SetClippingRange(distance - reach, distance + reach);
}

} // namespace

void CheckDisplay()
{
#ifdef RIDGES_HAVE_X11
  const vtkNew<vtkRenderWindow> window;
  if (!window->IsA("vtkXOpenGLRenderWindow"))
  {
    return;
  }
  Display* display = XOpenDisplay(nullptr);
  if (!display)
  {
    const char* name = std::getenv("DISPLAY");
    throw Failure(name && *name ? std::string("the X display ") + name + " cannot be opened"
                                : std::string("there is no X display to draw the picture on"),
      "run under xvfb-run -a, or add --no-picture");
  }
  XCloseDisplay(display);
#endif
}

vtkSmartPointer<vtkImageData> DrawPicture(
  vtkPolyData* mesh, vtkPolyData* ridges, vtkPolyData* umbilics, const PictureOptions& options)
{
  const double aspect = static_cast<double>(options.size[0]) / options.size[1];
  const std::vector<Vector3> points = PointsOfSurface(mesh);
  const View view = FindView(points, options.view, options.up, aspect, 0.04);

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  AddSurface(renderer, mesh);
  // Thickness in pixels of a picture 1200 high; half of it for a thicket of lines.
  const double pixel = 2.0 * view.scale / 1200.0;
  const bool isThicket = ridges->GetNumberOfCells() > 5000;
  AddRidges(renderer, ridges, view, (isThicket ? 1.3 : umbilics ? 2.6 : 3.6) * pixel);
  if (umbilics)
  {
    const bool areMany = umbilics->GetNumberOfPoints() > 200;
    AddUmbilics(renderer, umbilics, view, (areMany ? 4.0 : 7.0) * pixel);
  }
  AddLegend(renderer, LegendRows(ridges, umbilics), options.size, view, points);
  SetUpCamera(renderer->GetActiveCamera(), view);
  renderer->AutomaticLightCreationOff();
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightWarmth(0.5);
  lights->SetFillLightWarmth(0.5);
  lights->SetHeadLightWarmth(0.5);
  lights->SetKeyToFillRatio(2.2);
  lights->AddLightsToRenderer(renderer);

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetSize(options.size[0], options.size[1]);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->SetInputBufferTypeToRGB();
  image->ReadFrontBufferOff();
  image->ShouldRerenderOff();
  image->Update();
  return image->GetOutput();
}

} // namespace program
