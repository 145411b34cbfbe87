// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Legend.h"

#include "vtkActor2D.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRegularPolygonSource.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace program
{
namespace
{

/// A rectangle in pixels.
struct Rectangle
{
  double left;
  double bottom;
  double width;
  double height;
};

Rectangle FindCorner(double width, double height, const std::array<int, 2>& pictureSize,
  const View& view, const std::vector<Vector3>& points)
{
  const double margin = 0.03 * pictureSize[1];
  const double right = pictureSize[0] - margin - width;
  const double top = pictureSize[1] - margin - height;
  std::array<Rectangle, 4> corners{ { { margin, margin, width, height },
    { right, margin, width, height }, { margin, top, width, height },
    { right, top, width, height } } };
  std::array<std::size_t, 4> hidden{};
  for (const Vector3& point : points)
  {
    const std::array<double, 2> projected = view.Project(point);
    const double x = 0.5 * (pictureSize[0] + projected[0] * pictureSize[1]);
    const double y = 0.5 * (1.0 + projected[1]) * pictureSize[1];
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const Rectangle& corner = corners[i];
      const bool isInside = x >= corner.left && x <= corner.left + width && y >= corner.bottom &&
        y <= corner.bottom + height;
      hidden[i] += isInside ? 1 : 0;
    }
  }
  return corners[std::min_element(hidden.begin(), hidden.end()) - hidden.begin()];
}

/// A disk, or a thick line as a flat quadrilateral.
void AddMark(
  vtkRenderer* renderer, const LegendRow& row, double x, double y, double length, double thickness)
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  if (row.isDot)
  {
    vtkNew<vtkRegularPolygonSource> disk;
    disk->SetNumberOfSides(24);
    disk->SetRadius(0.9 * thickness);
    disk->SetCenter(x + 0.5 * length, y, 0.0);
    mapper->SetInputConnection(disk->GetOutputPort());
  }
  else
  {
    vtkNew<vtkPoints> points;
    for (const double side : { -0.5, 0.5 })
    {
      points->InsertNextPoint(x, y + side * thickness, 0.0);
      points->InsertNextPoint(x + length, y + side * thickness, 0.0);
    }
    vtkNew<vtkCellArray> quadrilateral;
    const vtkIdType corners[4] = { 0, 1, 3, 2 };
    quadrilateral->InsertNextCell(4, corners);
    vtkNew<vtkPolyData> mark;
    mark->SetPoints(points);
    mark->SetPolys(quadrilateral);
    mapper->SetInputData(mark);
  }
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(row.color[0], row.color[1], row.color[2]);
  renderer->AddActor2D(actor);
}

} // namespace

void AddLegend(vtkRenderer* renderer, const std::vector<LegendRow>& rows,
  const std::array<int, 2>& pictureSize, const View& view, const std::vector<Vector3>& points)
{
  const int fontSize = std::max(8, pictureSize[1] / 55);
  const double rowHeight = 1.6 * fontSize;
  const double markLength = 2.2 * fontSize;
  const double gap = 0.7 * fontSize;
  std::size_t longest = 0;
  for (const LegendRow& row : rows)
  {
    longest = std::max(longest, row.text.size());
  }
  const double width = markLength + gap + 0.5 * fontSize * static_cast<double>(longest);
  const double height = rowHeight * static_cast<double>(rows.size());
  const Rectangle place = FindCorner(width, height, pictureSize, view, points);

  double y = place.bottom + height - 0.5 * rowHeight;
  for (const LegendRow& row : rows)
  {
    AddMark(renderer, row, place.left, y, markLength, 0.35 * fontSize);
    vtkNew<vtkTextActor> text;
    text->SetInput(row.text.c_str());
    text->SetPosition(place.left + markLength + gap, y);
    text->GetTextProperty()->SetFontFamilyToArial();
    text->GetTextProperty()->SetFontSize(fontSize);
    text->GetTextProperty()->SetColor(0.25, 0.25, 0.25);
    text->GetTextProperty()->SetVerticalJustificationToCentered();
    renderer->AddActor2D(text);
    y -= rowHeight;
  }
}

} // namespace program
