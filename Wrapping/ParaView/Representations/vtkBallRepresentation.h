// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkBallRepresentation_h
#define vtkBallRepresentation_h

#include "vtkGlyph3DRepresentation.h"
#include "vtkNew.h"                         // for members
#include "vtkRidgesRepresentationsModule.h" // for the export macro

class vtkDistanceToCamera;
class vtkSphereSource;

/**
 * @class vtkBallRepresentation
 * @brief Shows points as balls in front of the surface that they lie on.
 *
 * A ball has the point size, in pixels, as its diameter. It is made of triangles, as the depth of
 * what VTK draws for vtkProperty::RenderPointsAsSpheres depends on the renderer.
 *
 * @sa vtkLiftedActor
 */
class VTKRIDGESREPRESENTATIONS_EXPORT vtkBallRepresentation : public vtkGlyph3DRepresentation
{
public:
  static vtkBallRepresentation* New();
  vtkTypeMacro(vtkBallRepresentation, vtkGlyph3DRepresentation);

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

  void SetPointSize(double pixels) override;

protected:
  vtkBallRepresentation();
  ~vtkBallRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkBallRepresentation(const vtkBallRepresentation&) = delete;
  void operator=(const vtkBallRepresentation&) = delete;

  vtkNew<vtkSphereSource> Ball;
  vtkNew<vtkDistanceToCamera> Sizes;    // diameters in the unit of the points
  vtkNew<vtkDistanceToCamera> LODSizes; // the same for reduced data
};

#endif
