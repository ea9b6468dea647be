"""The Python programs and the notebook in examples/ run as they stand there."""

import contextlib
import importlib.util
import io
import json
import os
import pathlib
import runpy
import struct
import sys
import tempfile
import unittest

import numpy
import vesicle

examples = pathlib.Path(os.environ["VESICLE_SOURCE_DIR"], "examples")


@contextlib.contextmanager
def in_a_folder():
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            yield pathlib.Path(folder)
        finally:
            os.chdir(before)


def write_mrc(file, voxels, spacing):
    """MRC 2014, mode 0: signed bytes."""
    sizes = voxels.shape[::-1]
    head = struct.pack("<10i6f3i3f", *sizes, 0, 0, 0, 0, *sizes, *(spacing * n for n in sizes), 90, 90, 90, 1, 2, 3,
                       0, 1, 0).ljust(208, b"\0") + b"MAP DD\0\0"
    pathlib.Path(file).write_bytes(head.ljust(1024, b"\0") + voxels.astype(numpy.int8).tobytes())


def run(name, *arguments):
    """What it prints."""
    text = io.StringIO()
    before = sys.argv
    sys.argv = [name, *arguments]
    try:
        with contextlib.redirect_stdout(text):
            runpy.run_path(str(examples / name), run_name="__main__")
    finally:
        sys.argv = before
    return text.getvalue()


class Examples(unittest.TestCase):
    def test_inclination(self):
        with in_a_folder():
            printed = run("inclination.py")
            table = vesicle.read_table("inclination.csv")
        self.assertEqual(printed.count("frequency"), 3)
        # The less it is inflated, the nearer to the flow it lies; 32.42° of v = 0.95 is the scene's.
        self.assertTrue((table["inclination_deg"][:-1] > table["inclination_deg"][1:]).all())
        self.assertAlmostEqual(table["inclination_deg"][1], 32.42, delta=0.5)

    def test_segmentation(self):
        """A ball of 12 voxels of 5 Å; the surface of a mask lies half a voxel off, here and there."""
        z, y, x = numpy.mgrid[:31, :31, :31] - 15
        with in_a_folder():
            ball = 2 * (x**2 + y**2 + z**2 <= 12**2)
            write_mrc("cell.mrc", numpy.where(z < -13, 1, ball), 5.0)  # and something else of label 1
            self.assertIn("cell.vtp", run("segmentation.py", "cell.mrc", "2", "cell.vtp"))
            points = vesicle.Frame(vesicle.read_mesh("cell.vtp")).points
            radius = numpy.linalg.norm(points - 75, axis=1)
            self.assertLess(abs(radius - 60).max(), 5)
            with self.assertRaisesRegex(vesicle.Error, "cell.mrc: has no label 3"):
                run("segmentation.py", "cell.mrc", "3", "none.vtp")
            with self.assertRaisesRegex(vesicle.Error, "missing.mrc: can't be read"):
                run("segmentation.py", "missing.mrc", "1", "none.vtp")

    def test_the_notebook(self):
        cells = json.loads((examples / "tank-treading.ipynb").read_text())["cells"]
        code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
        self.assertTrue(all(not cell.get("outputs") for cell in cells))
        with in_a_folder() as folder, contextlib.redirect_stdout(io.StringIO()):
            names = {}
            for cell in code:
                exec(compile(cell, "tank-treading.ipynb", "exec"), names)
            self.assertGreater((folder / "tension.png").stat().st_size, 1000)

    @unittest.skipUnless(importlib.util.find_spec("pyvista"), "PyVista isn't there")
    def test_pyvista(self):
        mesh = str(examples.parent / "data/meshes/peanut.obj")
        with in_a_folder() as folder:
            self.assertIn("555 points", run("pyvista_curvature.py", mesh))
            self.assertGreater((folder / "curvature.png").stat().st_size, 1000)


if __name__ == "__main__":
    unittest.main()
