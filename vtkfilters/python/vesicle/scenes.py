"""Scenes and single settings as TOML."""

from __future__ import annotations

import json
import typing

import numpy

from .errors import InputError


def toml_text(scene: typing.Mapping[str, typing.Any]) -> str:
    """The TOML of a scene as nested dicts: {"name": "pear", "vesicle": {"shape": "prolate"}}. A list of
    dicts is an array of tables. Numpy's numbers and arrays are as good as Python's."""
    return _table(scene, "")


def override_texts(overrides: typing.Any) -> list[str]:
    """Settings as "table.key=value", from such strings, or from {"table.key": value}."""
    if overrides is None:
        return []
    if isinstance(overrides, str):
        return [overrides]
    if isinstance(overrides, typing.Mapping):
        return [f"{key}={_value(value, key)}" for key, value in overrides.items()]
    return [str(setting) for setting in overrides]


def _table(table: typing.Mapping[str, typing.Any], prefix: str) -> str:
    """Plain values first: what follows a header belongs to it."""
    text = ""
    below = ""
    for key, value in table.items():
        name = prefix + str(key)
        if isinstance(value, typing.Mapping):
            below += f"\n[{name}]\n" + _table(value, name + ".")
        elif isinstance(value, (list, tuple)) and value and isinstance(value[0], typing.Mapping):
            below += "".join(f"\n[[{name}]]\n" + _table(entry, name + ".") for entry in value)
        else:
            text += f"{key} = {_value(value, name)}\n"
    return text + below


def _value(value: typing.Any, name: str) -> str:
    if isinstance(value, (numpy.generic, numpy.ndarray)):
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(entry, name) for entry in value) + "]"
    if isinstance(value, str) or hasattr(value, "__fspath__"):
        return json.dumps(str(value), ensure_ascii=False)
    raise InputError(f"setting {name}: a {type(value).__name__} is no value of a scene; allowed: numbers, "
                     "words, true and false, and lists of them")
