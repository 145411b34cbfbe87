// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_Monitor_h
#define ridges_Monitor_h

#include <functional>

namespace ridges
{

/// Called from time to time with the fraction that is done; false stops the work, which then has no
/// result.
using Monitor = std::function<bool(double done)>;

/// A monitor that never stops anything.
inline bool NeverStops(double)
{
  return true;
}

} // namespace ridges

#endif
