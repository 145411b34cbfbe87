// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLiftedActor.h"

#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkLiftedActor);

namespace
{

/// Brings everything nearer by this fraction of the view's height, which does not show.
void MakeLift(vtkCamera* camera, double fraction, vtkMatrix4x4* lift)
{
  lift->Identity();
  if (camera->GetParallelProjection())
  {
    const double* direction = camera->GetDirectionOfProjection();
    const double distance = 2.0 * fraction * camera->GetParallelScale();
    for (int i = 0; i < 3; ++i)
    {
      lift->SetElement(i, 3, -distance * direction[i]);
    }
    return;
  }
  const double angle = vtkMath::RadiansFromDegrees(camera->GetViewAngle());
  const double shrinkage = std::min(0.5, 2.0 * fraction * std::tan(0.5 * angle));
  const double* eye = camera->GetPosition();
  for (int i = 0; i < 3; ++i)
  {
    lift->SetElement(i, i, 1.0 - shrinkage);
    lift->SetElement(i, 3, shrinkage * eye[i]);
  }
}

/// Gives lines the depth offset of faces, so that only the lift decides what is in front.
void LevelOffsets(vtkMapper* mapper)
{
  double factor = 0.0;
  double faces = 0.0;
  if (vtkMapper::GetResolveCoincidentTopologyPolygonOffsetFaces())
  {
    vtkMapper::GetResolveCoincidentTopologyPolygonOffsetParameters(factor, faces);
  }
  double lines = 0.0;
  vtkMapper::GetResolveCoincidentTopologyLineOffsetParameters(factor, lines);
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-factor, faces - lines);
}

} // namespace

vtkLiftedActor::vtkLiftedActor() = default;
vtkLiftedActor::~vtkLiftedActor() = default;

void vtkLiftedActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  vtkProperty* property = this->GetProperty();
  const double thickness = std::max(property->GetLineWidth(), property->GetPointSize());
  const double fraction = thickness / std::max(1, renderer->GetSize()[1]);
  MakeLift(renderer->GetActiveCamera(), fraction, this->Lift);
  LevelOffsets(this->GetMapper());
  this->Superclass::Render(renderer, mapper);
  this->Lift->Identity();
}

void vtkLiftedActor::GetMatrix(vtkMatrix4x4* result)
{
  this->Superclass::GetMatrix(result);
  vtkMatrix4x4::Multiply4x4(this->Lift, result, result);
}
