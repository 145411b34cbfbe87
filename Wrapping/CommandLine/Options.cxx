// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "FilterOptions.h"
#include "HelpFormatter.h"
#include "OptionChecks.h"
#include "OptionGroup.h"
#include "Reading/MeshReader.h"

#include "vtkVersion.h"

#include <algorithm>
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
    .Number<int>(
      "--pieces", "N", options.pieces, { 1, VTK_INT_MAX },
      [&options](int value) { options.pieces = value; },
      "read MESH, a .pvtp, in N parts, one after the other, where all of it would take too much "
      "memory: the same ridges, without a picture")
    ->needs(mesh);
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

void AddFormula(CLI::App& app, Options& options, Filters& filters)
{
  vtkImplicitSurfaceMesh* surfaceMesh = filters.surfaceMesh;
  vtkImageSurfaceMesh* imageMesh = filters.imageMesh;
  vtkCertifiedRidges* certified = filters.certified;
  OptionGroup group(app, "Formula");
  group
    .Text("--formula", "TEXT", options.formula,
      "surface f(x, y, z) = 0, negative inside, such as 'x^2/4 + y^2 + z^2/0.4 - 1': the ridges "
      "are computed from exact derivatives, on a mesh of the surface or, with MESH, on that mesh "
      "moved to it")
    ->excludes("--surface")
    ->excludes("--frequency")
    ->excludes("--semi-axes");
  group.Numbers<6>(
    "--bounds", "X,X,Y,Y,Z,Z", "",
    [surfaceMesh](std::array<double, 6> bounds) { surfaceMesh->SetBounds(bounds.data()); },
    "box in which the surface is meshed: least and greatest x, y and z");
  group.Number<double>(
    "--edge-length", "L", surfaceMesh->GetEdgeLength(), { 0.0, AnyLength },
    [surfaceMesh, imageMesh](double length)
    {
      surfaceMesh->SetEdgeLength(length);
      imageMesh->SetEdgeLength(length);
    },
    "length of the edges of the mesh; 0 is a hundredth of the diagonal of --bounds, or three "
    "quarters of --sigma");
  CLI::Option* certify = group.Flag(
    "--certify", [&options](bool on) { options.certify = on; },
    "refine the mesh until interval arithmetic proves that all ridges and umbilics are found, and "
    "print what is proved; exit with code 3 if not all is");
  group
    .Number<int>(
      "--certify-points", "N", static_cast<int>(certified->GetMaximumNumberOfPoints()),
      { 0, VTK_INT_MAX }, [certified](int count) { certified->SetMaximumNumberOfPoints(count); },
      "points from which on --certify does not refine the mesh any more")
    ->needs(certify);
}

void AddImage(CLI::App& app, Options& options, Filters& filters)
{
  vtkImageSurfaceMesh* mesh = filters.imageMesh;
  vtkImageMongeForm* forms = filters.imageForms;
  OptionGroup group(app, "Image");
  CLI::Option* image = group.Text("--image", "FILE", options.image,
    "three-dimensional image (.vti, .mha, .nrrd, .nii and others), of an isosurface of which the "
    "ridges are computed, on a mesh of it or, with MESH, on that mesh moved to it");
  for (const char* other : { "--surface", "--frequency", "--semi-axes", "--formula" })
  {
    image->excludes(other);
  }
  group
    .Number<double>(
      "--isovalue", "V", mesh->GetIsoValue(), { -AnyLength, AnyLength },
      [mesh, forms](double value)
      {
        mesh->SetIsoValue(value);
        forms->SetIsoValue(value);
      },
      "value of the image on the isosurface")
    ->needs(image);
  group
    .Number<double>(
      "--sigma", "L", mesh->GetSigma(), { 0.0, AnyLength },
      [mesh, forms](double sigma)
      {
        mesh->SetSigma(sigma);
        forms->SetSigma(sigma);
      },
      "standard deviation of the Gaussian that smooths the image; 0 is what its noise needs, at "
      "least 1.5 samples")
    ->needs(image);
}

void AddLines(CLI::App& app, Options& options)
{
  OptionGroup group(app, "Lines");
  CLI::Option* complete = group.Flag(
    "--complete", [&options](bool) { options.lines = Lines::Complete; },
    "find all ridges and umbilics, as on a smooth surface");
  group
    .Flag(
      "--salient", [&options](bool) { options.lines = Lines::Salient; },
      "find the main feature lines, as on a scan or a part; without either option, an option of "
      "one of them decides or, if there is none, the noise of MESH")
    ->excludes(complete);
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
    "write PREFIX-ridges.vtp, PREFIX-umbilics.vtp and PREFIX.png [name of "
    "MESH, or ridges]");
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
      "number of threads, of each rank with mpirun, at most one for each processor")
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
  const std::string name = options.mesh.empty() && options.image.empty()
    ? std::string("ridges")
    : fs::path(options.mesh.empty() ? options.image : options.mesh).stem().string();
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
  app.formatter(std::make_shared<HelpFormatter>(
    std::vector<std::string>{ "MESH", "--orient", "--surface", "--formula", "--bounds",
      "--edge-length", "--certify", "--image", "--isovalue", "--sigma", "--complete", "--salient",
      "--neighborhood", "--minimum-number-of-points", "--crest-only", "--minimum-sharpness",
      "--keep", "--fold-angle", "--relative-scale", "--output", "--write-mesh", "--check",
      "--strict", "--no-picture", "--view", "--quiet", "--help", "--help-all", "--version" }));
  app.set_help_flag(); // Added again at the end, to be listed there.
  AddInput(app, options, filters.example);
  AddFormula(app, options, filters);
  AddImage(app, options, filters);
  AddLines(app, options);
  AddJetFitting(app, filters.jetFitting);
  AddUmbilics(app, filters.umbilics);
  AddRidges(app, filters.ridges);
  AddSharpness(app, filters.sharpness);
  AddSalient(app, filters.salient);
  AddOutput(app, options);
  AddGeneral(app, options);
  app.footer("Defaults are in brackets. A line is a part of a ridge that has one type.\n"
             "Of salient lines, red ones are crests and blue ones valleys.\n"
             "\n"
             "Colours: blue and green are ridges of the maximum principal curvature, elliptic\n"
             "and hyperbolic; red and yellow are those of the minimum. Along its curvature\n"
             "line, the maximum is greatest on a blue ridge, the minimum least on a red one.\n"
             "\n"
             "Exit codes: 0 done; 1 the job failed (a file that cannot be read or written, an\n"
             "error in a filter); 2 wrong usage; 3 a check failed, with --strict.\n"
             "\n"
             "Examples:\n"
             "  vtkridges scan.ply\n"
             "  vtkridges scan.ply --salient --fold-angle 25\n"
             "  vtkridges scan.ply --complete --minimum-sharpness 300\n"
             "  vtkridges part.stl --crest-only --output pictures/part\n"
             "  vtkridges --surface ellipsoid --view 1,-1,1 --output ellipsoid\n"
             "  vtkridges --image head.vti --isovalue 500\n"
             "  vtkridges --formula 'x^4+y^4+z^2-1' --bounds -1.1,1.1,-1.1,1.1,-1.1,1.1\n"
             "  xvfb-run -a vtkridges part.stl         (without an X display)\n"
             "  mpirun -np 4 vtkridges huge.pvtp       (all ridges, without a picture)");
  try
  {
    app.parse(argc, argv);
    CompleteNeighborhood(app, filters.jetFitting);
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
