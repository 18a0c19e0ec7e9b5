# SPDX-License-Identifier: GPL-3.0-or-later
"""What the scripts share that hold measured figures against goals.

What a file of figures lacks, because it is of a --quick run or because a tool failed, is not measured, and so not met.
"""
import argparse
import json
import sys


class NotMeasured(Exception):
    pass


class Figures:
    """Of one row. One that does not exist, or failed, has none."""

    def __init__(self, row):
        self.row = row or {}

    def __getitem__(self, key):
        if self.row.get(key) is None:
            raise NotMeasured
        return self.row[key]


def show(number):
    return "" if number is None else f"{number:.4g}"


def known(measure):
    """What it gives, a number or a function that gives one; None where that is not measured."""
    try:
        return measure() if callable(measure) else measure
    except NotMeasured:
        return None


class Goals:
    def __init__(self):
        self.lines = []
        self.are_met = True

    def at_most(self, what, measure, limit):
        """`measure` gives the figure; `limit` is a number or gives one."""
        self.judge(what, measure, limit, "<=", lambda value, bound: value <= bound)

    def at_least(self, what, measure, limit):
        self.judge(what, measure, limit, ">=", lambda value, bound: value >= bound)

    def judge(self, what, measure, limit, sign, holds):
        value, bound = known(measure), known(limit)
        measured = value is not None and bound is not None
        verdict = "**not measured**" if not measured else "met" if holds(value, bound) else "**not met**"
        self.add(what, show(value), f"{sign} {show(bound)}".strip(), verdict)

    def reported(self, what, measure):
        """Has to be measured, whatever it is."""
        value = known(measure)
        self.add(what, show(value), "", "**not measured**" if value is None else "reported")

    def beside(self, what, measured, wanted="", why=""):
        """No goal, but what a reader of the goals should know."""
        self.lines.append((what, measured, wanted, why))

    def add(self, what, measured, wanted, verdict):
        self.lines.append((what, measured, wanted, verdict))
        self.are_met = self.are_met and not verdict.startswith("**")


def print_lines(head, lines):
    print("| " + " | ".join(head).rstrip() + " |")
    print("|" + "---|" * len(head))
    for line in lines:
        print(("| " + " | ".join(line)).rstrip() + " |")


def run(doc, bench, judge_all, table_head, table_line):
    """The program: its exit code. `judge_all` makes Goals of rows, `table_line` cells of one."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("figures", help=f"JSON of scripts/bench.sh {bench}")
    parser.add_argument("--table", action="store_true", help="print the rows instead")
    args = parser.parse_args()
    try:
        with open(args.figures, encoding="utf-8") as file:
            rows = json.load(file)["rows"]
    except (OSError, ValueError, KeyError) as error:
        print(f"{parser.prog}: {args.figures}: {error}", file=sys.stderr)
        return 2
    if args.table:
        print_lines(table_head, [table_line(row) for row in rows])
        return 0
    goals = judge_all(rows)
    print_lines(["goal", "measured", "wanted", ""], [list(line) for line in goals.lines])
    return 0 if goals.are_met else 1
