// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImageSurfaceMesh.h"

#include "FilterTestTools.h"
#include "ImageSamples.h"
#include "MessageRecorder.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace ridges::testing;

namespace
{

/// Its axes are turned against the coordinates, and its samples are not cubes.
void SetEllipsoid(vtkImageData* image, double factor = 1.0)
{
  image->SetExtent(3, 47, -20, 39, 0, 35);
  image->SetSpacing(0.06, 0.06, 0.05);
  SetOblique(image, 25, 9, 17);
  Sample(
    image, [factor](double x, double y, double z) { return factor * TurnedEllipsoid(x, y, z); });
}

constexpr double Sigma = 0.1;

void Prepare(vtkImageSurfaceMesh* source, vtkImageData* image, double value)
{
  source->SetInputData(image);
  source->SetSigma(Sigma);
  source->SetIsoValue(value);
}

} // namespace

// The smoothed image is the image and sigma^2 (1/1.96 + 1 + 1/0.36): what its isosurface encloses
// is known. Whether values grow or fall outward does not matter.
TEST(ImageSurfaceMesh, IsClosedEvenAndFacesOutward)
{
  const double constant = Sigma * Sigma * (1.0 / 1.96 + 1.0 + 1.0 / 0.36);
  for (const double factor : { 1.0, -3.0 })
  {
    vtkNew<vtkImageData> image;
    SetEllipsoid(image, factor);
    vtkNew<vtkImageSurfaceMesh> source;
    const MessageRecorder messages(source);
    Prepare(source, image, factor);
    source->Update();
    vtkPolyData* mesh = source->GetOutput();
    EXPECT_EQ(messages.NumberOfErrors() + messages.NumberOfWarnings(), 0u)
      << messages.WarningText();
    ASSERT_GT(mesh->GetNumberOfPoints(), 500);
    // Closed, of genus 0.
    EXPECT_EQ(mesh->GetNumberOfCells(), 2 * (mesh->GetNumberOfPoints() - 2));
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
      const Eigen::Vector3d x = PointAt(mesh, p);
      EXPECT_NEAR(TurnedEllipsoid(x[0], x[1], x[2]) + constant, 1.0, 1e-11);
    }
    // A polyhedron inside, whose volume differs by the square of its edges.
    const double exact = 4.0 / 3.0 * std::acos(-1.0) * 1.4 * 0.6 * std::pow(1.0 - constant, 1.5);
    EXPECT_NEAR(SignedVolume(ToMesh(mesh)), exact, 0.02 * exact);
    EXPECT_LT(SignedVolume(ToMesh(mesh)), exact);
    double lengths = 0.0;
    for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
    {
      vtkNew<vtkIdList> corners;
      mesh->GetCellPoints(t, corners);
      for (int i = 0; i < 3; ++i)
      {
        const double length =
          (PointAt(mesh, corners->GetId(i)) - PointAt(mesh, corners->GetId((i + 1) % 3))).norm();
        lengths += length;
        EXPECT_GT(length, 0.6 * 0.75 * Sigma);
        EXPECT_LT(length, 1.5 * 0.75 * Sigma);
      }
    }
    EXPECT_NEAR(lengths / (3.0 * mesh->GetNumberOfCells()), 0.75 * Sigma, 0.06 * 0.75 * Sigma);
  }
}

TEST(ImageSurfaceMesh, SaysWhereTheImageEnds)
{
  vtkNew<vtkImageData> image;
  SetEllipsoid(image);
  vtkNew<vtkImageSurfaceMesh> source;
  const MessageRecorder messages(source);
  Prepare(source, image, 2.0);
  source->Update();
  EXPECT_NE(messages.WarningText().find("The image ends before the surface"), std::string::npos)
    << messages.WarningText();
}

TEST(ImageSurfaceMesh, RefusesBadInputWithOneError)
{
  const auto errorOf = [](vtkImageData* image, double value)
  {
    vtkNew<vtkImageSurfaceMesh> source;
    const MessageRecorder messages(source);
    Prepare(source, image, value);
    source->Update();
    EXPECT_EQ(messages.NumberOfErrors(), 1u);
    EXPECT_TRUE(IsEmpty(source->GetOutput()));
    return messages.ErrorText();
  };
  vtkNew<vtkImageData> image;
  image->SetDimensions(10, 10, 10);
  EXPECT_NE(errorOf(image, 1.0).find("no scalars"), std::string::npos);
  SetEllipsoid(image);
  EXPECT_NE(errorOf(image, -5.0).find("The surface is empty: within the image the smoothed values"),
    std::string::npos)
    << errorOf(image, -5.0);
  EXPECT_NE(
    errorOf(image, std::numeric_limits<double>::quiet_NaN()).find("IsoValue"), std::string::npos);
  image->GetPointData()->GetScalars()->SetComponent(
    40000, 0, std::numeric_limits<double>::quiet_NaN());
  EXPECT_NE(errorOf(image, 1.0).find("values that are not finite"), std::string::npos);
}

TEST(ImageSurfaceMesh, SameBytesForAnyThreads)
{
  vtkNew<vtkImageData> image;
  SetEllipsoid(image);
  const auto make = [&image](int threads)
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkImageSurfaceMesh> source;
    Prepare(source, image, 1.0);
    source->Update();
    vtkSMPTools::Initialize();
    return vtkSmartPointer<vtkPolyData>(source->GetOutput());
  };
  EXPECT_EQ(FirstDifference(make(1), make(3)), "");
}
