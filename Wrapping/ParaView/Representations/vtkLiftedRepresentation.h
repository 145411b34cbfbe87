// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkLiftedRepresentation_h
#define vtkLiftedRepresentation_h

#include "vtkGeometryRepresentation.h"
#include "vtkRidgesRepresentationsModule.h" // for the export macro

/**
 * @class vtkLiftedRepresentation
 * @brief Shows lines in front of the surface that they lie on.
 *
 * @sa vtkLiftedActor
 */
class VTKRIDGESREPRESENTATIONS_EXPORT vtkLiftedRepresentation : public vtkGeometryRepresentation
{
public:
  static vtkLiftedRepresentation* New();
  vtkTypeMacro(vtkLiftedRepresentation, vtkGeometryRepresentation);

protected:
  vtkLiftedRepresentation();
  ~vtkLiftedRepresentation() override = default;

private:
  vtkLiftedRepresentation(const vtkLiftedRepresentation&) = delete;
  void operator=(const vtkLiftedRepresentation&) = delete;
};

#endif
