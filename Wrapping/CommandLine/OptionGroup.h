// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OptionGroup_h
#define OptionGroup_h

#include "Reading/TextLines.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace program
{

template <typename T>
std::string ToText(const T& value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

template <typename T>
struct Range
{
  T minimum;
  T maximum;

  std::string AsText() const
  {
    // Bounds that only say what the type can hold are none.
    return static_cast<double>(this->maximum) >= std::numeric_limits<int>::max()
      ? ToText(this->minimum) + " or more"
      : ToText(this->minimum) + " to " + ToText(this->maximum);
  }

  bool Contains(double value) const
  {
    return std::isfinite(value) && value >= static_cast<double>(this->minimum) &&
      value <= static_cast<double>(this->maximum);
  }
};

inline constexpr double AnyLength = std::numeric_limits<double>::max();

/// An enumeration by the names of its values.
using Names = std::vector<std::pair<std::string, int>>;

/// Adds options to a group, with ranges and defaults in their description. The value of an option
/// goes to a setter, and its default is what the getter's value was.
class OptionGroup
{
public:
  OptionGroup(CLI::App& app, std::string name)
    : App(app)
    , Name(std::move(name))
  {
  }

  template <typename T, typename Setter>
  CLI::Option* Number(const std::string& flag, const std::string& unit, T value,
    const Range<T>& range, const Setter& set, const std::string& description)
  {
    const auto check = [range](const std::string& text)
    {
      const std::optional<double> number = ToReal(text);
      const bool isInteger = number && *number == std::floor(*number);
      const bool fits = number && (isInteger || !std::is_integral_v<T>)&&range.Contains(*number);
      return fits ? std::string() : text + " is not in the range, " + range.AsText();
    };
    return this->App
      .add_option_function<T>(
        flag, [set](const T& number) { set(number); }, description + " (" + range.AsText() + ")")
      ->check(CLI::Validator(check, "", "range"))
      ->type_name(unit)
      ->default_str(ToText(value))
      ->group(this->Name);
  }

  template <typename Setter>
  CLI::Option* Choice(const std::string& flag, const Names& names, int value, const Setter& set,
    const std::string& description)
  {
    std::string all;
    std::string initial;
    std::vector<std::string> keys;
    for (const auto& [key, number] : names)
    {
      all += (all.empty() ? "" : ", ") + key;
      initial = number == value ? key : initial;
      keys.push_back(key);
    }
    const auto setByName = [names, set](const std::string& name)
    {
      for (const auto& [key, number] : names)
      {
        if (key == name)
        {
          set(number);
        }
      }
    };
    return this->App.add_option_function<std::string>(flag, setByName, description + ": " + all)
      ->transform(CLI::IsMember(keys, CLI::ignore_case))
      ->type_name("NAME")
      ->default_str(initial)
      ->group(this->Name);
  }

  /// So many numbers with commas between them.
  template <std::size_t Count, typename Setter>
  CLI::Option* Numbers(const std::string& flag, const std::string& type, const std::string& initial,
    const Setter& set, const std::string& description)
  {
    using Values = std::vector<double>;
    return this->App
      .add_option_function<Values>(
        flag,
        [set](const Values& values)
        {
          std::array<double, Count> all{};
          std::copy_n(values.begin(), Count, all.begin());
          set(all);
        },
        description)
      ->expected(static_cast<int>(Count))
      ->delimiter(',')
      ->check(CLI::Validator(
        [](const std::string& text)
        {
          const std::optional<double> number = ToReal(text);
          return number && std::isfinite(*number) ? std::string() : text + " is not a number";
        },
        "", "finite"))
      ->type_name(type)
      ->default_str(initial)
      ->group(this->Name);
  }

  template <typename Setter>
  CLI::Option* Triple(const std::string& flag, const std::string& initial, const Setter& set,
    const std::string& description)
  {
    return this->Numbers<3>(flag, "X,Y,Z", initial, set, description);
  }

  CLI::Option* Text(const std::string& flag, const std::string& type, std::string& value,
    const std::string& description)
  {
    return this->App.add_option(flag, value, description)->type_name(type)->group(this->Name);
  }

  template <typename Setter>
  CLI::Option* Flag(const std::string& flag, const Setter& set, const std::string& description)
  {
    return this->App
      .add_flag_callback(
        flag, [set] { set(true); }, description)
      ->group(this->Name);
  }

private:
  CLI::App& App;
  std::string Name;
};

} // namespace program

#endif
