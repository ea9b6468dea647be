"""Windows without a screen, VTK's own classes and the view."""

import os
import subprocess
import sys
import unittest

import vesicle
from support import sphere, temporary_folder
from vesicle.rendering import View, vtkVesicleOffscreen
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkChartsCore import vtkChartXY
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkRenderWindowInteractor
from vtkmodules.vtkViewsContext2D import vtkContextView


LEAVES_A_WINDOW = """
import vesicle.rendering
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow
sphere, mapper, actor = vtkSphereSource(), vtkPolyDataMapper(), vtkActor()
mapper.SetInputConnection(sphere.GetOutputPort())
actor.SetMapper(mapper)
renderer, window = vtkRenderer(), vtkRenderWindow()
renderer.AddActor(actor)
window.AddRenderer(renderer)
window.SetSize(640, 480)
window.Render()
window.Render()
"""


def pixels(file):
    reader = vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, 3)


def curved_sphere():
    source = sphere()
    curvature = vesicle.vtkVesicleCurvatureFilter()
    curvature.SetInputConnection(source.GetOutputPort())
    return vesicle.update(curvature)


@unittest.skipIf(os.environ.get("DISPLAY"), "DISPLAY names a screen: VTK's own windows are used")
class WithoutAScreen(unittest.TestCase):
    def test_windows_of_vtk_draw_in_memory(self):
        self.assertEqual(vtkVesicleOffscreen.GetBackend(), "OSMesa")
        self.assertEqual(vtkRenderWindow().GetClassName(), "vtkVesicleOSMesaRenderWindow")
        vtkRenderWindowInteractor().Start()

    def test_charts_of_vtk(self):
        table = vtkTable()
        for name in ("x", "y"):
            column = vtkFloatArray()
            column.SetName(name)
            for i in range(5):
                column.InsertNextValue(i)
            table.AddColumn(column)
        chart = vtkChartXY()
        chart.AddPlot(0).SetInputData(table, 0, 1)
        view = vtkContextView()
        view.GetScene().AddItem(chart)
        view.Render()
        self.assertEqual(view.GetRenderWindow().GetClassName(), "vtkVesicleOSMesaRenderWindow")

    def test_a_view_of_a_sphere(self):
        view = View(size=(320, 240), range=(0.5, 1.5))
        view.show(curved_sphere(), "a sphere")
        view.wait()
        with temporary_folder() as folder:
            view.save(folder / "sphere.png")
            picture = pixels(folder / "sphere.png")
        self.assertEqual(picture.shape, (240, 320, 3))
        self.assertEqual(tuple(picture[0, -1]), (255, 255, 255))
        middle = picture[120, 160].astype(int)
        self.assertLess(middle.max() - middle.min(), 12, "the middle of the colours is grey")
        self.assertGreater(middle.min(), 180)

    def test_a_view_follows_its_surfaces(self):
        surface = curved_sphere()
        view = View(size=(200, 200), range=(0, 2))
        colors = []
        with temporary_folder() as folder:
            for value in (0, 2):
                surface.PointData["Mean_Curvature"][:] = value
                surface.VTKObject.GetPointData().GetArray("Mean_Curvature").Modified()
                view.show(surface)
                view.save(folder / "view.png")
                colors.append(pixels(folder / "view.png")[100, 100].astype(int))
        self.assertGreater(colors[0][2], colors[0][0] + 50, "low is blue")
        self.assertGreater(colors[1][0], colors[1][2] + 50, "high is red")

    def test_a_process_may_end_while_a_window_draws(self):
        for how in ("", "window.Register(None)", "import builtins; builtins.kept = window",
                    "import threading; threading.Thread(target=window.Render).start()"):
            with self.subTest(how):
                for _ in range(3):
                    subprocess.run([sys.executable, "-c", LEAVES_A_WINDOW + how], check=True,
                                   timeout=60)

    def test_a_display_that_nothing_answers_at_is_no_screen(self):
        subprocess.run([sys.executable, "-c", LEAVES_A_WINDOW], check=True, timeout=60,
                       env={**os.environ, "DISPLAY": ":4711"})

    def test_a_missing_array_is_named_with_those_there_are(self):
        with self.assertRaisesRegex(ValueError, "'Tension'; there are: .*Mean_Curvature"):
            View(color="Tension").show(curved_sphere())


if __name__ == "__main__":
    unittest.main()
