// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_ExtremalityErrors_h
#define ridges_ExtremalityErrors_h

#include "Fit/FitErrors.h"
#include "Mesh/CoordinateRounding.h"
#include "Mesh/IdTable.h"
#include "Monge/MongeField.h"

#include <cstdint>
#include <vector>

namespace ridges
{

/**
 * Whether the extremality of a colour, b0 or b3, is significant around a point: its squares, summed
 * over two rings, against those of its errors. On a ridge it is 0, but not around it.
 *
 * An error has these parts:
 * - noise: the heights that the fits around the point leave over, times what the fit magnifies
 *   noise by in the third order;
 * - the rounding of the coordinates, magnified in the same way, and that of the fit itself;
 * - the difference between b0 (b3) and the derivative of k1 (k2) along its direction, taken from
 *   the curvatures of the points around. For exact values it is 0. What the polynomials cannot
 *   follow shows here even on regular meshes, where it hardly shows in the heights left over.
 *
 * Where nothing is known of fits, only rounding counts.
 *
 * After Begin, Measure, Sum and Judge look at ranges of points, all of which are to be looked at,
 * one step after the other. Different ranges of one step may be done at the same time.
 */
class ExtremalityErrors
{
public:
  /// All of it has to outlive the object.
  struct Source
  {
    const TriangleMesh& mesh;
    const MongeField& field;
    const FitErrorSource& errors;
    const std::vector<std::uint8_t>& isFlagged; ///< Per point: 0 or as below; or empty.
  };

  /// Of fits that are not good: at a border or ill conditioned; or for other reasons.
  static constexpr std::uint8_t FlaggedAsInexact = 1;
  static constexpr std::uint8_t FlaggedAsWrong = 2;

  enum class Verdict : std::uint8_t
  {
    Unknown,       ///< Next to a border or to a fit that is flagged.
    RoundOff,      ///< 0 but for rounding.
    Insignificant, ///< Within its errors.
    Faint,         ///< No farther above them than chance has it somewhere.
    Significant,
    Unresolved ///< The surface turns and is rough within the radius of a fit, or folds over.
  };

  /// What exceeds `significance` standard errors is significant if it also exceeds half as many
  /// more of noise alone, else faint. Large fits err alike over wide areas, so that sums over two
  /// rings do not average noise out: on one noisy plane in ten there is an area above three
  /// standard errors.
  ExtremalityErrors(const Source& source, Color color, double significance);

  void Begin();
  void Measure(Id begin, Id end);
  void Sum(Id begin, Id end);
  void Judge(Id begin, Id end);

  const std::vector<Verdict>& Verdicts() const { return this->Verdicts_; }

  /// After Measure: the mean square of the extremality of some points, in that of its errors. 0 if
  /// it is not known of any.
  double MeanSquareInErrors(const std::vector<Id>& points) const;

  /// Before Begin: the verdict on a point. Not for several threads at the same time.
  Verdict VerdictAt(Id p);

private:
  struct Sums
  {
    double square = 0.0;
    double squaredError = 0.0;
    double squaredNoise = 0.0; ///< The part of noise and rounding.
  };

  /// Of the triangles around a point.
  struct Surroundings
  {
    bool isFlagged = false;  ///< Any of their points.
    double height = 0.0;     ///< That fits leave over, averaged over their points.
    double derivative = 0.0; ///< Of the curvature along its direction.
  };

  Surroundings LookAround(Id p) const;
  double RadiusAt(Id p) const;
  double GainAt(Id p) const;
  bool IsBad(Id p) const;
  bool IsUnresolved(Id p) const;
  bool IsRoundOff(Id p) const;
  double LargestCoordinate(Id p) const;
  double Magnified(double height, Id p, double radius) const;
  double RoundingError(Id p, double radius) const;
  Sums At(Id p) const;
  Verdict Compare(const Sums& sums) const;
  template <typename AtPoint>
  Sums OverRing(Id p, const AtPoint& atPoint) const;

  Source Source_;
  Color Color_;
  double Significance_;
  CoordinateRounding Rounding_;
  Verdict FindVerdict(Id p);

  IdTable<Sums> Asked_;     ///< Of points that VerdictAt needed.
  IdTable<Verdict> Told_;   ///< By VerdictAt.
  std::vector<Sums> Own_;   ///< Per point.
  std::vector<Sums> Rings_; ///< Per point, over its ring.
  std::vector<Verdict> Verdicts_;
};

} // namespace ridges

#endif
