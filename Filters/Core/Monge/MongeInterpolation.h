// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_MongeInterpolation_h
#define ridges_MongeInterpolation_h

#include "Base/SymmetricTensor.h"
#include "Monge/MongeField.h"
#include "Monge/MongeForm.h"

namespace ridges
{

/**
 * The Monge form on the way from p to q, two neighbours.
 *
 * Principal frames turn fast near umbilics, so that coefficients of neighbours do not belong to
 * the same axes. What is interpolated are the tensors behind them, brought to one frame: the
 * second, third and fourth-order form. The principal frame of the result is that of its second
 * order. (On the blend of Fig. 25 with 40k points P is then right to 6 % at the ridge points within
 * three edges of an umbilic, where P interpolated as a number is wrong by a factor of five.)
 */
class MongeInterpolation
{
public:
  MongeInterpolation(const MongeField& field, Id p, Id q);

  /**
   * The form at the fraction t of the way. Orders that the field does not have come out as zero.
   * d1, d2 and n are those of p, turned.
   */
  MongeForm At(double t) const;

  /// What a ridge needs of the form: P1 or P2 is 0 if the field does not have the fourth order.
  struct Extremum
  {
    double k1;
    double k2;
    double P;
  };
  Extremum ExtremumAt(Color color, double t) const;

  /// b0 or b3 alone, at the fraction t of the way. At 0 it is that of p, and at 1 that of q in the
  /// frame that the acute rule turns it to: the signs at the ends differ where IsCrossed.
  double Extremality(Color color, double t) const;

  /// Extremality but for a positive factor, and the step along t to where it would vanish if it
  /// kept its slope.
  struct NewtonStep
  {
    double value;
    double step;
  };
  NewtonStep StepToCrossing(Color color, double t) const;

  /// A turn in the tangent plane.
  struct Turn
  {
    double cosine;
    double sine;
  };

private:
  struct SecondOrder
  {
    double k1;
    double k2;
    Turn turn; ///< Of d1 from that of p.
  };
  SecondOrder SecondOrderAt(double t) const;

  MongeField Field_;
  Id P_;
  Id Q_;
  Turn Turn_; ///< Of the frame of q from that of p.

  /// In the frame of p: k1 + k2 of both, k1 - k2 of p, and of q as a vector at twice the angle of
  /// d1.
  double SumP_;
  double SumQ_;
  double GapP_;
  double AlongQ_;
  double AcrossQ_;
  SymmetricTensor<3> ThirdOrderP_;
  SymmetricTensor<3> ThirdOrderQ_;
};

} // namespace ridges

#endif
