// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SymmetricTensor_h
#define ridges_SymmetricTensor_h

#include <Eigen/Core>

#include <algorithm>
#include <array>

namespace ridges
{

/**
 * A symmetric tensor of order n over the plane, as its n + 1 different values: value j takes the
 * second axis j times. The derivatives of one degree of a function are such a tensor.
 */
template <int Order>
using SymmetricTensor = std::array<double, Order + 1>;

/// One slot filled with a vector: a tensor of one order less.
template <std::size_t Size>
std::array<double, Size - 1> Contract(
  const std::array<double, Size>& tensor, const Eigen::Vector2d& w)
{
  std::array<double, Size - 1> result{};
  for (std::size_t j = 0; j + 1 < Size; ++j)
  {
    result[j] = tensor[j] * w[0] + tensor[j + 1] * w[1];
  }
  return result;
}

/// The first value of the tensor over axes that begin with e: every slot filled with e.
template <std::size_t Size>
double ContractAll(const std::array<double, Size>& tensor, const Eigen::Vector2d& e)
{
  std::array<double, Size> left = tensor;
  for (std::size_t count = Size - 1; count > 0; --count)
  {
    for (std::size_t j = 0; j < count; ++j)
    {
      left[j] = left[j] * e[0] + left[j + 1] * e[1];
    }
  }
  return left[0];
}

/// One value of the tensor over the axes e and f, given in the old ones.
template <std::size_t J, std::size_t Size>
double ValueInBasis(
  const std::array<double, Size>& tensor, const Eigen::Vector2d& e, const Eigen::Vector2d& f)
{
  if constexpr (J == 0)
  {
    return ContractAll(tensor, e);
  }
  else
  {
    return ValueInBasis<J - 1>(Contract(tensor, f), e, f);
  }
}

/// The same tensor over the axes e and f, given in the old ones.
template <std::size_t Size>
std::array<double, Size> InBasis(
  const std::array<double, Size>& tensor, const Eigen::Vector2d& e, const Eigen::Vector2d& f)
{
  std::array<double, Size> result{};
  result[0] = ContractAll(tensor, e);
  if constexpr (Size > 1)
  {
    const auto others = InBasis(Contract(tensor, f), e, f);
    std::copy(others.begin(), others.end(), result.begin() + 1);
  }
  return result;
}

} // namespace ridges

#endif
