// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPJetFitting
 * @brief   vtkJetFitting of a mesh whose pieces are on several ranks
 *
 * Input: on each rank a piece of one triangle mesh, in any partition; a piece may be empty. Points
 * of different pieces at exactly the same place are one point. Ghost cells are not needed, and not
 * used.
 *
 * Output: on each rank its piece, with the arrays of vtkJetFitting. Guarantee: the same bytes as
 * those of vtkJetFitting for the whole mesh on one rank, for any number of ranks and any partition.
 *
 * Method: points are dealt to the ranks by position, about as many to each. A rank gets all that
 * the fits at its points look at from the others, ring after ring; where a fit has to look farther
 * than was foreseen it is done again on more rings.
 *
 * Each rank has an error, the same on all, where any rank has: where a piece cannot be used, where
 * arrays or properties differ between ranks, and where a piece has several points at a place at
 * which another piece has one, too, unless the points have global ids
 * (vtkDataSetAttributes::GetGlobalIds). Warnings come from rank 0.
 *
 * With one rank it is vtkJetFitting.
 * @sa vtkJetFitting vtkPRidgesAndUmbilics
 */

#ifndef vtkPJetFitting_h
#define vtkPJetFitting_h

#include "vtkFiltersParallelRidgesModule.h" // For export macro
#include "vtkJetFitting.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;

class VTKFILTERSPARALLELRIDGES_EXPORT vtkPJetFitting : public vtkJetFitting
{
public:
  static vtkPJetFitting* New();
  vtkTypeMacro(vtkPJetFitting, vtkJetFitting);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The ranks. Default: those of vtkMultiProcessController::GetGlobalController, as the filter is
   * made; if there is none, one rank.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkPJetFitting();
  ~vtkPJetFitting() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkExecutive* CreateDefaultExecutive() override;
  ridges::Ranks* GetRanks() override;

private:
  vtkPJetFitting(const vtkPJetFitting&) = delete;
  void operator=(const vtkPJetFitting&) = delete;

  vtkMultiProcessController* Controller = nullptr;
  ridges::Ranks* const Ranks;
};
VTK_ABI_NAMESPACE_END

#endif
