# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows scripts/mesh_goals.py made-up figures: test_mesh_goals.py PROJECT_FOLDER"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(sys.argv.pop(1))
SCRIPT = PROJECT / "scripts" / "mesh_goals.py"

KEYS = ("nodes", "tets", "min_dihedral_deg", "p5_dihedral_deg", "below_10_deg", "dt_ratio", "pcg_soft", "pcg_stiff",
        "volume_error", "hausdorff_out", "hausdorff_in", "inverted", "non_manifold", "cpu_s", "delaunay_relax_cull_s",
        "finish_s")
GOOD = dict(zip(KEYS, (300, 1000, 12, 30, 0, 0.9, 40, 200, 0.001, 0.001, 0.001, 0, 0, 0.1, 0.05, 0.05)))
HXT = GOOD | {"p5_dihedral_deg": 15, "below_10_deg": 100, "dt_ratio": 0.5, "pcg_stiff": 300, "finish_s": None}
OURS = ("crumple", "crumple_matched", "crumple_peel", "crumple_none")
SHELLS = ("bonnet", "boxnest", "carbody", "carhood", "cow", "fandisk", "spot", "suzanne")


def met():
    """Every goal is met; hxt fails on boxnest."""
    rows = [{"shell": shell, "tool": tool} | GOOD for shell in SHELLS for tool in OURS]
    rows += [{"shell": shell, "tool": tool} | HXT for shell in SHELLS for tool in ("tetgen", "hxt", "gmsh")]
    rows.append({"shell": "spot", "tool": "crumple_50k"} | GOOD | {"tets": 50000, "cpu_s": 14, "finish_s": 9})
    change(rows, "boxnest", "hxt", **dict.fromkeys(KEYS))
    return rows


def change(rows, shell, tool, **figures):
    for row in rows:
        if (row["shell"], row["tool"]) == (shell, tool):
            row |= figures


class MeshGoals(unittest.TestCase):
    def run_on(self, text, *flags):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "mesh.json"
            path.write_text(text)
            return subprocess.run([sys.executable, SCRIPT, path, *flags], capture_output=True, text=True, check=False)

    def verdicts(self, rows):
        """Exit code, and the verdict by goal."""
        done = self.run_on(json.dumps({"rows": rows}))
        lines = [[cell.strip() for cell in line.strip("|").split("|")] for line in done.stdout.splitlines()[2:]]
        return done.returncode, {line[0]: line[3] for line in lines}

    def expect_only(self, rows, verdict, *beginnings):
        """Goals that begin so, and no others, have this verdict; a goal that is not met shows in the exit code."""
        code, verdicts = self.verdicts(rows)
        self.assertEqual(code, 1)
        for goal, found in verdicts.items():
            self.assertEqual(found, verdict if goal.startswith(beginnings) else "met", goal)
        for beginning in beginnings:
            self.assertTrue(any(goal.startswith(beginning) for goal in verdicts), beginning)

    def test_all_met(self):
        code, verdicts = self.verdicts(met())
        self.assertEqual(code, 0)
        self.assertEqual(set(verdicts.values()), {"met"})

    def test_no_rows_are_no_goals_met(self):
        code, verdicts = self.verdicts([])
        self.assertEqual(code, 1)
        self.assertEqual(set(verdicts.values()), {"**not measured**"})

    def test_rows_of_nulls_are_no_goals_met(self):
        code, verdicts = self.verdicts([{key: row[key] if key in ("shell", "tool") else None for key in row} for row in met()])
        self.assertEqual(code, 1)
        self.assertEqual(set(verdicts.values()), {"**not measured**"})

    def test_the_same_goals_are_asked_of_any_file(self):
        self.assertEqual(list(self.verdicts([])[1]), list(self.verdicts(met())[1]))

    def test_a_quick_run_leaves_shells_unmeasured(self):
        rows = [row for row in met() if row["shell"] in ("spot", "carbody", "bonnet") and row["tool"] != "crumple_50k"]
        self.expect_only(rows, "**not measured**", "fandisk", "boxnest", "cow", "suzanne", "carhood", "spot, 50k")

    def test_a_matched_mesh_that_was_not_found(self):
        rows = met()
        change(rows, "fandisk", "crumple_matched", **dict.fromkeys(KEYS))
        self.expect_only(rows, "**not measured**", "fandisk, matched")

    def test_a_peer_that_was_not_asked_or_failed_everywhere(self):
        for tools in (("gmsh",), ("tetgen", "hxt", "gmsh")):
            rows = met()
            if len(tools) == 1:
                rows = [row for row in rows if (row["shell"], row["tool"]) != ("bonnet", "gmsh")]
            for tool in tools:
                change(rows, "bonnet", tool, **dict.fromkeys(KEYS))
            self.expect_only(rows, "**not measured**", "bonnet: dt ratio", "bonnet: stiff iterations")

    def test_a_single_figure_that_is_not_there(self):
        rows = met()
        change(rows, "cow", "crumple", non_manifold=None)
        self.expect_only(rows, "**not measured**", "cow: non-manifold")

    def test_figures_beyond_their_limits(self):
        for shell, tool, figures, goal in (
                ("carbody", "crumple", {"non_manifold": 1}, "carbody: non-manifold"),
                ("suzanne", "crumple", {"non_manifold": 2}, "suzanne: non-manifold"),
                ("cow", "crumple", {"inverted": 1}, "cow: inverted"),
                ("spot", "crumple", {"volume_error": -0.004}, "spot: volume error"),
                ("spot", "crumple_matched", {"tets": 1101}, "spot, matched: tets"),
                ("carhood", "crumple", {"finish_s": 0.21}, "carhood: finish"),
                ("cow", "crumple_peel", {"delaunay_relax_cull_s": 0.06}, "cow: delaunay, relax"),
                ("spot", "crumple_50k", {"cpu_s": 15.1}, "spot, 50k: CPU"),
                ("bonnet", "hxt", {"dt_ratio": 0.95}, "bonnet: dt ratio")):
            with self.subTest(goal):
                rows = met()
                change(rows, shell, tool, **figures)
                self.expect_only(rows, "**not met**", goal)

    def test_a_file_that_is_none(self):
        for text in ("", "{}", "nonsense"):
            done = self.run_on(text)
            self.assertEqual(done.returncode, 2, text)
            self.assertIn("mesh.json", done.stderr)

    def test_the_table_is_that_of_the_page(self):
        done = self.run_on(json.dumps({"rows": met()}), "--table")
        self.assertEqual(done.returncode, 0)
        head, dashes, *lines = done.stdout.splitlines()
        page = (PROJECT / "tests" / "bench" / "README.md").read_text(encoding="utf-8").splitlines()
        self.assertIn((head, dashes), list(zip(page, page[1:])))
        self.assertEqual(len(lines), len(met()))
        self.assertIn("| spot | crumple | 300 | 1000 | 12, 30 | 0 | 0.9 | 40 / 200 | 0.1 | 0.1, 0.1 | 0 | 0.1 | 0.05 |", lines)
        self.assertEqual({line.count("|") for line in lines}, {head.count("|")})
        self.assertTrue(any(line.startswith("| boxnest | hxt | fails |") for line in lines))


if __name__ == "__main__":
    unittest.main()
