// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ridges/RidgeCrossings.h"

#include "Monge/AcuteRule.h"

#include <utility>

namespace ridges
{

RidgeCrossings::RidgeCrossings(const TriangleMesh& mesh, const MongeField& field, Color color,
  CrossingRule rule, ExtremalityRule extremality)
  : Mesh_(mesh)
  , Field_(field)
  , Color_(color)
  , Rule_(rule)
  , Extremality_(extremality)
  , Numbers_(mesh.NumberOfEdges())
{
}

void RidgeCrossings::Find(Id beginEdge, Id endEdge, std::vector<Id>& crossed)
{
  for (Id e = beginEdge; e < endEdge; ++e)
  {
    const Edge& edge = this->Mesh_.EdgeAt(e);
    const auto changes = [this, &edge](Color color)
    { return ridges::IsCrossed(this->Field_, color, edge.v0, edge.v1); };
    // The product changes where one of its factors does, in whatever frame.
    const bool isCrossed = this->Extremality_ == ExtremalityRule::Principal
      ? changes(this->Color_)
      : changes(Color::Blue) != changes(Color::Red);
    this->Numbers_[e] = NotCrossed;
    if (isCrossed)
    {
      crossed.push_back(e);
    }
  }
}

void RidgeCrossings::SetCrossed(std::vector<Id> edges)
{
  this->Edges_ = std::move(edges);
  this->Points_.resize(this->Edges_.size());
}

void RidgeCrossings::Place(Id begin, Id end)
{
  for (Id i = begin; i < end; ++i)
  {
    this->Numbers_[this->Edges_[i]] = i;
    Color color = this->Color_;
    if (this->Extremality_ == ExtremalityRule::Gaussian)
    {
      const Edge& edge = this->Mesh_.EdgeAt(this->Edges_[i]);
      const bool blue = ridges::IsCrossed(this->Field_, Color::Blue, edge.v0, edge.v1);
      color = blue ? Color::Blue : Color::Red;
    }
    this->Points_[i] =
      RidgePointOnEdge(this->Mesh_, this->Field_, color, this->Rule_, this->Edges_[i]);
  }
}

void RidgeCrossings::Build()
{
  std::vector<Id> crossed;
  this->Find(0, this->Mesh_.NumberOfEdges(), crossed);
  this->SetCrossed(std::move(crossed));
  this->Place(0, this->Size());
}

} // namespace ridges
