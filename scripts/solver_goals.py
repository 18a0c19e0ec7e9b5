#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Holds what `scripts/bench.sh solver --json FILE` measured against the solver's targets, and prints both as Markdown.

    scripts/solver_goals.py solver.json            # the targets, line by line; 0 when all are met, 1 when not, 2 for no such file
    scripts/solver_goals.py solver.json --table    # every row

What the file lacks, because it is of a --quick run or because the processor lacks AVX-512, is not measured, and so not met.
Times that are wanted hold where the naive pipeline takes 4.9 ms per 1,000 tets of the small bar; on a machine where it takes
less or more, so do they. The 2 ms that a game gives a car do not change.
"""
import sys

import goals as shared
from goals import Figures, NotMeasured, known

NAIVE_MS = 4.9  # per 1,000 tets at 5k, on the machine of the targets
FRAME_MS = 2


class Goals(shared.Goals):
    def __init__(self, rows):
        super().__init__()
        self.rows = {}
        for row in rows:
            self.rows.setdefault(row["name"], row)

    def value(self, name):
        return lambda: Figures(self.rows.get(name))["value"]

    def ratio(self, name):
        return lambda: Figures(self.rows.get(name))["ratio"]

    def scaled(self, limit):
        return lambda: limit * self.value("step_5k_naive")() / NAIVE_MS

    def tets_of(self, name):
        """From the row's input: car_10273_tets."""
        words = self.rows.get(name, {}).get("input", "").split("_")
        return int(words[1]) if len(words) == 3 and words[1].isdigit() else None


def judge_steps(goals):
    goals.at_least("1: step_5k, naive / ours", goals.ratio("step_5k"), 27)
    goals.at_least("1: step_5k_conventional, conventional / ours", goals.ratio("step_5k_conventional"), 3.2)
    goals.at_least("2: step_50k, naive / ours, aim 22", goals.ratio("step_50k"), 18)
    goals.at_least("2: step_50k_conventional, conventional / ours", goals.ratio("step_50k_conventional"), 2.6)
    for size, times, ms in (("5k", 8, 0.6), ("50k", 6.6, 0.9)):
        goals.at_least(f"baseline: conventional, {size}, times as fast as naive",
                       goals.value(f"step_{size}_conventional_over_naive"), times)
        goals.at_most(f"baseline: conventional, {size}, ms per 1k tets, {ms} scaled", goals.value(f"step_{size}_conventional"),
                      goals.scaled(ms))


def judge_rotations(goals):
    goals.at_least("3: rotation_8, JacobiSVD / ours", goals.ratio("rotation_8"), 60)
    goals.at_least("3: rotation_16, JacobiSVD / ours", goals.ratio("rotation_16"), 100)
    goals.beside("3: error, 99 % of the matrices", "", "<= 1e-05", "by the tests of solver's rotations")
    goals.at_most("4: half_inverted, by reflection / none inverted", goals.ratio("half_inverted"), 1.5)
    goals.at_most("4: half_inverted_project, by projection / none inverted", goals.ratio("half_inverted_project"), 2)


def judge_kernels(goals):
    goals.at_most("5: assembly_ns_per_tet, 35 scaled", goals.value("assembly_ns_per_tet"), goals.scaled(35))
    goals.at_least("6: spmv_fraction_50k, of stream read", goals.value("spmv_fraction_50k"), 0.85)
    goals.at_most("6: spmv_ns_per_block_5k, 0.9 scaled", goals.value("spmv_ns_per_block_5k"), goals.scaled(0.9))


def judge_truth(goals):
    goals.at_most("7: scramble, reflection / SVD 1", goals.ratio("scramble"), 0.6)
    goals.at_least("7: scramble_recovered, share of the seeds", goals.value("scramble_recovered"), 1)
    goals.at_most("8: tip_error", goals.value("tip_error"), 0.003)
    goals.at_most("8: tip_error_stvk", goals.value("tip_error_stvk"), 0.0002)
    goals.beside("9: plastic result from 60 to 240 Hz, spread", "", "<= 0.02", "by the tests S12DtIndependence")
    goals.beside("10: NaN or hang in 1e5 random runs", "", "<= 0", "by the tests S10Crash, long form")
    goals.at_most("11: memory_bytes_per_tet, aim 300", goals.value("memory_bytes_per_tet"), 400)


def per_1k(goals, name):
    tets = goals.tets_of(name)
    if tets is None:
        raise NotMeasured
    return 1e3 * goals.value(name)() / tets


def judge_car(goals):
    """0.5 ms at 0.20 ms per 1,000 tets is a car of 2,500."""
    goals.at_most("12: car_step_ms_per_1k, 0.2 scaled", goals.value("car_step_ms_per_1k"), goals.scaled(0.2))
    goals.at_most("12: car_step_ms, 0.5 scaled", goals.value("car_step_ms"), goals.scaled(0.5))
    goals.reported("12: car_step_conventional_ms", goals.value("car_step_conventional_ms"))
    for name, which in (("car_step_ms", "that car"), ("car_coarse_step_ms", "the same car in a cage of coarse cells")):
        if goals.tets_of(name) is None:
            continue
        goals.beside(f"12: {which}: tets", str(goals.tets_of(name)), "", "2500 are meant: 0.5 / 0.2")
        if name != "car_step_ms":
            goals.beside(f"12: {which}: ms in all", shared.show(known(goals.value(name))),
                         f"<= {shared.show(known(goals.scaled(0.5)))}", "for comparison")
            goals.beside(f"12: {which}: ms per 1k tets", shared.show(known(lambda: per_1k(goals, name))),
                         f"<= {shared.show(known(goals.scaled(0.2)))}", "for comparison")


def judge_company(goals):
    goals.at_most("13: asleep_us", goals.value("asleep_us"), 1)
    goals.at_most("13: car_step_p99_ms", goals.value("car_step_p99_ms"), FRAME_MS)
    for threads in (1, 2):
        goals.at_most(f"13: cars_1_{threads}t, ms a frame", goals.value(f"cars_1_{threads}t"), FRAME_MS)
    for cars in (8, 20):
        for threads in (1, 2):
            goals.reported(f"13: cars_{cars}_{threads}t, ms a frame", goals.value(f"cars_{cars}_{threads}t"))
    for name in ("skin_100k", "load_50k", "two_threads_50k"):
        goals.reported(name, goals.value(name))


def judge_all(rows):
    goals = Goals(rows)
    for judge in (judge_steps, judge_rotations, judge_kernels, judge_truth, judge_car, judge_company):
        judge(goals)
    return goals


TABLE_HEAD = ["row", "input", "value", "unit", "ratio"]


def table_line(row):
    return [row["name"], row["input"], shared.show(row["value"]), row["unit"], shared.show(row["ratio"])]


if __name__ == "__main__":
    sys.exit(shared.run(__doc__, "solver", judge_all, TABLE_HEAD, table_line))
