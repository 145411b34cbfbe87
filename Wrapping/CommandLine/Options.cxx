// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "HelpFormatter.h"
#include "OptionChecks.h"
#include "OptionGroup.h"
#include "Reading/MeshReader.h"

#include "vtkVersion.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>

namespace program
{
namespace
{

// ---------------------------------------------------------------------------------- the options

using Vector3 = std::array<double, 3>;

void AddInput(CLI::App& app, Options& options, vtkRidgeExampleSource* example)
{
  OptionGroup group(app, "Input");
  CLI::Option* mesh = group.Text("MESH", "FILE", options.mesh,
    std::string("mesh to read (") + ReadableExtensions() +
      "); without it, the program uses an example surface");
  CLI::Option* merge = group.Flag(
    "--merge", [&options](bool) { options.repair.joining = Joining::All; },
    "join all points of MESH at the same place, not only those on borders, as along seams");
  group
    .Flag(
      "--no-merge", [&options](bool) { options.repair.joining = Joining::None; },
      "join no points of MESH, not even along seams")
    ->excludes(merge);
  group.Flag(
    "--orient", [&options](bool on) { options.repair.orient = on; },
    "give neighbouring faces of MESH the same orientation, outward on closed parts");
  group
    .Choice(
      "--surface",
      { { "blend", vtkRidgeExampleSource::BLEND },
        { "ellipsoid", vtkRidgeExampleSource::ELLIPSOID } },
      example->GetSurface(), [example](int value) { example->SetSurface(value); },
      "example surface")
    ->excludes(mesh);
  group
    .Number<int>(
      "--frequency", "N", example->GetFrequency(),
      { example->GetFrequencyMinValue(), example->GetFrequencyMaxValue() },
      [example](int value) { example->SetFrequency(value); },
      "resolution of the example: 10 N^2 + 2 points")
    ->excludes(mesh);
  const double* axes = example->GetSemiAxes();
  group
    .Triple(
      "--semi-axes", ToText(axes[0]) + "," + ToText(axes[1]) + "," + ToText(axes[2]),
      [example](Vector3 value) { example->SetSemiAxes(value.data()); },
      "semi-axes of the ellipsoid, all positive")
    ->excludes(mesh);
}

void AddJetFitting(CLI::App& app, vtkJetFitting* filter)
{
  constexpr int leastOrder = 3; // Ridges are where a third derivative vanishes.
  OptionGroup group(app, "Jet fitting");
  group.Number<int>(
    "--degree", "N", filter->GetDegree(), { leastOrder, filter->GetDegreeMaxValue() },
    [filter](int value) { filter->SetDegree(value); },
    "degree of the polynomial fitted at each point");
  group.Number<int>(
    "--monge-order", "N", filter->GetMongeOrder(), { leastOrder, filter->GetMongeOrderMaxValue() },
    [filter](int value) { filter->SetMongeOrder(value); },
    "highest order of the derivatives; 3 needs --type-rule third-order");
  group.Choice(
    "--neighborhood",
    { { "point-count", vtkJetFitting::BY_POINT_COUNT }, { "rings", vtkJetFitting::BY_RINGS },
      { "radius", vtkJetFitting::BY_RADIUS }, { "automatic", vtkJetFitting::AUTOMATIC } },
    filter->GetNeighborhood(), [filter](int value) { filter->SetNeighborhood(value); },
    "how large the neighbourhood of a point is; automatic selects 2 to 8 rings by the noise of the "
    "mesh");
  group.Number<int>(
    "--minimum-number-of-points", "N", filter->GetMinimumNumberOfPoints(),
    { filter->GetMinimumNumberOfPointsMinValue(), filter->GetMinimumNumberOfPointsMaxValue() },
    [filter](int value) { filter->SetMinimumNumberOfPoints(value); },
    "least number of points, for --neighborhood point-count; use 100 to 200 on noisy meshes");
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
    "--standard-errors", [filter](bool on) { filter->SetStandardErrors(on); },
    "compute standard errors of the derivatives; --write-mesh writes them too");
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
    "--keep-crest-only", [filter](bool on) { filter->SetCrestOnly(on); },
    "keep only crest lines of what is extracted");
}

void SetPictureSize(const std::string& text, std::array<int, 2>& size)
{
  constexpr int least = 64;
  constexpr int greatest = 8192;
  std::istringstream stream(text);
  char by = 0;
  std::array<int, 2> read{};
  if (!(stream >> read[0] >> by >> read[1]) || (by != 'x' && by != 'X') || !stream.eof() ||
    std::min(read[0], read[1]) < least || std::max(read[0], read[1]) > greatest)
  {
    throw CLI::ValidationError("--picture-size",
      text + " is not WIDTHxHEIGHT, each from " + ToText(least) + " to " + ToText(greatest));
  }
  size = read;
}

void AddOutput(CLI::App& app, Options& options)
{
  OptionGroup group(app, "Output");
  group.Text("-o,--output", "PREFIX", options.output,
    "write PREFIX-ridges.vtp, PREFIX-umbilics.vtp and PREFIX.png [name of MESH, or ridges]");
  group.Flag(
    "--write-mesh", [&options](bool on) { options.writeMesh = on; },
    "write PREFIX-mesh.vtp too: the mesh with the computed arrays");
  CLI::Option* check = group.Flag(
    "--check", [&options](bool on) { options.check = on; },
    "check whether ridges and umbilics are consistent, and print where they are not");
  group
    .Flag(
      "--strict", [&options](bool on) { options.strict = on; },
      "with --check: exit with code 3 if a check fails that noise cannot explain")
    ->needs(check);
  group.Flag(
    "--no-picture", [&options](bool on) { options.noPicture = on; },
    "draw no picture, which needs an X display");
  const std::array<int, 2>& size = options.picture.size;
  app
    .add_option_function<std::string>(
      "--picture-size",
      [&options](const std::string& text) { SetPictureSize(text, options.picture.size); },
      "width and height of the picture in pixels")
    ->type_name("WxH")
    ->default_str(ToText(size[0]) + "x" + ToText(size[1]))
    ->group("Output");
  group.Triple(
    "--view", "", [&options](Vector3 value) { options.picture.view = value; },
    "direction from the model to the viewer [along the least extent, but a little from the side "
    "and from above]");
  group.Triple(
    "--up", "", [&options](Vector3 value) { options.picture.up = value; },
    "direction that is up in the picture [y or z, the one of larger extent]");
}

void AddGeneral(CLI::App& app, Options& options)
{
  OptionGroup group(app, "General");
  group
    .Number<int>(
      "--threads", "N", options.threads, { 1, 1024 },
      [&options](int value) { options.threads = value; },
      "number of threads, at most one for each processor")
    ->default_str("all");
  group.Flag(
    "-q,--quiet", [&options](bool on) { options.quiet = on; }, "print only errors");
  app.set_help_flag("-h,--help", "print the most important options and exit")->group("General");
  app.set_help_all_flag("--help-all", "print all options and exit")->group("General");
  app
    .set_version_flag("--version",
      std::string("vtkridges " RIDGES_VERSION " (VTK ") + vtkVersion::GetVTKVersion() + ")")
    ->description("print the version and exit")
    ->group("General");
}

/// A directory is completed to a prefix in it, and no prefix to the name of the mesh.
void CompleteOutput(Options& options)
{
  namespace fs = std::filesystem;
  const std::string name =
    options.mesh.empty() ? std::string("ridges") : fs::path(options.mesh).stem().string();
  std::error_code error;
  if (options.output.empty())
  {
    options.output = name;
  }
  else if (fs::path(options.output).filename().empty() || fs::is_directory(options.output, error))
  {
    options.output = (fs::path(options.output) / name).string();
  }
}

} // namespace

std::optional<int> ParseCommandLine(int argc, char** argv, Options& options, Filters& filters)
{
  CLI::App app("Finds the ridges and umbilics of a triangle mesh and draws them.", "vtkridges");
  app.formatter(std::make_shared<HelpFormatter>(std::vector<std::string>{ "MESH", "--orient",
    "--surface", "--neighborhood", "--minimum-number-of-points", "--crest-only",
    "--minimum-sharpness", "--keep", "--output", "--write-mesh", "--check", "--strict",
    "--no-picture", "--view", "--quiet", "--help", "--help-all", "--version" }));
  app.set_help_flag(); // Added again at the end, to be listed there.
  AddInput(app, options, filters.example);
  AddJetFitting(app, filters.jetFitting);
  AddUmbilics(app, filters.umbilics);
  AddRidges(app, filters.ridges);
  AddSharpness(app, filters.sharpness);
  AddOutput(app, options);
  AddGeneral(app, options);
  app.footer("Defaults are in brackets. A line is a part of a ridge that has one type.\n"
             "\n"
             "Colours: blue and green are ridges of the maximum principal curvature, elliptic\n"
             "and hyperbolic; red and yellow are those of the minimum. Along its curvature\n"
             "line, the maximum is greatest on a blue ridge, the minimum least on a red one.\n"
             "\n"
             "Exit codes: 0 done; 1 the job failed (a file that cannot be read or written, an\n"
             "error in a filter); 2 wrong usage; 3 a check failed, with --strict.\n"
             "\n"
             "Examples:\n"
             "  vtkridges scan.ply --minimum-number-of-points 200 --minimum-sharpness 300\n"
             "  vtkridges part.stl --crest-only --output pictures/part\n"
             "  vtkridges --surface ellipsoid --view 1,-1,1 --output ellipsoid\n"
             "  xvfb-run -a vtkridges part.stl         (without an X display)");
  try
  {
    app.parse(argc, argv);
    CheckOptions(app, options, filters);
  }
  catch (const CLI::Success& success)
  {
    return app.exit(success, std::cout, std::cerr);
  }
  catch (const CLI::Error& error)
  {
    std::cerr << "vtkridges: " << error.what() << " : see vtkridges --help\n";
    return ExitMisused;
  }
  CompleteOutput(options);
  return std::nullopt;
}

} // namespace program
