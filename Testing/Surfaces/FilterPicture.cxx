// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterPicture.h"

#include "FilterTestTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRidgesArrayNames.h"

#include <map>

namespace ridges
{
namespace testing
{

namespace names = vtkRidgesArrayNames;
using Eigen::Matrix3d;
using Eigen::Vector3d;

//------------------------------------------------------------------------------
FoundPicture PictureOf(vtkPolyData* umbilics, vtkPolyData* ridges, const Matrix3d& rotation)
{
  FoundPicture picture;
  const auto place = [&rotation](vtkPolyData* data, vtkIdType id) -> Vector3d
  { return rotation.transpose() * PointAt(data, id); };
  for (vtkIdType i = 0; i < umbilics->GetNumberOfPoints(); ++i)
  {
    vtkPointData* values = umbilics->GetPointData();
    picture.umbilics.push_back({ place(umbilics, i), Value(values, names::Index, i),
      static_cast<int>(Value(values, names::RidgeCount, i)) });
  }

  vtkCellData* lines = ridges->GetCellData();
  std::map<vtkIdType, FoundRidge> byId;
  std::map<vtkIdType, std::map<vtkIdType, int>> endsOf; // of polylines, by ridge and point
  vtkNew<vtkIdList> line;
  for (vtkIdType cell = 0; cell < ridges->GetNumberOfLines(); ++cell)
  {
    ridges->GetLines()->GetCellAtId(cell, line);
    const auto id = static_cast<vtkIdType>(Value(lines, names::RidgeId, cell));
    FoundLine found;
    found.type = static_cast<int>(Value(lines, names::RidgeType, cell));
    for (vtkIdType i = 0; i < line->GetNumberOfIds(); ++i)
    {
      found.points.push_back(place(ridges, line->GetId(i)));
    }
    byId[id].lines.push_back(found);
    ++endsOf[id][line->GetId(0)];
    ++endsOf[id][line->GetId(line->GetNumberOfIds() - 1)];
  }
  vtkPointData* points = ridges->GetPointData();
  for (auto& [id, ridge] : byId)
  {
    for (const auto& [point, ends] : endsOf[id])
    {
      const int umbilic = static_cast<int>(Value(points, names::Umbilic, point));
      const bool isUmbilic = umbilic >= 0 ||
        (Value(points, names::EdgePoint0, point) < 0.0 &&
          Value(points, names::TurningPoint, point) == 0.0);
      // Where two polylines of a ridge meet outside umbilics it goes on.
      const int count = isUmbilic ? ends : ends % 2;
      ridge.ends.insert(
        ridge.ends.end(), count, { place(ridges, point), isUmbilic ? umbilic : FoundEnd::OnEdge });
    }
    picture.ridges.push_back(ridge);
  }
  return picture;
}

} // namespace testing
} // namespace ridges
