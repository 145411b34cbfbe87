// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// The arrays that filters read: any type and storage that holds the right values is as good as
// vtkJetFitting's own, and whatever does not fit is named in one error.

#include "FilterTestTools.h"
#include "MessageRecorder.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPrincipalFoliation.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStringArray.h"
#include "vtkUmbilicDetection.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

const std::vector<const char*> MongeNames = { names::MaximumCurvature, names::MinimumCurvature,
  names::MaximumDirection, names::MinimumDirection, names::ThirdOrder, names::FourthOrder,
  names::FitStatus };

/// A copy that shares nothing with others.
vtkSmartPointer<vtkPolyData> FittedEllipsoid()
{
  static const vtkSmartPointer<vtkPolyData> fitted = RunFilters(EllipsoidData(12)).fitted;
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(fitted);
  return copy;
}

/// What the filters give that read the Monge arrays.
std::string BytesBehind(vtkPolyData* fitted)
{
  vtkNew<vtkUmbilicDetection> umbilics;
  umbilics->SetInputData(fitted);
  vtkNew<vtkRidgeExtraction> ridges;
  ridges->SetInputConnection(umbilics->GetOutputPort());
  ridges->Update();
  vtkNew<vtkPrincipalFoliation> foliation;
  foliation->SetInputConnection(umbilics->GetOutputPort());
  foliation->SetSeparation(0.3);
  foliation->Update();
  EXPECT_GT(ridges->GetOutput()->GetNumberOfLines(), 0);
  EXPECT_GT(foliation->GetOutput()->GetNumberOfLines(), 0);
  return BytesOf(umbilics->GetOutput(1)) + BytesOf(ridges->GetOutput()) +
    BytesOf(foliation->GetOutput());
}

/// Replaces an array by one of another class with the same name, components and values.
template <typename Array>
void Replace(vtkPolyData* mesh, const char* name)
{
  vtkDataArray* old = mesh->GetPointData()->GetArray(name);
  vtkNew<Array> other;
  other->SetName(name);
  other->SetNumberOfComponents(old->GetNumberOfComponents());
  other->SetNumberOfTuples(old->GetNumberOfTuples());
  for (vtkIdType i = 0; i < old->GetNumberOfTuples(); ++i)
  {
    other->SetTuple(i, old->GetTuple(i));
  }
  mesh->GetPointData()->AddArray(other);
}

struct Failure
{
  std::string text;
  std::size_t errors;
};

Failure RunExtraction(vtkPolyData* mesh)
{
  vtkNew<vtkRidgeExtraction> ridges;
  const MessageRecorder recorder(ridges);
  ridges->SetInputData(mesh);
  ridges->Update();
  EXPECT_TRUE(IsEmpty(ridges->GetOutput()));
  return { recorder.ErrorText(), recorder.NumberOfErrors() };
}

} // namespace

TEST(InputArrays, MayBeStoredByComponents)
{
  const std::string expected = BytesBehind(FittedEllipsoid());
  const auto mesh = FittedEllipsoid();
  for (const char* name : MongeNames)
  {
    Replace<vtkSOADataArrayTemplate<double>>(mesh, name);
  }
  vtkNew<vtkSOADataArrayTemplate<double>> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    coordinates->SetTuple(p, mesh->GetPoint(p));
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  mesh->SetPoints(points);
  EXPECT_TRUE(BytesBehind(mesh) == expected);
}

TEST(InputArrays, MayBeOfSinglePrecision)
{
  const auto single = FittedEllipsoid();
  const auto rounded = FittedEllipsoid();
  for (const char* name : MongeNames)
  {
    Replace<vtkFloatArray>(single, name);
    Replace<vtkFloatArray>(rounded, name);
    Replace<vtkDoubleArray>(rounded, name);
  }
  EXPECT_TRUE(BytesBehind(single) == BytesBehind(rounded));
}

TEST(InputArrays, CellsMayBeStoredInAnyWidth)
{
  const std::string expected = BytesBehind(FittedEllipsoid());
  const auto mesh = FittedEllipsoid();
  vtkNew<vtkCellArray> narrow;
  narrow->DeepCopy(mesh->GetPolys());
  ASSERT_TRUE(narrow->ConvertTo32BitStorage());
  mesh->SetPolys(narrow);
  EXPECT_TRUE(BytesBehind(mesh) == expected);
}

TEST(InputArrays, WrongNumberOfTuplesIsAnErrorWithBothNumbers)
{
  for (const char* name : MongeNames)
  {
    for (const vtkIdType change : { -1, 1 })
    {
      const auto mesh = FittedEllipsoid();
      vtkDataArray* array = mesh->GetPointData()->GetArray(name);
      const vtkIdType tuples = mesh->GetNumberOfPoints() + change;
      array->Resize(tuples);
      array->SetNumberOfTuples(tuples);
      const Failure failure = RunExtraction(mesh);
      EXPECT_EQ(failure.errors, 1u) << name;
      EXPECT_NE(failure.text.find(std::string(name) + " has " + std::to_string(tuples) +
                  " tuples, not " + std::to_string(mesh->GetNumberOfPoints())),
        std::string::npos)
        << failure.text;
    }
  }
}

TEST(InputArrays, AllFaultsAreInOneError)
{
  const auto mesh = FittedEllipsoid();
  vtkPointData* data = mesh->GetPointData();
  data->RemoveArray(names::MaximumCurvature);
  data->RemoveArray(names::MinimumDirection);
  vtkNew<vtkStringArray> text;
  text->SetName(names::MinimumCurvature);
  text->SetNumberOfValues(mesh->GetNumberOfPoints());
  data->AddArray(text);
  AddPointArray(mesh, names::ThirdOrder, 3, [](vtkIdType, double* b) { b[0] = b[1] = b[2] = 1.0; });
  data->GetArray(names::FourthOrder)->SetNumberOfTuples(50);
  AddPointArray(mesh, names::FitStatus, 1, [](vtkIdType p, double* s) { *s = p == 7 ? 1e300 : 0; });
  const Failure failure = RunExtraction(mesh);
  EXPECT_EQ(failure.errors, 1u);
  for (const char* fault : { "lacks MaximumCurvature, MinimumDirection",
         "MinimumCurvature is a vtkStringArray", "ThirdOrder has 3 components, not 4",
         "FourthOrder has 50 tuples, not 1442", "FitStatus is 1e+300 in tuple 7" })
  {
    EXPECT_NE(failure.text.find(fault), std::string::npos) << fault << "\n" << failure.text;
  }
}

TEST(InputArrays, StatusThatIsNoIntegerIsAnError)
{
  for (const double status : { 0.5, -1.0, 1e300, std::numeric_limits<double>::quiet_NaN() })
  {
    const auto mesh = FittedEllipsoid();
    AddPointArray(
      mesh, names::FitStatus, 1, [status](vtkIdType p, double* s) { *s = p == 3 ? status : 0.0; });
    const Failure failure = RunExtraction(mesh);
    EXPECT_EQ(failure.errors, 1u) << status;
    EXPECT_NE(failure.text.find("in tuple 3, not an integer from 0 to"), std::string::npos)
      << failure.text;
  }
}

TEST(InputArrays, ValuesThatAreNotFiniteAreCountedInOneWarning)
{
  const auto mesh = FittedEllipsoid();
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  mesh->GetPointData()->GetArray(names::ThirdOrder)->SetComponent(5, 2, notANumber);
  mesh->GetPointData()->GetArray(names::FitResidual)->SetComponent(6, 0, notANumber);
  vtkDataArray* k1 = mesh->GetPointData()->GetArray(names::MaximumCurvature);
  vtkNew<vtkUmbilicDetection> umbilics;
  vtkNew<vtkRidgeExtraction> ridges;
  vtkNew<vtkPrincipalFoliation> foliation;
  const auto expectWarning = [mesh](vtkPolyDataAlgorithm* filter, const std::string& warning)
  {
    const MessageRecorder recorder(filter);
    filter->SetInputDataObject(mesh);
    filter->Modified();
    filter->Update();
    EXPECT_EQ(recorder.NumberOfWarnings(), warning.empty() ? 0u : 1u) << recorder.WarningText();
    EXPECT_NE(recorder.WarningText().find(warning), std::string::npos) << recorder.WarningText();
    EXPECT_EQ(recorder.ErrorText(), "");
  };
  const std::string two = "2 points have values that are not finite (ThirdOrder, FitResidual)";
  expectWarning(umbilics, two);
  expectWarning(ridges, two);
  expectWarning(foliation, ""); // It does not read these.
  k1->Fill(notANumber);
  const std::string all = "1442 points have values that are not finite (MaximumCurvature";
  expectWarning(umbilics, all);
  expectWarning(ridges, all);
  expectWarning(foliation, all);
}

// By other names, of a mesh that also has arrays of the usual names with other values.
TEST(InputArrays, MayBeChosenByIndex)
{
  const std::string expected = BytesBehind(FittedEllipsoid());
  const auto mesh = FittedEllipsoid();
  vtkNew<vtkUmbilicDetection> umbilics;
  vtkNew<vtkRidgeExtraction> ridges;
  vtkNew<vtkPrincipalFoliation> foliation;
  int index = 0;
  for (const char* name : names::MongeInputs)
  {
    if (vtkDataArray* array = mesh->GetPointData()->GetArray(name))
    {
      vtkSmartPointer<vtkDataArray> own;
      own.TakeReference(array->NewInstance());
      own->DeepCopy(array);
      own->SetName((std::string("My") + name).c_str());
      mesh->GetPointData()->AddArray(own);
      array->Fill(7.0);
      for (vtkAlgorithm* filter : { static_cast<vtkAlgorithm*>(umbilics),
             static_cast<vtkAlgorithm*>(ridges), static_cast<vtkAlgorithm*>(foliation) })
      {
        filter->SetInputArrayToProcess(
          index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, own->GetName());
      }
    }
    ++index;
  }
  umbilics->SetInputData(mesh);
  ridges->SetInputConnection(umbilics->GetOutputPort());
  foliation->SetInputConnection(umbilics->GetOutputPort());
  foliation->SetSeparation(0.3);
  ridges->Update();
  foliation->Update();
  EXPECT_TRUE(BytesOf(umbilics->GetOutput(1)) + BytesOf(ridges->GetOutput()) +
      BytesOf(foliation->GetOutput()) ==
    expected);
}

TEST(InputArrays, MayBeChosenAsAttribute)
{
  const auto mesh = FittedEllipsoid();
  mesh->GetPointData()->SetActiveScalars(names::MaximumCurvature);
  vtkNew<vtkRidgeExtraction> byName;
  byName->SetInputData(mesh);
  byName->Update();
  vtkNew<vtkRidgeExtraction> byAttribute;
  byAttribute->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  byAttribute->SetInputData(mesh);
  byAttribute->Update();
  EXPECT_GT(byName->GetOutput()->GetNumberOfLines(), 0);
  EXPECT_TRUE(BytesOf(byAttribute->GetOutput()) == BytesOf(byName->GetOutput()));
}

TEST(InputArrays, ThoseChosenAreNamedInErrors)
{
  vtkNew<vtkRidgeExtraction> ridges;
  const MessageRecorder recorder(ridges);
  ridges->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Kmax");
  ridges->SetInputArrayToProcess(
    4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, names::ThirdOrder);
  ridges->SetInputData(FittedEllipsoid());
  ridges->Update();
  EXPECT_EQ(recorder.NumberOfErrors(), 1u);
  EXPECT_NE(recorder.ErrorText().find("lacks Kmax;"), std::string::npos) << recorder.ErrorText();
  EXPECT_NE(recorder.ErrorText().find("ThirdOrder is to be read from other than point data"),
    std::string::npos)
    << recorder.ErrorText();
}
