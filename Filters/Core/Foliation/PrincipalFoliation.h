// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PrincipalFoliation_h
#define ridges_PrincipalFoliation_h

#include "Base/Monitor.h"
#include "Foliation/SurfaceWalk.h"
#include "Foliation/TracedSegments.h"

#include <vector>

namespace ridges
{

/// All lengths are in the unit of the points.
struct FoliationRule
{
  Color color = Color::Blue;
  double separation = 0.0;      ///< Distance of a new line's seed from the lines before it.
  double leastDistance = 0.0;   ///< Nearer to another line, or to itself, a line ends.
  double minimumLength = 0.0;   ///< Shorter lines are dropped.
  double maximumLength = 0.0;   ///< Lines are cut there.
  double step = 0.0;            ///< Longest step inside a triangle.
  double closingDistance = 0.0; ///< So near to its seed a line that comes back is closed.
};

struct CurvatureLine
{
  std::vector<Eigen::Vector3d> points; ///< A loop does not repeat its first point.
  std::vector<double> curvatures;      ///< Of the line's colour, at the points.
  double length = 0.0;
  bool closed = false;
};

/**
 * Evenly spaced curvature lines of one colour, after B. Jobard and W. Lefer, "Creating
 * evenly-spaced streamlines of arbitrary density" (1997), on a surface.
 *
 * The first line is the longest of some. Along every line, and across it at the separation on both
 * sides, there are candidates for the seeds of further ones; those of the longest line are taken
 * first, and of these the one where k1 - k2 is greatest, if no other line has come too near. So
 * lines grow beside long ones, in step with them, and short ones fill what is left. Where no
 * candidate is left, but a triangle farther than the separation from all lines is, the next line
 * starts there, again where k1 - k2 is greatest: other components of the surface, and what lies
 * behind umbilics, are reached that way, and no gap remains but where lines would be shorter than
 * the minimum.
 *
 * Order comes from curvatures and coordinates alone, so that a renumbered mesh has the same lines.
 */
class PrincipalFoliation
{
public:
  /// Lines end at singular triangles, which hold an umbilic, and at those with closed[t] != 0.
  PrincipalFoliation(const TriangleMesh& mesh, const MongeField& field, const FoliationRule& rule,
    std::vector<std::uint8_t> closed = {});
  PrincipalFoliation(const PrincipalFoliation&) = delete;
  PrincipalFoliation& operator=(const PrincipalFoliation&) = delete;

  /// False if the monitor stopped it, which gets the fraction of the surface that is covered.
  bool Trace(const Monitor& monitor = NeverStops);

  const std::vector<CurvatureLine>& Lines() const { return this->Lines_; }

private:
  struct Seed
  {
    double parentLength; ///< Of the line that it is a candidate of.
    double gap;
    Eigen::Vector3d position;
    Id triangle;

    /// The longest parent first, and then the greatest gap; where all is equal, by coordinates.
    bool operator<(const Seed& other) const;
  };
  /// Which of a line's own segments do not count as near: those around the end that grows, and,
  /// as long as it may still close, those around its seed.
  struct OwnRange
  {
    double arc;
    bool ignoreSeed;
  };

  std::vector<Seed> SeedsInTriangles();
  void TraceLongest(const std::vector<Seed>& seeds);
  void TraceCandidates();
  bool IsFree(const Seed& seed);
  bool TraceLine(const Seed& seed);
  double TraceSegments(const Seed& seed, std::size_t& middle, bool& closed);
  void DropSegments(std::size_t first);
  bool TraceHalf(double sign, double longest);
  bool CloseAt(const Eigen::Vector3d& direction);
  double DistanceToLines(double radius, const OwnRange& own);
  bool StoreLine(std::size_t first, std::size_t middle, bool closed);
  void AddCandidates(std::size_t first);
  void Cover(std::size_t first);
  void CoverAround(const Eigen::Vector3d& center, Id triangle, double radius);
  void CountBall();
  bool Report();

  const TriangleMesh& Mesh_;
  MongeField Field_;
  FoliationRule Rule_;
  std::vector<std::uint8_t> Closed_;  ///< No line enters.
  std::vector<std::uint8_t> Covered_; ///< No line is to start here.
  Id NumberOfCovered_ = 0;
  TracedSegments Segments_;
  SurfaceWalk Walk_;
  Seed Seed_{};
  Eigen::Vector2d SeedDirection_ = Eigen::Vector2d::Zero();
  Id Line_ = 0;
  std::vector<Seed> Candidates_; ///< A heap, the first on top.
  std::vector<CurvatureLine> Lines_;
  Monitor Monitor_;
  int UntilReport_ = 0;
  bool Stopped_ = false;
};

} // namespace ridges

#endif
