"""make_stubs.py FOLDER: writes VesicleFilters.pyi and VesicleOffscreen.pyi there, the types of the wrapped
classes, from the signatures that VTK's wrapping leaves in their docstrings. The build calls it, with the
package in PYTHONPATH."""

import importlib
import inspect
import pathlib
import re
import sys

MODULES = ("VesicleFilters", "VesicleOffscreen")
VTK = ("vtkCommonCore", "vtkCommonDataModel", "vtkCommonExecutionModel", "vtkIOCore")
PLAIN = {"str", "int", "float", "bool", "None"}
SIGNATURE = re.compile(r"^(\w+)\(([^\n]*?(?:\n +[^\n]*?)*)\)\s*->\s*([^\n]*)\nC\+\+:", re.MULTILINE)
ARGUMENT = re.compile(r"(\w+)(?::(\([^)]*\)|[^,]+))?(?:, |$)")


def stub(module):
    """The text of the module's stub."""
    classes = [value for name, value in sorted(vars(module).items())
               if inspect.isclass(value) and name.startswith("vtk") and not name.endswith("_")]
    imports = set()
    texts = [_class(cls, imports) for cls in _bases_first(classes)]
    lines = [f"from vtkmodules.{home} import {name}\n" for home, name in sorted(imports)]
    return "import typing\n\n" + "".join(lines) + "\n" + "\n".join(texts)


def _bases_first(classes):
    return sorted(classes, key=lambda cls: len(cls.__mro__))


def _class(cls, imports):
    base = _type(cls.__bases__[0].__name__, imports)
    enums = [name for name, value in vars(cls).items() if inspect.isclass(value)]
    body = [f"    class {name}(int): ...\n" for name in enums]
    body += [f"    {name}: {type(value).__name__}\n" for name, value in vars(cls).items()
             if type(value).__name__ in enums]
    for name, value in vars(cls).items():
        if callable(value) and not name.startswith("__") and name not in enums:
            body += _method(name, value.__doc__ or "", imports)
    return f"class {cls.__name__}({base}):\n" + ("".join(body) or "    ...\n")


def _method(name, documentation, imports):
    found = [match for match in SIGNATURE.finditer(documentation) if match[1] == name]
    if not found:
        raise SystemExit(f"{name}: no signature in its documentation: {documentation!r}")
    lines = []
    for match in found:
        arguments = _arguments(re.sub(r"\s+", " ", match[2]), imports)
        lines += ["    @typing.overload\n"] if len(found) > 1 else []
        lines += [] if arguments[:1] == ["self"] else ["    @staticmethod\n"]
        lines.append(f"    def {name}({', '.join(arguments)}) -> {_type(match[3].strip(), imports)}: ...\n")
    return lines


def _arguments(text, imports):
    return [name if kind == "" else f"{name}: {_type(kind, imports, given=True)}"
            for name, kind in ARGUMENT.findall(text) if name]


def _type(text, imports, given=False):
    """What is given as an argument may be any sequence where a tuple is returned."""
    if text.startswith("("):
        parts = [_type(part.strip(), imports) for part in text.strip("()").split(",")]
        return f"typing.Sequence[{parts[0]}]" if given else f"tuple[{', '.join(parts)}]"
    if text in PLAIN or text.startswith("vtkVesicle"):
        return text
    for home in VTK:
        if hasattr(importlib.import_module(f"vtkmodules.{home}"), text):
            imports.add((home, text))
            return text
    return "typing.Any"


if __name__ == "__main__":
    for name in MODULES:
        text = stub(importlib.import_module(f"vesicle.{name}"))
        pathlib.Path(sys.argv[1], f"{name}.pyi").write_text(text, encoding="utf-8")
