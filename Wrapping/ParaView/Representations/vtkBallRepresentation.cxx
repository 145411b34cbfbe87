// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBallRepresentation.h"

#include "vtkDistanceToCamera.h"
#include "vtkGlyph3DMapper.h"
#include "vtkLiftedActor.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkSphereSource.h"

vtkStandardNewMacro(vtkBallRepresentation);

namespace
{

void Connect(vtkGlyph3DMapper* mapper, vtkDistanceToCamera* sizes, vtkSphereSource* ball)
{
  // Without a glyph there is no data either, full or reduced.
  if (mapper->GetInputDataObject(1, 0))
  {
    sizes->SetInputConnection(mapper->GetInputConnection(0, 0));
    mapper->SetInputConnection(0, sizes->GetOutputPort());
    mapper->SetInputConnection(1, ball->GetOutputPort());
    mapper->SetScaleFactor(1.0);
  }
}

} // namespace

vtkBallRepresentation::vtkBallRepresentation()
{
  vtkLiftedActor* actor = vtkLiftedActor::New();
  actor->SetMapper(this->GlyphMapper);
  actor->SetLODMapper(this->LODGlyphMapper);
  actor->SetProperty(this->Property);
  this->GlyphActor->Delete();
  this->GlyphActor = actor;

  this->Ball->SetRadius(0.5);
  this->Ball->SetThetaResolution(20);
  this->Ball->SetPhiResolution(14);
  for (vtkGlyph3DMapper* mapper : { this->GlyphMapper, this->LODGlyphMapper })
  {
    mapper->SetScaleArray(this->Sizes->GetDistanceArrayName());
    mapper->SetScaleModeToScaleByMagnitude();
    mapper->SetOrient(false);
  }
}

vtkBallRepresentation::~vtkBallRepresentation() = default;

void vtkBallRepresentation::SetPointSize(double pixels)
{
  this->Superclass::SetPointSize(pixels);
  this->Sizes->SetScreenSize(pixels);
  this->LODSizes->SetScreenSize(pixels);
}

bool vtkBallRepresentation::AddToView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    this->Sizes->SetRenderer(renderView->GetRenderer());
    this->LODSizes->SetRenderer(renderView->GetRenderer());
  }
  return this->Superclass::AddToView(view);
}

bool vtkBallRepresentation::RemoveFromView(vtkView* view)
{
  this->Sizes->SetRenderer(nullptr);
  this->LODSizes->SetRenderer(nullptr);
  return this->Superclass::RemoveFromView(view);
}

int vtkBallRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    // Bounds are those of the points: the balls' size in the model depends on the view.
    this->GlyphMapper->SetScaleFactor(0.0);
  }
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_RENDER())
  {
    // In place of the superclass's glyph, which is an arrow unless a second input is given.
    Connect(this->GlyphMapper, this->Sizes, this->Ball);
    Connect(this->LODGlyphMapper, this->LODSizes, this->Ball);
  }
  return 1;
}
