#!/usr/bin/env python3
"""Draws docs/pictures/architecture.svg from the #include lines of the source.

    python3 docs/architecture-picture.py            writes the picture
    python3 docs/architecture-picture.py --list     prints who includes whom, and how often

A box is a folder, an arrow means "includes". Boxes stand above all that they include. Arrows that
follow from others (a includes b, b includes c) are left out. The order from the ground up is that of
the folders in solver/CMakeLists.txt, then vtkfilters, render, apps: an include against it is red, and
the command then ends with exit code 1.
"""

import re
import sys
from collections import Counter
from pathlib import Path

root = Path(__file__).resolve().parent.parent
picture = root / "docs/pictures/architecture.svg"

ABOUT = {
    "files": "whole files",
    "linear": "sparse Cholesky, GMRES, BLAS",
    "mesh": "triangles, shapes, resampling",
    "surface": "basis, quadrature, curvature",
    "flow": "imposed flows",
    "membrane": "force terms, incompressibility",
    "adaptation": "meshes laid anew",
    "stokes": "kernels, single layer",
    "dynamics": "system, state, step",
    "state": "run file, frames",
    "scene": "what was asked for",
    "simulation": "a scene's run",
    "vtkfilters": "VTK algorithms",
    "render": "pictures, movies",
    "apps": "the command vesicle",
}
COLORS = {"solver": "#dbe9f6", "vtkfilters": "#e2f0d9", "render": "#fff2cc", "apps": "#f8ddd0"}

WIDTH, HEIGHT = 200, 48  # of a box
GAP_X, GAP_Y, MARGIN = 34, 46, 30


def folders_in_order():
    text = (root / "solver/CMakeLists.txt").read_text()
    solver = re.search(r"foreach\(folder ([^)]*)\)", text).group(1).split()
    return solver + ["vtkfilters", "render", "apps"]


def folder_of(path, folders):
    """The box that a path from the root belongs to; None for solver's own files (errors)."""
    parts = path.parts
    name = parts[1] if parts[0] == "solver" and len(parts) > 2 else parts[0]
    return name if name in folders else None


def headers_by_name():
    """Headers of vtkfilters and render/Offscreen are included by their names alone."""
    return {file.name: file.relative_to(root)
            for folder in ("vtkfilters", "render") for file in (root / folder).rglob("*.h")}


def includes(folders):
    """How often the files of a folder include those of another."""
    by_name = headers_by_name()
    count = Counter()
    for top in ("solver", "vtkfilters", "render", "apps"):
        for file in sorted((root / top).rglob("*")):
            if file.suffix not in (".h", ".cpp", ".cxx"):
                continue
            here = folder_of(file.relative_to(root), folders)
            for name in re.findall(r'^#include "([^"]+)"', file.read_text(), flags=re.MULTILINE):
                path = Path(name) if (root / name).exists() else by_name.get(name)
                there = folder_of(path, folders) if path else None
                if here and there and here != there:
                    count[here, there] += 1
    return count


def levels(folders, edges):
    """A folder's level is one above the highest that it includes."""
    level = {}
    for folder in folders:
        level[folder] = 1 + max((level[b] for a, b in edges if a == folder and b in level), default=-1)
    return level


def without_implied(edges):
    """Edges that no path over other edges replaces."""
    above = {}
    for a, b in edges:
        above.setdefault(a, set()).add(b)

    def reaches(start, goal, seen):
        return any(n == goal or (n not in seen and reaches(n, goal, seen | {n}))
                   for n in above.get(start, ()))

    return [(a, b) for a, b in edges
            if not any(n != b and reaches(n, b, {a}) for n in above[a])]


def order_rows(rows, arrows):
    """Boxes of a row from left to right, each under those that include it."""
    place = {}
    for row in rows:  # from the top
        def wanted(folder):
            users = [place[a] for a, b in arrows if b == folder and a in place]
            return sum(users) / len(users) if users else 0
        row.sort(key=wanted)
        for i, folder in enumerate(row):
            place[folder] = i - (len(row) - 1) / 2
    return place


def draw(folders, edges):
    down = [e for e in edges if folders.index(e[0]) > folders.index(e[1])]
    up = [e for e in edges if e not in down]
    level = levels(folders, down)
    top = max(level.values())
    rows = [[f for f in folders if level[f] == k] for k in range(top, -1, -1)]
    arrows = without_implied(down)
    place = order_rows(rows, arrows)

    width = max(len(row) for row in rows) * (WIDTH + GAP_X) - GAP_X + 2 * MARGIN
    height = len(rows) * (HEIGHT + GAP_Y) - GAP_Y + 2 * MARGIN
    x = {f: width / 2 + place[f] * (WIDTH + GAP_X) for f in folders}
    y = {f: MARGIN + (top - level[f]) * (HEIGHT + GAP_Y) for f in folders}

    def box_between(a, b, at):
        """True where the straight arrow, offset by `at`, passes behind a box."""
        for f in folders:
            if f in (a, b) or not level[b] < level[f] < level[a]:
                continue
            middle = y[f] + HEIGHT / 2
            share = (middle - y[a] - HEIGHT) / (y[b] - y[a] - HEIGHT)
            if abs(x[a] + share * (x[b] - x[a]) + at - x[f]) < WIDTH / 2 + 8:
                return True
        return False

    def arrow(a, b, kind):
        xa, ya, xb, yb = x[a], y[a] + HEIGHT, x[b], y[b] - 3
        if kind == "up":
            ya, yb = y[a], y[b] + HEIGHT + 3
            return f'<path class="up" d="M{xa:.0f} {ya} C{xa:.0f} {ya - 30} {xb:.0f} {yb + 30} {xb:.0f} {yb}"/>'
        shift = 0
        if box_between(a, b, 0):
            side = (1 if x[a] + x[b] >= width else -1) * (WIDTH / 2 + 18)
            between = [f for f in folders if level[b] < level[f] < level[a]]
            edge = max(between, key=lambda f: side * x[f])
            shift = x[edge] + side
            return (f'<path class="down" d="M{xa:.0f} {ya} C{xa:.0f} {ya + GAP_Y} {shift:.0f} {ya} '
                    f'{shift:.0f} {ya + GAP_Y} L{shift:.0f} {yb - GAP_Y} '
                    f'C{shift:.0f} {yb} {xb:.0f} {yb - GAP_Y} {xb:.0f} {yb}"/>')
        return f'<path class="down" d="M{xa:.0f} {ya} L{xb:.0f} {yb}"/>'

    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height}" '
        f'viewBox="0 0 {width:.0f} {height}" font-family="sans-serif" text-anchor="middle">',
        "<!-- Made by docs/architecture-picture.py from the #include lines. -->",
        "<defs>",
        '<marker id="grey" markerWidth="9" markerHeight="8" refX="7" refY="4" orient="auto">'
        '<path d="M0 0 L8 4 L0 8 Z" fill="#666"/></marker>',
        '<marker id="red" markerWidth="9" markerHeight="8" refX="7" refY="4" orient="auto">'
        '<path d="M0 0 L8 4 L0 8 Z" fill="#c00"/></marker>',
        "</defs>",
        "<style>path.down { fill: none; stroke: #666; marker-end: url(#grey) } "
        "path.up { fill: none; stroke: #c00; stroke-width: 2; marker-end: url(#red) }</style>",
        f'<rect width="{width:.0f}" height="{height}" fill="white"/>',
    ]
    lines += [arrow(a, b, "down") for a, b in arrows]
    lines += [arrow(a, b, "up") for a, b in up]
    for f in folders:
        name = f if f in COLORS else f"solver/{f}"
        color = COLORS.get(f, COLORS["solver"])
        lines += [
            f'<rect x="{x[f] - WIDTH / 2:.0f}" y="{y[f]}" width="{WIDTH}" height="{HEIGHT}" rx="6" '
            f'fill="{color}" stroke="#444"/>',
            f'<text x="{x[f]:.0f}" y="{y[f] + 20}" font-size="15" font-weight="bold">{name}</text>',
            f'<text x="{x[f]:.0f}" y="{y[f] + 38}" font-size="12" fill="#333">{ABOUT.get(f, "")}</text>',
        ]
    picture.parent.mkdir(exist_ok=True)
    picture.write_text("\n".join(lines + ["</svg>", ""]))
    return up


def main():
    folders = folders_in_order()
    count = includes(folders)
    edges = sorted(count, key=lambda e: (folders.index(e[0]), folders.index(e[1])))
    if sys.argv[1:] == ["--list"]:
        for a, b in edges:
            print(f"{a:11} {b:11} {count[a, b]}")
        return 0
    if sys.argv[1:]:
        sys.exit(__doc__)
    up = draw(folders, edges)
    for a, b in up:
        print(f"upwards: {a} includes {b}", file=sys.stderr)
    return 1 if up else 0


if __name__ == "__main__":
    sys.exit(main())
