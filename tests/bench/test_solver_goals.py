# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows scripts/solver_goals.py made-up figures: test_solver_goals.py PROJECT_FOLDER"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(sys.argv.pop(1))
SCRIPT = PROJECT / "scripts" / "solver_goals.py"

# Value and ratio of each row, all as wanted, on the machine of the targets.
GOOD = {
    "step_5k": (0.18, 28), "step_5k_conventional": (0.58, 3.3), "step_5k_naive": (4.9, None),
    "step_5k_conventional_over_naive": (8.4, None), "step_50k": (0.3, 20), "step_50k_conventional": (0.88, 2.9),
    "step_50k_conventional_over_naive": (6.8, None), "rotation_8": (10, 61), "rotation_16": (6, 101),
    "half_inverted": (20, 1.4), "half_inverted_project": (20, 1.9), "assembly_ns_per_tet": (33, None),
    "spmv_fraction_50k": (0.9, None), "spmv_ns_per_block_5k": (0.8, None), "scramble": (0.6, 0.5),
    "scramble_recovered": (1, None), "tip_error": (0.002, None), "tip_error_stvk": (1e-4, None),
    "memory_bytes_per_tet": (390, None), "car_step_ms": (0.48, None), "car_step_p99_ms": (0.6, None),
    "car_step_ms_per_1k": (0.19, None), "car_step_conventional_ms": (1.2, None), "asleep_us": (0.1, None),
    "skin_100k": (0.2, None), "load_50k": (70, None), "two_threads_50k": (5, 1.7)}
GOOD |= {f"cars_{cars}_{threads}t": (cars, None) for cars in (1, 8, 20) for threads in (1, 2)}


def rows_of(figures):
    return [{"name": name, "input": "car_2500_tets" if name.startswith("car_") else "", "value": value, "unit": "", "ratio": ratio}
            for name, (value, ratio) in figures.items()]


class SolverGoals(unittest.TestCase):
    def run_on(self, text, *flags):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "solver.json"
            path.write_text(text)
            return subprocess.run([sys.executable, "-B", SCRIPT, path, *flags], capture_output=True, text=True, check=False)

    def verdicts(self, figures):
        """Exit code, and the verdict by target."""
        done = self.run_on(json.dumps({"rows": rows_of(figures)}))
        lines = [[cell.strip() for cell in line.strip("|").split("|")] for line in done.stdout.splitlines()[2:]]
        return done.returncode, {line[0]: line[3] for line in lines}

    def failing(self, **changes):
        """What is not met once figures are changed; None takes a row away."""
        figures = {name: figure for name, figure in (GOOD | changes).items() if figure}
        code, verdicts = self.verdicts(figures)
        failing = {name: verdict for name, verdict in verdicts.items() if verdict.startswith("**")}
        self.assertEqual(code, 1 if failing else 0)
        return failing

    def test_all_met(self):
        self.assertEqual(self.failing(), {})

    def test_no_rows_are_no_targets_met(self):
        code, verdicts = self.verdicts({})
        self.assertEqual(code, 1)
        told = {verdict for verdict in verdicts.values() if not verdict.startswith("by the tests")}
        self.assertEqual(told, {"**not measured**"})

    def test_every_figure_is_asked_for(self):
        for name in GOOD:
            with self.subTest(name):
                self.assertIn("**not measured**", self.failing(**{name: None}).values())
                self.assertIn("**not measured**", self.failing(**{name: (None, None)}).values())

    def test_figures_beyond_their_limits(self):
        for name, figure, target in (
                ("step_5k", (0.18, 26.9), "1: step_5k, naive"), ("step_5k_conventional", (0.58, 3.1), "1: step_5k_conventional"),
                ("step_50k", (0.3, 17), "2: step_50k, naive"), ("rotation_16", (6, 99), "3: rotation_16"),
                ("half_inverted", (20, 1.6), "4: half_inverted,"), ("assembly_ns_per_tet", (36, None), "5: "),
                ("spmv_fraction_50k", (0.84, None), "6: "), ("scramble", (0.6, 0.61), "7: scramble, "),
                ("scramble_recovered", (0.99, None), "7: scramble_recovered"), ("tip_error", (0.004, None), "8: tip_error"),
                ("memory_bytes_per_tet", (401, None), "11: "), ("car_step_ms", (0.51, None), "12: car_step_ms, 0.5"),
                ("asleep_us", (1.1, None), "13: asleep_us"), ("cars_1_2t", (2.1, None), "13: cars_1_2t")):
            with self.subTest(name):
                failing = self.failing(**{name: figure})
                self.assertEqual(list(failing.values()), ["**not met**"])
                self.assertTrue(list(failing)[0].startswith(target), failing)

    def test_times_are_wanted_of_a_machine_as_fast_as_naive_finds_it(self):
        self.assertEqual(self.failing(step_5k_naive=(9.8, None), car_step_ms=(0.9, None), car_step_ms_per_1k=(0.39, None)), {})
        failing = self.failing(step_5k_naive=(2.45, None))
        self.assertTrue({"12: car_step_ms, 0.5 scaled", "12: car_step_ms_per_1k, 0.2 scaled"} < set(failing), failing)
        self.assertFalse([name for name in failing if name.startswith("13")], failing)

    def test_the_size_of_the_car_is_told(self):
        figures = GOOD | {"car_coarse_step_ms": (0.4, None)}
        code, verdicts = self.verdicts(figures)
        self.assertEqual(code, 0)
        self.assertIn("12: that car: tets", verdicts)
        self.assertIn("12: the same car in a cage of coarse cells: ms in all", verdicts)

    def test_a_file_that_is_none(self):
        for text in ("", "{}", "nonsense"):
            done = self.run_on(text)
            self.assertEqual(done.returncode, 2, text)
            self.assertIn("solver.json", done.stderr)

    def test_the_table_has_every_row(self):
        done = self.run_on(json.dumps({"rows": rows_of(GOOD)}), "--table")
        self.assertEqual(done.returncode, 0)
        self.assertEqual(len(done.stdout.splitlines()), 2 + len(GOOD))
        self.assertIn("| step_5k |  | 0.18 |  | 28 |", done.stdout)


if __name__ == "__main__":
    unittest.main()
