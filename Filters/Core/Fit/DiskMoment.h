// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_DiskMoment_h
#define ridges_DiskMoment_h

namespace ridges
{

/// The mean of u^i v^j over the unit disk: 2 (i - 1)!! (j - 1)!! / (i + j + 2)!! for even powers.
constexpr double DiskMoment(int i, int j)
{
  if (i % 2 != 0 || j % 2 != 0)
  {
    return 0.0;
  }
  double moment = 1.0;
  for (int k = 2; k <= i; k += 2)
  {
    moment *= (k - 1.0) / (k + 2.0);
  }
  for (int k = 2; k <= j; k += 2)
  {
    moment *= (k - 1.0) / (i + k + 2.0);
  }
  return moment;
}

} // namespace ridges

#endif
