// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_Finite_h
#define ridges_Finite_h

namespace ridges
{

/// Whether all values are finite: without a branch for each, as nearly always all are.
inline bool AllFinite(const double* begin, const double* end)
{
  constexpr int lanes = 8;
  double zeros[lanes] = {};
  for (; end - begin >= lanes; begin += lanes)
  {
    for (int i = 0; i < lanes; ++i)
    {
      zeros[i] += 0.0 * begin[i];
    }
  }
  for (; begin != end; ++begin)
  {
    zeros[0] += 0.0 * *begin;
  }
  bool finite = true;
  for (const double zero : zeros)
  {
    finite = finite && zero == 0.0;
  }
  return finite;
}

} // namespace ridges

#endif
