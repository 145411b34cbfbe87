// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesMongeArrays_h
#define vtkRidgesMongeArrays_h

#include "Core/Monge/MongeField.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

/**
 * The Monge arrays on a mesh, as the numerics want them, private to the module.
 */
class vtkRidgesMongeArrays
{
public:
  /**
   * Fetches the arrays. What is wrong, all of it, comes back as text that names each array; empty
   * if nothing is. FourthOrder, or else P1 and P2, is demanded only where the caller needs it.
   */
  std::string Fetch(vtkPolyData* mesh, bool needsFourthOrder);

  /// The same for curvatures and directions alone.
  std::string FetchSecondOrder(vtkPolyData* mesh);

  const ridges::MongeField& GetField() const { return this->Field; }

  /// Per point: 0 where the fit is invalid or a value is not finite.
  const std::vector<std::uint8_t>& GetUsable() const { return this->Usable; }

private:
  void Fault(const std::string& text);
  void FetchStatus(vtkPolyData* mesh);
  const double* FetchArray(vtkPolyData* mesh, const char* name, int components);

  ridges::MongeField Field;
  std::vector<std::uint8_t> Usable;
  std::vector<std::vector<double>> Converted;
  std::string Faults;
};

#endif
