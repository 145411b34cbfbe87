// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkLiftedActor_h
#define vtkLiftedActor_h

#include "vtkNew.h" // for the lift
#include "vtkPVLODActor.h"
#include "vtkRidgesRepresentationsModule.h" // for the export macro

/**
 * @class vtkLiftedActor
 * @brief Lines or points in front of the surface that they lie on.
 *
 * What lies exactly on a surface has the surface's depth: round-off decides which of them is seen,
 * and the effect of a small depth offset depends on the renderer. This actor draws its data nearer
 * to the viewer, by the line width or point size of its property, whichever is larger. The picture
 * stays the same: in a perspective projection the data shrinks towards the eye, in a parallel one
 * it moves along the view direction.
 */
class VTKRIDGESREPRESENTATIONS_EXPORT vtkLiftedActor : public vtkPVLODActor
{
public:
  static vtkLiftedActor* New();
  vtkTypeMacro(vtkLiftedActor, vtkPVLODActor);

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;

  /// Includes the lift during rendering only, so that bounds are those of the data.
  void GetMatrix(vtkMatrix4x4* result) override;
  using vtkPVLODActor::GetMatrix;

protected:
  vtkLiftedActor();
  ~vtkLiftedActor() override;

private:
  vtkLiftedActor(const vtkLiftedActor&) = delete;
  void operator=(const vtkLiftedActor&) = delete;

  vtkNew<vtkMatrix4x4> Lift; // the identity unless Render runs
};

#endif
