// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesFieldSmoothing_h
#define vtkRidgesFieldSmoothing_h

#include "Core/Mesh/OrderedRings.h"
#include "Core/Monge/MongeForm.h"
#include "Core/Salience/OneRings.h"
#include "Core/Salience/SmoothingPlan.h"
#include "vtkRidgesMongeInput.h"

#include <functional>
#include <memory>

/**
 * What vtkMongeSmoothing does, private to the module: and the same for other fields on the same
 * mesh, with the same weights, so that what comes out differs by the fields alone.
 */
class vtkRidgesFieldSmoothing
{
public:
  struct Rule
  {
    bool allOrders = false;
    double sigma = 0.0;         ///< 0: relativeSigma.
    double relativeSigma = 0.0; ///< Over the diameter of the model.
    int steps = 0;              ///< 0: as many as sigma needs.
  };

  /// Smooths the arrays of a mesh and makes `output` that mesh with the result. False after an
  /// error in the name of the filter. Where the user aborted the output is left alone.
  bool Run(vtkAlgorithm* filter, vtkPolyData* input, const Rule& rule, vtkPolyData* output,
    double from = 0.0, double to = 1.0);

  /// Of the last mesh.
  const ridges::TriangleMesh& GetMesh() const { return this->Monge->mesh.GetTriangles(); }
  const ridges::OrderedRings& GetRings() const { return *this->Ordered; }

  /// Smooths the curvatures and directions of another field on that mesh and gives them to `store`,
  /// in parallel; where there are none all values are 0. False where the user aborted.
  bool SmoothAgain(vtkAlgorithm* filter, const vtkRidgesMongeArrays& arrays,
    const std::function<void(ridges::Id, const ridges::MongeForm&)>& store, double from,
    double to) const;

private:
  bool BuildRings(vtkAlgorithm* filter, double from, double to);

  std::unique_ptr<vtkRidgesMongeInput> Monge;
  std::unique_ptr<ridges::OrderedRings> Ordered;
  std::unique_ptr<ridges::OneRings> Rings;
  std::unique_ptr<ridges::SmoothingPlan> Plan;
};

#endif
