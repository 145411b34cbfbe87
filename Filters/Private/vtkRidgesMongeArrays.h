// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesMongeArrays_h
#define vtkRidgesMongeArrays_h

#include "Core/Fit/FitErrors.h"
#include "Core/Monge/MongeField.h"
#include "vtkRidgesArrayReader.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/// Makes a filter read the arrays of vtkJetFitting unless the user chooses others: to be called in
/// its constructor.
void vtkRidgesChooseMongeArrays(vtkAlgorithm* filter);

/**
 * The Monge arrays on a mesh that a filter reads, as the numerics want them, private to the module.
 */
class vtkRidgesMongeArrays
{
public:
  /**
   * Fetches the arrays. All that is wrong with them becomes one text, which is empty if nothing is.
   * FourthOrder, or else P1 and P2, is required only where the caller needs it.
   */
  std::string Fetch(vtkAlgorithm* filter, vtkPolyData* mesh, bool needsFourthOrder);

  /// The same for curvatures and directions alone.
  std::string FetchSecondOrder(vtkAlgorithm* filter, vtkPolyData* mesh);

  const ridges::MongeField& GetField() const { return this->Field; }

  /// What is known of the errors of the fits. The arrays for it may be missing.
  const ridges::FitErrorSource& GetErrors() const { return this->Errors; }

  /// Per point: 0 where the fit is invalid or a value is not finite.
  const std::vector<std::uint8_t>& GetUsable() const { return this->Usable; }

  /// Per point, what ExtremalityErrors wants to know of FitStatus; empty if it is missing.
  std::vector<std::uint8_t> FlaggedPoints() const;

  /// How many points have values that are not finite, and in which arrays; empty if there are none.
  std::string GetWarning() const;

private:
  void Choose(vtkAlgorithm* filter, vtkPolyData* mesh);
  bool Has(const char* contractName) const;
  void ReadSecondOrder();
  void ReadErrors();
  void ReadStatus();
  const double* Read(const char* contractName, int components,
    vtkRidgesArrayReader::Presence presence = vtkRidgesArrayReader::Presence::Required);
  bool FlagNotFinite(const double* values, int components);

  ridges::MongeField Field;
  ridges::FitErrorSource Errors;
  vtkRidgesArrayReader Reader;
  vtkRidgesArrayReader::Source Source;       ///< The point data of the mesh.
  std::map<std::string, std::string> Chosen; ///< Names of the contract, and of the arrays to read.
  const vtkIdType* Status = nullptr;         ///< Null if it is missing.
  std::vector<std::uint8_t> Usable;
  std::string NotFinite; ///< Names of arrays.
  vtkIdType NumberOfNotFinitePoints = 0;
};

#endif
