// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_SymmetricTensor_h
#define ridges_SymmetricTensor_h

#include <Eigen/Core>

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

/// The same tensor over the axes e and f, given in the old ones.
template <std::size_t Size>
std::array<double, Size> InBasis(
  const std::array<double, Size>& tensor, const Eigen::Vector2d& e, const Eigen::Vector2d& f)
{
  if constexpr (Size == 1)
  {
    return tensor;
  }
  else
  {
    const auto withE = InBasis(Contract(tensor, e), e, f);
    const auto withF = InBasis(Contract(tensor, f), e, f);
    std::array<double, Size> result{};
    result[0] = withE[0];
    for (std::size_t j = 1; j < Size; ++j)
    {
      result[j] = withF[j - 1];
    }
    return result;
  }
}

} // namespace ridges

#endif
