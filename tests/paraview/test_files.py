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
            frame = self.frame(series, time)
            self.assertEqual(frame.FieldData["TimeValue"][0], time)
            self.assertEqual(frame.FieldData["Area"][0], float(self.rows[time]["area"]))
            self.assertEqual(frame.GetNumberOfCells(), 80)
            self.assertTrue(numpy.isfinite(frame.PointData["Velocity"]).all())

    def test_pvd(self):
        self.check(".pvd")

    def test_series(self):
        self.check(".vtu.series")

    def test_xdmf(self):
        series = simple.OpenDataFile(str(self.name) + ".xdmf")
        frames = simple.OpenDataFile(str(self.name) + ".pvd")
        self.assertEqual(list(series.TimestepValues), list(frames.TimestepValues))
        for time in frames.TimestepValues:
            self.assertIn(time, self.rows)
            found, expected = (self.frame(source, time) for source in (series, frames))
            self.assertEqual(found.GetNumberOfCells(), 80)
            self.assertTrue((found.Points == expected.Points).all())
            for name in expected.PointData.keys():
                self.assertTrue((found.PointData[name] == expected.PointData[name]).all(), name)

    def frame(self, source, time):
        source.UpdatePipeline(time)  # the function of that name takes a time of 0 for none
        data = servermanager.Fetch(source)
        while data.IsA("vtkMultiBlockDataSet"):
            data = data.GetBlock(0)
        return dataset_adapter.WrapDataObject(data)


if __name__ == "__main__":
    unittest.main(verbosity=2)
