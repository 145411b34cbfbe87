// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_CoordinateRounding_h
#define ridges_CoordinateRounding_h

namespace ridges
{

class TriangleMesh;

/**
 * How the coordinates of a mesh may have been rounded: to single or double precision, and to a few
 * decimal digits, as in files of text. On regular meshes rounding repeats from row to row, so that
 * residuals of fits may not show it.
 */
struct CoordinateRounding
{
  static constexpr int NotDecimal = 10; ///< So many digits or more.

  bool isSingle = true; ///< All coordinates are numbers of single precision.
  int digits = 0;       ///< The most significant decimal digits that any coordinate has.
  double largest = 0.0; ///< Of the coordinates, by absolute value, where these are rounded.

  CoordinateRounding& Include(double coordinate);
  CoordinateRounding& Include(const CoordinateRounding& other);

  /// The largest error of precision as a part of a coordinate: half a unit in the last place.
  double OfPrecision() const;

  /// The standard deviation of the error of digits at a coordinate; 0 if there is none. Up to four
  /// digits count as meant: those of grids and voxels.
  double OfDigits(double coordinate) const;

  /// Whether it is coarser than double precision.
  bool IsCoarse() const { return this->isSingle || this->digits < NotDecimal; }

  /// The standard deviation of the error at the largest coordinate; 0 if it is not coarse.
  double Height() const;
};

/// Of a part of a mesh: that of the whole mesh.
CoordinateRounding FindCoordinateRounding(const TriangleMesh& mesh);

} // namespace ridges

#endif
