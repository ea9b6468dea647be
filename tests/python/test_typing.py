"""Types: the stubs name what the package has, functions say what they take, mypy (where it is) agrees."""

import ast
import importlib.util
import inspect
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import vesicle
from vesicle import VesicleFilters, VesicleOffscreen

package = pathlib.Path(vesicle.__file__).parent

USES = '''
import numpy
import vesicle

run = vesicle.run("pear.toml", callback=lambda step: step.time > 1, overrides={"vesicle.triangles": 320})
points: numpy.ndarray = run.frames[0].points
area: numpy.ndarray = run.diagnostics["area"]
stepper = vesicle.vtkVesicleStepper()
time: float = stepper.GetStateTime()
stepper.SetFlowAxis((0, 0, 1))
stepper.SetFlowAxis(0, 0, 1)
'''
ABUSES = "stepper.SetTolerance('a')", "vesicle.run(3)", "vesicle.open_run()"


def stubs():
    for module in (VesicleFilters, VesicleOffscreen):
        file = package / (module.__name__.rpartition(".")[2] + ".pyi")
        for node in ast.parse(file.read_text()).body:
            if isinstance(node, ast.ClassDef):
                yield getattr(module, node.name), node


def names(node):
    return {getattr(part, "name", None) or getattr(getattr(part, "target", None), "id", None)
            for part in node.body} - {None}


class Types(unittest.TestCase):
    def test_the_package_is_marked(self):
        self.assertTrue((package / "py.typed").exists())
        self.assertRegex(vesicle.__version__, r"^\d+\.\d+\.\d+$")

    def test_stubs_name_what_the_classes_have(self):
        found = {cls.__name__: names(node) for cls, node in stubs()}
        self.assertLessEqual({"vtkVesicleStepper", "vtkVesicleSeriesWriter", "vtkVesicleOffscreen"}, set(found))
        for cls, node in stubs():
            with self.subTest(cls=cls.__name__):
                self.assertEqual(names(node), {name for name in vars(cls) if not name.startswith("__")})

    def test_every_function_says_what_it_takes_and_is_documented(self):
        for name, value in inspect.getmembers(vesicle):
            if not getattr(value, "__module__", "").startswith("vesicle.") or name.startswith("vtk"):
                continue
            parts = [(name, value)]
            if inspect.isclass(value):
                parts += [(f"{name}.{key}", getattr(part, "fget", part)) for key, part in vars(value).items()
                          if not key.startswith("_") and (callable(part) or isinstance(part, property))]
            for place, part in parts:
                with self.subTest(place):
                    if inspect.isfunction(part):
                        self.assertIn("return", part.__annotations__)
                        arguments = set(inspect.signature(part).parameters) - {"self"}
                        self.assertLessEqual(arguments, set(part.__annotations__))
                    elif inspect.isclass(part):
                        self.assertGreater(len(part.__doc__ or ""), 40)

    @unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy isn't there (python3-mypy)")
    def test_mypy_agrees(self):
        with tempfile.TemporaryDirectory() as folder:
            def check(*arguments):
                return subprocess.run(
                    [sys.executable, "-m", "mypy", "--ignore-missing-imports", *arguments], cwd=folder,
                    env={**os.environ, "MYPYPATH": str(package.parent)}, capture_output=True, text=True)

            whole = check("--disallow-untyped-defs", "-p", "vesicle")
            self.assertEqual(whole.returncode, 0, whole.stdout)
            pathlib.Path(folder, "uses.py").write_text(USES)
            uses = check("uses.py")
            self.assertEqual(uses.returncode, 0, uses.stdout)
            pathlib.Path(folder, "abuses.py").write_text(USES + "\n".join(ABUSES))
            self.assertIn(f"Found {len(ABUSES)} errors", check("abuses.py").stdout)


if __name__ == "__main__":
    unittest.main()
