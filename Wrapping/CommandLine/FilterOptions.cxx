// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterOptions.h"

#include "OptionGroup.h"

#include "vtkJetFitting.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgeSharpnessFilter.h"
#include "vtkSalientRidges.h"
#include "vtkUmbilicDetection.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace program
{
namespace
{

/// The five switches of the types in one option, as a list.
void AddKeep(CLI::App& app, vtkRidgeSharpnessFilter* filter)
{
  using Class = vtkRidgeSharpnessFilter;
  struct Type
  {
    std::string name;
    void (Class::*set)(bool);
    bool (Class::*get)();
  };
  const std::vector<Type> types{
    { "blue", &Class::SetKeepMaximumElliptic, &Class::GetKeepMaximumElliptic },
    { "green", &Class::SetKeepMaximumHyperbolic, &Class::GetKeepMaximumHyperbolic },
    { "red", &Class::SetKeepMinimumElliptic, &Class::GetKeepMinimumElliptic },
    { "yellow", &Class::SetKeepMinimumHyperbolic, &Class::GetKeepMinimumHyperbolic },
    { "undecided", &Class::SetKeepUndecided, &Class::GetKeepUndecided },
  };
  std::string initial;
  for (const Type& type : types)
  {
    if ((filter->*type.get)())
    {
      initial += (initial.empty() ? "" : ",") + type.name;
    }
  }
  // Split here: a list option of CLI11 would take the arguments behind it for more types.
  const auto keep = [types, filter](const std::string& text)
  {
    std::vector<bool> isWanted(types.size(), false);
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');)
    {
      std::transform(word.begin(), word.end(), word.begin(),
        [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      const auto type = std::find_if(
        types.begin(), types.end(), [&word](const Type& known) { return known.name == word; });
      if (type == types.end())
      {
        throw CLI::ValidationError("--keep", text + " is not a list of types");
      }
      isWanted[static_cast<std::size_t>(type - types.begin())] = true;
    }
    for (std::size_t i = 0; i < types.size(); ++i)
    {
      (filter->*types[i].set)(isWanted[i]);
    }
  };
  app
    .add_option_function<std::string>("--keep", keep,
      "types of lines to keep: blue (maximum, elliptic), green (maximum, hyperbolic), red "
      "(minimum, "
      "elliptic), yellow (minimum, hyperbolic), undecided")
    ->type_name("TYPE,...")
    ->default_str(initial)
    ->group("Filter");
}

} // namespace

void AddJetFitting(CLI::App& app, vtkJetFitting* filter)
{
  constexpr int leastOrder = 3; // Ridges are where a third derivative vanishes.
  OptionGroup group(app, "Jet fitting");
  group
    .Number<int>(
      "--degree", "N", filter->GetDegree(), { leastOrder, filter->GetDegreeMaxValue() },
      [filter](int value) { filter->SetDegree(value); },
      "degree of the polynomial fitted at each point; without it, --neighborhood automatic chooses "
      "one, and the others take 4")
    ->default_str("");
  group.Number<int>(
    "--monge-order", "N", filter->GetMongeOrder(), { leastOrder, filter->GetMongeOrderMaxValue() },
    [filter](int value) { filter->SetMongeOrder(value); },
    "highest order of the derivatives; 3 needs --type-rule third-order");
  group.Choice(
    "--neighborhood",
    { { "point-count", vtkJetFitting::BY_POINT_COUNT }, { "rings", vtkJetFitting::BY_RINGS },
      { "radius", vtkJetFitting::BY_RADIUS }, { "automatic", vtkJetFitting::AUTOMATIC } },
    filter->GetNeighborhood(), [filter](int value) { filter->SetNeighborhood(value); },
    "how large the neighbourhood of a point is; automatic chooses the degree and 2 to 24 rings by "
    "the noise of the mesh, unless --minimum-number-of-points is given");
  group.Number<int>(
    "--minimum-number-of-points", "N", filter->GetMinimumNumberOfPoints(),
    { filter->GetMinimumNumberOfPointsMinValue(), filter->GetMinimumNumberOfPointsMaxValue() },
    [filter](int value) { filter->SetMinimumNumberOfPoints(value); },
    "least number of points; means --neighborhood point-count");
  group.Number<int>(
    "--number-of-rings", "N", filter->GetNumberOfRings(),
    { filter->GetNumberOfRingsMinValue(), filter->GetNumberOfRingsMaxValue() },
    [filter](int value) { filter->SetNumberOfRings(value); },
    "number of rings, for --neighborhood rings");
  group.Number<double>(
    "--radius", "LENGTH", filter->GetRadius(), { 0.0, AnyLength },
    [filter](double value) { filter->SetRadius(value); },
    "radius in units of the mesh, for --neighborhood radius");
  group.Choice(
    "--weighting",
    { { "uniform", vtkJetFitting::UNIFORM }, { "gaussian", vtkJetFitting::GAUSSIAN } },
    filter->GetWeighting(), [filter](int value) { filter->SetWeighting(value); },
    "weight of the points in a neighbourhood; gaussian decreases with their distance");
  group.Flag(
    "--no-blend-noisy-fits", [filter](bool off) { filter->SetBlendNoisyFits(!off); },
    "on noisy meshes do not blend fits of several degrees and numbers of rings at each point, for "
    "--neighborhood automatic: faster, finds fewer whole ridges and umbilics");
  group.Flag(
    "--standard-errors", [filter](bool on) { filter->SetStandardErrors(on); },
    "compute standard errors of the derivatives; --write-mesh writes them too");
}

void CompleteNeighborhood(const CLI::App& app, vtkJetFitting* filter)
{
  if (app.count("--neighborhood") == 0 && app.count("--minimum-number-of-points") > 0)
  {
    filter->SetNeighborhoodToPointCount();
  }
}

void AddUmbilics(CLI::App& app, vtkUmbilicDetection* filter)
{
  OptionGroup group(app, "Umbilics");
  group.Choice(
    "--umbilic-method",
    { { "indices", vtkUmbilicDetection::INDICES }, { "minima", vtkUmbilicDetection::MINIMA } },
    filter->GetMethod(), [filter](int value) { filter->SetMethod(value); },
    "how umbilics are found: by the index of every triangle, which misses none, or at minima of "
    "k1 - k2, as in the paper");
  group.Number<double>(
    "--umbilic-significance", "ERRORS", filter->GetSignificance(),
    { filter->GetSignificanceMinValue(), filter->GetSignificanceMaxValue() },
    [filter](double value) { filter->SetSignificance(value); },
    "number of standard errors within which k1 - k2 counts as 0; opposite umbilics that such "
    "places "
    "connect cancel each other, as noise may have caused them");
  group.Number<double>(
    "--patch-size", "FACTOR", filter->GetPatchSize(),
    { filter->GetPatchSizeMinValue(), filter->GetPatchSizeMaxValue() },
    [filter](double value) { filter->SetPatchSize(value); },
    "size of the patch around an umbilic, as a multiple of the triangles there");
}

void AddRidges(CLI::App& app, vtkRidgeExtraction* filter)
{
  constexpr int maximum = 1;
  constexpr int minimum = 2;
  OptionGroup group(app, "Ridges");
  group.Choice(
    "--extract", { { "maximum", maximum }, { "minimum", minimum }, { "both", maximum | minimum } },
    (filter->GetExtractMaximum() ? maximum : 0) | (filter->GetExtractMinimum() ? minimum : 0),
    [filter](int value)
    {
      filter->SetExtractMaximum((value & maximum) != 0);
      filter->SetExtractMinimum((value & minimum) != 0);
    },
    "principal curvature whose ridges are extracted");
  group.Flag(
    "--crest-only", [filter](bool on) { filter->SetCrestOnly(on); },
    "extract only crest lines, the visually salient ridges");
  group.Choice(
    "--type-rule",
    { { "fourth-order", vtkRidgeExtraction::FOURTH_ORDER },
      { "third-order", vtkRidgeExtraction::THIRD_ORDER } },
    filter->GetTypeRule(), [filter](int value) { filter->SetTypeRule(value); },
    "order of the derivatives that decide whether a ridge is elliptic or hyperbolic");
  group.Choice(
    "--extremality-rule",
    { { "principal", vtkRidgeExtraction::PRINCIPAL },
      { "gaussian", vtkRidgeExtraction::GAUSSIAN } },
    filter->GetExtremalityRule(), [filter](int value) { filter->SetExtremalityRule(value); },
    "where ridges are: where a principal curvature is extremal or, for comparison, where the "
    "product "
    "of both extremalities changes sign");
  group.Choice(
    "--umbilic-joining",
    { { "patches", vtkRidgeExtraction::PATCHES }, { "triangles", vtkRidgeExtraction::TRIANGLES } },
    filter->GetUmbilicJoining(), [filter](int value) { filter->SetUmbilicJoining(value); },
    "where ridges are connected to umbilics: in their patches or, less reliably, in single "
    "triangles");
  group.Number<double>(
    "--loop-significance", "ERRORS", filter->GetLoopSignificance(),
    { filter->GetLoopSignificanceMinValue(), filter->GetLoopSignificanceMaxValue() },
    [filter](double value) { filter->SetLoopSignificance(value); },
    "small loops whose extremality is within this many standard errors of 0 are omitted, as noise "
    "may "
    "have caused them; 0 keeps all");
  group.Number<double>(
    "--zone-significance", "ERRORS", filter->GetZoneSignificance(),
    { filter->GetZoneSignificanceMinValue(), filter->GetZoneSignificanceMaxValue() },
    [filter](double value) { filter->SetZoneSignificance(value); },
    "ridges in regions whose extremality is nowhere more than this many standard errors from 0, as "
    "on cylinders, are omitted; 0 keeps all");
  group.Number<double>(
    "--type-significance", "ERRORS", filter->GetTypeSignificance(),
    { filter->GetTypeSignificanceMinValue(), filter->GetTypeSignificanceMaxValue() },
    [filter](double value) { filter->SetTypeSignificance(value); },
    "stretches of one type over which P is within this many standard errors of 0 take the type of "
    "both neighbours, as noise may have caused them; 0 keeps all");
  group.Number<double>(
    "--type-hysteresis", "EDGES", filter->GetTypeHysteresis(),
    { filter->GetTypeHysteresisMinValue(), filter->GetTypeHysteresisMaxValue() },
    [filter](double value) { filter->SetTypeHysteresis(value); },
    "stretches of one type that are shorter than this many mean edges take the type of both "
    "neighbours; 0 keeps all");
  group.Number<double>(
    "--model-size", "LENGTH", filter->GetModelSize(),
    { filter->GetModelSizeMinValue(), filter->GetModelSizeMaxValue() },
    [filter](double value) { filter->SetModelSize(value); },
    "length that makes sharpness dimensionless; 0: the radius of the smallest enclosing sphere");
  group.Number<double>(
    "--umbilic-cut-off", "FACTOR", filter->GetUmbilicCutOff(),
    { filter->GetUmbilicCutOffMinValue(), filter->GetUmbilicCutOffMaxValue() },
    [filter](double value) { filter->SetUmbilicCutOff(value); },
    "distance from umbilics, in model sizes, within which the sharpness of hyperbolic ridges is "
    "not "
    "integrated, as it diverges there");
}

void AddSharpness(CLI::App& app, vtkRidgeSharpnessFilter* filter)
{
  OptionGroup group(app, "Filter");
  group.Number<double>(
    "--minimum-sharpness", "S", filter->GetMinimumSharpness(),
    { filter->GetMinimumSharpnessMinValue(), filter->GetMinimumSharpnessMaxValue() },
    [filter](double value) { filter->SetMinimumSharpness(value); },
    "least sharpness of a line, dimensionless; 100 to 1000 removes most of the noise");
  group.Number<double>(
    "--minimum-strength", "S", filter->GetMinimumStrength(),
    { filter->GetMinimumStrengthMinValue(), filter->GetMinimumStrengthMaxValue() },
    [filter](double value) { filter->SetMinimumStrength(value); },
    "least strength of a line, the integral of its curvature, dimensionless");
  group.Number<double>(
    "--minimum-length", "LENGTH", filter->GetMinimumLength(),
    { filter->GetMinimumLengthMinValue(), filter->GetMinimumLengthMaxValue() },
    [filter](double value) { filter->SetMinimumLength(value); },
    "least length of a line, in units of the mesh");

  AddKeep(app, filter);
  group.Flag(
    "--whole-ridges", [filter](bool on) { filter->SetWholeRidges(on); },
    "apply the minima and --keep-first to whole ridges, summed over the lines of the types kept");
  group.Number<int>(
    "--keep-first", "N", filter->GetMaximumNumber(),
    { filter->GetMaximumNumberMinValue(), filter->GetMaximumNumberMaxValue() },
    [filter](int value) { filter->SetMaximumNumber(value); },
    "keep at most so many lines, or whole ridges, the first by --rank-by; 0 keeps all");
  group.Choice(
    "--rank-by",
    { { "sharpness", vtkRidgeSharpnessFilter::SHARPNESS },
      { "strength", vtkRidgeSharpnessFilter::STRENGTH },
      { "length", vtkRidgeSharpnessFilter::LENGTH } },
    filter->GetRankBy(), [filter](int value) { filter->SetRankBy(value); },
    "what --keep-first ranks by");
  group.Flag(
    "--keep-crest-only", [filter](bool on) { filter->SetCrestOnly(on); },
    "keep only crest lines of what is extracted");
}

void AddSalient(CLI::App& app, vtkSalientRidges* filter)
{
  OptionGroup group(app, "Salient lines");
  group.Number<double>(
    "--fold-angle", "DEGREES", filter->GetFoldAngle(),
    { filter->GetFoldAngleMinValue(), filter->GetFoldAngleMaxValue() },
    [filter](double value) { filter->SetFoldAngle(value); },
    "angle by which the surface folds somewhere along every line; more gives fewer lines");
  group.Number<double>(
    "--relative-scale", "SHARE", filter->GetRelativeScale(),
    { filter->GetRelativeScaleMinValue(), filter->GetRelativeScaleMaxValue() },
    [filter](double value) { filter->SetRelativeScale(value); },
    "size of the smallest features, as a share of the model's diameter");
  group.Number<double>(
    "--hysteresis", "SHARE", filter->GetHysteresis(),
    { filter->GetHysteresisMinValue(), filter->GetHysteresisMaxValue() },
    [filter](double value) { filter->SetHysteresis(value); },
    "share of --fold-angle by which a line folds everywhere");
  group.Number<double>(
    "--longest-gap", "SCALES", filter->GetLongestGap(),
    { filter->GetLongestGapMinValue(), filter->GetLongestGapMaxValue() },
    [filter](double value) { filter->SetLongestGap(value); },
    "longest gap along a ridge that is bridged, in units of the scale");
  group.Number<double>(
    "--least-mass", "SHARE", filter->GetLeastMass(),
    { filter->GetLeastMassMinValue(), filter->GetLeastMassMaxValue() },
    [filter](double value) { filter->SetLeastMass(value); },
    "least mass of a line: its length, over the model's diameter, if it folded by --fold-angle "
    "everywhere");
  group.Number<double>(
    "--noise-factor", "DEVIATIONS", filter->GetNoiseFactor(),
    { filter->GetNoiseFactorMinValue(), filter->GetNoiseFactorMaxValue() },
    [filter](double value) { filter->SetNoiseFactor(value); },
    "number of standard deviations of noise by which the angles that lines need are raised; 0 "
    "does not estimate noise");
  group.Number<double>(
    "--line-smoothing", "SCALES", filter->GetLineSmoothing(),
    { filter->GetLineSmoothingMinValue(), filter->GetLineSmoothingMaxValue() },
    [filter](double value) { filter->SetLineSmoothing(value); },
    "how far lines are smoothed on the surface, in units of the scale");
  group.Flag(
    "--not-crest-only", [filter](bool on) { filter->SetCrestOnly(!on); },
    "keep also ridges of the smaller of both curvatures");
}

} // namespace program
