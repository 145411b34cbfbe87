# SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Properties as keywords and attributes, and pipelines by >>, which VTK has since 9.4."""

import unittest

from vtkmodules.vtkCommonCore import vtkVersion

import vtkridges

VERSION = (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion())


@unittest.skipIf(VERSION < (9, 4), "needs VTK 9.4")
class TestKeywords(unittest.TestCase):
    def test_properties(self):
        lines = vtkridges.vtkSalientRidges(fold_angle=20.0, crest_only=False)
        self.assertEqual((lines.GetFoldAngle(), lines.GetCrestOnly()), (20.0, False))
        lines.relative_scale = 0.02
        self.assertEqual(lines.GetRelativeScale(), 0.02)
        ridges = vtkridges.vtkRidgesAndUmbilics(minimum_sharpness=3.0)
        self.assertEqual(ridges.minimum_sharpness, 3.0)

    def test_pipeline(self):
        chain = (
            vtkridges.vtkRidgeExampleSource(frequency=20)
            >> vtkridges.vtkJetFitting(degree=6)
            >> vtkridges.vtkUmbilicDetection()
            >> vtkridges.vtkRidgeExtraction()
            >> vtkridges.vtkRidgeSharpnessFilter(minimum_sharpness=10.0)
        )
        source = vtkridges.vtkRidgeExampleSource()
        source.SetFrequency(20)
        stages = [source, vtkridges.vtkJetFitting(), vtkridges.vtkUmbilicDetection()]
        stages += [vtkridges.vtkRidgeExtraction(), vtkridges.vtkRidgeSharpnessFilter()]
        stages[1].SetDegree(6)
        stages[-1].SetMinimumSharpness(10.0)
        for stage, following in zip(stages, stages[1:]):
            following.SetInputConnection(stage.GetOutputPort())
        stages[-1].Update()
        lines = chain.update().output
        self.assertGreater(lines.GetNumberOfLines(), 0)
        self.assertEqual(lines.GetNumberOfLines(), stages[-1].GetOutput().GetNumberOfLines())


if __name__ == "__main__":
    unittest.main()
