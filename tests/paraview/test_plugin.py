"""The plugin in pvpython: shape, simulation over several times, curvature, screenshot without a screen."""

import os
import tempfile
import unittest
from pathlib import Path

import numpy
from paraview import servermanager, simple
from paraview.vtk.numpy_interface import dataset_adapter
from pictures import pixels

source_folder = Path(os.environ["VESICLE_SOURCE_DIR"])
scene = str(source_folder / "data/scenes/tank-treading.toml")
overrides = ["vesicle.triangles=180", "time.end=1.0", "time.output_every=0.25"]


def data(proxy, time=0.0):
    proxy.UpdatePipeline(time)
    return dataset_adapter.WrapDataObject(servermanager.Fetch(proxy))


class Plugin(unittest.TestCase):
    def setUp(self):
        simple.ResetSession()

    def pipeline(self):
        shape = simple.VesicleSource(Shape="Prolate", ReducedVolume=0.95, Triangles=180,
                                     Axis=[1, 0, 0])
        simulation = simple.VesicleSimulationFromMesh(Input=shape, FlowKind="Shear", FlowRate=3,
                                                      BendingRigidity=0, EndTime=1,
                                                      OutputEvery=0.25)
        return shape, simulation, simple.VesicleCurvature(Input=simulation)

    def test_times_are_in_the_time_controls(self):
        _, simulation, curvature = self.pipeline()
        simulation.UpdatePipelineInformation()
        expected = [0, 0.25, 0.5, 0.75, 1]
        self.assertEqual(list(simulation.TimestepValues), expected)
        simple.Show(curvature)
        animation = simple.GetAnimationScene()
        animation.UpdateAnimationUsingDataTimeSteps()
        self.assertEqual(list(animation.TimeKeeper.TimestepValues), expected)
        animation.GoToLast()
        self.assertEqual(animation.TimeKeeper.Time, 1)
        animation.GoToPrevious()
        self.assertEqual(animation.TimeKeeper.Time, 0.75)

    def test_starts_from_the_shape_and_goes_there_and_back(self):
        shape, simulation, curvature = self.pipeline()
        start = numpy.array(data(shape).Points)
        shapes = [numpy.array(data(curvature, time).Points) for time in (0, 0.5, 1, 0.5, 0)]
        # On the way in, the start shape's volume is brought to the one of the Loop surface.
        numpy.testing.assert_allclose(shapes[0], start, atol=0.02)
        numpy.testing.assert_array_equal(shapes[0], shapes[4])
        numpy.testing.assert_array_equal(shapes[1], shapes[3])
        self.assertGreater(abs(shapes[2] - shapes[0]).max(), 0.05)

    def test_arrays(self):
        *_, curvature = self.pipeline()
        surface = data(curvature, 0.5)
        self.assertLessEqual({"Mean_Curvature", "Bending_Force", "Velocity", "Tension"},
                             set(surface.PointData.keys()))
        self.assertEqual(surface.FieldData["TimeValue"][0], 0.5)
        self.assertTrue(numpy.isfinite(surface.PointData["Bending_Force"]).all())

    def test_a_scene_replaces_the_properties(self):
        _, simulation, _ = self.pipeline()
        simulation.FileName = scene
        simulation.Overrides = ["time.end=0.5", "time.output_every=0.5"]
        simulation.UpdatePipelineInformation()
        self.assertEqual(list(simulation.TimestepValues), [0, 0.5])

    def test_streamlines_around_a_vesicle(self):
        shape, *_ = self.pipeline()
        forces = simple.VesicleForces(Input=shape, FlowKind="Uniform", FlowVelocity=[1, 0, 0])
        image = simple.FastUniformGrid(WholeExtent=[-3, 3, -3, 3, -3, 3])
        flow = simple.VesicleFlow(Input=image, Vesicle=forces)
        surface = data(forces)
        self.assertLessEqual({"Tension_Force", "Velocity", "Membrane_Force"},
                             set(surface.PointData.keys()))
        self.assertTrue(numpy.isfinite(data(flow).PointData["Velocity"]).all())
        self.assertEqual(data(flow).PointData["Inside"].max(), 1)
        lines = simple.StreamTracer(Input=flow, SeedType="Line", Vectors=["POINTS", "Velocity"])
        self.assertGreater(len(data(lines).Points), 10)

    def test_the_sphere_has_its_curvature(self):
        sphere = simple.VesicleSource(Shape="Sphere", ReducedVolume=0, Radius=2)
        curvature = simple.VesicleCurvature(Input=sphere, Scheme="Fit", BendingRigidity=3)
        surface = data(curvature)
        radius = numpy.linalg.norm(surface.Points, axis=1)
        numpy.testing.assert_allclose(surface.PointData["Mean_Curvature"] * radius, 1, rtol=1e-3)

    def test_the_perturbed_sphere_takes_its_modes(self):
        shape = simple.VesicleSource(Shape="Perturbed", ReducedVolume=0, Modes=[2, 0, 0.2])
        extent = numpy.ptp(data(shape).Points, axis=0)
        self.assertGreater(extent[2], 1.1 * extent[0])

    def test_a_scene_opens_like_a_file(self):
        simulation = simple.OpenDataFile(scene)
        self.assertEqual(simulation.GetXMLName(), "VesicleSimulation")
        simulation.Overrides = overrides
        self.assertEqual(data(simulation, 0.25).FieldData["TimeValue"][0], 0.25)

    def test_an_off_file_opens(self):
        mesh = simple.OpenDataFile(str(source_folder / "data/meshes/peanut.off"))
        self.assertGreater(len(data(mesh).Points), 100)

    def test_screenshots_without_a_screen(self):
        *_, curvature = self.pipeline()
        simple.LoadPalette("WhiteBackground")
        view = simple.CreateRenderView(ViewSize=[400, 300])
        self.assertEqual(view.GetRenderWindow().GetClassName(), "vtkVesicleOSMesaRenderWindow")
        display = simple.Show(curvature, view)
        simple.ColorBy(display, ("POINTS", "Mean_Curvature"))
        display.RescaleTransferFunctionToDataRange()
        display.SetScalarBarVisibility(view, True)
        view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, -9, 0], [0, 0, 0], [0, 0, 1]
        simple.ResetCamera(view)
        pictures = []
        folder = os.environ.get("VESICLE_SCREENSHOTS") or tempfile.mkdtemp()
        for time in (0, 0.5, 1):
            view.ViewTime = time
            file = Path(folder, f"plugin-{time}.png")
            simple.SaveScreenshot(str(file), view)
            pictures.append(pixels(file))
        for picture in pictures:
            self.assertEqual(picture.shape, (300, 400, 3))
            self.assertEqual(tuple(picture[0, 0]), (255, 255, 255))
            colored = (picture.max(axis=2) - picture.min(axis=2)) > 40
            self.assertGreater(colored.mean(), 0.03)
        self.assertGreater((pictures[0] != pictures[2]).any(axis=2).mean(), 0.02)


plugin = Path(os.environ["PV_PLUGIN_PATH"], "Vesicle.so")

if __name__ == "__main__":
    simple.LoadPlugin(str(plugin), ns=globals())
    unittest.main(verbosity=2)
