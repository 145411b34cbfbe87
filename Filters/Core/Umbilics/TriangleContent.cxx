// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Umbilics/TriangleContent.h"

#include "Monge/AcuteRule.h"
#include "Umbilics/DirectionIndex.h"

#include <algorithm>

namespace ridges
{

TriangleContents::TriangleContents(
  const MongeField& field, const FitErrorSource& errors, double significance, Id numberOfPoints)
  : Field_(field)
  , Errors_(errors)
  , Significance_(significance)
  , IsPlain_(numberOfPoints, 0)
{
  const bool hasStandardErrors = errors.maximumCurvatureError && errors.minimumCurvatureError;
  for (Id p = 0; p < numberOfPoints; ++p)
  {
    const bool isClear = hasStandardErrors || !MayBeWeak(field, errors, significance, p);
    this->IsPlain_[p] = isClear && IsGentle(field, errors, p) ? 1 : 0;
  }
}

TriangleContent TriangleContents::At(const Triangle& corners) const
{
  const bool isPlain =
    std::all_of(corners.begin(), corners.end(), [this](Id p) { return this->IsPlain_[p] != 0; });
  if (!isPlain || DirectionsMayTurn(this->Field_, corners) ||
    (this->Errors_.maximumCurvatureError &&
      IsWeakByStandardErrors(this->Field_, this->Errors_, this->Significance_, corners)))
  {
    return TriangleContent::Umbilic;
  }
  for (int side = 0; side < 3; ++side)
  {
    const Id p = corners[side];
    const Id q = corners[(side + 1) % 3];
    if (IsCrossed(this->Field_, Color::Blue, p, q) || IsCrossed(this->Field_, Color::Red, p, q))
    {
      return TriangleContent::Ridge;
    }
  }
  return TriangleContent::Nothing;
}

} // namespace ridges
