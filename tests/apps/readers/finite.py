"""No NaN and no infinity in any text that a run leaves behind; the arrays are looked at by the
others."""
import json
import math

import common


def refuse(word):
    raise ValueError(word)


for row in common.table():
    for name, value in row.items():
        assert value == "" or math.isfinite(float(value)), (name, value)
for file in ("pear/summary.json", "pear/pear.vtu.series"):
    with open(file) as text:
        json.load(text, parse_constant=refuse)

meshio = common.module("meshio")
numpy = common.module("numpy")
for index in range(common.frames):
    mesh = meshio.read(common.frame(index, ".vtu"))
    for data in (mesh.point_data, mesh.field_data):
        for name, values in data.items():
            assert numpy.isfinite(values).all(), name
