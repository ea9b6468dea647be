"""Scenes run from Python: as the command runs them, followed by callbacks, ended, failed, and read again."""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tomllib
import unittest

import numpy
import vesicle
from support import source_folder, temporary_folder
from vesicle import blas, scenes

SMALL = {"vesicle.triangles": 80, "time.end": 1.0, "time.output_every": 0.25}
SCENE = source_folder / "data/scenes/tank-treading.toml"
# Here numpy has loaded OpenBLAS, with whatever kernel it chose.
ONE_KERNEL = {**os.environ, "OPENBLAS_CORETYPE": "Prescott"}


def small_run(**options):
    return vesicle.run(SCENE, overrides=SMALL, **options)


def command(*arguments):
    return subprocess.run([os.environ["VESICLE_COMMAND"], *arguments], env=ONE_KERNEL, capture_output=True,
                          text=True, timeout=120)


def assert_same_frames(found, expected):
    assert len(found) == len(expected), (len(found), len(expected))
    for one, other in zip(found, expected):
        numpy.testing.assert_array_equal(one.points, other.points)
        numpy.testing.assert_array_equal(one.triangles, other.triangles)
        assert one.arrays.keys() == other.arrays.keys()
        for name in one.arrays:
            numpy.testing.assert_array_equal(one[name], other[name], name)
        assert one.field.keys() == other.field.keys()
        for name, value in one.field.items():
            numpy.testing.assert_array_equal(value, other.field[name], name)


class Running(unittest.TestCase):
    def test_as_the_command_does(self):
        with temporary_folder() as folder:
            theirs = command("run", str(SCENE), "-o", "theirs", "--no-movie", "--no-plots", "--quiet",
                             *(part for key, value in SMALL.items() for part in ("--set", f"{key}={value}")))
            self.assertEqual(theirs.returncode, 0, theirs.stderr)
            subprocess.run([sys.executable, "-c", f"import vesicle; vesicle.run({str(SCENE)!r}, "
                            f"overrides={SMALL}, output='ours')"], env=ONE_KERNEL, check=True, timeout=120)
            for name in ("tank-treading.csv", "tank-treading.pvd", "tank-treading.vtu.series",
                         "tank-treading.xdmf", "frames/tank-treading_000004.vtu"):
                self.assertEqual((folder / "ours" / name).read_bytes(),
                                 (folder / "theirs" / name).read_bytes(), name)
            ours, theirs = vesicle.open_run("ours"), vesicle.open_run("theirs")
            assert_same_frames(ours, theirs)
            self.assertEqual(ours.scene, theirs.scene)
            self.assertEqual((ours.outcome, theirs.outcome), ("finished", "finished"))
            self.assertIn("tank-treading", command("info", "ours").stdout)

    def test_in_memory_as_on_the_disk(self):
        with temporary_folder():
            kept, written = small_run(), small_run(output="run")
            assert_same_frames(kept, written)
            for name in kept.diagnostics:
                numpy.testing.assert_array_equal(kept.diagnostics[name], written.diagnostics[name])
            self.assertIsNone(kept.folder)
            self.assertEqual(written.folder, pathlib.Path("run"))

    def test_frames_and_tables(self):
        run = small_run()
        self.assertEqual([frame.time for frame in run], [0, 0.25, 0.5, 0.75, 1])
        numpy.testing.assert_array_equal(run.states["TimeValue"], [0, 0.25, 0.5, 0.75, 1])
        frame = run[-1]
        self.assertEqual((frame.points.shape, frame.triangles.shape), ((42, 3), (80, 3)))
        self.assertEqual(frame["Velocity"].shape, (42, 3))
        last = run.diagnostics.row(-1)
        self.assertEqual((last["time"], last["area"]), (1, frame.field["Area"]))
        late = run.diagnostics.where(run.diagnostics["time"] > 0.5)
        self.assertEqual(late["time"].min(), run.diagnostics["time"][run.diagnostics["time"] > 0.5][0])
        with self.assertRaisesRegex(KeyError, "'Nothing'; there are: .*Velocity"):
            frame["Nothing"]
        with self.assertRaisesRegex(KeyError, "'nothing'; there are: .*area"):
            run.diagnostics["nothing"]

    def test_arrays_stay_what_they_are(self):
        run = small_run()
        points, speed = run[0].points, run[0]["Velocity"]
        kept = points.copy(), speed.copy()
        del run
        numpy.testing.assert_array_equal(points, kept[0])
        numpy.testing.assert_array_equal(speed, kept[1])
        self.assertEqual((points.dtype, points.flags["C_CONTIGUOUS"], type(points)), (float, True, numpy.ndarray))

    def test_of_several_vesicles(self):
        with temporary_folder():
            run = vesicle.run(source_folder / "data/scenes/pair.toml", output="pair",
                              overrides={"vesicle.triangles": 80, "time.end": 0.1})
            self.assertEqual(set(run.diagnostics["vesicle"]), {0, 1})
            self.assertEqual(run.diagnostics.rows, 2 * len(set(run.diagnostics["step"])))
            self.assertEqual(set(run[-1]["Vesicle_Id"]), {0, 1})
            summary = json.loads(pathlib.Path("pair/summary.json").read_text())
            self.assertEqual([final["triangles"] for final in summary["final"]], [80, 80])
            self.assertLess(summary["final"][0]["centroid_x"], summary["final"][1]["centroid_x"])

    def test_until_it_is_steady(self):
        run = vesicle.run(source_folder / "data/scenes/relax-prolate.toml", overrides={
            "vesicle.triangles": 80, "time.end": "steady", "vesicle.reduced_volume": 0.99})
        self.assertEqual(run.outcome, "steady")
        self.assertEqual(run[-1].time, run.diagnostics["time"][-1])

    def test_from_a_start_of_ones_own(self):
        start = small_run()[2]
        again = small_run(start=start)
        numpy.testing.assert_allclose(again[0].points, start.points, atol=1e-12)
        mesh = vesicle.make_mesh(start.points, start.triangles)
        assert_same_frames(small_run(start=mesh), small_run(start=vesicle.make_mesh(
            start.points.tolist(), start.triangles.astype(numpy.uint8)[:, :])))


class Scenes(unittest.TestCase):
    def test_a_path_text_and_dicts_are_the_same(self):
        text = SCENE.read_text()
        runs = [small_run(), vesicle.run(text, overrides=SMALL),
                vesicle.run(tomllib.loads(text), overrides=[f"{k}={v}" for k, v in SMALL.items()])]
        for run in runs[1:]:
            assert_same_frames(run, runs[0])
        assert_same_frames(vesicle.run(runs[0].scene), runs[0])

    def test_dicts_as_toml(self):
        scene = {"name": 'a "name" \\ of\nÅ', "yes": True, "count": numpy.int64(3), "size": numpy.float64(0.1),
                 "axis": numpy.array([0.0, 0.5, 1.0]), "modes": [[2, 0, 0.1]], "tiny": 1e-300,
                 "table": {"below": {"key": 1}, "plain": "word"}, "vesicle": [{"a": 1, "b": {"c": 2}}, {"a": 2}]}
        again = tomllib.loads(scenes.toml_text(scene))
        self.assertEqual(again, {**scene, "axis": [0.0, 0.5, 1.0]})

    def test_overrides(self):
        self.assertEqual(scenes.override_texts({"a.b": "steady", "c.d": (1, 2)}), ['a.b="steady"', "c.d=[1, 2]"])
        self.assertEqual(scenes.override_texts("a.b=1"), ["a.b=1"])
        self.assertEqual(scenes.override_texts(None), [])
        with self.assertRaisesRegex(vesicle.InputError, "flow.rate: a object"):
            scenes.override_texts({"flow.rate": object()})


class Callbacks(unittest.TestCase):
    def test_get_the_start_and_every_step(self):
        steps = []
        run = small_run(callback=lambda step: steps.append((step.number, step.time, step["area"], step.frame)))
        numbers, times, areas, frames = zip(*steps)
        numpy.testing.assert_array_equal(numbers, run.diagnostics["step"])
        numpy.testing.assert_array_equal(times, run.diagnostics["time"])
        numpy.testing.assert_array_equal(areas, run.diagnostics["area"])
        assert_same_frames([frame for frame in frames if frame.time in (0, 0.25, 0.5, 0.75, 1)], run)

    def test_end_the_run_by_true(self):
        with temporary_folder():
            run = small_run(callback=lambda step: numpy.bool_(step.time > 0.4), output="run")
            self.assertEqual(run.outcome, "interrupted")
            times = run.diagnostics["time"]
            self.assertTrue(times[-2] <= 0.4 < times[-1] < 0.5)
            self.assertEqual([frame.time for frame in run], [0, 0.25, times[-1]])
        start = small_run(callback=lambda step: True)
        self.assertEqual((len(start), start.diagnostics.rows), (1, 1))

    def test_raise_what_they_raise(self):
        def fail(step):
            if step.number == 3:
                raise ZeroDivisionError("mine")

        with temporary_folder():
            with self.assertRaisesRegex(ZeroDivisionError, "mine"):
                small_run(callback=fail, output="run")
            run = vesicle.open_run("run")
            self.assertEqual((run.outcome, run.diagnostics["step"][-1]), ("interrupted", 3))
            self.assertEqual(run[-1].time, run.diagnostics["time"][-1])

    def test_ctrl_c_leaves_what_there_is(self):
        with temporary_folder():
            with self.assertRaises(KeyboardInterrupt):
                small_run(output="run", callback=lambda step: step.number == 2 and os.kill(
                    os.getpid(), signal.SIGINT))
            self.assertEqual(vesicle.open_run("run").outcome, "interrupted")

    def test_frames_are_those_of_the_step(self):
        kept = []
        small_run(callback=kept.append)
        with self.assertRaisesRegex(vesicle.InputError, "step 0 is over"):
            kept[0].frame


class Failures(unittest.TestCase):
    def test_the_scene_is_named_and_nothing_left(self):
        with temporary_folder() as folder:
            for scene, text in (("missing.toml", "missing.toml"), ({"name": "x", "vessel": {}}, "vessel"),
                                ("name = 1\n", "name")):
                with self.assertRaisesRegex(vesicle.Error, text):
                    vesicle.run(scene, output="run")
            self.assertFalse((folder / "run").exists())

    def test_an_existing_folder_is_left_alone(self):
        with temporary_folder() as folder:
            (folder / "run").mkdir()
            (folder / "run/mine.txt").write_text("mine")
            with self.assertRaisesRegex(vesicle.InputError, "run: the folder isn't empty"):
                small_run(output="run")
            with self.assertRaisesRegex(vesicle.Error, "mine.txt"):
                small_run(output="run/mine.txt")
            self.assertEqual([file.name for file in (folder / "run").iterdir()], ["mine.txt"])

    def test_what_could_not_go_on_has_its_last_good_state(self):
        with temporary_folder():
            with self.assertRaises(vesicle.Error) as caught:
                vesicle.run(SCENE, output="run", overrides={
                    "vesicle.triangles": 80, "time.step": 50.0, "time.end": 100.0,
                    "time.output_every": 50.0, "flow.rate": 30.0})
            run = caught.exception.run
            self.assertEqual((run.outcome, run.message), ("failed", str(caught.exception)))
            self.assertEqual(run[-1].time, run.diagnostics["time"][-1])
            self.assertEqual(vesicle.open_run("run").message, run.message)


class Kernels(unittest.TestCase):
    def test_are_chosen_by_the_processors_flags(self):
        for words, kernel in (("GenuineIntel fma avx2 avx512f avx512dq avx512bw avx512vl", "SKYLAKEX"),
                              ("AuthenticAMD fma avx2", None), ("GenuineIntel fma avx2", "HASWELL"), ("", None)):
            self.assertEqual(blas._kernel(words), kernel)


class Tables(unittest.TestCase):
    def test_are_the_same_when_written_and_read(self):
        table = vesicle.Table({"a": [1, 0.1, numpy.nan], "b": [1e-300, -2, 1 / 3]})
        with temporary_folder():
            table.write("table.csv")
            again = vesicle.read_table("table.csv")
            with self.assertRaisesRegex(vesicle.Error, "nowhere/table.csv: can't be written"):
                table.write("nowhere/table.csv")
        for name in table:
            numpy.testing.assert_array_equal(again[name], table[name])
        with self.assertRaisesRegex(vesicle.InputError, "one length, not a 1, b 2"):
            vesicle.Table({"a": [1], "b": [1, 2]})


class Opening(unittest.TestCase):
    def test_folders_without_one_run(self):
        with temporary_folder() as folder:
            with self.assertRaisesRegex(vesicle.Error, "nowhere: there is no such folder"):
                vesicle.open_run("nowhere")
            with self.assertRaisesRegex(vesicle.Error, "there is no run in this folder"):
                vesicle.open_run(folder)
            for name in ("a", "b"):
                (folder / f"{name}.vtu.series").write_text('{"files": []}')
                (folder / f"{name}.csv").write_text("step,time\n0,0\n")
            with self.assertRaisesRegex(vesicle.Error, "several runs .*a.vtu.series"):
                vesicle.open_run(folder)
            self.assertEqual(vesicle.open_run(folder / "b.vtu.series").name, "b")

    def test_under_way(self):
        with temporary_folder() as folder:
            small_run(output="run")
            (folder / "run/summary.json").unlink()
            run = vesicle.open_run("run")
            self.assertEqual((run.outcome, run.settings, len(run)), ("running", "", 5))
            self.assertEqual([frame.time for frame in run[1:3]], [0.25, 0.5])

    def test_damaged_files_are_named(self):
        with temporary_folder() as folder:
            (folder / "a.vtu.series").write_text('{"files": [{"name": "frames/a.vtu"}]}')
            for text, error in (("", "first line"), ("a,b\n1,2\n3\n", "a.csv:3: 1 fields"),
                                ("a\nx\n", "a.csv:2: .*'x'")):
                (folder / "a.csv").write_text(text)
                with self.assertRaisesRegex(vesicle.Error, error):
                    vesicle.open_run(folder)
            (folder / "a.csv").write_text("step,tilt_deg\n1,\n")
            run = vesicle.open_run(folder)
            self.assertTrue(numpy.isnan(run.diagnostics["tilt_deg"][0]))
            with self.assertRaisesRegex(vesicle.Error, "frames/a.vtu"):
                run[0]
            for text in ("{", "[]", json.dumps({"files": [1]})):
                (folder / "a.vtu.series").write_text(text)
                with self.assertRaisesRegex(vesicle.Error, "a.vtu.series: is no list"):
                    vesicle.open_run(folder)


if __name__ == "__main__":
    unittest.main()
