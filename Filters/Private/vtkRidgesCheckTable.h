// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesCheckTable_h
#define vtkRidgesCheckTable_h

#include "Core/Coherence/CoherenceCheck.h"
#include "Core/Coherence/RidgePicture.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesMakeArray.h"
#include "vtkRidgesMesh.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkTable;
VTK_ABI_NAMESPACE_END

/**
 * The table of vtkRidgeCoherence, private to the module.
 */
class vtkRidgesCheckTable
{
public:
  explicit vtkRidgesCheckTable(const vtkRidgesMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// A row for each check.
  void Add(const std::vector<ridges::CoherenceCheck>& checks, const ridges::RidgePicture& picture);

  /// A row for each hypothesis of the certified algorithm, if the cells have verdicts. Returns what
  /// is wrong with these, as text.
  std::string AddCertificate();

  void Store(vtkTable* output) const;

private:
  struct Row
  {
    std::string name;
    std::string section;
    std::string expected;
    std::string found;
    bool applies = true;
    int severity = 0;
    vtkIdType numberOfOffenders = 0;
    const char* offenderKind = "cell";
    std::string offenders;
    Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< Of the first offender.
  };

  void Add(const Row& row);

  const vtkRidgesMesh& Mesh;
  vtkNew<vtkStringArray> Check = vtkRidgesMakeArray<vtkStringArray>(vtkRidgesArrayNames::Check);
  vtkNew<vtkStringArray> Section = vtkRidgesMakeArray<vtkStringArray>(vtkRidgesArrayNames::Section);
  vtkNew<vtkStringArray> Expected =
    vtkRidgesMakeArray<vtkStringArray>(vtkRidgesArrayNames::Expected);
  vtkNew<vtkStringArray> Found = vtkRidgesMakeArray<vtkStringArray>(vtkRidgesArrayNames::Found);
  vtkNew<vtkIntArray> Applies = vtkRidgesMakeArray<vtkIntArray>(vtkRidgesArrayNames::Applies);
  vtkNew<vtkIntArray> Passed = vtkRidgesMakeArray<vtkIntArray>(vtkRidgesArrayNames::Passed);
  vtkNew<vtkIntArray> Severity = vtkRidgesMakeArray<vtkIntArray>(vtkRidgesArrayNames::Severity);
  vtkNew<vtkIdTypeArray> Number =
    vtkRidgesMakeArray<vtkIdTypeArray>(vtkRidgesArrayNames::NumberOfOffenders);
  vtkNew<vtkStringArray> Kind =
    vtkRidgesMakeArray<vtkStringArray>(vtkRidgesArrayNames::OffenderKind);
  vtkNew<vtkStringArray> Offenders =
    vtkRidgesMakeArray<vtkStringArray>(vtkRidgesArrayNames::Offenders);
  vtkNew<vtkDoubleArray> Place =
    vtkRidgesMakeArray<vtkDoubleArray>(vtkRidgesArrayNames::OffenderPosition, 3);
};

#endif
