// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLiftedRepresentation.h"

#include "vtkLiftedActor.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkLiftedRepresentation);

vtkLiftedRepresentation::vtkLiftedRepresentation()
{
  vtkLiftedActor* actor = vtkLiftedActor::New();
  actor->SetMapper(this->Mapper);
  actor->SetLODMapper(this->LODMapper);
  actor->SetProperty(this->Property);
  actor->SetPropertyKeys(this->Actor->GetPropertyKeys());
  this->Actor->Delete();
  this->Actor = actor;
}
