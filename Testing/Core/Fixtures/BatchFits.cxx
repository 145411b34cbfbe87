// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Fixtures/BatchFits.h"

#include "Fixtures/MongeComparison.h"
#include "Fixtures/TestFields.h"

#include "Fit/JetFit.h"

#include <algorithm>

namespace ridges
{
namespace testing
{

void FitAdded(JetBatchFiller& filler, const JetBatchKernel& kernel, std::vector<BatchFit>& fits)
{
  filler.Fit(kernel,
    [&fits, &kernel](const JetBatch& batch, Span<Id> vertices)
    {
      for (int lane = 0; lane < vertices.size(); ++lane)
      {
        BatchFit& fit = fits[vertices[lane]];
        fit.good = TakeResult(batch, kernel.lanes, lane, fit.form);
        fit.P1 = batch.P1[lane];
        fit.P2 = batch.P2[lane];
        fit.conditionNumber = batch.conditionNumber[lane];
        fit.residual = batch.residual[lane];
        fit.radius = batch.radius[lane];
        fit.noiseGain = batch.noiseGain[lane];
        fit.doubtful = batch.doubtful[lane] != 0.0;
        for (int i = 0; batch.standardErrors && i < JetBatch::NumberOfErrors; ++i)
        {
          fit.errors[i] = batch.errors[i * kernel.lanes + lane];
        }
      }
    });
}

std::vector<BatchFit> FitAll(const TriangleMesh& mesh, const JetBatchKernel& kernel, int degree,
  int minimumNumberOfPoints, Id first, Weighting weighting, bool standardErrors, bool exactGain)
{
  const OrderedRings rings = RingsOf(mesh);
  RingNeighborhood neighborhood(mesh, rings);
  NeighborhoodRule rule;
  rule.minimumNumberOfPoints = minimumNumberOfPoints;
  std::vector<BatchFit> fits(mesh.NumberOfPoints());
  JetBatchFiller filler(mesh, rings, degree, weighting, standardErrors, exactGain);
  for (Id i = 0; i < mesh.NumberOfPoints(); ++i)
  {
    const Id p = (i + first) % mesh.NumberOfPoints();
    filler.Add(p, neighborhood.Gather(p, rule));
    if (filler.IsFull())
    {
      FitAdded(filler, kernel, fits);
    }
  }
  FitAdded(filler, kernel, fits);
  return fits;
}

NeighborhoodRule RuleFor(int degree)
{
  NeighborhoodRule rule;
  rule.minimumNumberOfPoints = std::max(18, JetFitter::FewestPoints(degree));
  return rule;
}

Mesh ToMesh(const PointsAndTriangles& input)
{
  Mesh mesh;
  for (Eigen::Index p = 0; p < input.points.cols(); ++p)
  {
    mesh.AddPoint(input.points.col(p));
  }
  for (const Triangle& t : input.triangles)
  {
    mesh.AddTriangle(t[0], t[1], t[2]);
  }
  return mesh;
}

} // namespace testing
} // namespace ridges
