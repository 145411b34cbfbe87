# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces given by a formula, through Python."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkCommonCore import vtkCommand
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource

from vtkridges import (
    vtkCertifiedRidges,
    vtkCompliantRefinement,
    vtkImageMongeForm,
    vtkImplicitMongeForm,
    vtkImplicitSurfaceMesh,
    vtkRidgeExampleSource,
    vtkRidgeExtraction,
    vtkUmbilicDetection,
)

ELLIPSOID = "x^2/1.96 + y^2 + z^2/0.36 - 1"


def ellipsoid_forms(formula=ELLIPSOID):
    source = vtkRidgeExampleSource()
    source.SetSurfaceToEllipsoid()
    source.SetFrequency(16)
    forms = vtkImplicitMongeForm()
    forms.SetInputConnection(source.GetOutputPort())
    forms.SetFormula(formula)
    return forms


def array(forms, name):
    return vtk_to_numpy(forms.GetOutput().GetPointData().GetArray(name))


def verdicts(table):
    rows = range(table.GetNumberOfRows())
    return {
        table.GetValueByName(row, "Check").ToString(): table.GetValueByName(row, "Verdict").ToString()
        for row in rows
    }


class TestCertificates(unittest.TestCase):
    def certified(self, cls, frequency):
        source = vtkRidgeExampleSource()
        source.SetSurfaceToEllipsoid()
        source.SetFrequency(frequency)
        certified = cls()
        certified.SetInputConnection(source.GetOutputPort())
        axes = source.GetSemiAxes()
        terms = (f"({x}/{axis!r})^2" for x, axis in zip("xyz", axes))
        certified.SetFormula(" + ".join(terms) + " - 1")
        certified.Update()
        return certified

    def test_an_ellipsoid_is_proved(self):
        certified = self.certified(vtkCertifiedRidges, 6)
        self.assertEqual(set(verdicts(certified.GetOutputDataObject(4)).values()), {"proved"})
        self.assertEqual(certified.GetOutput(1).GetNumberOfPoints(), 4)

    def test_refinement_marks_the_mesh(self):
        refinement = self.certified(vtkCompliantRefinement, 4)
        self.assertEqual(set(verdicts(refinement.GetOutputDataObject(1)).values()), {"proved"})
        ridges = vtkRidgeExtraction()
        ridges.SetInputConnection(refinement.GetOutputPort())
        ridges.Update()
        cells = refinement.GetOutput().GetCellData()
        self.assertEqual(set(vtk_to_numpy(cells.GetArray("Certificate"))), {2})
        self.assertGreaterEqual(ridges.GetOutput().GetNumberOfLines(), 6)


class TestFormulas(unittest.TestCase):
    def test_umbilics_of_an_ellipsoid(self):
        forms = ellipsoid_forms()
        umbilics = vtkUmbilicDetection()
        umbilics.SetInputConnection(forms.GetOutputPort())
        ridges = vtkRidgeExtraction()
        ridges.SetInputConnection(umbilics.GetOutputPort())
        ridges.Update()
        self.assertEqual(umbilics.GetOutput(1).GetNumberOfPoints(), 4)
        self.assertGreaterEqual(ridges.GetOutput().GetNumberOfLines(), 6)
        self.assertEqual(set(array(forms, "FitStatus")), {0})

    def test_gaussian_curvature_of_an_ellipsoid(self):
        forms = ellipsoid_forms()
        forms.Update()
        points = vtk_to_numpy(forms.GetOutput().GetPoints().GetData())
        squares = np.array([1.96, 1.0, 0.36])
        expected = 1 / (squares.prod() * np.sum(points**2 / squares**2, axis=1) ** 2)
        found = array(forms, "MaximumCurvature") * array(forms, "MinimumCurvature")
        np.testing.assert_allclose(found, expected, rtol=1e-12)

    def test_mesh_of_a_parametric_function(self):
        torus = vtkParametricTorus()
        source = vtkParametricFunctionSource()
        source.SetParametricFunction(torus)
        source.GenerateTextureCoordinatesOn()
        forms = vtkImplicitMongeForm()
        forms.SetInputConnection(source.GetOutputPort())
        forms.SetSurfaceTypeToParametric()
        forms.SetXFormula("(1 + 0.5*cos(v))*sin(u)")
        forms.SetYFormula("(1 + 0.5*cos(v))*cos(u)")
        forms.SetZFormula("0.5*sin(v)")
        forms.SetParameterRange(0, 2 * np.pi, 2 * np.pi, 0)
        forms.Update()
        before = vtk_to_numpy(source.GetOutput().GetPoints().GetData())
        after = vtk_to_numpy(forms.GetOutput().GetPoints().GetData())
        self.assertLess(np.abs(after - before).max(), 1e-6)  # in single precision before
        # The tube bends most, whichever way its normal points.
        curvatures = np.abs([array(forms, "MaximumCurvature"), array(forms, "MinimumCurvature")])
        np.testing.assert_allclose(curvatures.max(axis=0), 2.0, rtol=1e-12)

    def test_mesh_of_a_formula(self):
        mesh = vtkImplicitSurfaceMesh()
        mesh.SetFormula(ELLIPSOID)
        mesh.SetBounds(-1.5, 1.5, -1.1, 1.1, -0.7, 0.7)
        mesh.SetEdgeLength(0.1)
        forms = vtkImplicitMongeForm()  # takes the formula from the mesh
        forms.SetInputConnection(mesh.GetOutputPort())
        umbilics = vtkUmbilicDetection()
        umbilics.SetInputConnection(forms.GetOutputPort())
        umbilics.Update()
        self.assertEqual(umbilics.GetOutput(1).GetNumberOfPoints(), 4)

    def test_isosurface_of_an_image(self):
        image = vtkImageData()
        image.SetDimensions(40, 40, 40)
        image.SetOrigin(-1.5, -1.5, -1.5)
        image.SetSpacing(3 / 39, 3 / 39, 3 / 39)
        axis = np.linspace(-1.5, 1.5, 40)
        z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
        scalars = numpy_to_vtk((x**2 + y**2 + z**2).ravel(), deep=True)
        image.GetPointData().SetScalars(scalars)
        mesh = vtkFlyingEdges3D()
        mesh.SetInputData(image)
        mesh.SetValue(0, 1.0)
        forms = vtkImageMongeForm()
        forms.SetInputConnection(0, mesh.GetOutputPort())
        forms.SetInputData(1, image)
        forms.SetIsoValue(1.0)
        forms.SetSigma(0.1)
        forms.Update()
        # Smoothing adds three times the variance to the squared distance. Which of the two the
        # curvature is depends on the orientation of the mesh.
        expected = 1 / np.sqrt(1 - 3 * 0.1**2)
        curvature = np.abs(array(forms, "MaximumCurvature"))
        np.testing.assert_allclose(curvature, expected, rtol=1e-9)

    def test_errors_show_the_place(self):
        messages = []
        forms = ellipsoid_forms("x^2 + foo(y)")

        def record(caller, event, text):
            messages.append(text)

        record.CallDataType = "string0"
        forms.AddObserver(vtkCommand.ErrorEvent, record)
        forms.GetExecutive().AddObserver(vtkCommand.ErrorEvent, lambda *_: None)
        forms.Update()
        self.assertEqual(len(messages), 1)
        self.assertIn('at character 7, "foo(y)"', messages[0])


if __name__ == "__main__":
    unittest.main()
