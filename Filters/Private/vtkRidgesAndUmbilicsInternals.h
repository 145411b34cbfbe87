// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesAndUmbilicsInternals_h
#define vtkRidgesAndUmbilicsInternals_h

#include "vtkJetFitting.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgeSharpnessFilter.h"
#include "vtkRidgesAndUmbilics.h"
#include "vtkRidgesGathering.h"
#include "vtkRidgesStreamedFit.h"
#include "vtkRidgesStreamedGathering.h"
#include "vtkUmbilicDetection.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <string>

/// The four filters in a row; private to the module.
class vtkRidgesAndUmbilics::vtkInternals
{
  /// On the ranks of the filter.
  class Jets : public vtkJetFitting
  {
  public:
    static Jets* New();
    vtkRidgesAndUmbilics* filter = nullptr;

  protected:
    ridges::Ranks* GetRanks() override { return this->filter->GetRanks(); }
    ridges::SharedSurface* GetSurface() override { return &this->filter->Internals->surface; }
  };

  /// On the part of the mesh that was gathered, if ranks share it.
  template <typename Stage>
  class OnPart : public Stage
  {
  public:
    static OnPart* New() { VTK_STANDARD_NEW_BODY(OnPart); }
    const vtkInternals* internals = nullptr;

  protected:
    const ridges::MeshPart* GetPart() override
    {
      return this->internals->gathering ? this->internals->gathering->GetPart() : nullptr;
    }
  };

public:
  explicit vtkInternals(vtkRidgesAndUmbilics* filter);

  std::array<vtkPolyDataAlgorithm*, 4> GetStages()
  {
    return { this->jets, this->umbilics, this->ridges, this->selection };
  }

  void TakeIn(vtkPolyData* input);

  /// Runs a stage. False where the filter has to stop: because of an error, or of the user.
  bool Run(vtkPolyDataAlgorithm* stage);

  /// Outputs ridges and umbilics with ids in the whole mesh.
  void StoreLines(vtkInformationVector* outputs);

  /// Fits on one rank, piece after piece. False if the user aborted.
  bool FitPieces();

  /// Fits on all ranks if any of them has to. The same result on all.
  bool FitOnRanks(ridges::Ranks& ranks);

  /// Finds umbilics and ridges on the first rank, from as much of the mesh as that takes. The same
  /// result on all.
  bool FindOnFirst(ridges::Ranks& ranks);

  vtkSmartPointer<vtkJetFitting> jets;
  vtkSmartPointer<vtkUmbilicDetection> umbilics;
  vtkSmartPointer<vtkRidgeExtraction> ridges;
  vtkNew<vtkRidgeSharpnessFilter> selection;
  std::string errorText; ///< Of the stages, in this update.
  vtkRidgesGathering ofRanks;
  vtkRidgesStreamedGathering ofPieces;
  vtkRidgesGathering* gathering =
    nullptr; ///< Of these the one that is used; null: the mesh is whole.
  std::unique_ptr<vtkRidgesStreamedFit> stream;
  ridges::SharedSurface surface; ///< From the fit to the gathering.

private:
  bool RunOnFirst(ridges::Ranks& ranks);
  vtkRidgesGathering::Extent LeastExtent(ridges::Ranks& ranks);

  void ForwardProgress(vtkObject* stage, unsigned long, void*);
  void ForwardMessage(vtkObject* caller, unsigned long event, void* text);

  vtkRidgesAndUmbilics* Filter;
  const vtkPolyData* LastInput = nullptr; ///< To compare with only.
  vtkMTimeType LastInputTime = 0;
  vtkMTimeType LastFitTime = 0;             ///< On ranks.
  vtkRidgesGathering::Extent LeastGathered; ///< What was asked for,
  vtkRidgesGathering::Extent Gathered;      ///< and what it took.
  bool HasGathered = false;
};

#endif
