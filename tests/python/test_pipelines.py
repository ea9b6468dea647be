"""The filters among VTK's own, from Python."""

import os
import signal
import unittest

import numpy
import vesicle
from support import sphere, temporary_folder
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkCleanPolyData
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter, vtkWarpVector


def connected(algorithm, source):
    algorithm.SetInputConnection(source.GetOutputPort())
    return algorithm


class Count:
    """How often an algorithm has run."""

    def __init__(self, algorithm):
        self.runs = 0
        algorithm.AddObserver("EndEvent", self.note)

    def note(self, algorithm, event):
        self.runs += 1


def small_shear():
    stepper = vesicle.vtkVesicleStepper()
    with temporary_folder():
        stepper.SetSceneFileName("data/scenes/tank-treading.toml")
        for setting in ("vesicle.triangles=80", "time.end=1.0", "time.output_every=0.25"):
            stepper.AddOverride(setting)
        vesicle.update(stepper, 0)
    return stepper


class Flow(unittest.TestCase):
    def test_around_and_inside(self):
        source = vesicle.vtkVesicleSource()
        source.SetShapeByName("prolate")
        source.SetReducedVolume(0.9)
        source.SetTriangles(80)
        forces = connected(vesicle.vtkVesicleForceFilter(), source)
        forces.SetFlowKind(forces.Shear)
        forces.SetFlowRate(2)
        membrane = vesicle.update(forces)
        points = numpy.array([[0, 0, 0], [0, 0, 100], [100, 0, 0]], dtype=float)
        places = vtkPolyData()
        dataset_adapter.WrapDataObject(places).Points = points
        probe = vesicle.vtkVesicleProbeFilter()
        probe.SetInputData(places)
        probe.SetSourceConnection(forces.GetOutputPort())
        flow = vesicle.update(probe)
        self.assertEqual(list(flow.PointData["Inside"]), [1, 0, 0])
        self.assertEqual(len(membrane.PointData["Tension"]), 42)
        # Far away the shear flow is what it was.
        numpy.testing.assert_allclose(flow.PointData["Velocity"][1], [200, 0, 0], atol=1e-2)

    def test_streamlines_through_a_bare_surface_follow_the_imposed_shear(self):
        source = sphere(1.05)
        forces = connected(vesicle.vtkVesicleForceFilter(), source)
        forces.SetBendingRigidity(0)
        forces.IncompressibleOff()
        forces.SetFlowKind(vesicle.vtkVesicleForceFilter.Shear)
        forces.SetFlowRate(2)
        box = vtkImageData()
        box.SetDimensions(9, 9, 9)
        box.SetOrigin(-2, -2, -2)
        box.SetSpacing(0.5, 0.5, 0.5)
        flow = vesicle.vtkVesicleProbeFilter()
        flow.SetInputData(box)
        flow.SetSourceConnection(forces.GetOutputPort())
        velocity = vesicle.update(flow).PointData["Velocity"]
        z = numpy.array([box.GetPoint(i)[2] for i in range(box.GetNumberOfPoints())])
        numpy.testing.assert_allclose(velocity, numpy.outer(2 * z, [1, 0, 0]), atol=1e-12)
        inside = vesicle.update(flow).PointData["Inside"]
        self.assertEqual(inside.sum(), 33)  # points of the grid not farther than 1 from its middle

        seeds = vtkPoints()
        seeds.InsertNextPoint(-1.8, 0.1, 0.7)
        start = vtkPolyData()
        start.SetPoints(seeds)
        tracer = connected(vtkStreamTracer(), flow)
        tracer.SetSourceData(start)
        tracer.SetInputArrayToProcess(0, 0, 0, vtkPolyData.FIELD_ASSOCIATION_POINTS, "Velocity")
        tracer.SetMaximumPropagation(10)
        line = vesicle.update(tracer).Points
        self.assertGreater(line[:, 0].max(), 1.5)
        numpy.testing.assert_allclose(line[:, 1:], [[0.1, 0.7]] * len(line), atol=1e-6)


class Curvature(unittest.TestCase):
    def test_of_a_sphere_that_vtk_moved(self):
        transform = vtkTransform()
        transform.Translate(3, 2, 1)
        transform.Scale(2, 2, 2)
        move = vtkTransformPolyDataFilter()
        move.SetTransform(transform)
        connected(move, sphere(1, 1280))
        curvature = connected(vesicle.vtkVesicleCurvatureFilter(), connected(vtkCleanPolyData(), move))
        surface = vesicle.update(curvature)
        outward = surface.Points - numpy.array([3, 2, 1])
        radius = numpy.linalg.norm(outward, axis=1)  # above 2: the triangles cut into the sphere
        numpy.testing.assert_allclose(surface.PointData["Mean_Curvature"] * radius, 1, rtol=1e-3)
        numpy.testing.assert_allclose(surface.PointData["Gauss_Curvature"] * radius**2, 1, rtol=2e-3)
        numpy.testing.assert_allclose(surface.PointData["Normals"], outward / radius[:, None],
                                      atol=1e-3)

    def test_other_arrays_pass_through(self):
        surface = vesicle.update(sphere())
        surface.PointData.append(numpy.arange(len(surface.Points)), "Point_Number")
        surface.CellData.append(numpy.arange(320), "Cell_Number")
        curvature = vesicle.vtkVesicleCurvatureFilter()
        curvature.SetInputData(surface.VTKObject)
        output = vesicle.update(curvature)
        numpy.testing.assert_array_equal(output.PointData["Point_Number"], numpy.arange(162))
        numpy.testing.assert_array_equal(output.CellData["Cell_Number"], numpy.arange(320))

    def test_warped_along_its_force(self):
        source = vesicle.vtkVesicleSource()
        source.SetShapeByName("prolate")
        source.SetReducedVolume(0.8)
        source.SetTriangles(320)
        curvature = connected(vesicle.vtkVesicleCurvatureFilter(), source)
        warp = connected(vtkWarpVector(), curvature)
        warp.SetInputArrayToProcess(0, 0, 0, vtkPolyData.FIELD_ASSOCIATION_POINTS, "Bending_Force")
        warp.SetScaleFactor(0.01)
        moved = vesicle.update(warp)
        before = vesicle.update(curvature)
        numpy.testing.assert_allclose(moved.Points,
                                      before.Points + 0.01 * before.PointData["Bending_Force"],
                                      atol=1e-6)

    def test_runs_only_when_something_changed(self):
        source = sphere()
        curvature = connected(vesicle.vtkVesicleCurvatureFilter(), source)
        runs = Count(curvature)
        for _ in range(3):
            vesicle.update(curvature)
        self.assertEqual(runs.runs, 1)
        curvature.SetBendingRigidity(curvature.GetBendingRigidity())
        vesicle.update(curvature)
        self.assertEqual(runs.runs, 1)
        curvature.SetBendingRigidity(2)
        vesicle.update(curvature)
        source.SetRadius(2)
        vesicle.update(curvature)
        self.assertEqual(runs.runs, 3)

    def test_deep_copies_are_on_their_own(self):
        curvature = connected(vesicle.vtkVesicleCurvatureFilter(), sphere())
        vesicle.update(curvature)
        copy = vtkPolyData()
        copy.DeepCopy(curvature.GetOutput())
        dataset_adapter.WrapDataObject(copy).PointData["Mean_Curvature"][:] = 7
        self.assertLess(vesicle.update(curvature).PointData["Mean_Curvature"].max(), 2)

    def test_arrays_share_vtks_memory(self):
        surface = vesicle.update(connected(vesicle.vtkVesicleCurvatureFilter(), sphere()))
        surface.PointData["Mean_Curvature"][0] = 7
        array = surface.VTKObject.GetPointData().GetArray("Mean_Curvature")
        self.assertEqual(array.GetValue(0), 7)


    def test_what_update_gave_stays_what_it_was(self):
        source = sphere()
        curvature = connected(vesicle.vtkVesicleCurvatureFilter(), source)
        before = vesicle.update(curvature)
        points, mean = before.Points, before.PointData["Mean_Curvature"]
        kept = points.copy(), mean.copy()
        source.SetRadius(3)
        vesicle.update(curvature)
        del before
        numpy.testing.assert_array_equal(points, kept[0])
        numpy.testing.assert_array_equal(mean, kept[1])


class Stepper(unittest.TestCase):
    def test_same_time_same_shape_through_a_pipeline(self):
        stepper = small_shear()
        self.assertEqual(vesicle.times(stepper), (0, 0.25, 0.5, 0.75, 1))
        clean = connected(vtkCleanPolyData(), stepper)
        shapes = [numpy.array(vesicle.update(clean, time).Points) for time in (0, 0.5, 1, 0.5, 0)]
        numpy.testing.assert_array_equal(shapes[0], shapes[4])
        numpy.testing.assert_array_equal(shapes[1], shapes[3])
        self.assertGreater(abs(shapes[0] - shapes[1]).max(), 0.01)

    def test_its_numbers(self):
        surface = vesicle.update(small_shear(), 0.25)
        self.assertEqual(surface.FieldData["TimeValue"][0], 0.25)
        self.assertLess(abs(surface.FieldData["Volume_Drift"][0]), 1e-10)
        self.assertEqual(surface.PointData["Velocity"].shape, (42, 3))

    def test_starts_from_numpys_mesh(self):
        start = vesicle.update(small_shear(), 0)
        mesh = vesicle.make_mesh(start.Points, vesicle.triangles(start))
        stepper = small_shear()
        stepper.SetInputData(mesh)
        numpy.testing.assert_allclose(vesicle.update(stepper, 0).Points, start.Points, atol=1e-13)

    def test_an_observer_follows_and_ends_it(self):
        stepper = small_shear()
        times = []

        def note(stepper, event):
            times.append(stepper.GetStateTime())
            if len(times) == 2:
                stepper.SetAbortExecute(1)

        stepper.AddObserver(vesicle.vtkVesicleStepper.StepAcceptedEvent, note)
        surface = vesicle.update(stepper, 1)
        self.assertEqual(len(times), 2)
        self.assertEqual(surface.FieldData["TimeValue"][0], times[-1])

    def test_ctrl_c_ends_it_after_the_step(self):
        stepper = small_shear()
        clean = connected(vtkCleanPolyData(), stepper)
        press = stepper.AddObserver(vesicle.vtkVesicleStepper.StepAcceptedEvent,
                                    lambda stepper, event: os.kill(os.getpid(), signal.SIGINT))
        steps = stepper.GetNumberOfSteps()
        with self.assertRaises(KeyboardInterrupt):
            vesicle.update(clean, 1)
        self.assertEqual(stepper.GetNumberOfSteps(), steps + 1)
        stepper.RemoveObserver(press)
        self.assertEqual(vesicle.update(clean, 1).FieldData["TimeValue"][0], 1)


if __name__ == "__main__":
    unittest.main()
