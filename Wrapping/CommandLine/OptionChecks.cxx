// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionChecks.h"

#include "Reading/PiecesReader.h"

#include <algorithm>
#include <array>
#include <vector>

namespace program
{
namespace
{

/// Options that were given although they have no effect.
void CheckEffects(const CLI::App& app, const Options& options, const Filters& filters)
{
  struct Condition
  {
    const char* option;
    bool hasEffect;
    const char* where;
  };
  const int neighborhood = filters.jetFitting->GetNeighborhood();
  const bool isPrincipal = filters.ridges->GetExtremalityRule() == vtkRidgeExtraction::PRINCIPAL;
  const bool hasPicture = !options.noPicture;
  const Condition conditions[] = {
    { "--merge", !options.mesh.empty(), "without MESH" },
    { "--no-merge", !options.mesh.empty(), "without MESH" },
    { "--orient", !options.mesh.empty(), "without MESH" },
    { "--semi-axes", filters.example->GetSurface() == vtkRidgeExampleSource::ELLIPSOID,
      "without --surface ellipsoid" },
    { "--bounds", !options.formula.empty() && options.mesh.empty(),
      "without --formula, or with MESH" },
    { "--edge-length", options.HasForms() && options.mesh.empty(),
      "without --formula or --image, or with MESH" },
    { "--certify", !options.formula.empty(), "without --formula" },
    { "--minimum-number-of-points", neighborhood == vtkJetFitting::BY_POINT_COUNT,
      "without --neighborhood point-count" },
    { "--number-of-rings", neighborhood == vtkJetFitting::BY_RINGS,
      "without --neighborhood rings" },
    { "--radius", neighborhood == vtkJetFitting::BY_RADIUS, "without --neighborhood radius" },
    { "--no-blend-noisy-fits",
      neighborhood == vtkJetFitting::AUTOMATIC && filters.jetFitting->GetDegree() == 0,
      "without --neighborhood automatic, or with --degree" },
    { "--umbilic-significance", filters.umbilics->GetMethod() == vtkUmbilicDetection::INDICES,
      "with --umbilic-method minima" },
    { "--umbilic-joining", isPrincipal, "with --extremality-rule gaussian" },
    { "--extract", isPrincipal, "with --extremality-rule gaussian" },
    { "--keep-crest-only", !filters.ridges->GetCrestOnly(), "with --crest-only" },
    { "--rank-by", filters.sharpness->GetMaximumNumber() > 0, "without --keep-first" },
    { "--picture-size", hasPicture, "with --no-picture" },
    { "--view", hasPicture, "with --no-picture" },
    { "--up", hasPicture, "with --no-picture" },
    { "--check", !options.certify, "with --certify, which checks more" },
    { "--check", options.strict || !options.quiet, "with --quiet and without --strict" },
  };
  for (const Condition& condition : conditions)
  {
    if (!condition.hasEffect && app.count(condition.option) > 0)
    {
      throw Contradiction(std::string(condition.option) + " has no effect " + condition.where);
    }
  }
}

bool IsOfGroup(const CLI::Option* option, std::initializer_list<const char*> groups)
{
  return std::any_of(groups.begin(), groups.end(),
    [option](const char* group) { return option->get_group() == group; });
}

/// An option given that only works with one of both kinds of lines; empty if there is none.
std::string OptionOf(const CLI::App& app, Lines lines)
{
  for (const CLI::Option* option : app.get_options())
  {
    const bool isOfComplete =
      IsOfGroup(option, { "Jet fitting", "Umbilics", "Ridges", "Filter" }) ||
      option->check_name("--check") || option->check_name("--strict");
    const bool isOfKind =
      lines == Lines::Complete ? isOfComplete : IsOfGroup(option, { "Salient lines" });
    if (option->count() > 0 && isOfKind)
    {
      return option->get_name();
    }
  }
  return {};
}

/// Settles which lines are wanted if the options say so. The example surface and those of formulas
/// and smoothed images are smooth.
void CheckLines(const CLI::App& app, Options& options)
{
  const std::string complete = OptionOf(app, Lines::Complete);
  const std::string salient = OptionOf(app, Lines::Salient);
  if (options.lines == Lines::ByData)
  {
    if (!complete.empty() && !salient.empty())
    {
      throw Contradiction(salient + " is for salient lines, " + complete + " for all ridges");
    }
    const bool isExample = options.mesh.empty() || options.HasForms();
    options.lines = !salient.empty()   ? Lines::Salient
      : !complete.empty() || isExample ? Lines::Complete
                                       : Lines::ByData;
  }
  const std::string& idle = options.lines == Lines::Complete ? salient : complete;
  if (options.lines != Lines::ByData && !idle.empty())
  {
    throw Contradiction(idle + " has no effect with " +
      (options.lines == Lines::Complete ? "--complete" : "--salient"));
  }
}

void CheckFormula(const CLI::App& app, const Options& options)
{
  if (app.count("--formula") > 0 && options.formula.empty())
  {
    throw Contradiction("--formula is empty");
  }
  if (options.formula.empty())
  {
    return;
  }
  if (options.lines == Lines::Salient)
  {
    throw Contradiction("--formula gives exact ridges of all kinds, not salient lines");
  }
  if (options.mesh.empty() && app.count("--bounds") == 0)
  {
    throw Contradiction("--formula needs --bounds, the box to look for the surface in, or MESH");
  }
  for (const CLI::Option* option : app.get_options())
  {
    if (options.certify && option->count() > 0 && IsOfGroup(option, { "Umbilics", "Ridges" }))
    {
      throw Contradiction(option->get_name() + " has no effect with --certify");
    }
  }
}

void CheckImage(const CLI::App& app, const Options& options)
{
  if (app.count("--image") > 0 && options.image.empty())
  {
    throw Contradiction("--image is empty");
  }
  if (!options.image.empty() && app.count("--isovalue") == 0)
  {
    throw Contradiction("--image needs --isovalue, the value on the surface");
  }
}

/// There is no fit where forms are computed.
void CheckForms(const CLI::App& app, const Options& options)
{
  for (const CLI::Option* option : app.get_options())
  {
    if (options.HasForms() && option->count() > 0 && IsOfGroup(option, { "Jet fitting" }))
    {
      throw Contradiction(option->get_name() + " has no effect with " +
        (options.formula.empty() ? "--image" : "--formula"));
    }
  }
}

void CheckFit(const Filters& filters)
{
  constexpr int fourthOrder = 4;
  const int degree = filters.jetFitting->GetDegree();
  const int order = degree > 0 ? std::min(filters.jetFitting->GetMongeOrder(), degree)
                               : filters.jetFitting->GetMongeOrder();
  if (order < fourthOrder && filters.ridges->GetTypeRule() == vtkRidgeExtraction::FOURTH_ORDER)
  {
    throw Contradiction("--degree and --monge-order less than 4 need --type-rule third-order");
  }
  if (filters.jetFitting->GetNeighborhood() == vtkJetFitting::BY_RADIUS &&
    filters.jetFitting->GetRadius() <= 0.0)
  {
    throw Contradiction("--neighborhood radius needs a positive --radius");
  }
}

void CheckChecks(const CLI::App& app, const Options& options, const Filters& filters)
{
  if (!options.check)
  {
    return;
  }
  if (app.count("--extract") + app.count("--crest-only") > 0)
  {
    throw Contradiction("--check needs all ridges, without --extract and --crest-only");
  }
  if (filters.ridges->GetExtremalityRule() == vtkRidgeExtraction::GAUSSIAN)
  {
    throw Contradiction("--check needs --extremality-rule principal");
  }
}

/// What takes the whole mesh at once on one rank, or a filter that knows of nothing else.
void CheckRanks(const CLI::App& app, Options& options)
{
  const bool areSeveral = options.numberOfRanks > 1;
  if (!areSeveral && options.pieces == 1)
  {
    return;
  }
  const auto refuse = [areSeveral](const std::string& name, const std::string& reason)
  {
    throw Contradiction(name + " does not work " +
      (areSeveral ? "on several ranks (mpirun)" : "with --pieces") + reason);
  };
  if (!areSeveral && !IsOfPieces(options.mesh))
  {
    throw Contradiction("--pieces needs a MESH that is in pieces, a .pvtp");
  }
  std::vector<const char*> names = { "--salient", "--monge-order", "--extract", "--crest-only",
    "--extremality-rule", "--check", "--picture-size", "--view", "--up" };
  names.push_back(areSeveral ? "--pieces" : "--write-mesh");
  for (const CLI::Option* option : app.get_options())
  {
    const bool isNamed = std::any_of(
      names.begin(), names.end(), [option](const char* name) { return option->check_name(name); });
    if (option->count() > 0 &&
      (isNamed || IsOfGroup(option, { "Formula", "Image", "Salient lines" })))
    {
      refuse(option->get_name(), "");
    }
  }
  if (IsOfPieces(options.mesh) && app.count("--orient") > 0)
  {
    refuse("--orient", " with the pieces of a .pvtp");
  }
  options.lines = Lines::Complete;
  options.noPicture = true;
}

} // namespace

void CheckOptions(const CLI::App& app, Options& options, const Filters& filters)
{
  if (app.count("MESH") > 0 && options.mesh.empty())
  {
    throw Contradiction("the name of MESH is empty, as from a variable that is not set");
  }
  if (app.count("--output") > 0 && options.output.empty())
  {
    throw Contradiction("--output is empty");
  }
  const double* axes = filters.example->GetSemiAxes();
  if (std::min({ axes[0], axes[1], axes[2] }) <= 0.0)
  {
    throw Contradiction("the three --semi-axes must be positive");
  }
  for (const std::optional<std::array<double, 3>>& direction :
    { options.picture.view, options.picture.up })
  {
    if (direction && *direction == std::array<double, 3>{ 0.0, 0.0, 0.0 })
    {
      throw Contradiction("--view and --up need a direction, which 0,0,0 is not");
    }
  }
  CheckRanks(app, options);
  CheckLines(app, options);
  CheckFormula(app, options);
  CheckImage(app, options);
  CheckForms(app, options);
  CheckEffects(app, options, filters);
  CheckFit(filters);
  CheckChecks(app, options, filters);
}

} // namespace program
