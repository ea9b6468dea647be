#!/usr/bin/env python3
"""Markdown tables of what vesicle_benchmarks has measured.

    python3 tests/benchmarks/tables.py build/release/benchmarks/*.json
    python3 tests/benchmarks/tables.py --into docs/performance.md build/release/benchmarks/*.json

Google Benchmark's JSON in, tables out, or into a page between two marks. What is given in part
gives tables in part.
"""

import json
import math
import pathlib
import statistics
import sys

MARKS = "<!-- measured -->\n", "<!-- end of what was measured -->\n"
SIZES = [320, 1280, 5120, 20480, 81920]
THREADS = 2
SETS = ["AVX-512", "AVX2"]  # the widest first
PRECISIONS = ["double", "single"]

STEP_GOALS = {320: 4, 1280: 25, 5120: 250, 20480: 2000}  # milliseconds
MEMORY_GOALS = {320: 100, 1280: 250, 5120: 800, 20480: 3000}  # MB
SIDES = [1, 2, 4, 8]  # of cubes of vesicles
SEVERAL_GOALS = {64: (2000, 2000)}  # vesicles: milliseconds, MB
PROCESSORS_GOAL = 1.8  # of two, from 1,280 triangles on
KERNEL_GOAL = 0.85  # of the loop written by hand
PAPER_GOAL = 100  # times the time of the default preset

PARTS = [
    ("space", "basis, tables, patterns (once a mesh)"),
    ("rules", "quadrature rules of the layer (once a mesh)"),
    ("shape", "shape: surface, forces, constraint"),
    ("layer", "layer: geometry, corrections"),
    ("apply/double", "layer applied, double precision"),
    ("apply/single", "layer applied, single precision"),
    ("tree", "layer: the same and clusters"),
    ("tree/double", "layer applied by clusters, to 1e-7"),
    ("tree/single", "layer applied by clusters, single precision"),
    ("preconditioner/tension", "preconditioner, tension (kept while it does)"),
    ("preconditioner/bending", "preconditioner, bending"),
    ("precondition", "preconditioner applied"),
    ("solve", "linear solve of a stage"),
    ("motion", "motion of the mesh"),
    ("projection", "projection of area and volume"),
    ("diagnostics", "diagnostics"),
]
TERMS = [  # scenes without and with it
    ("gravity", "at-rest", "gravity"),
    ("flow", "at-rest", "flow"),
    ("spontaneous curvature", "at-rest", "spontaneous-curvature"),
    ("area difference", "at-rest", "area-difference"),
    ("bending", "flow-without-bending", "flow"),
    ("tension", "flow-without-tension", "flow"),
]
QUANTITIES = {"energy": "E, v = .8", "pear-speed": "pear's speed", "shear-angle": "angle in shear"}
MILLISECONDS = {"ns": 1e-6, "us": 1e-3, "ms": 1, "s": 1e3}


class Measured:
    """All repetitions by the benchmark's name, without what Google Benchmark adds to it."""

    def __init__(self, files):
        self.context, self.runs = {}, {}
        for file in files:
            with open(file, encoding="utf-8") as stream:
                content = json.load(stream)
            self.context = content["context"]
            for run in content["benchmarks"]:
                if run["run_type"] == "iteration" and not run.get("error_occurred"):
                    self.runs.setdefault(plain_name(run["name"]), []).append(run)

    def has(self, name):
        return name in self.runs

    def median(self, name, field):
        return statistics.median(run[field] for run in self.runs[name])

    def best(self, name, field):
        return max(run[field] for run in self.runs[name])

    def least(self, name, field):
        return min(run[field] for run in self.runs[name])

    def wall(self, name):
        """Milliseconds."""
        return self.median(name, "real_time") * self.unit(name)

    def cpu(self, name):
        return self.median(name, "cpu_time") * self.unit(name)

    def unit(self, name):
        return MILLISECONDS[self.runs[name][0]["time_unit"]]


def plain_name(name):
    added = ("iterations:", "repeats:", "min_time:", "process_time", "real_time")
    return "/".join(part for part in name.split("/") if not part.startswith(added))


def number(x):
    """Three digits, all of whole numbers."""
    if x != 0 and not 1e-2 <= abs(x) < 1e7:
        mantissa, exponent = f"{x:.1e}".split("e")
        return f"{mantissa}e{int(exponent)}"
    if math.isclose(x, round(x)):
        return f"{x:,.0f}"
    digits = 2 - math.floor(math.log10(abs(x)))
    return f"{round(x, digits):,.{max(0, digits)}f}"


def given(x):
    return "" if x is None else number(x)


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return lines + ["| " + " | ".join(row) + " |" for row in rows]


def step(scene, size, threads=THREADS):
    return f"Step/{scene}/{size}/threads:{threads}"


def sizes_with(measured, name):
    return [size for size in SIZES if measured.has(name(size))]


class Goals:
    def __init__(self):
        self.missed, self.met = [], 0

    def at_most(self, what, value, goal, unit=""):
        self.note(value <= goal, f"{what}: {number(value)}{unit}, at most {number(goal)}{unit}")

    def at_least(self, what, value, goal):
        self.note(value >= goal, f"{what}: {number(value)}, at least {number(goal)}")

    def note(self, met, text):
        if met:
            self.met += 1
        else:
            self.missed.append(text)

    def lines(self):
        if not self.missed:
            return [f"All {self.met} goals are met."]
        return [f"Goals met: {self.met}. Missed:", ""] + [f"- {text}" for text in self.missed]


def kernel_table(measured, goals):
    rows = []

    def row(name, key, by_hand):
        ours = measured.best(key, "pairs/s")
        limit = measured.best(by_hand, "pairs/s")
        peak = measured.best(by_hand.replace("ByHand", "Peak"), "flop/s")
        goals.at_least(f"{name}, of the loop by hand", ours / limit, KERNEL_GOAL)
        rows.append([name, number(peak / 1e9), number(limit / 1e9), number(ours / 1e9),
                     number(ours / limit)])

    for precision in PRECISIONS:
        there = [s for s in SETS if measured.has(f"ByHand/{s}/{precision}")]
        for instructions in there:
            key = f"{instructions}/{precision}"
            row(f"kernel, {instructions}, {precision}", f"Kernel/{key}", f"ByHand/{key}")
        if there:
            row(f"direct sum, {precision}", f"DirectSum/{precision}",
                f"ByHand/{there[0]}/{precision}")
    header = ["one core", "peak, Gflop/s", "by hand, Gpairs/s", "ours, Gpairs/s", "ratio"]
    return table(header, rows) if rows else []


def lower_bound(measured, size):
    """Milliseconds that the pairs of a pear's step take where all cores run the loop by hand."""
    solve = f"Part/solve/{size}"
    sets = [s for s in SETS if measured.has(f"ByHand/{s}/double")]
    if not measured.has(solve) or not sets:
        return None
    double, single = (measured.median(solve, f"applies_{p}") for p in PRECISIONS)
    # Both stages begin with the velocity of the first guess.
    applies = measured.median(step("pear", size), "gmres") + 2
    seconds_a_pair = sum(
        share / measured.best(f"ByHand/{sets[0]}/{precision}", "pairs/s")
        for precision, share in zip(PRECISIONS, (double, single))) / (double + single)
    return 1e3 * measured.median(solve, "pairs") * applies * seconds_a_pair / THREADS


def step_table(measured, goals):
    rows, before = [], None
    for size in sizes_with(measured, lambda size: step("pear", size)):
        wall = measured.wall(step("pear", size))
        exponent = math.log(wall / before[1]) / math.log(size / before[0]) if before else None
        before = size, wall
        row = [f"{size:,}", number(wall), given(STEP_GOALS.get(size)), given(exponent),
               number(measured.median(step("pear", size), "gmres"))]
        for scene, field in [("tank-treading", None), ("tank-treading", "gmres"), ("pear-fast", None)]:
            name = step(scene, size)
            there = measured.has(name)
            row.append(given((measured.median(name, field) if field else measured.wall(name))
                             if there else None))
        rows.append(row)
        if size in STEP_GOALS:
            goals.at_most(f"step, {size:,} triangles", wall, STEP_GOALS[size], " ms")
    header = ["triangles", "pear, ms", "goal", "exponent", "iterations", "tank-treading, ms",
              "iterations", "pear, `fast`, ms"]
    return table(header, rows) if rows else []


def resource_table(measured, goals):
    rows = []
    for size in sizes_with(measured, lambda size: step("pear", size)):
        name, alone = step("pear", size), step("pear", size, 1)
        wall, cpu = measured.wall(name), measured.cpu(name)
        memory, bound = measured.least(name, "memory") / 1e6, lower_bound(measured, size)
        rows.append([f"{size:,}", number(cpu), number(cpu / wall),
                     given(measured.wall(alone) / wall if measured.has(alone) else None),
                     given(bound / wall if bound else None), number(memory),
                     given(MEMORY_GOALS.get(size))])
        if size >= 1280:
            goals.at_least(f"processors, {size:,} triangles", cpu / wall, PROCESSORS_GOAL)
        if size in MEMORY_GOALS:
            goals.at_most(f"memory, {size:,} triangles", memory, MEMORY_GOALS[size], " MB")
    header = ["triangles", "CPU ms", "processors used", "one thread / two", "lower bound / step",
              "memory, MB", "goal"]
    return table(header, rows) if rows else []


def several_table(measured, goals):
    rows, before = [], None
    for side in SIDES:
        name, count = f"Several/step/side:{side}/threads:{THREADS}", side**3
        if not measured.has(name):
            continue
        wall, cpu = measured.wall(name), measured.cpu(name)
        memory = measured.least(name, "memory") / 1e6
        exponent = math.log(cpu / before[1]) / math.log(count / before[0]) if before else None
        before = count, cpu
        time_goal, memory_goal = SEVERAL_GOALS.get(count, (None, None))
        rows.append([number(count), number(wall), given(time_goal), number(cpu / count), given(exponent),
                     number(measured.median(name, "gmres")), number(memory), given(memory_goal)])
        if time_goal:
            goals.at_most(f"step, {count:,} vesicles", wall, time_goal, " ms")
            goals.at_most(f"memory, {count:,} vesicles", memory, memory_goal, " MB")
    header = ["vesicles", "ms a step", "goal", "CPU ms a vesicle", "exponent", "iterations", "memory, MB",
              "goal"]
    return table(header, rows) if rows else []


def part_table(measured):
    sizes = sizes_with(measured, lambda size: f"Part/solve/{size}")
    rows = []
    for key, title in PARTS:
        names = [f"Part/{key}/{size}" for size in sizes]
        if names and all(measured.has(name) for name in names):
            rows.append([title] + [number(measured.wall(name)) for name in names]
                        + [number(measured.cpu(names[-1]) / measured.wall(names[-1]))])
    header = ["ms, two threads"] + [f"{size:,}" for size in sizes] + ["processors used"]
    return table(header, rows) if rows else []


def term_table(measured):
    rows = []
    for term, *scenes in TERMS:
        names = [f"Term/{scene}" for scene in scenes]
        if all(measured.has(name) for name in names):
            rows.append([term] + [number(measured.cpu(name)) for name in names]
                        + [number(measured.median(name, "gmres")) for name in names])
    header = ["term", "without, CPU ms", "with, CPU ms", "iterations without", "with"]
    return table(header, rows) if rows else []


def paper_table(measured, goals):
    rows = []
    for key, title in QUANTITIES.items():
        coarse, balanced = (f"EqualError/{key}/balanced/{n}" for n in (80, 320))
        paper = {n: f"EqualError/{key}/paper/{n}" for n in (640, 1280, 2560)}
        paper = {n: name for n, name in paper.items() if measured.has(name)}
        if not measured.has(coarse) or not measured.has(balanced) or len(paper) < 2:
            continue
        errors = {n: measured.median(name, "error") for n, name in paper.items()}
        order = -statistics.linear_regression([math.log(n) for n in errors],
                                              [math.log(e) for e in errors.values()]).slope
        # In the paper's favour: an order of at least 1, and a time that grows as N² only, as its
        # columns do, when its factorisation grows as N³ and its steps get shorter.
        finest, error = max(paper), measured.median(balanced, "error")
        finer = (errors[finest] / error) ** (1 / max(1, order))
        seconds = measured.cpu(paper[finest]) / 1e3 * finer**2
        ratio = seconds / (measured.cpu(balanced) / 1e3)
        goals.at_least(f"paper's time at equal error, {title}", ratio, PAPER_GOAL)
        cells = [f(name) for name in (coarse, balanced, paper[finest])
                 for f in (lambda n: measured.median(n, "error"), lambda n: measured.cpu(n) / 1e3)]
        rows.append([title] + [number(x) for x in [*cells, order, finest * finer, seconds, ratio]])
    header = ["", "balanced, 80: error", "CPU s", "balanced, 320: error", "CPU s",
              "paper, finest: error", "CPU s", "its order in N",
              "extrapolated to balanced, 320: triangles", "CPU s", "times balanced's"]
    return table(header, rows) if rows else []


def linear_table(measured):
    kinds = ["eigen", "double", "single"]
    names = [f"Linear/{task}/{kind}" for task in ("factor", "solve") for kind in kinds]
    names += ["Linear/columns", "Linear/factor/dense"]
    rows = [[f"{size:,}"] + [number(measured.cpu(f"{name}/{size}")) for name in names]
            for size in SIZES if all(measured.has(f"{name}/{size}") for name in names)]
    header = ["CPU ms", "factor: Eigen's `SimplicialLDLT`", "double", "single", "solve: Eigen",
              "double", "single", "flat: columns", "LU"]
    return table(header, rows) if rows else []


def report(measured):
    goals = Goals()
    sections = [
        ("Kernels", kernel_table(measured, goals)),
        ("Steps", step_table(measured, goals)),
        ("What a pear's step takes", resource_table(measured, goals)),
        ("Several vesicles of 320 triangles", several_table(measured, goals)),
        ("What it is made of", part_table(measured)),
        ("Terms, 1,280 triangles", term_table(measured)),
        ("The paper's scheme", paper_table(measured, goals)),
        ("Factorisations", linear_table(measured)),
        ("Goals", goals.lines()),
    ]
    machine = f"{measured.context.get('processor') or 'A processor'}, {measured.context['num_cpus']} cores."
    parts = [machine] + ["\n".join([f"### {title}", "", *lines]) for title, lines in sections if lines]
    return "\n\n".join(parts) + "\n"


def put_into(page, text):
    """Between the page's marks."""
    before, rest = page.read_text(encoding="utf-8").split(MARKS[0])
    after = rest.split(MARKS[1])[1]
    page.write_text(f"{before}{MARKS[0]}\n{text}\n{MARKS[1]}{after}", encoding="utf-8")


def main(arguments):
    if arguments[0] == "--into":
        put_into(pathlib.Path(arguments[1]), report(Measured(arguments[2:])))
    else:
        print(report(Measured(arguments)), end="")


if __name__ == "__main__":
    main(sys.argv[1:])
