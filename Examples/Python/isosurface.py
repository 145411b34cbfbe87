# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Ridges and umbilics of an isosurface, from the derivatives of the smoothed image:

    python3 isosurface.py [image.vti isovalue [sigma]]

Writes ridges.vtp and umbilics.vtp. Without arguments it makes an image of an ellipsoid, with noise of
5 % of the contrast. Sigma is the deviation of the Gaussian that smooths the image, in the unit of the
spacing; without it, it is what the noise of the image needs.
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataWriter

import vtkridges


def noisy_ellipsoid(samples=96):
    """An image that falls from 1 inside to 0 outside, within about two samples."""
    side = np.arange(samples) - 0.5 * (samples - 1)
    z, y, x = np.meshgrid(side, side, side, indexing="ij")
    axes = samples * np.array([0.44, 0.31, 0.19])
    level = np.sqrt((x / axes[0]) ** 2 + (y / axes[1]) ** 2 + (z / axes[2]) ** 2)
    values = 0.5 - 0.5 * np.tanh((level - 1.0) * axes[2])
    values += np.random.default_rng(1).normal(scale=0.05, size=values.shape)
    image = vtkImageData()
    image.SetDimensions(samples, samples, samples)
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
    producer = vtkTrivialProducer()
    producer.SetOutput(image)
    return producer


sigma = 0.0  # what the noise needs
if len(sys.argv) in (3, 4):
    image = vtkXMLImageDataReader()
    image.SetFileName(sys.argv[1])
    isovalue, sigma = (float(text) for text in [*sys.argv[2:], "0"][:2])
elif len(sys.argv) == 1:
    image, isovalue = noisy_ellipsoid(), 0.5
else:
    sys.exit(__doc__)

mesh = vtkridges.vtkImageSurfaceMesh()
mesh.SetInputConnection(image.GetOutputPort())
forms = vtkridges.vtkImageMongeForm()  # in place of vtkJetFitting
forms.SetInputConnection(0, mesh.GetOutputPort())
forms.SetInputConnection(1, image.GetOutputPort())
for stage in (mesh, forms):
    stage.SetIsoValue(isovalue)
    stage.SetSigma(sigma)
umbilics = vtkridges.vtkUmbilicDetection()
umbilics.SetInputConnection(forms.GetOutputPort())
ridges = vtkridges.vtkRidgeExtraction()
ridges.SetInputConnection(umbilics.GetOutputPort())

ridges.Update()
if mesh.GetOutput().GetNumberOfPoints() == 0:
    sys.exit("there is no isosurface")

outputs = {"ridges.vtp": ridges.GetOutputPort(), "umbilics.vtp": umbilics.GetOutputPort(1)}
for name, port in outputs.items():
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(name)
    writer.SetInputConnection(port)
    if not writer.Write():
        sys.exit(f"cannot write {name}")

print(mesh.GetOutput().GetNumberOfPoints(), "points")
for name in ("ImageNoise", "ImageSigma"):
    print(name, forms.GetOutput().GetFieldData().GetArray(name).GetValue(0))
print(umbilics.GetOutput(1).GetNumberOfPoints(), "umbilics")
print(ridges.GetOutput().GetNumberOfLines(), "lines")
