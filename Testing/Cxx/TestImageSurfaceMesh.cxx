// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImageSurfaceMesh.h"

#include "FilterTestTools.h"
#include "MessageRecorder.h"

#include "vtkDoubleArray.h"
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

/// x^2/1.96 + y^2 + z^2/0.36 in a frame turned about z.
double Ellipsoid(const double x[3])
{
  const double u = 0.8 * x[0] + 0.6 * x[1];
  const double v = -0.6 * x[0] + 0.8 * x[1];
  return u * u / 1.96 + v * v + x[2] * x[2] / 0.36;
}

/// Its axes are turned against the coordinates, and its samples are not cubes.
void SetEllipsoid(vtkImageData* image, double factor = 1.0)
{
  image->SetExtent(3, 47, -20, 39, 0, 35);
  image->SetSpacing(0.06, 0.06, 0.05);
  image->SetDirectionMatrix(0.6, 0.8, 0.0, -0.8, 0.6, 0.0, 0.0, 0.0, 1.0);
  double center[3];
  image->TransformIndexToPhysicalPoint(25, 9, 17, center);
  image->SetOrigin(-center[0], -center[1], -center[2]);
  vtkNew<vtkDoubleArray> scalars;
  const int* extent = image->GetExtent();
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        double x[3];
        image->TransformIndexToPhysicalPoint(i, j, k, x);
        scalars->InsertNextValue(factor * Ellipsoid(x));
      }
    }
  }
  image->GetPointData()->SetScalars(scalars);
}

constexpr double Sigma = 0.1;

void Prepare(vtkImageSurfaceMesh* source, vtkImageData* image, double value)
{
  source->SetInputData(image);
  source->SetSigma(Sigma);
  source->SetIsoValue(value);
}

double Volume(vtkPolyData* mesh)
{
  double volume = 0.0;
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    vtkNew<vtkIdList> corners;
    mesh->GetCellPoints(t, corners);
    volume += PointAt(mesh, corners->GetId(0))
                .cross(PointAt(mesh, corners->GetId(1)))
                .dot(PointAt(mesh, corners->GetId(2)));
  }
  return volume / 6.0;
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
      EXPECT_NEAR(Ellipsoid(PointAt(mesh, p).data()) + constant, 1.0, 1e-11);
    }
    // A polyhedron inside, whose volume differs by the square of its edges.
    const double exact = 4.0 / 3.0 * std::acos(-1.0) * 1.4 * 0.6 * std::pow(1.0 - constant, 1.5);
    EXPECT_NEAR(Volume(mesh), exact, 0.02 * exact);
    EXPECT_LT(Volume(mesh), exact);
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
