// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FilterOptions.h
 * The options of the command line that are properties of a filter, a group for each filter.
 */

#ifndef FilterOptions_h
#define FilterOptions_h

namespace CLI
{
class App;
}

class vtkJetFitting;
class vtkRidgeExtraction;
class vtkRidgeSharpnessFilter;
class vtkSalientRidges;
class vtkUmbilicDetection;

namespace program
{

void AddJetFitting(CLI::App& app, vtkJetFitting* filter);

/// After parsing: a number of points asks for the neighbourhood that has it.
void CompleteNeighborhood(const CLI::App& app, vtkJetFitting* filter);

void AddUmbilics(CLI::App& app, vtkUmbilicDetection* filter);
void AddRidges(CLI::App& app, vtkRidgeExtraction* filter);
void AddSharpness(CLI::App& app, vtkRidgeSharpnessFilter* filter);
void AddSalient(CLI::App& app, vtkSalientRidges* filter);

} // namespace program

#endif
