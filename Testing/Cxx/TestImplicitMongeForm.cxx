// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImplicitMongeForm.h"

#include "AnalyticSurface.h"
#include "FilterTestTools.h"
#include "MessageRecorder.h"
#include "vtkJetFitting.h"
#include "vtkJetFunction.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkUmbilicDetection.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

constexpr const char* Ellipsoid = "x^2/1.96 + y^2 + z^2/0.36 - 1";
constexpr const char* Blend = "1 - exp(-0.7*((x/0.15)^2+(y/0.25)^2+(z/0.35)^2-1))"
                              " - exp(-0.7*(((x-0.25)/0.1)^2+((y-0.1)/0.2)^2+((z-0.1)/0.3)^2-1))";

vtkSmartPointer<vtkPolyData> Exact(vtkPolyData* mesh, const char* formula)
{
  vtkNew<vtkImplicitMongeForm> forms;
  forms->SetInputData(mesh);
  forms->SetFormula(formula);
  forms->Update();
  return forms->GetOutput();
}

/// A mesh with its points moved off the surface, by up to so much along each axis.
Mesh Displaced(Mesh mesh, double distance)
{
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    mesh.points[i] += distance * std::sin(static_cast<double>(17 * i));
  }
  return mesh;
}

/// x^2/1.96 + y^2 + z^2/0.36 - 1 by hand.
class EllipsoidFunction : public vtkJetFunction
{
public:
  static EllipsoidFunction* New();
  vtkTypeMacro(EllipsoidFunction, vtkJetFunction);

  void EvaluateJet(const double x[3], int order, double* coefficients) override
  {
    const double factors[] = { 1.0 / 1.96, 1.0, 1.0 / 0.36 };
    std::fill_n(coefficients, NumberOfCoefficients(order), 0.0);
    coefficients[0] = -1.0;
    for (int i = 0; i < 3; ++i)
    {
      coefficients[0] += factors[i] * x[i] * x[i];
      coefficients[1 + i] = 2.0 * factors[i] * x[i];
      if (order > 1)
      {
        coefficients[Index(2 * (i == 0), 2 * (i == 1), 2 * (i == 2))] = factors[i];
      }
    }
  }
};
vtkStandardNewMacro(EllipsoidFunction);

} // namespace

TEST(ImplicitMongeForm, MakesTheArraysOfTheFit)
{
  const auto mesh = ToPolyData(Displaced(EllipsoidMesh(12, 1.4, 1.0, 0.6), 0.01), VTK_FLOAT);
  const auto exact = Exact(mesh, Ellipsoid);
  const vtkIdType count = mesh->GetNumberOfPoints();
  vtkPointData* data = exact->GetPointData();
  for (const char* name : { names::MaximumCurvature, names::MinimumCurvature, names::P1, names::P2,
         names::FitScale, names::FitResidual, names::FitConditionNumber, names::FitNoiseGain })
  {
    ExpectArray(data, name, VTK_DOUBLE, 1, count);
  }
  ExpectArray(data, names::Normals, VTK_DOUBLE, 3, count);
  ExpectArray(data, names::MaximumDirection, VTK_DOUBLE, 3, count);
  ExpectArray(data, names::MinimumDirection, VTK_DOUBLE, 3, count);
  ExpectArray(data, names::ThirdOrder, VTK_DOUBLE, 4, count);
  ExpectArray(data, names::FourthOrder, VTK_DOUBLE, 5, count);
  ExpectArray(data, names::FitStatus, VTK_INT, 1, count);
  ExpectAllFinite(exact);
  EXPECT_EQ(exact->GetPoints()->GetDataType(), VTK_DOUBLE);
  const AnalyticSurface surface = MakeEllipsoid(1.4, 1.0, 0.6);
  for (vtkIdType p = 0; p < count; ++p)
  {
    const ExactMonge expected = surface.Monge(PointAt(exact, p));
    EXPECT_LT(std::abs(surface.Value(expected.origin)), 1e-15 * 10);
    EXPECT_EQ(Value(data, names::FitStatus, p), 0.0);
    EXPECT_LT((VectorAt(data, names::Normals, p) - expected.n).norm(), 1e-14);
    EXPECT_NEAR(Value(data, names::MaximumCurvature, p), expected.k1, 1e-12);
    EXPECT_NEAR(Value(data, names::MinimumCurvature, p), expected.k2, 1e-12);
  }
  // The input stays as it was.
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_FALSE(mesh->GetPointData()->HasArray(names::Normals));
}

TEST(ImplicitMongeForm, GivesTheRidgesAndUmbilicsOfTheBlend)
{
  vtkNew<vtkImplicitMongeForm> forms;
  forms->SetInputData(BlendData(32));
  forms->SetFormula(Blend);
  vtkNew<vtkUmbilicDetection> umbilics;
  umbilics->SetInputConnection(forms->GetOutputPort());
  vtkNew<vtkRidgeExtraction> ridges;
  ridges->SetInputConnection(umbilics->GetOutputPort());
  ridges->Update();
  vtkPolyData* found = umbilics->GetOutput(1);
  int positive = 0;
  for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
  {
    positive += Value(found->GetPointData(), names::Index, i) > 0.0 ? 1 : 0;
  }
  EXPECT_EQ(found->GetNumberOfPoints(), 8);
  EXPECT_EQ(positive, 6);
  EXPECT_GE(ridges->GetOutput()->GetNumberOfLines(), 20);
}

// The difference between fit and exact form is the error of the fit: it falls with the orders that
// the documentation states for the fit on an ellipsoid, less the scatter of a single step.
TEST(ImplicitMongeForm, FitsConvergeToIt)
{
  std::array<std::array<double, 2>, 2> errors{};
  for (int level = 0; level < 2; ++level)
  {
    const auto exact = Exact(EllipsoidData(16 << level), Ellipsoid);
    vtkNew<vtkJetFitting> jets;
    jets->SetInputData(exact);
    jets->Update();
    vtkPolyData* fitted = jets->GetOutput();
    const vtkIdType count = fitted->GetNumberOfPoints();
    for (vtkIdType p = 0; p < count; ++p)
    {
      const auto difference = [&exact, fitted, p](const char* name, int component)
      {
        return std::abs(std::abs(Value(fitted->GetPointData(), name, p, component)) -
          std::abs(Value(exact->GetPointData(), name, p, component)));
      };
      errors[level][0] += difference(names::MaximumCurvature, 0) / static_cast<double>(count);
      errors[level][1] += difference(names::ThirdOrder, 0) / static_cast<double>(count);
    }
  }
  EXPECT_GT(std::log2(errors[0][0] / errors[1][0]), 3.0);
  EXPECT_GT(std::log2(errors[0][1] / errors[1][1]), 1.8);
}

// Each connected part by itself: here one of two spheres is inside out.
TEST(ImplicitMongeForm, NormalsFollowTheOrientationOfEachPart)
{
  const Mesh outer = Icosphere(6);
  Mesh both = outer;
  const auto offset = static_cast<std::int32_t>(outer.PointCount());
  for (const double coordinate : outer.points)
  {
    both.points.push_back(0.5 * coordinate);
  }
  for (std::size_t i = 0; i < outer.triangles.size(); i += 3)
  {
    both.triangles.insert(both.triangles.end(),
      { outer.triangles[i] + offset, outer.triangles[i + 2] + offset,
        outer.triangles[i + 1] + offset });
  }
  // Negative between the spheres: its gradient points inward on the inner one.
  const auto exact = Exact(ToPolyData(both), "(x^2+y^2+z^2-1)*(x^2+y^2+z^2-0.25)");
  const auto reversed = Exact(ToPolyData(both), "(1-x^2-y^2-z^2)*(x^2+y^2+z^2-0.25)");
  for (const auto& result : { exact, reversed })
  {
    for (vtkIdType p = 0; p < result->GetNumberOfPoints(); ++p)
    {
      const bool isOuter = p < offset;
      EXPECT_NEAR(
        Value(result->GetPointData(), names::MaximumCurvature, p), isOuter ? -1.0 : 2.0, 1e-12);
      const double side =
        VectorAt(result->GetPointData(), names::Normals, p).dot(PointAt(result, p));
      EXPECT_EQ(side > 0.0, isOuter);
    }
  }
}

TEST(ImplicitMongeForm, TakesTheFormulaOfItsInput)
{
  const auto mesh = EllipsoidData(6);
  vtkNew<vtkStringArray> formula;
  formula->SetName(names::Formula);
  formula->InsertNextValue(Ellipsoid);
  mesh->GetFieldData()->AddArray(formula);
  EXPECT_EQ(FirstDifference(Exact(mesh, ""), Exact(mesh, Ellipsoid)), "");
}

TEST(ImplicitMongeForm, TakesAFunctionOfTheUser)
{
  vtkNew<EllipsoidFunction> function;
  vtkNew<vtkImplicitMongeForm> forms;
  const auto mesh = ToPolyData(Displaced(EllipsoidMesh(8, 1.4, 1.0, 0.6), 0.01));
  forms->SetInputData(mesh);
  forms->SetJetFunction(function);
  forms->Update();
  const auto expected = Exact(mesh, Ellipsoid);
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    for (const char* name : { names::MaximumCurvature, names::ThirdOrder, names::P1, names::P2 })
    {
      EXPECT_NEAR(Value(forms->GetOutput()->GetPointData(), name, p),
        Value(expected->GetPointData(), name, p), 1e-9)
        << name;
    }
  }
  const vtkMTimeType before = forms->GetMTime();
  function->Modified();
  EXPECT_GT(forms->GetMTime(), before);
}

TEST(ImplicitMongeForm, TakesGraphsAndParametricSurfaces)
{
  // Texture coordinates from 0 to 1 for u in (-1, 1) and v in (0, 2).
  Mesh patch = GraphPatch([](double, double) { return 0.0; }, 1.0, 10, 0.1);
  const auto mesh = ToPolyData(patch);
  AddPointArray(mesh, "parameters", 2,
    [&mesh](vtkIdType p, double* values)
    {
      values[0] = 0.5 + 0.5 * PointAt(mesh, p).x();
      values[1] = 0.5 + 0.5 * PointAt(mesh, p).y();
    });
  mesh->GetPointData()->SetActiveTCoords("parameters");
  vtkNew<vtkImplicitMongeForm> parametric;
  parametric->SetInputData(mesh);
  parametric->SetSurfaceTypeToParametric();
  parametric->SetXFormula("u");
  parametric->SetYFormula("v");
  parametric->SetZFormula("sin(u)*exp(v)/4");
  parametric->SetParameterRange(-1.0, 1.0, 0.0, 2.0);
  parametric->Update();
  vtkPolyData* surface = parametric->GetOutput();
  EXPECT_NEAR(surface->GetBounds()[3], 2.0, 1e-15);

  vtkNew<vtkImplicitMongeForm> graph;
  graph->SetInputData(surface);
  graph->SetSurfaceTypeToGraph();
  graph->SetFormula("sin(x)*exp(y)/4");
  graph->Update();
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    for (const char* name : { names::MaximumCurvature, names::MinimumCurvature, names::P1 })
    {
      const double expected = Value(surface->GetPointData(), name, p);
      EXPECT_NEAR(Value(graph->GetOutput()->GetPointData(), name, p), expected,
        1e-12 * (1.0 + std::abs(expected)))
        << name;
    }
  }
}

TEST(ImplicitMongeForm, CountsPointsWithoutAFormInOneWarning)
{
  const auto mesh = ToPolyData(EllipsoidMesh(8, 1.4, 1.0, 0.6));
  const double none = std::numeric_limits<double>::quiet_NaN();
  mesh->GetPoints()->SetPoint(5, none, 0.0, 0.0);
  vtkNew<vtkImplicitMongeForm> forms;
  const MessageRecorder messages(forms);
  forms->SetInputData(mesh);
  forms->SetFormula("x^2/1.96 + y^2 + z^2/0.36 - 1 + 0*sqrt(y+0.5)");
  forms->Update();
  ASSERT_EQ(messages.NumberOfWarnings(), 1u);
  EXPECT_EQ(messages.NumberOfErrors(), 0u);
  EXPECT_NE(messages.WarningText().find("of 642, where the surface or a derivative is not finite"),
    std::string::npos)
    << messages.WarningText();
  EXPECT_NE(messages.WarningText().find("in the formula at character 35, \"sqrt(y+0.5)\""),
    std::string::npos)
    << messages.WarningText();
  vtkPolyData* output = forms->GetOutput();
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    const bool isBad = p == 5 || PointAt(output, p).y() < -0.5;
    EXPECT_EQ(
      Value(output->GetPointData(), names::FitStatus, p), isBad ? vtkJetFitting::FIT_INVALID : 0);
    EXPECT_EQ(Value(output->GetPointData(), names::MaximumCurvature, p) == 0.0, isBad);
  }
}

TEST(ImplicitMongeForm, ErrorsAreOneLineThatShowsThePlace)
{
  const auto mesh = EllipsoidData(4);
  const auto errorOf = [&mesh](const char* formula)
  {
    vtkNew<vtkImplicitMongeForm> forms;
    const MessageRecorder messages(forms);
    forms->SetInputData(mesh);
    forms->SetFormula(formula);
    forms->Update();
    EXPECT_EQ(messages.NumberOfErrors(), 1u) << formula;
    EXPECT_EQ(messages.NumberOfWarnings(), 0u) << formula;
    EXPECT_TRUE(IsEmpty(forms->GetOutput())) << formula;
    return messages.ErrorText();
  };
  EXPECT_NE(errorOf("x^2 + abs(y)").find("at character 7, \"abs(y)\""), std::string::npos);
  EXPECT_NE(errorOf("").find("Formula: the formula is empty"), std::string::npos);
  // An empty zero set, a surface taken twice, and what is nowhere a number.
  EXPECT_NE(errorOf("x^2+y^2+z^2+1").find("162 of 162, where no point of the surface was found"),
    std::string::npos);
  EXPECT_NE(
    errorOf("(x^2/1.96+y^2+z^2/0.36-1)^2").find("162 of 162, where the surface has no normal"),
    std::string::npos);
  EXPECT_NE(errorOf("x + log(-1-x^2)").find("in the formula at character 5, \"log(-1-x^2)\""),
    std::string::npos);

  vtkNew<vtkImplicitMongeForm> forms;
  const MessageRecorder messages(forms);
  forms->SetInputData(mesh);
  forms->SetSurfaceTypeToParametric();
  forms->SetXFormula("u");
  forms->SetYFormula("v");
  forms->SetZFormula("u*w");
  forms->Update();
  EXPECT_NE(messages.ErrorText().find("ZFormula: unknown name"), std::string::npos);
  forms->SetZFormula("u*v");
  forms->Update();
  EXPECT_NE(messages.ErrorText().find("texture coordinates"), std::string::npos);
  EXPECT_EQ(messages.NumberOfErrors(), 2u);
}

TEST(ImplicitMongeForm, SameBytesForAnyThreadsAndNumbering)
{
  const Mesh mesh = Displaced(EllipsoidMesh(10, 1.4, 1.0, 0.6), 0.01);
  vtkSMPTools::Initialize(1);
  const auto one = Exact(ToPolyData(mesh), Ellipsoid);
  vtkSMPTools::Initialize(3);
  const auto three = Exact(ToPolyData(mesh), Ellipsoid);
  vtkSMPTools::Initialize();
  EXPECT_EQ(FirstDifference(one, three), "");
  std::vector<std::int32_t> newToOld;
  const auto permuted = Exact(ToPolyData(Permute(mesh, 4, &newToOld)), Ellipsoid);
  for (const char* name : { names::MaximumCurvature, names::ThirdOrder, names::FourthOrder })
  {
    vtkDataArray* expected = one->GetPointData()->GetArray(name);
    for (std::size_t p = 0; p < newToOld.size(); ++p)
    {
      for (int i = 0; i < expected->GetNumberOfComponents(); ++i)
      {
        ASSERT_EQ(Value(permuted->GetPointData(), name, static_cast<vtkIdType>(p), i),
          expected->GetComponent(newToOld[p], i));
      }
    }
  }
}

TEST(ImplicitMongeForm, NothingComesOfNothing)
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkImplicitMongeForm> forms;
  const MessageRecorder messages(forms);
  forms->SetInputData(empty);
  forms->SetFormula(Ellipsoid);
  forms->Update();
  EXPECT_EQ(messages.ErrorText(), "");
  EXPECT_TRUE(IsEmpty(forms->GetOutput()));
  std::ostringstream text;
  forms->Print(text);
  EXPECT_NE(text.str().find(Ellipsoid), std::string::npos);
}
