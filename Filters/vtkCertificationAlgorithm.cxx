// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCertificationAlgorithm.h"

#include "vtkJetFunction.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"

#include <algorithm>

vtkCxxSetSmartPointerMacro(vtkCertificationAlgorithm, JetFunction, vtkJetFunction);

vtkCertificationAlgorithm::vtkCertificationAlgorithm() = default;

vtkCertificationAlgorithm::~vtkCertificationAlgorithm() = default;

vtkJetFunction* vtkCertificationAlgorithm::GetJetFunction() const
{
  return this->JetFunction;
}

vtkMTimeType vtkCertificationAlgorithm::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->JetFunction ? std::max(own, this->JetFunction->GetMTime()) : own;
}

int vtkCertificationAlgorithm::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port == this->GetNumberOfOutputPorts() - 1)
  {
    info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
    return 1;
  }
  return this->Superclass::FillOutputPortInformation(port, info);
}

void vtkCertificationAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SurfaceType: " << (this->SurfaceType == GRAPH ? "Graph" : "Implicit") << "\n";
  os << indent << "Formula: " << this->Formula << "\n";
  os << indent << "Level: " << (this->Level == PROVED ? "Proved" : "Checked") << "\n";
  os << indent << "MaximumNumberOfPoints: " << this->MaximumNumberOfPoints << "\n";
  os << indent << "JetFunction: " << this->JetFunction.Get() << "\n";
}
