// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Options_h
#define Options_h

#include "LineChoice.h"
#include "Picture.h"
#include "Repair/RepairMesh.h"

#include "vtkCertifiedRidges.h"
#include "vtkImageMongeForm.h"
#include "vtkImageSurfaceMesh.h"
#include "vtkImplicitMongeForm.h"
#include "vtkImplicitSurfaceMesh.h"
#include "vtkJetFitting.h"
#include "vtkNew.h"
#include "vtkRidgeCoherence.h"
#include "vtkRidgeExampleSource.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgeSharpnessFilter.h"
#include "vtkRidgesAndUmbilics.h"
#include "vtkSalientRidges.h"
#include "vtkSmartPointer.h"
#include "vtkUmbilicDetection.h"

#include <optional>
#include <string>

namespace program
{

/// The pipelines. The options of the command line are kept nowhere but in its filters.
struct Filters
{
  vtkNew<vtkRidgeExampleSource> example;
  vtkNew<vtkImplicitSurfaceMesh> surfaceMesh;
  vtkNew<vtkJetFitting> jetFitting;
  vtkNew<vtkImplicitMongeForm> exactForms; ///< Instead of the fit, where there is a formula.
  vtkNew<vtkImageSurfaceMesh> imageMesh;
  vtkNew<vtkImageMongeForm> imageForms; ///< Instead of the fit, where there is an image.
  vtkNew<vtkCertifiedRidges> certified; ///< Instead of all up to the ridges, if wanted.
  vtkNew<vtkUmbilicDetection> umbilics;
  vtkNew<vtkRidgeExtraction> ridges;
  vtkNew<vtkRidgeCoherence> coherence;
  vtkNew<vtkRidgeSharpnessFilter> sharpness;
  vtkNew<vtkSalientRidges> salient; ///< From the mesh, instead of the others.
  vtkSmartPointer<vtkRidgesAndUmbilics>
    onRanks; ///< Instead of all from fit to filter; in pieces, too.
};

/// What is no property of a filter.
struct Options
{
  std::string mesh;    ///< Empty: the surface of formula or image or, without them, the example.
  std::string formula; ///< Of the surface, if it is not empty.
  std::string image;   ///< Whose isosurface it is, if it is not empty.

  /// Whether Monge forms are computed instead of fitted.
  bool HasForms() const { return !this->formula.empty() || !this->image.empty(); }

  bool certify = false;
  RepairOptions repair;
  Lines lines = Lines::ByData;
  std::string output; ///< Path and beginning of the names of the files written.
  bool writeMesh = false;
  bool check = false;
  bool strict = false; ///< Whether a failed check is a failure of the program.
  bool noPicture = false;
  PictureOptions picture;
  int threads = 0; ///< 0: all.
  int numberOfRanks = 1;
  int pieces = 1; ///< In how many parts the mesh is taken, one after the other.
  bool quiet = false;
};

/// Exit codes of the program.
enum ExitCode
{
  ExitDone = 0,
  ExitJobFailed = 1,
  ExitMisused = 2,
  ExitCheckFailed = 3
};

/// Sets the options and the filters by the command line. Has a value, the exit code, if that is
/// all: after --help, or after a message about a wrong option.
std::optional<int> ParseCommandLine(int argc, char** argv, Options& options, Filters& filters);

} // namespace program

#endif
