#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Holds what `scripts/bench.sh mesh --json FILE` measured against the project's goals, and prints both as Markdown.

    scripts/mesh_goals.py mesh.json            # the goals, line by line
    scripts/mesh_goals.py mesh.json --table    # every row
"""
import argparse
import json

# The control mesh that a shipped game-physics demo made of the shell carbody, measured the same way.
SHIPPED_CARBODY = {"tets": 898, "pcg_soft": 92, "pcg_stiff": 419}


class Goals:
    def __init__(self, rows):
        self.rows = {(row["shell"], row["tool"]): row for row in rows}
        self.lines = []

    def row(self, shell, tool="crumple"):
        row = self.rows.get((shell, tool))
        return row if row and row["tets"] is not None else None

    def best_peer(self, shell, key, best):
        values = [row[key] for tool in ("tetgen", "hxt", "gmsh") if (row := self.row(shell, tool))]
        return best(values) if values else None

    def at_most(self, what, value, limit):
        self.add(what, value, "<=", limit, value is not None and limit is not None and value <= limit)

    def at_least(self, what, value, limit):
        self.add(what, value, ">=", limit, value is not None and limit is not None and value >= limit)

    def add(self, what, value, sign, limit, met):
        show = lambda number: "none" if number is None else f"{number:.4g}"
        self.lines.append((what, show(value), f"{sign} {show(limit)}", "met" if met else "**not met**"))


def judge_matched(goals):
    for shell in ("spot", "fandisk"):
        ours, hxt = goals.row(shell, "crumple_matched"), goals.row(shell, "hxt")
        if not ours or not hxt:
            continue
        at = f"{shell}, matched: "
        goals.at_most(at + "tets, share off HXT's", abs(ours["tets"] / hxt["tets"] - 1), 0.1)
        goals.at_most(at + "below 10 degrees", ours["below_10_deg"], 1 if shell == "spot" else 0.1 * hxt["below_10_deg"])
        goals.at_least(at + "p5 / HXT's", ours["p5_dihedral_deg"] / hxt["p5_dihedral_deg"], 1.35)
        goals.at_most(at + "stiff iterations / HXT's", ours["pcg_stiff"] / hxt["pcg_stiff"], 1.0)
        goals.at_least(at + "dt ratio / HXT's", ours["dt_ratio"] / hxt["dt_ratio"], 1.4)


def judge_automatic(goals):
    if spot := goals.row("spot"):
        goals.at_most("spot: below 10 degrees", spot["below_10_deg"], 0)
        goals.at_least("spot: p5", spot["p5_dihedral_deg"], 28)
        goals.at_most("spot: volume error", abs(spot["volume_error"]), 0.003)
        goals.at_most("spot: Hausdorff", max(spot["hausdorff_out"], spot["hausdorff_in"]), 0.01)
    if fandisk := goals.row("fandisk"):
        goals.at_most("fandisk: below 10 degrees", fandisk["below_10_deg"], 30)
        goals.at_most("fandisk: volume error", abs(fandisk["volume_error"]), 0.005)
    for shell in ("bonnet", "boxnest"):
        if ours := goals.row(shell):
            goals.at_most(f"{shell}: below 10 degrees", ours["below_10_deg"], 0)
            goals.at_least(f"{shell}: dt ratio, best peer's", ours["dt_ratio"], goals.best_peer(shell, "dt_ratio", max))
            best = goals.best_peer(shell, "pcg_stiff", min)
            goals.at_most(f"{shell}: stiff iterations, 1.1 x best peer's", ours["pcg_stiff"], best and 1.1 * best)
    if bonnet := goals.row("bonnet"):
        goals.at_least("bonnet: smallest angle", bonnet["min_dihedral_deg"], 10.7)


def judge_carbody(goals):
    ours = goals.row("carbody")
    if not ours:
        return
    goals.at_most("carbody: tets / shipped", ours["tets"] / SHIPPED_CARBODY["tets"], 1.25)
    goals.at_most("carbody: share below 10 degrees", ours["below_10_deg"] / ours["tets"], 0.005)
    goals.at_least("carbody: dt ratio (shipped 0.298)", ours["dt_ratio"], 0.42)
    for key in ("pcg_soft", "pcg_stiff"):
        goals.at_most(f"carbody: {key} / shipped", ours[key] / SHIPPED_CARBODY[key], 1.05)
    goals.at_most("carbody: volume error", abs(ours["volume_error"]), 0.003)


def judge_dirty(goals):
    for shell, limit in (("cow", 0.01), ("suzanne", 0.02)):
        if ours := goals.row(shell):
            goals.at_least(f"{shell}: smallest angle", ours["min_dihedral_deg"], 1)
            goals.at_most(f"{shell}: volume error", abs(ours["volume_error"]), limit)


def judge_all(rows):
    goals = Goals(rows)
    judge_matched(goals)
    judge_automatic(goals)
    judge_carbody(goals)
    judge_dirty(goals)
    return [("goal", "measured", "wanted", ""), ("---", "---", "---", "---")] + goals.lines


def all_rows(rows):
    show = lambda value: "" if value is None else value if isinstance(value, str) else f"{value:.4g}"
    keys = list(rows[0])
    return [keys, ["---"] * len(keys)] + [[show(row[key]) for key in keys] for row in rows]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("figures", help="JSON of scripts/bench.sh mesh")
    parser.add_argument("--table", action="store_true", help="print the rows instead")
    args = parser.parse_args()
    with open(args.figures, encoding="utf-8") as file:
        rows = json.load(file)["rows"]
    for line in all_rows(rows) if args.table else judge_all(rows):
        print("| " + " | ".join(line) + " |")


main()
