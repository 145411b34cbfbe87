// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesGhosts_h
#define vtkRidgesGhosts_h

#include "vtkRidgesCompatibility.h"

#include "vtkType.h"

#include <cstdint>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkInformationVector;
class vtkJetFitting;
class vtkPolyData;
class vtkRidgeExtraction;
class vtkUmbilicDetection;
VTK_ABI_NAMESPACE_END

/**
 * The vtkGhostType arrays of a data set: which cells and points are hidden, and which cells are
 * duplicates of cells in another piece. Private to the module.
 */
class vtkRidgesGhosts
{
public:
  /// Reads the arrays, if there are any. What is wrong with them becomes a text.
  std::string Read(vtkPolyData* data);

  bool HasHidden() const { return this->AnyHidden; }
  bool HasDuplicates() const { return this->AnyDuplicate; }

  /// Cells are numbered as in the data set.
  bool IsHiddenCell(vtkIdType cell) const;
  bool IsDuplicateCell(vtkIdType cell) const;
  bool IsHiddenPoint(vtkIdType point) const;

private:
  std::vector<std::uint8_t> CellFlags; ///< Empty if there are no flags.
  std::vector<std::uint8_t> PointFlags;
  bool AnyHidden = false;
  bool AnyDuplicate = false;
};

/// Layers of ghost cells that a filter needs around its piece, so that the piece's own cells get
/// the values they have in the whole mesh.
int vtkRidgesGhostLevelsOf(vtkJetFitting* filter);
int vtkRidgesGhostLevelsOf(vtkUmbilicDetection* filter);
int vtkRidgesGhostLevelsOf(vtkRidgeExtraction* filter);

/// Asks for more layers of ghost cells than are asked of the filter, if the data come in pieces.
void vtkRidgesRequestGhostLevels(vtkInformationVector* input, int levels);

/// Warns if a mesh is one of several pieces, but has no ghost cells.
void vtkRidgesWarnOfMissingGhosts(vtkAlgorithm* filter, vtkInformationVector* input);

#endif
