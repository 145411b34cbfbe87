// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fit/ImageScale.h"

#include "Fit/FieldErrors.h"
#include "Formula/ExactSurface.h"
#include "Formula/ImageNoise.h"
#include "Formula/SmoothedImage.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ridges
{
namespace
{

constexpr std::size_t MostPlaces = 300;

/// Where the image takes the value between two samples of a row, along any axis: every so many of
/// these, so that there are not too many.
std::vector<Eigen::Vector3d> PlacesOnSurface(const ImageGrid& grid, double value)
{
  const std::array<std::size_t, 3> step = { 1, static_cast<std::size_t>(grid.size[0]),
    static_cast<std::size_t>(grid.size[0]) * grid.size[1] };
  std::vector<Eigen::Vector3d> places;
  std::size_t stride = 1;
  std::size_t found = 0;
  const auto look = [&](const std::array<int, 3>& at, int axis)
  {
    const std::size_t i = at[0] + step[1] * at[1] + step[2] * at[2];
    const double here = grid.values[i] - value;
    const double next = grid.values[i + step[axis]] - value;
    if ((here < 0.0) == (next < 0.0) || !std::isfinite(here) || !std::isfinite(next) ||
      found++ % stride != 0)
    {
      return;
    }
    Eigen::Vector3d index(at[0], at[1], at[2]);
    index[axis] += here / (here - next);
    places.emplace_back(grid.origin + grid.axes * index.cwiseProduct(grid.spacing));
    if (places.size() == 2 * MostPlaces)
    {
      for (std::size_t k = 0; k < MostPlaces; ++k)
      {
        places[k] = places[2 * k];
      }
      places.resize(MostPlaces);
      stride *= 2;
    }
  };
  for (int k = 0; k + 1 < grid.size[2]; ++k)
  {
    for (int j = 0; j + 1 < grid.size[1]; ++j)
    {
      for (int i = 0; i + 1 < grid.size[0]; ++i)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          look({ i, j, k }, axis);
        }
      }
    }
  }
  return places;
}

double Median(std::vector<double>& values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Squares of the norms of b and of its errors.
struct Measured
{
  double b = 0.0;
  double error = 0.0;
};

Measured Measure(SurfacePoints& points, int lane, double noise, double sigma)
{
  constexpr double times[] = { 1.0, 3.0, 3.0, 1.0 };
  constexpr double leastByCurvature = 0.05;
  const MongeForm& form = points.form[lane];
  const JetErrors errors = ErrorsOfDisplacement(form, noise / points.steepness[lane], sigma);
  Measured measured;
  for (int i = 0; i < 4; ++i)
  {
    measured.b += times[i] * form.b[i] * form.b[i];
    measured.error += times[i] * errors.b[i] * errors.b[i];
  }
  // On spheres and cylinders there is no b for errors to be small against.
  const double least = leastByCurvature * (form.k1 * form.k1 + form.k2 * form.k2);
  measured.b = std::max(measured.b, least * least);
  return measured;
}

/// The ratio of the medians of error and b; 0 where there is no surface.
double ErrorOfThirdOrder(const ImageGrid& smoothed, double value, double noise, double sigma,
  const std::vector<Eigen::Vector3d>& places, const RangeLoop& loop)
{
  const ImageFunction function(smoothed, sigma, value);
  const ImplicitExactSurface surface(function);
  std::vector<Measured> all(places.size());
  std::vector<std::uint8_t> isGood(places.size(), 0);
  loop(static_cast<Id>(places.size()),
    [&](Id begin, Id end)
    {
      for (Id first = begin; first < end; first += Lanes::Count)
      {
        SurfacePoints points;
        points.count = static_cast<int>(std::min<Id>(Lanes::Count, end - first));
        std::copy_n(places.begin() + first, points.count, points.position.begin());
        surface.Locate(points);
        surface.Differentiate(points);
        for (int lane = 0; lane < points.count; ++lane)
        {
          isGood[first + lane] = points.fault[lane] == ExactFault::None ? 1 : 0;
          all[first + lane] =
            isGood[first + lane] ? Measure(points, lane, noise, sigma) : Measured();
        }
      }
    });
  std::vector<double> squares;
  std::vector<double> errors;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (isGood[i])
    {
      squares.push_back(all[i].b);
      errors.push_back(all[i].error);
    }
  }
  const double square = squares.empty() ? 0.0 : Median(squares);
  return square > 0.0 ? std::sqrt(Median(errors) / square) : 0.0;
}

} // namespace

double ChooseImageScale(const ImageGrid& grid, double value, double least, const RangeLoop& loop)
{
  constexpr double mostError = 0.25;
  constexpr double orderOfError = 4.5;
  constexpr double samplesAcross = 16.0;
  const SmoothedImage first(grid, least, loop, 0.0);
  const std::vector<Eigen::Vector3d> places = PlacesOnSurface(first.Grid(), value);
  std::vector<double> coordinates;
  for (const Eigen::Vector3d& place : places)
  {
    coordinates.insert(coordinates.end(), place.data(), place.data() + 3);
  }
  const double noise =
    EstimateImageNoise(grid, { coordinates.data(), coordinates.data() + coordinates.size() });
  double most = least;
  for (int i = 0; i < 3; ++i)
  {
    most = std::max(most, grid.size[i] * grid.spacing[i] / samplesAcross);
  }
  for (double sigma = least; noise > 0.0; sigma = std::min(2.0 * sigma, most))
  {
    const SmoothedImage smoothed(grid, sigma, loop);
    const double error = ErrorOfThirdOrder(
      smoothed.Grid(), value, noise * SmoothedNoise(grid, sigma), sigma, places, loop);
    if (error <= mostError)
    {
      const double enough = sigma * std::pow(error / mostError, 1.0 / orderOfError);
      return std::max(least, std::max(enough, 0.5 * sigma));
    }
    if (sigma >= most)
    {
      return most;
    }
  }
  return least;
}

} // namespace ridges
