"""The Python programs and the notebook in examples/ run as they stand there."""

import contextlib
import importlib.util
import io
import json
import os
import pathlib
import runpy
import sys
import tempfile
import unittest

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
