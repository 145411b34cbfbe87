// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesSharedFit.h"

#include "Core/Base/RankGathering.h"
#include "Core/Shares/SharedMesh.h"
#include "Core/Shares/SharedSurface.h"
#include "vtkJetFitting.h"
#include "vtkRidgesFitFaults.h"
#include "vtkRidgesFitSettings.h"
#include "vtkRidgesMesh.h"
#include "vtkRidgesOwnedFits.h"
#include "vtkRidgesPiece.h"
#include "vtkRidgesSharedInput.h"

#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using ridges::Id;

std::string TextOfProperties(vtkJetFitting* filter)
{
  std::ostringstream text;
  text << filter->GetDegree() << " " << filter->GetMongeOrder() << " " << filter->GetNeighborhood()
       << " " << filter->GetMinimumNumberOfPoints() << " " << filter->GetNumberOfRings() << " "
       << filter->GetRadius() << " " << filter->GetWeighting() << " " << filter->GetStandardErrors()
       << " " << filter->GetBlendNoisyFits();
  return text.str();
}

/// The fits of one rank, from its piece to the values for it. Each step is taken by all ranks.
class SharedFit
{
public:
  SharedFit(vtkJetFitting* filter, ridges::Ranks& ranks)
    : Filter(filter)
    , Ranks(ranks)
  {
  }

  /// False after an error.
  bool Take(vtkInformationVector* input);

  /// False if the user aborted.
  bool Fit();

  void Warn();
  void Store(vtkPolyData* output);

  /// At the end, once.
  void Keep(ridges::SharedSurface& surface);

private:
  vtkJetFitting* Filter;
  ridges::Ranks& Ranks;
  vtkSmartPointer<vtkPolyData> Piece; ///< Of triangles.
  ridges::SharedMesh Shared;
  std::unique_ptr<vtkRidgesOwnedFits> Fits;
  vtkNew<vtkPointData> Values; ///< Of the piece.
  vtkRidgesFitFaults Faults;   ///< Of the piece.
};

bool SharedFit::Take(vtkInformationVector* input)
{
  std::string faults;
  vtkPolyData* piece = vtkRidgesGetPiece(this->Ranks, input, faults);
  if (piece)
  {
    faults = vtkRidgesFitSettingsFault(this->Filter);
  }
  vtkRidgesMesh mesh;
  if (faults.empty())
  {
    faults = mesh.Build(
      piece, {}, ridges::TriangleMesh::Edges::NotBuilt, vtkRidgesMesh::Duplicates::LeftOut);
  }
  if (!vtkRidgesAgree(this->Filter, this->Ranks, piece, TextOfProperties(this->Filter), faults))
  {
    return false;
  }
  // Of the piece itself, nothing but the values of its points is needed any more.
  this->Piece = mesh.GetPolyData();
  this->Faults.triangulatedCells = mesh.GetNumberOfTriangulatedCells();
  this->Faults.unusableTriangles = mesh.GetNumberOfUnusableTriangles();
  // Found out together: all ranks have the same text.
  return vtkRidgesAgree(
    this->Filter, this->Ranks, this->Shared.Share(this->Ranks, vtkRidgesPiece(mesh).GetView()));
}

bool SharedFit::Fit()
{
  this->Fits = std::make_unique<vtkRidgesOwnedFits>(this->Filter, this->Ranks, this->Shared);
  return this->Fits->Choose() && this->Fits->FitPiece(this->Values);
}

void SharedFit::Warn()
{
  this->Faults += this->Fits->CountFaults();
  vtkRidgesFitFaults all;
  for (const vtkRidgesFitFaults& faults : ridges::GatherAllOne(this->Ranks, this->Faults))
  {
    all += faults;
  }
  all.triangles = this->Shared.NumberOfTriangles();
  const std::string text = all.GetText();
  if (!text.empty() && this->Ranks.Rank() == 0)
  {
    vtkWarningWithObjectMacro(this->Filter, << text << ".");
  }
}

void SharedFit::Store(vtkPolyData* output)
{
  this->Shared.Release();
  this->Fits->Store(this->Piece, this->Values, output);
}

void SharedFit::Keep(ridges::SharedSurface& surface)
{
  this->Fits->KeepSurface(surface);
  surface.points = this->Shared.TakePoints();
}

} // namespace

int vtkRidgesSharedFit(vtkJetFitting* filter, ridges::Ranks& ranks, vtkInformationVector* input,
  vtkPolyData* output, ridges::SharedSurface* surface)
{
  SharedFit fit(filter, ranks);
  if (!fit.Take(input))
  {
    return 0;
  }
  if (!fit.Fit())
  {
    return 1;
  }
  fit.Warn();
  fit.Store(output);
  if (surface)
  {
    fit.Keep(*surface);
  }
  return 1;
}
