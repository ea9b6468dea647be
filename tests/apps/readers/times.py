"""The times in the three lists of frames, as plain XML and JSON parsers see them, are those of the
table's rows, to the last digit."""
import json
import os
from xml.etree import ElementTree

import common

rows = [row["time"] for row in common.table()]
pvd = ElementTree.parse("pear/pear.pvd").getroot()
xdmf = ElementTree.parse("pear/pear.xdmf").getroot()
with open("pear/pear.vtu.series") as file:
    series = json.load(file)["files"]

lists = {
    "pvd": [(entry.get("timestep"), entry.get("file")) for entry in pvd.iter("DataSet")],
    "xdmf": [(grid.find("Time").get("Value"), grid.find("Geometry/DataItem").text.split(":")[0])
             for grid in xdmf.findall("Domain/Grid/Grid")],
    "series": [(repr(entry["time"]), entry["name"]) for entry in series],
}
for name, entries in lists.items():
    assert len(entries) == common.frames, name
    for time, file in entries:
        assert float(time) in map(float, rows), (name, time)
        if name != "series":  # JSON writes 0.0
            assert time in rows, (name, time)
        assert os.path.exists(os.path.join("pear", file)), (name, file)
times = {name: [float(time) for time, _ in entries] for name, entries in lists.items()}
assert times["pvd"] == times["xdmf"] == times["series"] == [0, 0.1, 0.2], times
