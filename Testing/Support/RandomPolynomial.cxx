// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RandomPolynomial.h"

#include "AnalyticSurface.h"

#include <random>

namespace ridges
{
namespace testing
{

RandomPolynomial::RandomPolynomial(int first, int last, std::uint64_t seed)
  : Degree(last)
{
  std::mt19937_64 generator(seed);
  for (int degree = first; degree <= last; ++degree)
  {
    for (int i = 0; i <= degree; ++i)
    {
      for (int j = 0; i + j <= degree; ++j)
      {
        this->Terms.push_back({ i, j, degree - i - j, 2 * Uniform(generator) - 1 });
      }
    }
  }
}

} // namespace testing
} // namespace ridges
