// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Monge/AcuteRule.h"

#include <cmath>

namespace ridges
{

double CrossingParameter(double extremalityAtP, double extremalityAtQ)
{
  const double atP = std::abs(extremalityAtP);
  const double atQ = std::abs(extremalityAtQ);
  const double sum = atP + atQ;
  return sum > 0.0 ? atP / sum : 0.5;
}

bool IsRegular(const TriangleMesh& mesh, const MongeField& field, Id triangle)
{
  const Triangle& c = mesh.Corners(triangle);
  return AcuteSign(field, c[0], c[1]) * AcuteSign(field, c[1], c[2]) *
    AcuteSign(field, c[2], c[0]) >
    0;
}

} // namespace ridges
