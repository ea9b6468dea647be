"""ParaView opens what a run leaves behind; times are those of the table to the last digit."""

import csv
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy
from paraview import servermanager, simple
from paraview.vtk.numpy_interface import dataset_adapter

scene = Path(os.environ["VESICLE_SOURCE_DIR"], "data/scenes/tank-treading.toml")


class Files(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        run = Path(cls.folder.name, "run")
        subprocess.run([os.environ["VESICLE_COMMAND"], "run", str(scene), "-o", str(run), "--no-movie",
                        "--quiet", "--set", "vesicle.triangles=80", "--set", "time.end=0.7",
                        "--set", "time.output_every=0.1"], check=True)
        cls.name = run / "tank-treading"
        with open(cls.name.with_suffix(".csv")) as table:
            cls.rows = {float(row["time"]): row for row in csv.DictReader(table)}

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def check(self, ending):
        series = simple.OpenDataFile(str(self.name) + ending)
        times = list(series.TimestepValues)
        self.assertEqual(len(times), 8)
        for time in times:
            self.assertIn(time, self.rows)
            simple.UpdatePipeline(time, series)
            frame = dataset_adapter.WrapDataObject(servermanager.Fetch(series))
            self.assertEqual(frame.FieldData["TimeValue"][0], time)
            self.assertEqual(frame.FieldData["Area"][0], float(self.rows[time]["area"]))
            self.assertEqual(frame.GetNumberOfCells(), 80)
            self.assertTrue(numpy.isfinite(frame.PointData["Velocity"]).all())

    def test_pvd(self):
        self.check(".pvd")

    def test_series(self):
        self.check(".vtu.series")


if __name__ == "__main__":
    unittest.main(verbosity=2)
