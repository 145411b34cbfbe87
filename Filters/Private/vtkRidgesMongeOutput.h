// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesMongeOutput_h
#define vtkRidgesMongeOutput_h

#include "Core/Fit/Batch/JetBatch.h"
#include "Core/Fit/JetErrors.h"
#include "Core/Mesh/TriangleMesh.h"
#include "Core/Monge/MongeField.h"
#include "Core/Monge/MongeForm.h"
#include "vtkRidgesFormArrays.h"

/**
 * The arrays that come out of vtkJetFitting, one tuple per point, each point to be stored once;
 * private to the module.
 */
class vtkRidgesMongeOutput : public vtkRidgesFormArrays
{
public:
  /// What is known of a fit besides the Monge form.
  struct Quality
  {
    double conditionNumber = 0.0;
    double residual = 0.0;
    double radius = 0.0;
    double noiseGain = 0.0;
    int status = 0;
  };

  /// Of so many fits of one point that are blended with these shares, whose sum is 1. The status is
  /// that of the one with the largest share.
  static Quality Blended(const Quality* fits, const double* shares, int count);

  vtkRidgesMongeOutput(vtkIdType count, int order, bool standardErrors);

  void Store(vtkIdType p, const ridges::MongeForm& form, const Quality& quality);

  /// The results of the lanes of a batch, but not their status. Results that are no good may be
  /// among them: those are to be stored over.
  void Store(ridges::Span<ridges::Id> points, const ridges::JetBatch& batch, int lanes);
  /// Mixes in the fit of the same point in an output of the same order, of which `share` is taken,
  /// 0 to 1. Both are valid, or the share is 1.
  void Blend(vtkIdType p, const vtkRidgesMongeOutput& other, double share);

  Quality GetQuality(vtkIdType p) const;

  void StoreQuality(vtkIdType p, const Quality& quality);

  void StoreStatus(vtkIdType p, int status) { this->Status[p] = status; }

  /// Only if the arrays for it were asked for.
  void StoreErrors(vtkIdType p, const ridges::JetErrors& errors);

private:
  ridges::MongeField View() const;

  double *Normals, *MaximumCurvature, *MinimumCurvature, *MaximumDirection, *MinimumDirection,
    *ThirdOrder, *FourthOrder, *P1, *P2, *ConditionNumber, *Residual, *Scale, *NoiseGain;
  double *MaximumCurvatureError, *MinimumCurvatureError, *ThirdOrderError, *P1Error, *P2Error;
};

#endif
