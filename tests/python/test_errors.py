"""Errors of VTK's algorithms in Python: exceptions from `update`, events for observers."""

import contextlib
import io
import os
import sys
import unittest
import warnings

import vesicle
from support import sphere, temporary_folder
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData


@contextlib.contextmanager
def standard_error_of_the_process():
    """What VTK itself prints goes past sys.stderr."""
    sys.stderr.flush()
    before = os.dup(2)
    with open("stderr.txt", "w+") as file:
        os.dup2(file.fileno(), 2)
        text = io.StringIO()
        try:
            yield text
        finally:
            os.dup2(before, 2)
            os.close(before)
            file.seek(0)
            text.write(file.read())


class Errors(unittest.TestCase):
    def test_the_first_error_is_raised_and_nothing_printed(self):
        source = sphere()
        source.SetRadius(-1)
        with temporary_folder(), standard_error_of_the_process() as printed:
            with self.assertRaisesRegex(vesicle.Error, "^Radius must be above 0"):
                vesicle.update(source)
        self.assertEqual(printed.getvalue(), "")

    def test_errors_upstream_are_raised(self):
        source = sphere()
        source.SetRadius(-1)
        clean = vtkCleanPolyData()
        clean.SetInputConnection(source.GetOutputPort())
        with self.assertRaisesRegex(vesicle.Error, "Radius"):
            vesicle.update(clean)

    def test_a_mended_pipeline_works(self):
        source = sphere()
        source.SetRadius(-1)
        with self.assertRaises(vesicle.Error):
            vesicle.update(source)
        source.SetRadius(2)
        self.assertAlmostEqual(abs(vesicle.update(source).Points).max(), 2, delta=0.05)

    def test_the_scene_is_named(self):
        stepper = vesicle.vtkVesicleStepper()
        stepper.SetSceneFileName("/nowhere/scene.toml")
        for ask in (vesicle.times, vesicle.update):
            with self.assertRaisesRegex(vesicle.Error, "/nowhere/scene.toml"):
                ask(stepper)
        self.assertEqual(stepper.GetErrorCategory(), vesicle.vtkVesicleStepper.InputFailure)

    def test_the_last_good_state_is_still_there(self):
        stepper = vesicle.vtkVesicleStepper()
        with temporary_folder():
            stepper.SetSceneFileName("data/scenes/tank-treading.toml")
            for setting in ("vesicle.triangles=80", "time.step=50.0", "time.end=100.0",
                            "time.output_every=50.0", "flow.rate=30.0"):
                stepper.AddOverride(setting)
            with self.assertRaises(vesicle.Error):
                vesicle.update(stepper, 100)
        self.assertEqual(stepper.GetErrorCategory(), vesicle.vtkVesicleStepper.NumericalFailure)
        self.assertEqual(stepper.GetOutput().GetNumberOfPolys(), 80)

    def test_warnings_are_pythons(self):
        curvature = vesicle.vtkVesicleCurvatureFilter()
        curvature.SetInputData(vtkPolyData())
        with self.assertWarnsRegex(RuntimeWarning, "no triangles") as caught:
            vesicle.update(curvature)
        self.assertEqual(caught.filename, __file__)

    def test_observers_get_the_text(self):
        texts = []

        def note(algorithm, event, text):
            texts.append(text)

        note.CallDataType = "string0"
        source = sphere()
        source.SetRadius(-1)
        source.AddObserver("ErrorEvent", note)
        with contextlib.suppress(vesicle.Error):
            vesicle.update(source)
        self.assertIn("Radius must be above 0", texts[0])


if __name__ == "__main__":
    unittest.main()
