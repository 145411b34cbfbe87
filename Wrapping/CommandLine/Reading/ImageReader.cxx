// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/ImageReader.h"

#include "Console.h"
#include "Reading/FileBytes.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataReader.h"

namespace program
{
namespace
{

/// A reader that says that it can; null if there is none.
vtkSmartPointer<vtkImageReader2> FindReader(const std::string& fileName)
{
  const auto nrrd = vtkSmartPointer<vtkNrrdReader>::New();
  if (nrrd->CanReadFile(fileName.c_str()) != 0)
  {
    return nrrd;
  }
  const auto nifti = vtkSmartPointer<vtkNIFTIImageReader>::New();
  if (nifti->CanReadFile(fileName.c_str()) != 0)
  {
    return nifti;
  }
  return vtk::TakeSmartPointer(vtkImageReader2Factory::CreateImageReader2(fileName.c_str()));
}

} // namespace

vtkSmartPointer<vtkImageData> ReadImage(const std::string& fileName)
{
  CheckIsFile(fileName, "give an image");
  vtkSmartPointer<vtkImageData> image;
  vtkNew<vtkXMLImageDataReader> xml;
  if (xml->CanReadFile(fileName.c_str()) != 0)
  {
    xml->SetFileName(fileName.c_str());
    xml->Update();
    image = xml->GetOutput();
  }
  else if (const vtkSmartPointer<vtkImageReader2> reader = FindReader(fileName))
  {
    reader->SetFileName(fileName.c_str());
    reader->Update();
    image = reader->GetOutput();
  }
  else
  {
    throw Failure(
      fileName + " is not an image that VTK can read", "give a .vti, .mha, .nrrd or .nii file");
  }
  if (!image->GetPointData()->GetScalars() && image->GetPointData()->GetNumberOfArrays() > 0)
  {
    image->GetPointData()->SetActiveScalars(image->GetPointData()->GetArrayName(0));
  }
  const vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfTuples() == 0)
  {
    throw Failure(fileName + " has no values at its samples", "give an image with point data");
  }
  return image;
}

} // namespace program
