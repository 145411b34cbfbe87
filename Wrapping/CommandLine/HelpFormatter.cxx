// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HelpFormatter.h"

#include <algorithm>
#include <sstream>

namespace program
{

HelpFormatter::HelpFormatter(std::vector<std::string> namesInShort)
  : NamesInShort(std::move(namesInShort))
{
}

std::string HelpFormatter::make_help(
  const CLI::App* app, std::string name, CLI::AppFormatMode mode) const
{
  const bool isShort = mode != CLI::AppFormatMode::All;
  const auto isListed = [this, isShort](const CLI::Option* option)
  {
    return !isShort ||
      std::any_of(this->NamesInShort.begin(), this->NamesInShort.end(),
        [option](const std::string& inShort) { return option->check_name(inShort); });
  };
  std::string text = app->get_description() + "\n\nUsage: " + name + " [MESH] [OPTION]...\n";
  // Unlike in the base class, the positional argument is listed in its group.
  for (const std::string& group : app->get_groups())
  {
    const auto options = app->get_options([&group, &isListed](const CLI::Option* option)
      { return option->get_group() == group && isListed(option); });
    if (!group.empty() && !options.empty())
    {
      text += "\n" + group + ":\n";
      for (const CLI::Option* option : options)
      {
        text += this->make_option(option, option->get_positional());
      }
    }
  }
  return text + "\n" + app->get_footer() + "\n";
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool isPositional) const
{
  constexpr std::size_t column = 29;
  constexpr std::size_t width = 80;
  std::string name = option->get_name(isPositional, !isPositional);
  if (const auto comma = name.find(','); comma != std::string::npos)
  {
    name.insert(comma + 1, " ");
  }
  if (!isPositional && option->get_type_size() != 0)
  {
    // Without the lists of names that CLI11 appends: the descriptions have them.
    const std::string type = option->get_type_name();
    name += " " + type.substr(0, type.find(':'));
  }
  std::string text = "  " + name;
  if (text.size() + 2 > column)
  {
    text += "\n" + std::string(column, ' ');
  }
  else
  {
    text.resize(column, ' ');
  }

  std::string description = option->get_description();
  if (!option->get_default_str().empty())
  {
    description += " [" + option->get_default_str() + "]";
  }
  std::istringstream words(description);
  std::size_t at = column;
  for (std::string word; words >> word;)
  {
    if (at > column && at + 1 + word.size() > width)
    {
      text += "\n" + std::string(column, ' ');
      at = column;
    }
    else if (at > column)
    {
      text += ' ';
      ++at;
    }
    text += word;
    at += word.size();
  }
  return text + "\n";
}

} // namespace program
