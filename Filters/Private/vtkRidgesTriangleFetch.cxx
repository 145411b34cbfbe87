// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesTriangleFetch.h"

#include "Core/Base/Finite.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <limits>

namespace
{

using ridges::Id;
using ridges::Triangle;

/// Whether all cells are triangles, by their sizes.
bool AreTriangles(vtkCellArray* cells)
{
  const vtkIdType count = cells->GetNumberOfCells();
  return count == 0 ||
    (cells->IsHomogeneous() == 3 && cells->GetNumberOfConnectivityIds() >= 3 * count);
}

/// The usual case, done in parallel: whether all triangles have three different points. Loops
/// without branches, over values in a row.
struct FetchTriangles
{
  template <typename Array>
  void operator()(Array* connectivity, vtkIdType numberOfPoints,
    ridges::Buffer<Triangle>& triangles, bool& good) const
  {
    const auto ids = vtk::DataArrayValueRange<1>(connectivity).begin();
    std::atomic<bool> allGood(true);
    vtkSMPTools::For(0, static_cast<vtkIdType>(triangles.size()),
      [ids, numberOfPoints, &triangles, &allGood](vtkIdType begin, vtkIdType end)
      {
        if (!Narrow(ids + 3 * begin, ids + 3 * end, numberOfPoints, triangles[begin].data()) ||
          !HaveThreePoints(triangles.data() + begin, triangles.data() + end))
        {
          allGood = false;
        }
      });
    good = allGood;
  }

private:
  template <typename Iterator>
  static bool Narrow(Iterator begin, Iterator end, vtkIdType numberOfPoints, Id* narrowed)
  {
    using PointId = typename std::iterator_traits<Iterator>::value_type;
    PointId bits = 0;
    Id largest = 0;
    for (Iterator p = begin; p != end; ++p)
    {
      const PointId wide = *p;
      const auto id = static_cast<Id>(wide);
      bits |= wide;
      largest = std::max(largest, id);
      *narrowed++ = id;
    }
    return bits >= 0 && bits <= std::numeric_limits<Id>::max() && largest < numberOfPoints;
  }

  static bool HaveThreePoints(const Triangle* begin, const Triangle* end)
  {
    bool all = true;
    for (const Triangle* c = begin; c < end; ++c)
    {
      all &= ((*c)[0] != (*c)[1]) & ((*c)[1] != (*c)[2]) & ((*c)[2] != (*c)[0]);
    }
    return all;
  }
};

/// The types of ids that vtkCellArray stores. Others take the slow way.
using StoredIds = vtkArrayDispatch::DispatchByValueType<vtkTypeList::Create<int, long, long long>>;

bool AllFinite(const double* points, vtkIdType count)
{
  std::atomic<bool> finite(true);
  vtkSMPTools::For(0, count,
    [points, &finite](vtkIdType begin, vtkIdType end)
    {
      if (!ridges::AllFinite(points + 3 * begin, points + 3 * end))
      {
        finite = false;
      }
    });
  return finite;
}

} // namespace

bool vtkRidgesFetchAllTriangles(vtkPolyData* data, const double* points,
  const std::vector<std::uint8_t>& usable, ridges::Buffer<Triangle>& triangles)
{
  const vtkIdType numberOfPoints = data->GetNumberOfPoints();
  vtkCellArray* polys = data->GetPolys();
  if (data->GetNumberOfStrips() > 0 || std::find(usable.begin(), usable.end(), 0) != usable.end() ||
    !AreTriangles(polys) || !AllFinite(points, numberOfPoints))
  {
    return false;
  }
  triangles = ridges::Buffer<Triangle>(polys->GetNumberOfCells());
  bool good = false;
  return StoredIds::Execute(
           polys->GetConnectivityArray(), FetchTriangles{}, numberOfPoints, triangles, good) &&
    good;
}
