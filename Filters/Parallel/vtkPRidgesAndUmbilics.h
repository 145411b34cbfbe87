// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPRidgesAndUmbilics
 * @brief   vtkRidgesAndUmbilics of a mesh whose pieces are on several ranks
 *
 * Input: on each rank a piece of one triangle mesh, as for vtkPJetFitting.
 *
 * Output: on rank 0 all ridges (port 0; but see DistributeLines) and umbilics (port 1), on each
 * rank its piece (port 2) with the arrays that vtkRidgesAndUmbilics gives the mesh. Ids of points
 * and triangles in ports 0 and 1, and in field data, are those of the whole mesh: pieces have them
 * as the point array GatheredPointId and the cell array GatheredCellId, which is -1 where a cell is
 * no triangle.
 *
 * Guarantee: the same points, types, umbilics and arrays, byte for byte, as those of
 * vtkRidgesAndUmbilics for the whole mesh on one rank, but for ids, for any number of ranks and any
 * partition.
 *
 * Jets, which take most of the time, are fitted on all ranks (vtkPJetFitting). Then rank 0 gets the
 * triangles in which something may be, with rings around them, and finds umbilics and ridges alone:
 * on clean meshes a small part. On noisy meshes, and where regions without significant ridges are
 * looked for, it gets the whole mesh, and needs as much memory as it would without the others.
 *
 * Errors are the same on all ranks; warnings come from rank 0. With one rank it is
 * vtkRidgesAndUmbilics.
 * @sa vtkRidgesAndUmbilics vtkPJetFitting
 */

#ifndef vtkPRidgesAndUmbilics_h
#define vtkPRidgesAndUmbilics_h

#include "vtkFiltersParallelRidgesModule.h" // For export macro
#include "vtkRidgesAndUmbilics.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;

class VTKFILTERSPARALLELRIDGES_EXPORT vtkPRidgesAndUmbilics : public vtkRidgesAndUmbilics
{
public:
  static vtkPRidgesAndUmbilics* New();
  vtkTypeMacro(vtkPRidgesAndUmbilics, vtkRidgesAndUmbilics);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The ranks. Default: those of vtkMultiProcessController::GetGlobalController, as the filter is
   * made; if there is none, one rank.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  ///@{
  /**
   * Whether each rank has a share of the ridges, about as many points on each, all lines of a ridge
   * (RidgeId) on one. Rank after rank they are in the order that they have else, when rank 0 has
   * all. Umbilics are on rank 0. Default: off.
   */
  vtkSetMacro(DistributeLines, bool);
  vtkGetMacro(DistributeLines, bool);
  vtkBooleanMacro(DistributeLines, bool);
  ///@}

  ///@{
  /**
   * On one rank: in how many pieces the input is asked for, one after the other, at least 1. For a
   * mesh whose fits are too much for the memory: of each piece positions and triangles are kept,
   * about 85 bytes per point, and fits only where an umbilic or a ridge may be. The output is that
   * of one piece, but that port 2 is this part of the mesh, without the arrays of the input.
   * Whatever has changed, all pieces are asked for again. What makes the pieces has to be able to:
   * a reader of .pvtp is. Default 1: fits are made once.
   */
  vtkSetClampMacro(NumberOfPieces, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfPieces, int);
  ///@}

protected:
  vtkPRidgesAndUmbilics();
  ~vtkPRidgesAndUmbilics() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkExecutive* CreateDefaultExecutive() override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  ridges::Ranks* GetRanks() override;
  int GetNumberOfStreamedPieces() override { return this->NumberOfPieces; }

private:
  vtkPRidgesAndUmbilics(const vtkPRidgesAndUmbilics&) = delete;
  void operator=(const vtkPRidgesAndUmbilics&) = delete;

  vtkMultiProcessController* Controller = nullptr;
  bool DistributeLines = false;
  int NumberOfPieces = 1;
  ridges::Ranks* const Ranks;
};
VTK_ABI_NAMESPACE_END

#endif
