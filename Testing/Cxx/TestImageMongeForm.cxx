// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImageMongeForm.h"

#include "FilterTestTools.h"
#include "ImageSamples.h"
#include "MessageRecorder.h"
#include "vtkImageSurfaceMesh.h"
#include "vtkImplicitMongeForm.h"
#include "vtkImplicitSurfaceMesh.h"
#include "vtkJetFitting.h"
#include "vtkRidgeExtraction.h"
#include "vtkRidgesArrayNames.h"
#include "vtkUmbilicDetection.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>

using namespace ridges::testing;
namespace names = vtkRidgesArrayNames;

namespace
{

vtkSmartPointer<vtkPolyData> FromImage(
  vtkPolyData* mesh, vtkImageData* image, double sigma, double value = 0.0)
{
  vtkNew<vtkImageMongeForm> forms;
  forms->SetInputData(0, mesh);
  forms->SetInputData(1, image);
  forms->SetSigma(sigma);
  forms->SetIsoValue(value);
  forms->Update();
  return forms->GetOutput();
}

vtkSmartPointer<vtkPolyData> FromFormula(vtkPolyData* mesh, const std::string& formula)
{
  vtkNew<vtkImplicitMongeForm> forms;
  forms->SetInputData(mesh);
  forms->SetFormula(formula.c_str());
  forms->Update();
  return forms->GetOutput();
}

/// The greatest difference of the lengths of a tuple's components, relative to the greatest value.
double LargestDifference(vtkPolyData* a, vtkPolyData* b, const char* name)
{
  vtkDataArray* left = a->GetPointData()->GetArray(name);
  vtkDataArray* right = b->GetPointData()->GetArray(name);
  double difference = 0.0;
  double greatest = 0.0;
  for (vtkIdType p = 0; p < left->GetNumberOfTuples(); ++p)
  {
    for (int i = 0; i < left->GetNumberOfComponents(); ++i)
    {
      // The signs of b depend on the direction.
      const double l = std::abs(left->GetComponent(p, i));
      const double r = std::abs(right->GetComponent(p, i));
      difference = std::max(difference, std::abs(l - r));
      greatest = std::max(greatest, r);
    }
  }
  return difference / greatest;
}

/// Of TurnedEllipsoid, with sigma^2 (1/1.96 + 1 + 1/0.36) more: the image smoothed, less a value.
std::string EllipsoidFormula(double sigma, double value)
{
  std::ostringstream text;
  text.precision(17);
  text << "(0.8*x+0.6*y)^2/1.96 + (0.8*y-0.6*x)^2 + z^2/0.36 + "
       << sigma * sigma * (1.0 / 1.96 + 1.0 + 1.0 / 0.36) - value;
  return text.str();
}

vtkSmartPointer<vtkPolyData> EllipsoidMeshOfImage()
{
  vtkNew<vtkImplicitSurfaceMesh> source;
  source->SetFormula(EllipsoidFormula(0.0, 1.0).c_str());
  source->SetBounds(-1.3, 1.3, -1.3, 1.3, -0.7, 0.7);
  source->SetEdgeLength(0.1);
  source->Update();
  return source->GetOutput();
}

/// Axes turned against the coordinates, unequal spacing, an extent that does not begin at 0.
void SetGrid(vtkImageData* image)
{
  image->SetExtent(3, 52, -20, 19, 0, 27);
  image->SetSpacing(0.06, 0.08, 0.06);
  SetOblique(image, 27, 0, 14);
}

constexpr double A[3] = { 0.15, 0.25, 0.35 };
constexpr double B[3] = { 0.1, 0.2, 0.3 };
constexpr double CenterOfB[3] = { 0.25, 0.1, 0.1 };

double Blend(double x, double y, double z)
{
  const double at[3] = { x, y, z };
  double a = -1.0;
  double b = -1.0;
  for (int i = 0; i < 3; ++i)
  {
    a += std::pow(at[i] / A[i], 2);
    b += std::pow((at[i] - CenterOfB[i]) / B[i], 2);
  }
  return 1.0 - std::exp(-0.7 * a) - std::exp(-0.7 * b);
}

/// Each Gaussian becomes a wider and lower one.
std::string SmoothedBlend(double sigma)
{
  std::ostringstream text;
  text.precision(17);
  text << "1";
  for (const auto& [axes, center] : { std::make_pair(A, std::array<double, 3>{ 0.0, 0.0, 0.0 }),
         std::make_pair(B, std::array<double, 3>{ CenterOfB[0], CenterOfB[1], CenterOfB[2] }) })
  {
    double height = std::exp(0.7);
    std::ostringstream exponent;
    exponent.precision(17);
    for (int i = 0; i < 3; ++i)
    {
      const double square = axes[i] * axes[i] + 1.4 * sigma * sigma;
      height *= axes[i] / std::sqrt(square);
      exponent << (i > 0 ? "+" : "") << "("
               << "xyz"[i] << "-" << center[i] << ")^2/" << square;
    }
    text << " - " << height << "*exp(-0.7*(" << exponent.str() << "))";
  }
  return text.str();
}

struct MeanSquare
{
  double sum = 0.0;
  int count = 0;

  double Root() const { return std::sqrt(this->sum / this->count); }
};

/// The differences of what was found over its standard errors, where directions are certain.
void AddErrorRatios(
  vtkPolyData* found, vtkPolyData* expected, std::map<std::string, MeanSquare>& ratios)
{
  const std::pair<const char*, const char*> pairs[] = { { names::MaximumCurvature,
                                                          names::MaximumCurvatureError },
    { names::MinimumCurvature, names::MinimumCurvatureError },
    { names::ThirdOrder, names::ThirdOrderError }, { names::P1, names::P1Error },
    { names::P2, names::P2Error } };
  vtkPointData* left = found->GetPointData();
  vtkPointData* right = expected->GetPointData();
  for (vtkIdType p = 0; p < found->GetNumberOfPoints(); ++p)
  {
    const double gap =
      Value(right, names::MaximumCurvature, p) - Value(right, names::MinimumCurvature, p);
    if (gap < 10.0 * Value(left, names::MaximumCurvatureError, p))
    {
      continue;
    }
    const double* l = left->GetArray(names::MaximumDirection)->GetTuple3(p);
    const Eigen::Vector3d direction(l[0], l[1], l[2]);
    const double* r = right->GetArray(names::MaximumDirection)->GetTuple3(p);
    const double side = direction.dot(Eigen::Vector3d(r[0], r[1], r[2])) > 0.0 ? 1.0 : -1.0;
    for (const auto& [name, error] : pairs)
    {
      const int last = left->GetArray(name)->GetNumberOfComponents() - 1;
      for (const int i : { 0, last })
      {
        const double sign = last > 0 ? side : 1.0;
        const double ratio = (left->GetArray(name)->GetComponent(p, i) -
                               sign * right->GetArray(name)->GetComponent(p, i)) /
          left->GetArray(error)->GetComponent(p, i);
        MeanSquare& mean = ratios[name + std::to_string(i)];
        mean.sum += ratio * ratio;
        ++mean.count;
      }
    }
  }
}

std::size_t NumberOfRidges(vtkPolyData* lines)
{
  std::set<double> ids;
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    ids.insert(Value(lines->GetCellData(), names::RidgeId, line));
  }
  return ids.size();
}

/// Of a smooth step across the surface, from 1 inside to 0 outside.
vtkSmartPointer<vtkImageData> NoisyEllipsoid(double noise)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(144, 112, 80);
  image->SetOrigin(-71.5, -55.5, -39.5);
  std::mt19937 generator(1);
  std::normal_distribution<double> normal(0.0, noise);
  Sample(image,
    [&generator, &normal](double x, double y, double z)
    {
      const double f = std::sqrt(x * x / 3136.0 + y * y / 1600.0 + z * z / 576.0);
      return 1.0 / (1.0 + std::exp(32.0 * (f - 1.0))) + normal(generator);
    });
  return image;
}

double SigmaOf(vtkPolyData* mesh)
{
  return mesh->GetFieldData()->GetArray(names::ImageSigma)->GetComponent(0, 0);
}

} // namespace

// A quadratic image is smoothed to itself and a constant: the filter has to agree to round-off, at
// the border of the image, too.
TEST(ImageMongeForm, IsExactForAnEllipsoid)
{
  vtkNew<vtkImageData> image;
  SetGrid(image);
  Sample(image, TurnedEllipsoid);
  const auto mesh = EllipsoidMeshOfImage();
  const auto found = FromImage(mesh, image, 0.1, 1.0);
  const auto expected = FromFormula(mesh, EllipsoidFormula(0.1, 1.0));
  ASSERT_GT(found->GetNumberOfPoints(), 1000);
  ExpectAllFinite(found);
  int atBorder = 0;
  for (vtkIdType p = 0; p < found->GetNumberOfPoints(); ++p)
  {
    EXPECT_LT((PointAt(found, p) - PointAt(expected, p)).norm(), 1e-12);
    atBorder += Value(found->GetPointData(), names::FitStatus, p) == vtkJetFitting::FIT_BOUNDARY;
  }
  EXPECT_GT(atBorder, 10);
  EXPECT_LT(LargestDifference(found, expected, names::MaximumCurvature), 1e-10);
  EXPECT_LT(LargestDifference(found, expected, names::MinimumCurvature), 1e-10);
  EXPECT_LT(LargestDifference(found, expected, names::ThirdOrder), 1e-7);
}

// What noise does, over the standard errors: 1 in the root mean square. An image has about 40
// places that know nothing of each other, so that of four images is within 12 % (two standard
// deviations); the errors are of first order, too.
TEST(ImageMongeForm, StandardErrorsAreThoseOfNoise)
{
  const double noise = 0.02;
  const double sigma = 0.2; // more than three samples
  const auto mesh = EllipsoidMeshOfImage();
  const auto expected = FromFormula(mesh, EllipsoidFormula(sigma, 1.0));
  std::map<std::string, MeanSquare> ratios;
  for (unsigned seed = 1; seed <= 4; ++seed)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(60, 60, 50);
    image->SetOrigin(-1.65, -1.65, -1.35);
    image->SetSpacing(0.055, 0.055, 0.055);
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal(0.0, noise);
    Sample(image,
      [&generator, &normal](double x, double y, double z)
      { return TurnedEllipsoid(x, y, z) + normal(generator); });
    const auto found = FromImage(mesh, image, sigma, 1.0);
    EXPECT_NEAR(
      found->GetFieldData()->GetArray(names::ImageNoise)->GetComponent(0, 0), noise, 0.05 * noise);
    AddErrorRatios(found, expected, ratios);
  }
  for (const auto& [name, ratio] : ratios)
  {
    EXPECT_GT(ratio.count, 2000) << name;
    EXPECT_NEAR(ratio.Root(), 1.0, 0.2) << name;
  }
}

// Noise of 5 % of the contrast.
TEST(ImageMongeForm, RidgesOfANoisyImageAreThoseOfTheSurface)
{
  const auto image = NoisyEllipsoid(0.05);
  vtkNew<vtkImageSurfaceMesh> source;
  source->SetInputData(image);
  source->SetIsoValue(0.5);
  source->SetSigma(4.5);
  source->Update();
  vtkNew<vtkUmbilicDetection> umbilics;
  umbilics->SetInputData(FromImage(source->GetOutput(), image, 4.5, 0.5));
  vtkNew<vtkRidgeExtraction> ridges;
  ridges->SetInputConnection(umbilics->GetOutputPort());
  ridges->Update();
  EXPECT_EQ(umbilics->GetOutput(1)->GetNumberOfPoints(), 4);
  EXPECT_EQ(NumberOfRidges(ridges->GetOutput()), 6u);
  ridges->SetLoopSignificance(0.0); // all that noise makes
  ridges->Update();
  EXPECT_GT(NumberOfRidges(ridges->GetOutput()), 8u);
}

TEST(ImageMongeForm, ChoosesSigmaByTheNoise)
{
  const auto image = NoisyEllipsoid(0.05);
  vtkNew<vtkImageSurfaceMesh> source;
  source->SetInputData(image);
  source->SetIsoValue(0.5);
  vtkNew<vtkImageMongeForm> forms;
  forms->SetInputConnection(0, source->GetOutputPort());
  forms->SetInputData(1, image);
  forms->SetIsoValue(0.5);
  vtkNew<vtkUmbilicDetection> umbilics;
  umbilics->SetInputConnection(forms->GetOutputPort());
  vtkNew<vtkRidgeExtraction> ridges;
  ridges->SetInputConnection(umbilics->GetOutputPort());
  ridges->Update();
  EXPECT_EQ(umbilics->GetOutput(1)->GetNumberOfPoints(), 4);
  EXPECT_EQ(NumberOfRidges(ridges->GetOutput()), 6u);

  // The mesh says it; without that, it is chosen again, and the same.
  const double sigma = SigmaOf(forms->GetOutput());
  EXPECT_NEAR(sigma, 4.25, 0.75);
  EXPECT_EQ(SigmaOf(source->GetOutput()), sigma);
  source->SetSigma(sigma);
  source->SetEdgeLength(15.0); // a few points will do
  source->Update();
  vtkNew<vtkPolyData> bare;
  bare->CopyStructure(source->GetOutput());
  EXPECT_EQ(SigmaOf(FromImage(bare, image, 0.0, 0.5)), sigma);

  // Less noise needs less, and hardly any at all leaves one and a half samples.
  EXPECT_LT(SigmaOf(FromImage(bare, NoisyEllipsoid(0.01), 0.0, 0.5)), 0.75 * sigma);
  EXPECT_EQ(SigmaOf(FromImage(bare, NoisyEllipsoid(1e-4), 0.0, 0.5)), 1.5);
}

// The fineness of the samples hardly matters: the error is that of the sums' ends.
TEST(ImageMongeForm, GivesTheUmbilicsOfTheBlend)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 64, 64);
  image->SetOrigin(-0.35, -0.4, -0.5);
  image->SetSpacing(0.9 / 63, 0.9 / 63, 1.1 / 63);
  Sample(image, Blend);
  const double sigma = 0.02;
  vtkNew<vtkImplicitSurfaceMesh> source;
  source->SetEdgeLength(0.02);
  source->Update();
  const auto found = FromImage(source->GetOutput(), image, sigma);
  const auto expected = FromFormula(source->GetOutput(), SmoothedBlend(sigma));
  EXPECT_LT(LargestDifference(found, expected, names::MaximumCurvature), 1e-5);
  EXPECT_LT(LargestDifference(found, expected, names::MinimumCurvature), 1e-5);
  EXPECT_LT(LargestDifference(found, expected, names::ThirdOrder), 1e-4);
  EXPECT_LT(LargestDifference(found, expected, names::P1), 1e-3);
  for (const auto& mesh : { found, expected })
  {
    vtkNew<vtkUmbilicDetection> umbilics;
    umbilics->SetInputData(mesh);
    umbilics->Update();
    EXPECT_EQ(umbilics->GetOutput(1)->GetNumberOfPoints(), 8);
  }
}

TEST(ImageMongeForm, TakesAnyScalarsAndFlagsPointsOutside)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(30, 30, 30);
  image->SetOrigin(-1.5, -1.5, -1.5);
  image->SetSpacing(0.1, 0.1, 0.1);
  Sample(image, [](double x, double y, double z) { return x * x + y * y + z * z; });
  vtkNew<vtkFloatArray> scalars; // the first of two components
  scalars->SetNumberOfComponents(2);
  scalars->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    scalars->SetTuple2(i, image->GetPointData()->GetScalars()->GetTuple1(i), -7.0);
  }
  image->GetPointData()->SetScalars(scalars);
  const auto mesh = ToPolyData(Icosphere(8));
  mesh->GetPoints()->SetPoint(3, 50.0, 0.0, 0.0);
  vtkNew<vtkImageMongeForm> forms;
  const MessageRecorder messages(forms);
  forms->SetInputData(0, mesh);
  forms->SetInputData(1, image);
  forms->SetIsoValue(1.0);
  forms->Update();
  EXPECT_EQ(messages.NumberOfWarnings(), 1u);
  EXPECT_NE(
    messages.WarningText().find("1 of 642, where the surface or a derivative is not finite"),
    std::string::npos)
    << messages.WarningText();
  const double radius = std::sqrt(1.0 - 3.0 * 0.15 * 0.15); // sigma is 1.5 samples
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    const double k = Value(forms->GetOutput()->GetPointData(), names::MinimumCurvature, p);
    EXPECT_NEAR(k, p == 3 ? 0.0 : -1.0 / radius, 1e-5); // samples are of single precision
  }
}

TEST(ImageMongeForm, RefusesBadInputWithOneError)
{
  const auto mesh = ToPolyData(Icosphere(4));
  const auto errorOf = [&mesh](vtkImageData* image, double sigma)
  {
    vtkNew<vtkImageMongeForm> forms;
    const MessageRecorder messages(forms);
    forms->SetInputData(0, mesh);
    forms->SetInputData(1, image);
    forms->SetSigma(sigma);
    forms->Update();
    EXPECT_EQ(messages.NumberOfErrors(), 1u);
    EXPECT_TRUE(IsEmpty(forms->GetOutput()));
    return messages.ErrorText();
  };
  vtkNew<vtkImageData> image;
  image->SetDimensions(10, 10, 10);
  EXPECT_NE(errorOf(image, 1.0).find("no scalars"), std::string::npos);
  Sample(image, [](double x, double, double) { return x - 4.5; });
  EXPECT_NE(
    errorOf(image, std::numeric_limits<double>::quiet_NaN()).find("Sigma"), std::string::npos);
  image->SetSpacing(1.0, 0.0, 1.0);
  EXPECT_NE(errorOf(image, 1.0).find("spacing"), std::string::npos);
  vtkNew<vtkImageData> flat;
  flat->SetDimensions(10, 10, 1);
  Sample(flat, [](double x, double, double) { return x - 4.5; });
  EXPECT_NE(errorOf(flat, 1.0).find("fewer than five samples"), std::string::npos);
  // The value is nowhere in the image.
  vtkNew<vtkImageData> positive;
  positive->SetDimensions(10, 10, 10);
  Sample(positive, [](double x, double, double) { return 1.0 + x * x; });
  EXPECT_NE(errorOf(positive, 1.0).find("No point has a Monge form"), std::string::npos);
}

TEST(ImageMongeForm, SameBytesForAnyThreads)
{
  vtkNew<vtkImageData> image;
  SetGrid(image);
  Sample(image, TurnedEllipsoid);
  const auto mesh = EllipsoidData(4);
  vtkSMPTools::Initialize(1);
  const auto one = FromImage(mesh, image, 0.1, 1.0);
  vtkSMPTools::Initialize(3);
  const auto three = FromImage(mesh, image, 0.1, 1.0);
  vtkSMPTools::Initialize();
  EXPECT_EQ(FirstDifference(one, three), "");
}
