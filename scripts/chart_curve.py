#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what `scripts/bench.sh curve --json FILE` measured into an SVG: quality against fidelity, one column a shell.

    scripts/chart_curve.py curve.json -o curve.svg

Each point is one way to finish: none, peel, full with the surface allowed to stray by 0 to 1 % of the diagonal, and the
defaults. To the left is nearer to the shell; upper row: angles, higher is better; lower row: solver work, lower is better.
"""
import argparse
import html
import json
import math

WIDTH, HEIGHT = 300, 220  # of a panel's inside
LEFT, TOP, GAP_X, GAP_Y = 70, 50, 70, 60
# What is drawn over what: quality, its name, whether on a logarithmic scale, fidelity in percent, its name.
ROWS = [("p5_dihedral_deg", "5th percentile of the smallest angles, degrees", False,
         lambda row: 100 * abs(row["volume_error"]), "volume error, %"),
        ("pcg_stiff", "iterations of the stiff step", True,
         lambda row: 100 * max(row["hausdorff_out"], row["hausdorff_in"]), "farthest stray, % of the diagonal")]
COLORS = {"none": "#b03a2e", "peel": "#d68910", "full": "#2471a3", "default": "#1e8449"}


def ticks(low, high, logarithmic):
    if logarithmic:
        powers = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
        for steps in ((1,), (1, 2, 5), (1, 1.5, 2, 3, 4, 5, 6, 7, 8, 9)):
            found = [m * 10.0**p for p in powers for m in steps if low <= m * 10.0**p <= high]
            if len(found) >= 3:
                break
        return found
    step = 10 ** math.floor(math.log10((high - low) / 2))
    step = next(step * m for m in (1, 2, 5, 10) if (high - low) / (step * m) <= 6)
    return [step * i for i in range(math.ceil(low / step), math.floor(high / step) + 1)]


class Axis:
    def __init__(self, values, size, logarithmic=False):
        self.logarithmic, self.size = logarithmic, size
        low, high = min(values), max(values)
        if logarithmic:
            self.low, self.high = low / 1.15, high * 1.15
        else:
            margin = 0.08 * (high - low) or 1
            self.low, self.high = low - margin, high + margin

    def place(self, value):
        move = math.log if self.logarithmic else float
        return self.size * (move(value) - move(self.low)) / (move(self.high) - move(self.low))

    def ticks(self):
        return ticks(self.low, self.high, self.logarithmic)


def text(x, y, words, anchor="middle", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" {more}>{html.escape(words)}</text>'


def label_of(row, last_gap):
    """The points of a full finish lie in a line: its ends are named."""
    if row["finish"] != "full":
        return row["finish"]
    gap = row["surface_gap_diagonal"]
    return f"full {100 * gap:g} %" if gap in (0, last_gap) else ""


def spread(labels):
    """Moves labels apart that would cover each other: list of (x, y, row), any order."""
    placed = []
    for x, y, row in sorted(labels, key=lambda label: label[1]):
        for _, other, _ in placed:
            if abs(y - other) < 12:
                y = other + 12
        placed.append((x, y, row))
    return placed


def panel(rows, axes, left, top):
    key, title, logarithmic, fidelity, fidelity_title = axes
    xs, ys = Axis([fidelity(r) for r in rows], WIDTH), Axis([r[key] for r in rows], HEIGHT, logarithmic)
    parts = [f'<rect x="{left}" y="{top}" width="{WIDTH}" height="{HEIGHT}" class="frame"/>']
    for tick in xs.ticks():
        x = left + xs.place(tick)
        parts.append(f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{top}" y2="{top + HEIGHT}" class="grid"/>')
        parts.append(text(x, top + HEIGHT + 14, f"{tick:.3g}"))
    for tick in ys.ticks():
        y = top + HEIGHT - ys.place(tick)
        parts.append(f'<line x1="{left}" x2="{left + WIDTH}" y1="{y:.1f}" y2="{y:.1f}" class="grid"/>')
        parts.append(text(left - 6, y + 4, f"{tick:g}", "end"))
    points = [(left + xs.place(fidelity(r)), top + HEIGHT - ys.place(r[key]), r) for r in rows]
    full = " ".join(f"{x:.1f},{y:.1f}" for x, y, r in points if r["finish"] == "full")
    parts.append(f'<polyline points="{full}" class="line"/>')
    for x, y, row in points:
        parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{COLORS[row["finish"]]}"/>')
    last_gap = max(row["surface_gap_diagonal"] for row in rows)
    points.sort(key=lambda point: label_of(point[2], last_gap) == "default")  # on top, its label last
    labels = [(x, y - 7, row) for x, y, row in points if label_of(row, last_gap)]
    for on_right in (False, True):
        for x, y, row in spread([label for label in labels if (label[0] > left + WIDTH / 2) == on_right]):
            anchor, shift = ("end", -3) if on_right else ("start", 3)
            parts.append(text(x + shift, y, label_of(row, last_gap), anchor, f'style="fill:{COLORS[row["finish"]]}"'))
    parts.append(text(left + WIDTH / 2, top + HEIGHT + 30, fidelity_title))
    parts.append(text(0, 0, title, "middle", f'transform="translate({left - 46} {top + HEIGHT / 2}) rotate(-90)"'))
    return parts


def draw(rows):
    shells = list(dict.fromkeys(row["shell"] for row in rows))
    width = LEFT + len(shells) * (WIDTH + GAP_X)
    height = TOP + len(ROWS) * (HEIGHT + GAP_Y)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}">',
             "<style>text{font:12px sans-serif;fill:#333}.frame{fill:#fff;stroke:#888}"
             ".grid{stroke:#e4e4e4}.line{fill:none;stroke:#2471a3;stroke-width:1.2}</style>",
             f'<rect width="{width}" height="{height}" fill="#fafafa"/>']
    for column, shell in enumerate(shells):
        own = [row for row in rows if row["shell"] == shell and row["tets"] is not None]
        left = LEFT + column * (WIDTH + GAP_X)
        parts.append(text(left + WIDTH / 2, TOP - 16, shell, "middle", 'style="font-weight:bold;font-size:14px"'))
        for line, axes in enumerate(ROWS):
            parts += panel(own, axes, left, TOP + line * (HEIGHT + GAP_Y))
    return "\n".join(parts + ["</svg>", ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("figures", help="JSON of scripts/bench.sh curve")
    parser.add_argument("-o", "--out", required=True, help="the SVG to write")
    args = parser.parse_args()
    with open(args.figures, encoding="utf-8") as file:
        rows = json.load(file)["rows"]
    with open(args.out, "w", encoding="utf-8") as file:
        file.write(draw(rows))


main()
