// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesSalientLines_h
#define vtkRidgesSalientLines_h

#include "Core/Salience/LineCorners.h"
#include "vtkRidgesCompatibility.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * Collects the salient lines of both colours and stores them as the polylines and arrays of
 * vtkSalientRidges, private to the module. What is added has to outlive it.
 */
class vtkRidgesSalientLines
{
public:
  /// The model's diameter is the unit of masses, half of it that of sharpness.
  vtkRidgesSalientLines(const ridges::TriangleMesh& mesh, double diameter)
    : Mesh(mesh)
    , Diameter(diameter)
  {
  }

  /// The lines that were selected from these ridges of one colour.
  void Add(const std::vector<ridges::RidgeTrace>& ridges,
    const std::vector<ridges::RidgeFolds>& folds, std::vector<ridges::SalientLine> lines);

  /// Lengthens lines to where they meet.
  void MeetAtCorners(const ridges::MongeField& field, const ridges::CornerRule& rule);

  /// Stores all, the most massive first, smoothed to this deviation.
  void Store(const ridges::MongeField& field, double smoothing, vtkPolyData* output) const;

private:
  struct Entry
  {
    ridges::SalientLine line;
    const ridges::RidgeTrace* ridge;
    const ridges::RidgeFolds* folds;
  };

  static std::vector<ridges::RidgeVertex> VerticesOf(const Entry& entry);
  static const ridges::Fold& FoldAt(const Entry& entry, std::size_t vertex);

  const ridges::TriangleMesh& Mesh;
  double Diameter;
  std::vector<Entry> Entries;
};

#endif
