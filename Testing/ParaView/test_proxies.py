# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every proxy of the plugin in ParaView: results, properties, messages."""

import os
import tempfile
import unittest

import numpy as np
from paraview import simple
from ridges_paraview import PROXIES, Messages, arrays, delete_all, fetch, load_plugin


def setUpModule():
    load_plugin()


def example(frequency=16):
    return simple.RidgeExampleSource(Frequency=frequency)


def write_obj(path, mesh):
    with open(path, "w", encoding="ascii") as file:
        for i in range(mesh.GetNumberOfPoints()):
            file.write("v {} {} {}\n".format(*mesh.GetPoint(i)))
        for i in range(mesh.GetNumberOfCells()):
            ids = mesh.GetCell(i).GetPointIds()
            file.write("f {} {} {}\n".format(*(ids.GetId(j) + 1 for j in range(3))))


def chain(mesh):
    jets = simple.JetFitting(Input=mesh)
    umbilics = simple.UmbilicDetection(Input=jets)
    ridges = simple.RidgeExtraction(Input=umbilics)
    return jets, umbilics, ridges, simple.RidgeSharpnessFilter(Input=ridges)


class TestProxies(unittest.TestCase):
    def tearDown(self):
        delete_all()

    def test_the_whole_job_is_the_stages_in_a_row(self):
        mesh = example(32)
        _, umbilics, ridges, selection = chain(mesh)
        whole = simple.RidgesAndUmbilics(Input=mesh)
        for setting in (selection, whole):
            setting.MinimumSharpness = 10.0
        by_hand = (fetch(selection), fetch(umbilics, 1), fetch(ridges, 2))
        for port, expected in enumerate(by_hand):
            expected = arrays(expected)
            found = arrays(fetch(whole, port))
            self.assertEqual(list(found), list(expected))
            for name, values in expected.items():
                np.testing.assert_array_equal(found[name], values, err_msg=name)
        self.assertEqual(fetch(whole, 1).GetNumberOfPoints(), 8)

    def test_ports_have_names(self):
        whole = simple.RidgesAndUmbilics(Input=example())
        names = [whole.SMProxy.GetOutputPortName(port) for port in range(3)]
        self.assertEqual(names, ["Ridges", "Umbilics", "Mesh"])

    def test_enumerations_go_by_name(self):
        jets = simple.JetFitting(Input=example(), Neighborhood="Rings", NumberOfRings=2)
        two = arrays(fetch(jets))["point FitScale"]
        jets.NumberOfRings = 4
        four = arrays(fetch(jets))["point FitScale"]
        self.assertTrue(np.all(four > two))
        jets.Neighborhood = "Automatic"
        rings = fetch(jets).GetFieldData().GetArray("SelectedNumberOfRings")
        self.assertGreaterEqual(rings.GetValue(0), 2)

    def test_properties_have_an_effect(self):
        whole = simple.RidgesAndUmbilics(Input=example(32))
        everything = fetch(whole).GetNumberOfLines()
        whole.CrestOnly = 1
        crests = arrays(fetch(whole))
        self.assertTrue(0 < len(crests["cell Crest"]) < everything)
        self.assertTrue(np.all(crests["cell Crest"] == 1))
        whole.CrestOnly = 0
        whole.KeepMaximumElliptic = 0
        self.assertNotIn(1, arrays(fetch(whole))["cell RidgeType"])

    def test_properties_against_noise_reach_the_stages(self):
        mesh = example()
        _, umbilics, ridges, selection = chain(mesh)
        whole = simple.RidgesAndUmbilics(Input=mesh)
        for stage, name, value in (
            (umbilics, "Method", "Minima"),
            (umbilics, "Significance", 10.0),
            (ridges, "UmbilicJoining", "Triangles"),
            (ridges, "LoopSignificance", 10.0),
            (ridges, "TypeHysteresis", 5.0),
        ):
            with self.subTest(name):
                setattr(stage, name, value)
                setattr(whole, name, value)
                expected = arrays(fetch(selection))
                found = arrays(fetch(whole))
                self.assertEqual(list(found), list(expected))
                for array, values in expected.items():
                    np.testing.assert_array_equal(found[array], values, err_msg=array)

    def test_purple_points_are_on_the_second_port(self):
        _, _, ridges, _ = chain(example(32))
        self.assertEqual(ridges.SMProxy.GetOutputPortName(1), "PurplePoints")
        self.assertEqual(fetch(ridges, 1).GetNumberOfPoints(), 0)
        ridges.FindPurplePoints = 1
        purple = fetch(ridges, 1)
        self.assertGreater(purple.GetNumberOfPoints(), 0)
        types = dict(zip(*(arrays(fetch(ridges))["cell " + n] for n in ("RidgeId", "RidgeType"))))
        for array, wanted in (("MaximumRidgeId", {1, 2}), ("MinimumRidgeId", {3, 4})):
            self.assertLessEqual({types[i] for i in arrays(purple)["point " + array]}, wanted)

    def test_arrays_of_other_names_can_be_chosen(self):
        jets, umbilics, ridges, _ = chain(example(32))
        lines = simple.PrincipalFoliation(Input=umbilics)
        self.assertEqual(umbilics.MaximumCurvatureArray, ["POINTS", "MaximumCurvature"])
        expected = [arrays(fetch(stage)) for stage in (ridges, lines)]
        rename = """
for name in {names}:
    output.PointData.GetArray(name).SetName("my" + name)
"""
        names = ["MaximumCurvature", "MinimumCurvature", "MaximumDirection", "MinimumDirection"]
        names += ["ThirdOrder", "FourthOrder", "FitStatus"]
        script = "output.DeepCopy(inputs[0].VTKObject)" + rename.format(names=names)
        renamed = simple.ProgrammableFilter(Input=jets, Script=script, CopyArrays=0)
        umbilics.Input = renamed
        for stage in (umbilics, ridges, lines):
            for name in names:
                setattr(stage, name + "Array", "my" + name)
        for stage, before in zip((ridges, lines), expected):
            found = arrays(fetch(stage))
            self.assertEqual(list(found), list(before))
            for name, values in before.items():
                np.testing.assert_array_equal(found[name], values, err_msg=name)

    def test_curvature_lines(self):
        _, umbilics, _, _ = chain(example(32))
        lines = simple.PrincipalFoliation(Input=umbilics, Direction="Both")
        found = arrays(fetch(lines))["cell PrincipalDirection"]
        self.assertEqual(set(found), {0, 1})
        lines.Separation = 0.1
        self.assertLess(len(arrays(fetch(lines))["cell PrincipalDirection"]), len(found))

    def test_coherence_is_a_table_with_and_without_umbilics(self):
        _, umbilics, ridges, _ = chain(example(32))
        checks = simple.RidgeCoherence(Input=umbilics, Ridges=ridges)
        without = fetch(checks)
        checks.Umbilics = simple.OutputPort(umbilics, 1)
        for table in (without, fetch(checks)):
            self.assertTrue(table.IsA("vtkTable"))
            names = table.GetColumnByName("Check")
            failed = {
                names.GetValue(row)
                for row in range(table.GetNumberOfRows())
                if table.GetColumnByName("Passed").GetValue(row) != 1
            }
            self.assertGreater(table.GetNumberOfRows(), 10)
            self.assertEqual(failed, set())

    def test_polygons_are_triangulated(self):
        # A sphere would have no ridges.
        quadric = simple.Superquadric(ThetaResolution=40, PhiResolution=40, Toroidal=0, Scale=[1, 0.8, 0.6])
        whole = simple.RidgesAndUmbilics(Input=quadric)
        with Messages() as messages:
            ridges = fetch(whole)
        self.assertGreater(ridges.GetNumberOfLines(), 0)
        said = [line for line in messages.lines_of("vtkPRidgesAndUmbilics") if "triangulated" in line]
        self.assertEqual(len(said), 1, messages.text)

    def test_progress_reaches_the_session(self):
        session = simple.servermanager.ActiveConnection.Session
        handler = session.GetProgressHandler()
        handler.SetProgressInterval(0.01)  # the least: what comes sooner is left out
        reported = []

        def record(*_):
            if "Ridges" in handler.GetLastProgressText():
                reported.append(handler.GetLastProgress())

        tag = handler.AddObserver("ProgressEvent", record)
        simple.RidgesAndUmbilics(Input=example(63)).UpdatePipeline()
        handler.RemoveObserver(tag)
        self.assertGreater(len(reported), 1)
        self.assertEqual(reported, sorted(reported))

    def test_abort_leaves_nothing_and_the_next_run_is_whole(self):
        whole = simple.RidgesAndUmbilics(Input=example(32))
        everything = fetch(whole).GetNumberOfLines()
        algorithm = whole.GetClientSideObject()
        for where in (0.3, 0.6, 0.8):

            def abort(caller, _event, where=where):
                if caller.GetProgress() >= where:
                    caller.SetAbortExecute(1)

            tag = algorithm.AddObserver("ProgressEvent", abort)
            algorithm.Modified()
            whole.MinimumNumberOfPoints = 30
            whole.UpdatePipeline()
            algorithm.RemoveObserver(tag)
            algorithm.SetAbortExecute(0)  # VTK after 9.1 leaves it to those who have set it
            for port in range(3):
                self.assertEqual(algorithm.GetOutputDataObject(port).GetNumberOfPoints(), 0)
            whole.MinimumNumberOfPoints = 18
            self.assertEqual(fetch(whole).GetNumberOfLines(), everything)

    def test_meshes_that_paraview_reads(self):
        mesh = example()
        with tempfile.TemporaryDirectory() as folder:
            for name in ("mesh.ply", "mesh.stl", "mesh.vtp", "mesh.obj"):
                with self.subTest(name), Messages() as messages:
                    path = os.path.join(folder, name)
                    if name == "mesh.obj":
                        write_obj(path, fetch(mesh))
                    elif name == "mesh.vtp":
                        simple.SaveData(path, mesh, DataMode="Binary")
                    else:
                        simple.SaveData(path, mesh)
                    whole = simple.RidgesAndUmbilics(Input=simple.OpenDataFile(path))
                    self.assertEqual(fetch(whole, 2).GetNumberOfPoints(), 2562)
                    self.assertGreater(fetch(whole).GetNumberOfLines(), 10)
                    self.assertEqual(messages.text, "")

    def test_documentation_comes_along(self):
        self.assertIn("umbilic", simple.RidgesAndUmbilics.__doc__)
        self.assertIn("polynomial is fitted", simple.JetFitting.__doc__)


class TestBadInput(unittest.TestCase):
    def tearDown(self):
        delete_all()

    def test_loaded_twice(self):
        load_plugin()
        self.assertGreater(fetch(simple.RidgesAndUmbilics(Input=example())).GetNumberOfLines(), 0)

    def test_empty_input(self):
        empty = simple.ProgrammableSource(Script="", OutputDataSetType="vtkPolyData")
        for name in PROXIES:
            with self.subTest(name), Messages() as messages:
                proxy = getattr(simple, name)(Input=empty)
                for port in range(proxy.SMProxy.GetNumberOfOutputPorts()):
                    output = fetch(proxy, port)
                    self.assertTrue(output.IsA("vtkPolyData"))
                    self.assertEqual(output.GetNumberOfPoints(), 0)
                self.assertEqual(messages.text, "")

    def test_an_image_is_refused(self):
        wavelet = simple.Wavelet()
        for name in PROXIES:
            with self.subTest(name), Messages() as messages:
                proxy = getattr(simple, name)(Input=wavelet)
                proxy.UpdatePipeline()
                self.assertIn("is of type vtkImageData, but a vtkPolyData is required", messages.text)

    def test_arrays_that_are_missing_are_named(self):
        mesh = example()
        for name, text in (
            ("UmbilicDetection", "MaximumCurvature, MinimumCurvature"),
            ("RidgeExtraction", "MaximumCurvature, MinimumCurvature"),
            ("MongeSmoothing", "MaximumCurvature, MinimumCurvature"),
            ("PrincipalFoliation", "MaximumCurvature, MinimumCurvature"),
            ("RidgeSharpnessFilter", "RidgeType"),
        ):
            with self.subTest(name), Messages() as messages:
                getattr(simple, name)(Input=mesh).UpdatePipeline()
                lines = messages.lines_of("vtk" + name)
                self.assertEqual(len(lines), 1, messages.text)
                self.assertIn(text, lines[0])

    def test_points_without_triangles(self):
        line = simple.Line()
        with Messages() as messages:
            simple.RidgesAndUmbilics(Input=line).UpdatePipeline()
            simple.JetFitting(Input=line).UpdatePipeline()
        self.assertEqual(
            messages.lines_of("vtkPRidgesAndUmbilics"),
            ["The input has points, but no triangles: give the mesh of a surface."],
        )
        self.assertIn("have no fit", "".join(messages.lines_of("vtkPJetFitting")))

    def test_radius_that_is_not_set(self):
        for name in ("JetFitting", "RidgesAndUmbilics"):
            with self.subTest(name), Messages() as messages:
                proxy = getattr(simple, name)(Input=example(), Neighborhood="Radius")
                proxy.UpdatePipeline()
                self.assertEqual(
                    messages.lines_of("vtkP" + name),
                    ["Neighborhood is by radius, but Radius is 0: set a positive one."],
                )
                self.assertEqual(fetch(proxy).GetNumberOfCells(), 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
