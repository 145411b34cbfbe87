// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CertifiedSurface_h
#define CertifiedSurface_h

#include "Certification/SurfacePiece.h"
#include "Formula/ExactSurface.h"
#include "Formula/FormulaParser.h"

#include <string>

namespace ridges
{
namespace testing
{

/// A formula with both kinds of bounds.
class CertifiedSurface
{
public:
  CertifiedSurface(const std::string& formula, FormulaFunction::Kind kind)
    : function(ParseFormula(formula, Variables(kind)).program, kind)
    , proof(this->function)
    , samples(this->function)
    , exact(this->function)
  {
  }

  /// The point of a graph over x and y.
  Eigen::Vector3d Over(double x, double y) const
  {
    const Eigen::Vector3d start(x, y, 0.0);
    const Eigen::Vector3d up(0.0, 0.0, 1.0);
    return start + HeightAlong(this->proof, start, up, 0.0) * up;
  }

  /// The triangle, or with two equal corners the edge, with exact normals.
  MappedTriangle Mapped(const std::array<Eigen::Vector3d, 3>& corners) const
  {
    MappedTriangle whole;
    for (int i = 0; i < 3; ++i)
    {
      whole.point[i] = corners[i];
      whole.normal[i] = this->FrameAt(corners[i]).col(2);
    }
    return whole;
  }

  Eigen::Matrix3d FrameAt(const Eigen::Vector3d& x) const
  {
    return PrincipalFrameAt(this->proof, x).axes;
  }

  const FormulaFunction function;
  const IntervalBounds proof;
  const SampledBounds samples;
  const ImplicitExactSurface exact;

private:
  static std::vector<std::string> Variables(FormulaFunction::Kind kind)
  {
    return kind == FormulaFunction::Kind::Graph ? std::vector<std::string>{ "x", "y" }
                                                : std::vector<std::string>{ "x", "y", "z" };
  }
};

} // namespace testing
} // namespace ridges

#endif
