// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesStreamedFit_h
#define vtkRidgesStreamedFit_h

#include "Core/Shares/MergedPieces.h"
#include "Core/Shares/SharedMesh.h"
#include "vtkRidgesCompatibility.h"
#include "vtkRidgesFitFaults.h"
#include "vtkRidgesOwnedFits.h"

#include "vtkType.h"

#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkInformation;
class vtkInformationVector;
class vtkJetFitting;
class vtkPointData;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * What vtkJetFitting does on one rank where a mesh is asked for in pieces, one after the other;
 * private to the module. Of all pieces the positions and triangles are kept, and nothing else. Then
 * the values of each piece are those of the whole mesh.
 */
class vtkRidgesStreamedFit
{
public:
  /// The pieces of what is before a filter, from `first` on and around.
  vtkRidgesStreamedFit(vtkAlgorithm* filter, int pieces, int first);

  /// Whether the pieces are still what was taken, or will be.
  bool IsOf(vtkAlgorithm* filter, int pieces) const;

  /// Asks what is before the filter for the piece that is to be taken next, or for this one.
  void AskFor(vtkInformationVector* input, int piece) const;

  bool IsComplete() const { return this->NextPiece() < 0; }

  /// What is wrong with a piece, or after the last one with all of them; empty if nothing is.
  std::string Take(vtkPolyData* piece);

  /// Chooses the fit by the properties of the filter, if it has not done so. False if the user
  /// aborted.
  bool Choose(vtkJetFitting* filter);

  /// The output for a piece. The result is that of RequestData.
  int FitPiece(vtkJetFitting* filter, int piece, vtkPolyData* input, vtkPolyData* output);

  /// What is wrong with the mesh and the fits that were made.
  void Warn(vtkJetFitting* filter) const;

  int GetNumberOfPieces() const { return this->NumberOfPieces; }
  const ridges::MergedPieces& GetPieces() const { return this->Pieces; }
  const ridges::SharedMesh& GetMesh() const { return this->Shared; }
  vtkRidgesOwnedFits& GetFits() { return *this->Fits; }

  /// VTK's type of the coordinates of the pieces.
  int GetCoordinateType() const { return this->CoordinateType; }

private:
  int NextPiece() const;
  int IndexOf(int piece) const;
  std::string FinishTaking();
  bool FitPoints(const std::vector<ridges::Id>& points, vtkPointData* values);

  int NumberOfPieces;
  int First;
  vtkMTimeType SourceTime;
  ridges::OneRank Alone;
  ridges::MergedPieces Pieces;
  std::string Arrays; ///< Of pieces that have points.
  int CoordinateType;
  ridges::SharedMesh Shared;
  vtkRidgesFitFaults Faults; ///< Of pieces.
  std::unique_ptr<vtkRidgesOwnedFits> Fits;
  vtkMTimeType ChoiceTime = 0;
  std::vector<char> IsFitted; ///< By piece.
};

/// When what is before a filter was last changed.
vtkMTimeType vtkRidgesTimeOfSource(vtkAlgorithm* filter);

#endif
