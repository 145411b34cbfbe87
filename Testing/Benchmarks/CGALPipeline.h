// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The same steps with CGAL's packages Jet_fitting_3 and Ridges_3, on a Surface_mesh with its
// property maps, the fastest that these packages take. CGAL leaves the gathering of neighbourhoods
// to its users: here rings of neighbours, marked in a property map, until there are 18 points.
//
// Building the mesh is not part of any of the times.

#ifndef RIDGES_BENCHMARKS_CGAL_PIPELINE_H
#define RIDGES_BENCHMARKS_CGAL_PIPELINE_H

#include "Minimum.h"

#include "vtkPolyData.h"

#include <cstddef>
#include <functional>
#include <memory>

namespace benchmarks
{

class CGALPipeline
{
public:
  // Whole rings until there are that many points.
  explicit CGALPipeline(vtkPolyData* mesh, int degree = 4, int numberOfPoints = 18);
  ~CGALPipeline();
  CGALPipeline(const CGALPipeline&) = delete;
  CGALPipeline& operator=(const CGALPipeline&) = delete;

  // One pass over all points. The times are the sums over blocks of points of the least that each
  // has taken in any pass yet: a long run has a chance of quiet moments as good as short ones have.
  // `between`, if given, is run ten times between blocks, for what CGAL is to be compared with: the
  // speed of a shared processor changes within seconds.
  Times Fit(const std::function<void()>& between = {});

  // The same of every so-manieth block of 256 points only, scaled to all.
  Times FitSome(int everyBlock, const std::function<void()>& between);

  // Both colours with types of the fourth order; the number of lines.
  std::size_t ExtractRidges() const;

  // The number of umbilics in patches of that size.
  std::size_t DetectUmbilics(double patchSize) const;

private:
  struct Data;
  std::unique_ptr<Data> Members;
};

} // namespace benchmarks

#endif
