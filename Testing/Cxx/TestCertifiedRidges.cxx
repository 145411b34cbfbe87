// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCertifiedRidges.h"

#include "FilterTestTools.h"
#include "MessageRecorder.h"
#include "vtkCompliantRefinement.h"
#include "vtkJetFunction.h"
#include "vtkRidgeCoherence.h"
#include "vtkRidgesArrayNames.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"
#include "vtkTriangleFilter.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

constexpr const char* Ellipsoid = "x^2+y^2/0.64+z^2/0.36-1";

/// x² + b y² + c z² - 1 with its derivatives.
class Quadric : public vtkJetFunction
{
public:
  static Quadric* New();
  vtkTypeMacro(Quadric, vtkJetFunction);
  void EvaluateJet(const double x[3], int order, double* coefficients) override
  {
    const double squares[3] = { 1.0, 1.0 / 0.64, 1.0 / 0.36 };
    std::fill_n(coefficients, NumberOfCoefficients(order), 0.0);
    coefficients[0] = -1.0;
    for (int i = 0; i < 3; ++i)
    {
      coefficients[0] += squares[i] * x[i] * x[i];
      coefficients[1 + i] = 2.0 * squares[i] * x[i];
    }
    if (order > 1)
    {
      coefficients[Index(2, 0, 0)] = squares[0];
      coefficients[Index(0, 2, 0)] = squares[1];
      coefficients[Index(0, 0, 2)] = squares[2];
    }
  }
};
vtkStandardNewMacro(Quadric);

vtkSmartPointer<vtkPolyData> EllipsoidOf(int frequency)
{
  return ToPolyData(EllipsoidMesh(frequency, 1.0, 0.8, 0.6));
}

/// Verdicts by the name of the hypothesis.
std::map<std::string, std::string> VerdictsOf(vtkDataObject* data)
{
  auto* table = vtkTable::SafeDownCast(data);
  std::map<std::string, std::string> verdicts;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    verdicts[table->GetValueByName(row, names::Check).ToString()] =
      table->GetValueByName(row, names::Verdict).ToString();
  }
  return verdicts;
}

void Connect(vtkCertifiedRidges* certified, vtkRidgeCoherence* coherence)
{
  coherence->SetInputConnection(0, certified->GetOutputPort(vtkCertifiedRidges::MESH));
  coherence->SetInputConnection(1, certified->GetOutputPort(vtkCertifiedRidges::RIDGES));
  coherence->SetInputConnection(2, certified->GetOutputPort(vtkCertifiedRidges::UMBILICS));
}

} // namespace

TEST(CertifiedRidges, ProvesAnEllipsoid)
{
  vtkNew<vtkCertifiedRidges> certified;
  const MessageRecorder messages(certified);
  certified->SetInputData(EllipsoidOf(6));
  certified->SetFormula(Ellipsoid);
  certified->Update();
  EXPECT_EQ(messages.ErrorText() + messages.WarningText(), "");
  for (const auto& [name, verdict] :
    VerdictsOf(certified->GetOutputDataObject(vtkCertifiedRidges::TABLE)))
  {
    EXPECT_EQ(verdict, "proved") << name;
  }
  vtkPolyData* mesh = certified->GetOutput(vtkCertifiedRidges::MESH);
  EXPECT_EQ(mesh->GetCellData()->GetArray(names::Certificate)->GetRange()[0], 2.0);
  EXPECT_EQ(mesh->GetCellData()->GetArray(names::FailedHypotheses)->GetRange()[1], 0.0);

  // a sqrt((a² - b²) / (a² - c²)) and c sqrt((b² - c²) / (a² - c²))
  vtkPolyData* umbilics = certified->GetOutput(vtkCertifiedRidges::UMBILICS);
  ASSERT_EQ(umbilics->GetNumberOfPoints(), 4);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const Eigen::Vector3d x = PointAt(umbilics, i);
    EXPECT_NEAR(std::abs(x[0]), 0.75, 1e-12);
    EXPECT_NEAR(x[1], 0.0, 1e-12);
    EXPECT_NEAR(std::abs(x[2]), 0.6 * std::sqrt(0.4375), 1e-12);
    EXPECT_EQ(Value(umbilics->GetPointData(), names::RidgeCount, i), 1.0);
  }
}

// Two ridges leave this umbilic within three degrees, so that the disk around it that can be
// certified is a small fraction of an edge.
TEST(CertifiedRidges, ProvesAnUmbilicWithCloseRidges)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.08, -0.0824, 0.0);
  plane->SetPoint1(0.0808, -0.0824, 0.0);
  plane->SetPoint2(-0.08, 0.08, 0.0);
  plane->SetResolution(5, 5);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkCertifiedRidges> certified;
  certified->SetInputConnection(triangles->GetOutputPort());
  certified->SetSurfaceType(vtkCertifiedRidges::GRAPH);
  certified->SetFormula("0.5*(x^2+y^2)+0.3*(x^2*y-0.0005*y^3)");
  certified->Update();
  for (const auto& [name, verdict] :
    VerdictsOf(certified->GetOutputDataObject(vtkCertifiedRidges::TABLE)))
  {
    EXPECT_EQ(verdict, "proved") << name;
  }
  EXPECT_EQ(certified->GetOutput(vtkCertifiedRidges::UMBILICS)->GetNumberOfPoints(), 1);
}

TEST(CertifiedRidges, PlacesPointsOnTheTrueRidges)
{
  vtkNew<vtkCertifiedRidges> certified;
  certified->SetInputData(EllipsoidOf(8));
  certified->SetFormula(Ellipsoid);
  certified->Update();
  vtkPolyData* lines = certified->GetOutput();
  vtkDataArray* patch =
    certified->GetOutput(vtkCertifiedRidges::MESH)->GetCellData()->GetArray(names::UmbilicPatch);
  ASSERT_NE(patch, nullptr);
  int onRidge = 0;
  for (vtkIdType p = 0; p < lines->GetNumberOfPoints(); ++p)
  {
    const Eigen::Vector3d x = PointAt(lines, p);
    // In the coordinate planes, and on the surface, but for points inside patches.
    const bool isExact = x.cwiseAbs().minCoeff() < 1e-11 &&
      std::abs(x[0] * x[0] + x[1] * x[1] / 0.64 + x[2] * x[2] / 0.36 - 1.0) < 1e-12;
    onRidge += isExact ? 1 : 0;
  }
  EXPECT_GT(onRidge, 0.9 * lines->GetNumberOfPoints());
}

// The result is consistent by the checks that know nothing of the formula, too, and the verdicts of
// the proof are among them.
TEST(CertifiedRidges, PassesTheChecksOfConsistency)
{
  vtkNew<vtkCertifiedRidges> certified;
  certified->SetInputData(EllipsoidOf(8));
  certified->SetFormula(Ellipsoid);
  vtkNew<vtkRidgeCoherence> coherence;
  Connect(certified, coherence);
  coherence->Update();
  vtkTable* checks = coherence->GetOutput();
  int proved = 0;
  for (vtkIdType row = 0; row < checks->GetNumberOfRows(); ++row)
  {
    const std::string name = checks->GetValueByName(row, names::Check).ToString();
    EXPECT_EQ(checks->GetValueByName(row, names::Passed).ToInt(), 1) << name;
    // Points are on the surface instead.
    EXPECT_EQ(
      checks->GetValueByName(row, names::Applies).ToInt(), name == "points on edges" ? 0 : 1)
      << name;
    proved += checks->GetValueByName(row, names::Found).ToString() == "proved" ? 1 : 0;
  }
  EXPECT_EQ(checks->GetNumberOfRows(), 14 + 12);
  EXPECT_EQ(proved, 12);
}

TEST(CertifiedRidges, ChecksSayWhichHypothesisFailsWhere)
{
  vtkNew<vtkCertifiedRidges> certified;
  const MessageRecorder messages(certified); // not certified
  certified->SetInputData(EllipsoidOf(2));
  certified->SetFormula(Ellipsoid);
  certified->SetMaximumNumberOfPoints(0);
  vtkNew<vtkRidgeCoherence> coherence;
  Connect(certified, coherence);
  coherence->Update();
  vtkTable* checks = coherence->GetOutput();
  vtkDataArray* failed = certified->GetOutput(vtkCertifiedRidges::MESH)
                           ->GetCellData()
                           ->GetArray(names::FailedHypotheses);
  int row = 14;
  ASSERT_EQ(checks->GetNumberOfRows(), row + 12);
  int failing = 0;
  for (int bit = 0; bit < 12; ++bit, ++row)
  {
    int cells = 0;
    for (vtkIdType i = 0; i < failed->GetNumberOfTuples(); ++i)
    {
      cells += (static_cast<int>(failed->GetTuple1(i)) >> bit) & 1;
    }
    const std::string name = checks->GetValueByName(row, names::Check).ToString();
    EXPECT_EQ(name.rfind("hypothesis ", 0), 0u) << name;
    EXPECT_EQ(checks->GetValueByName(row, names::NumberOfOffenders).ToInt(), cells) << name;
    EXPECT_EQ(checks->GetValueByName(row, names::Severity).ToInt(), cells > 0 ? 1 : 0) << name;
    const std::string found = checks->GetValueByName(row, names::Found).ToString();
    EXPECT_EQ(
      found.rfind("fails in " + std::to_string(cells) + " of 80 triangles", 0) == 0, cells > 0)
      << name << ": " << found;
    failing += cells > 0 ? 1 : 0;
  }
  EXPECT_GT(failing, 0);
}

TEST(CertifiedRidges, ChecksRefuseVerdictsThatAreNone)
{
  vtkNew<vtkCertifiedRidges> certified;
  certified->SetInputData(EllipsoidOf(6));
  certified->SetFormula(Ellipsoid);
  certified->Update();
  vtkPolyData* mesh = certified->GetOutput(vtkCertifiedRidges::MESH);
  mesh->GetCellData()->GetArray(names::Certificate)->SetTuple1(7, 5.0);
  vtkNew<vtkRidgeCoherence> coherence;
  const MessageRecorder messages(coherence);
  coherence->SetInputData(0, mesh);
  coherence->SetInputData(1, certified->GetOutput(vtkCertifiedRidges::RIDGES));
  coherence->Update();
  EXPECT_NE(messages.ErrorText().find("Certificate"), std::string::npos) << messages.ErrorText();
  EXPECT_EQ(coherence->GetOutput()->GetNumberOfRows(), 0);
}

TEST(CertifiedRidges, FailsOnACoarseMeshThatMayNotBeRefined)
{
  vtkNew<vtkCertifiedRidges> certified;
  const MessageRecorder messages(certified);
  certified->SetInputData(EllipsoidOf(2));
  certified->SetFormula(Ellipsoid);
  certified->SetMaximumNumberOfPoints(0);
  certified->Update();
  EXPECT_NE(messages.WarningText().find("not certified"), std::string::npos);
  vtkPolyData* mesh = certified->GetOutput(vtkCertifiedRidges::MESH);
  EXPECT_EQ(mesh->GetNumberOfPoints(), 42);
  EXPECT_EQ(mesh->GetCellData()->GetArray(names::Certificate)->GetRange()[0], 0.0);
}

TEST(CertifiedRidges, ChecksAFunctionWithoutAFormula)
{
  vtkNew<Quadric> quadric;
  vtkNew<vtkCertifiedRidges> certified;
  const MessageRecorder messages(certified);
  certified->SetInputData(EllipsoidOf(6));
  certified->SetJetFunction(quadric);
  certified->Update();
  EXPECT_NE(messages.ErrorText().find("a proof needs a formula"), std::string::npos);
  certified->SetLevelToChecked();
  certified->Update();
  for (const auto& [name, verdict] :
    VerdictsOf(certified->GetOutputDataObject(vtkCertifiedRidges::TABLE)))
  {
    EXPECT_EQ(verdict, "checked") << name;
  }
}

TEST(CertifiedRidges, ReportsWhatCannotBeUsed)
{
  vtkNew<vtkCertifiedRidges> certified;
  const MessageRecorder messages(certified);
  certified->SetInputData(EllipsoidOf(2));
  certified->SetFormula("x^2+foo(y)");
  certified->Update();
  EXPECT_NE(messages.ErrorText().find("at character 5"), std::string::npos) << messages.ErrorText();
  certified->SetFormula("x^2+1");
  certified->Update();
  EXPECT_NE(messages.ErrorText().find("no Monge form"), std::string::npos) << messages.ErrorText();
}

TEST(CertifiedRidges, IsTheSameForAnyNumberOfThreads)
{
  std::string before;
  for (const int threads : { 1, 4 })
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkCertifiedRidges> certified;
    certified->SetInputData(EllipsoidOf(3));
    certified->SetFormula(Ellipsoid);
    certified->Update();
    const std::string bytes = BytesOf(certified->GetOutput()) +
      BytesOf(certified->GetOutput(vtkCertifiedRidges::MESH)) +
      BytesOf(certified->GetOutput(vtkCertifiedRidges::EDGES));
    EXPECT_TRUE(before.empty() || bytes == before);
    before = bytes;
  }
  vtkSMPTools::Initialize();
}

TEST(CertifiedRidges, GivesEmptyOutputForEmptyInput)
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkCertifiedRidges> certified;
  const MessageRecorder messages(certified);
  certified->SetInputData(empty);
  certified->SetFormula(Ellipsoid);
  certified->Update();
  EXPECT_EQ(messages.ErrorText(), "");
  EXPECT_TRUE(IsEmpty(certified->GetOutput()));
}

TEST(CompliantRefinement, EndsOnSurfacesOfRevolution)
{
  for (const char* formula : { "x^2+y^2+z^2-1", "x^2+y^2+z^2/0.36-1" })
  {
    vtkNew<vtkCompliantRefinement> refinement;
    refinement->SetInputData(ToPolyData(Icosphere(6)));
    refinement->SetFormula(formula);
    refinement->Update();
    auto verdicts = VerdictsOf(refinement->GetOutputDataObject(1));
    const std::string& failed = verdicts[formula == std::string("x^2+y^2+z^2-1") ? "D1" : "D2"];
    EXPECT_EQ(failed, "failed: the surface is not generic there") << formula;
    EXPECT_EQ(refinement->GetOutput()->GetNumberOfPoints(), 362);
  }
}

TEST(CompliantRefinement, StopsAtTheLimit)
{
  vtkNew<vtkCompliantRefinement> refinement;
  refinement->SetInputData(EllipsoidOf(1));
  refinement->SetFormula(Ellipsoid);
  refinement->SetMaximumNumberOfPoints(13);
  refinement->Update();
  EXPECT_LT(refinement->GetOutput()->GetNumberOfPoints(), 30); // one round of 12 points
  const auto verdicts = VerdictsOf(refinement->GetOutputDataObject(1));
  EXPECT_TRUE(std::any_of(verdicts.begin(), verdicts.end(),
    [](const auto& verdict) { return verdict.second == "failed"; }));
}
