// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_FieldOrder_h
#define ridges_FieldOrder_h

#include "Mesh/PositionOrder.h"
#include "Monge/MongeField.h"

namespace ridges
{

/// An order of points that the numbering has no part in: by position, in one place by what lies
/// around them, and then by values.
bool ComesBefore(const TriangleMesh& mesh, const MongeField& field, Id p, Id q);

/// The ends of an edge in this order.
OrderedEdge EndsInOrder(const TriangleMesh& mesh, const MongeField& field, Id edge);

} // namespace ridges

#endif
