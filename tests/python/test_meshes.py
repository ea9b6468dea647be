"""Meshes from and to numpy arrays and files."""

import unittest

import numpy
import vesicle
from support import sphere, temporary_folder
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.vtkFiltersSources import vtkCubeSource

tetrahedron = (numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float),
               numpy.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]))


class Meshes(unittest.TestCase):
    def test_arrays_in_and_out(self):
        points, triangles = tetrahedron
        mesh = vesicle.make_mesh(points, triangles)
        numpy.testing.assert_array_equal(vesicle.triangles(mesh), triangles)
        numpy.testing.assert_array_equal(dataset_adapter.WrapDataObject(mesh).Points, points)
        points[0, 0] = 5
        self.assertEqual(mesh.GetPoint(0)[0], 0)
        points[0, 0] = 0

    def test_arrays_that_are_no_mesh_are_refused(self):
        points, triangles = tetrahedron
        with self.assertRaisesRegex(ValueError, "3 columns"):
            vesicle.make_mesh(points[:, :2], triangles)
        with self.assertRaisesRegex(ValueError, "there are 4"):
            vesicle.make_mesh(points, triangles + 1)

    def test_numbers_that_cannot_be(self):
        points, triangles = tetrahedron
        with self.assertRaisesRegex(ValueError, "must be integers"):
            vesicle.make_mesh(points, numpy.asarray(triangles) + 0.5)
        bad = numpy.array(points, dtype=float)
        bad[2, 1] = numpy.nan
        with self.assertRaisesRegex(ValueError, "point 2 is .*finite"):
            vesicle.make_mesh(bad, triangles)

    def test_other_polygons_are_not_triangles(self):
        cube = vtkCubeSource()
        cube.Update()
        with self.assertRaisesRegex(ValueError, "vtkTriangleFilter"):
            vesicle.triangles(cube.GetOutput())

    def test_no_triangles(self):
        mesh = vesicle.make_mesh(numpy.zeros((0, 3)), numpy.zeros((0, 3), int))
        self.assertEqual(vesicle.triangles(mesh).shape, (0, 3))

    def test_files_keep_points_triangles_and_arrays(self):
        surface = vesicle.update(sphere(1.3))
        surface.PointData.append(numpy.arange(len(surface.Points), dtype=float), "Number")
        with temporary_folder():
            for file in ("mesh.vtu", "mesh.vtp", "mesh.vtk"):
                vesicle.write_mesh(surface, file)
                again = dataset_adapter.WrapDataObject(vesicle.read_mesh(file))
                numpy.testing.assert_array_equal(again.Points, surface.Points)
                numpy.testing.assert_array_equal(vesicle.triangles(again), vesicle.triangles(surface))
                numpy.testing.assert_array_equal(again.PointData["Number"],
                                                 surface.PointData["Number"])

    def test_shapes_survive_the_other_formats(self):
        surface = vesicle.update(sphere())
        with temporary_folder() as folder:
            for ending in ("stl", "ply", "obj", "off"):
                vesicle.write_mesh(surface, folder / f"mesh.{ending}")
                again = vesicle.read_mesh(folder / f"mesh.{ending}")
                self.assertEqual(again.GetNumberOfPolys(), 320)
                self.assertEqual(again.GetNumberOfPoints(), 162)

    def test_bad_files_are_named(self):
        mesh = vesicle.make_mesh(*tetrahedron)
        with temporary_folder() as folder:
            with self.assertRaisesRegex(vesicle.Error, "missing.stl: there is no such file"):
                vesicle.read_mesh("missing.stl")
            (folder / "broken.vtu").write_text("<VTKFile")
            with self.assertRaisesRegex(vesicle.Error, "broken.vtu"):
                vesicle.read_mesh("broken.vtu")
            with self.assertRaisesRegex(vesicle.Error, "mesh.txt: meshes end in .vtu"):
                vesicle.write_mesh(mesh, "mesh.txt")
            with self.assertRaisesRegex(vesicle.Error, "nowhere/mesh.vtu"):
                vesicle.write_mesh(mesh, "nowhere/mesh.vtu")


if __name__ == "__main__":
    unittest.main()
