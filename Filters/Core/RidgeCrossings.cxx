// SPDX-License-Identifier: BSD-3-Clause
#include "RidgeCrossings.h"

namespace ridges
{

RidgeCrossings::RidgeCrossings(
  const TriangleMesh& mesh, const MongeField& field, Color color, CrossingRule rule)
  : Mesh_(mesh)
  , Field_(field)
  , Color_(color)
  , Rule_(rule)
  , Numbers_(mesh.NumberOfEdges(), NotCrossed)
{
}

void RidgeCrossings::Find(Id beginEdge, Id endEdge)
{
  for (Id e = beginEdge; e < endEdge; ++e)
  {
    const Edge& edge = this->Mesh_.EdgeAt(e);
    const bool crossed = ridges::IsCrossed(this->Field_, this->Color_, edge.v0, edge.v1);
    this->Numbers_[e] = crossed ? 0 : NotCrossed;
  }
}

void RidgeCrossings::Number()
{
  this->Edges_.clear();
  for (Id e = 0; e < this->Mesh_.NumberOfEdges(); ++e)
  {
    if (this->Numbers_[e] != NotCrossed)
    {
      this->Numbers_[e] = static_cast<Id>(this->Edges_.size());
      this->Edges_.push_back(e);
    }
  }
  this->Points_.resize(this->Edges_.size());
}

void RidgeCrossings::Place(Id begin, Id end)
{
  for (Id i = begin; i < end; ++i)
  {
    this->Points_[i] =
      RidgePointOnEdge(this->Mesh_, this->Field_, this->Color_, this->Rule_, this->Edges_[i]);
  }
}

void RidgeCrossings::Build()
{
  this->Find(0, this->Mesh_.NumberOfEdges());
  this->Number();
  this->Place(0, this->Size());
}

} // namespace ridges
