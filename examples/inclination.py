"""How a vesicle lies in a shear flow, by its reduced volume: a table, and a file for every other program.

    python3 inclination.py [FILE.csv]
"""

import sys

import vesicle

SCENE = {
    "name": "inclination",
    "vesicle": {"shape": "prolate", "triangles": 180, "axis": [1, 0, 0]},
    "flow": {"kind": "shear", "rate": 1.0},
    "time": {"end": 8.0, "output_every": 1.0},
}


def settled(step):
    """Ends a run where the angle no longer changes."""
    before, now = getattr(settled, "angle", None), step["inclination_deg"]
    settled.angle = now
    return step.time > 1 and before is not None and abs(now - before) < 1e-3


def main(file):
    found = {"reduced_volume": [], "inclination_deg": [], "tank_treading_frequency": []}
    for reduced_volume in (0.99, 0.95, 0.9):
        run = vesicle.run(SCENE, callback=settled, overrides={"vesicle.reduced_volume": reduced_volume})
        for name, values in found.items():
            values.append(run.diagnostics[name][-1])
    table = vesicle.Table(found)
    for i in range(table.rows):
        print("v = {reduced_volume:.2f}: {inclination_deg:.1f}°, frequency {tank_treading_frequency:.3f}".format(
            **table.row(i)))
    table.write(file)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "inclination.csv")
