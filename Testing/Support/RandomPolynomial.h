// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Polynomials without any symmetry, to make surfaces generic.

#ifndef RIDGES_TESTING_RANDOM_POLYNOMIAL_H
#define RIDGES_TESTING_RANDOM_POLYNOMIAL_H

#include <cstdint>
#include <vector>

namespace ridges
{
namespace testing
{

// All monomials of degrees first to last in x, y, z, with coefficients in [-1, 1) drawn from the
// seed. Evaluates for numbers and for jets alike.
class RandomPolynomial
{
public:
  RandomPolynomial(int first, int last, std::uint64_t seed);

  template <typename Number>
  Number operator()(const Number& x, const Number& y, const Number& z) const
  {
    const std::vector<Number> powersOfX = this->Powers(x);
    const std::vector<Number> powersOfY = this->Powers(y);
    const std::vector<Number> powersOfZ = this->Powers(z);
    Number sum(0.0);
    for (const Term& term : this->Terms)
    {
      sum += term.factor * (powersOfX[term.i] * powersOfY[term.j] * powersOfZ[term.k]);
    }
    return sum;
  }

private:
  struct Term
  {
    int i, j, k;
    double factor;
  };

  template <typename Number>
  std::vector<Number> Powers(const Number& x) const
  {
    std::vector<Number> powers(1, Number(1.0));
    for (int n = 1; n <= this->Degree; ++n)
    {
      powers.push_back(powers.back() * x);
    }
    return powers;
  }

  int Degree;
  std::vector<Term> Terms;
};

} // namespace testing
} // namespace ridges

#endif
