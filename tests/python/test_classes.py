"""Every wrapped class: documented, its properties settable and printed."""

import inspect
import unittest

import vesicle
from vesicle import rendering


def classes():
    found = [value for module in (vesicle, rendering) for name, value in vars(module).items()
             if name.startswith("vtkVesicle") and inspect.isclass(value)]
    return list(dict.fromkeys(found))


def concrete(cls):
    """Whether it has objects; the others are superclasses."""
    try:
        return cls() is not None
    except TypeError:
        return False


def properties(cls):
    """What the class itself, or a superclass of ours, has both a Set and a Get method for."""
    own = {name for base in cls.__mro__ if base.__name__.startswith("vtkVesicle")
           for name in vars(base)}
    return sorted(name[3:] for name in own if name.startswith("Set") and "Get" + name[3:] in own)


class Classes(unittest.TestCase):
    def test_all_are_there(self):
        names = {cls.__name__ for cls in classes()}
        self.assertLessEqual({"vtkVesicleSource", "vtkVesicleCurvatureFilter", "vtkVesicleStepper",
                              "vtkVesicleForceFilter", "vtkVesicleProbeFilter",
                              "vtkVesicleMeshReader", "vtkVesicleMeshWriter", "vtkVesicleOffscreen"},
                             names)

    def test_every_class_is_documented(self):
        for cls in classes():
            self.assertGreater(len(cls.__doc__), 100, cls.__name__)

    def test_every_property_is_documented_and_printed(self):
        for cls in filter(concrete, classes()):
            instance = cls()
            for name in properties(cls):
                with self.subTest(cls=cls.__name__, property=name):
                    self.assertIn(f"{name}:", str(instance))
                    documented = any(
                        len(getattr(cls, prefix + name).__doc__.split("\n", 3)[-1].strip()) > 20
                        for prefix in ("Set", "Get"))
                    self.assertTrue(documented)

    def test_enumerations(self):
        source = vesicle.vtkVesicleSource()
        source.SetShape(vesicle.vtkVesicleSource.Oblate)
        self.assertEqual(source.GetShapeName(), "oblate")
        source.SetBasis(vesicle.vtkVesicleSource.Linear)
        self.assertEqual(source.GetBasis(), 0)
        source.SetShapeByName("prolate")
        self.assertEqual(source.GetShape(), vesicle.vtkVesicleSource.Prolate)


if __name__ == "__main__":
    unittest.main()
