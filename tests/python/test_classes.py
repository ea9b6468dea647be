"""Every wrapped class: documented, its properties settable and printed."""

import inspect
import unittest

import vesicle
from vesicle import rendering


def classes():
    found = [value for module in (vesicle, rendering) for name, value in vars(module).items()
             if name.startswith("vtkVesicle") and inspect.isclass(value)]
    return list(dict.fromkeys(found))


def properties(cls):
    """What the class itself, not its superclass, has both a Set and a Get method for."""
    own = vars(cls)
    return [name[3:] for name in own if name.startswith("Set") and "Get" + name[3:] in own]


def first_instance(cls):
    """Of the class, or where it is abstract of one derived from it."""
    try:
        return cls()
    except TypeError:
        return next(other() for other in classes() if issubclass(other, cls) and other is not cls)


class Classes(unittest.TestCase):
    def test_all_are_there(self):
        names = {cls.__name__ for cls in classes()}
        self.assertLessEqual({"vtkVesicleSource", "vtkVesicleCurvatureFilter", "vtkVesicleStepper",
                              "vtkVesicleMeshReader", "vtkVesicleMeshWriter", "vtkVesicleOffscreen"},
                             names)

    def test_every_class_is_documented(self):
        for cls in classes():
            self.assertGreater(len(cls.__doc__), 100, cls.__name__)

    def test_every_property_is_documented_and_printed(self):
        for cls in classes():
            instance = first_instance(cls)
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
        source.SetShapeByName("prolate")
        self.assertEqual(source.GetShape(), vesicle.vtkVesicleSource.Prolate)


if __name__ == "__main__":
    unittest.main()
