# SPDX-License-Identifier: GPL-3.0-or-later
"""Quality gates: what a cook refuses, what check says of it, and the baseline of an asset."""
import json
import unittest

import program

STRICT = ["--set", "gates.enforce=true", "--set", "gates.min_dihedral_deg.fail=60"]


class Rejected(program.Case):
    def setUp(self):
        super().setUp()
        self.rejected = self.path("out.rejected.hdf")

    def test_the_output_stays_as_it_was_and_the_result_lies_beside_it(self):
        self.ok(self.cook())
        before = self.output.read_bytes()
        process = self.fails(self.cook(*STRICT), 4, "GATE_MIN_DIHEDRAL", "out.rejected.hdf", "stays as it was")
        self.assertEqual(self.output.read_bytes(), before)
        self.assertTrue(self.rejected.exists())
        self.assertEqual(self.leftovers(), [])
        # Where: component, material, nearest painted vertex.
        self.assertIn("steel", process.stderr)
        self.assertIn("painted vertex", process.stderr)

    def test_exported_as_a_blob_it_warns_of_its_gates(self):
        self.fails(self.cook(*STRICT), 4)
        process = self.ok(program.run("export", self.rejected, "--blob", self.path("car.blob")))
        self.assertIn("warning", process.stderr)
        self.assertIn("refused this bundle (GATE_MIN_DIHEDRAL, ", process.stderr)
        self.ok(self.cook())
        self.assertNotIn("warning", self.ok(program.run("export", self.output, "--blob", self.path("car.blob"))).stderr)

    def test_where_there_was_no_output_there_is_none(self):
        self.fails(self.cook(*STRICT), 4)
        self.assertFalse(self.output.exists())
        self.assertTrue(self.rejected.exists())

    def test_after_a_good_one_the_refused_result_is_gone(self):
        self.fails(self.cook(*STRICT), 4)
        self.assertTrue(self.rejected.exists())
        self.ok(self.cook())
        self.assertFalse(self.rejected.exists())

    def test_a_file_of_that_name_that_is_none_of_ours_stays(self):
        self.rejected.write_text("notes")
        self.ok(self.cook())
        self.assertEqual(self.rejected.read_text(), "notes")

    def test_a_good_bundle_of_that_name_stays(self):
        self.ok(self.cook(output=self.rejected))
        before = self.rejected.read_bytes()
        self.ok(self.cook())
        self.assertEqual(self.rejected.read_bytes(), before)

    def test_a_refused_result_that_someone_linked_or_protected_stays(self):
        self.fails(self.cook(*STRICT), 4)
        self.rejected.chmod(0o444)
        self.ok(self.cook())
        self.assertTrue(self.rejected.exists())
        kept = self.path("kept.hdf")
        self.rejected.rename(kept)
        kept.chmod(0o644)
        self.rejected.symlink_to(kept)
        self.ok(self.cook())
        self.assertTrue(self.rejected.is_symlink() and kept.exists())

    def test_the_place_of_a_refused_result_is_no_input_and_no_other_output(self):
        self.ok(self.cook("--keep-work"))
        self.output.rename(self.rejected)
        before = self.rejected.read_bytes()
        self.fails(program.run("gates", self.rejected, "-o", self.output), 1,
                   f"{self.rejected}, the place of what a quality gate refuses: would replace an input")
        self.assertEqual(self.rejected.read_bytes(), before)
        self.fails(self.cook("--report", self.rejected), 1, "name the same file")

    def test_the_report_tells_the_figures_and_that_it_was_rejected(self):
        path = self.path("report.json")
        self.fails(self.cook(*STRICT, "--report", path), 4)
        report = json.loads(path.read_text())
        self.assertEqual((report["exit_code"], report["stopped_in"]), (4, "gates"))
        self.assertTrue(report["output"]["is_rejected"])
        gates = report["stages"][-1]
        self.assertEqual(gates["name"], "gates")
        errors = [finding for finding in gates["findings"] if finding["severity"] == "error"]
        self.assertIn("GATE_MIN_DIHEDRAL", [finding["code"] for finding in errors])
        self.assertTrue(errors[0]["places"])
        self.assertLess(gates["report"]["figures"]["shape"]["min_dihedral_deg"], 60)

    def test_check_says_the_same_of_the_rejected_file(self):
        for words in [[], ["--keep-work"]]:
            self.fails(self.cook(*STRICT, *words), 4)
            process = program.run("check", self.rejected)
            self.assertEqual(process.returncode, 4, process.stdout)
            self.assertIn("GATE_MIN_DIHEDRAL", process.stdout)
            self.assertIn("every invariant holds", process.stdout)

    def test_a_gate_can_be_loosened_by_the_recipe(self):
        recipe = self.path("loose.json")
        recipe.write_text(json.dumps({"gates": {"min_dihedral_deg": {"fail": 0, "warn": 0}}, "relax": {"sweeps": 3}}))
        self.ok(self.cook(recipe=str(recipe)))
        self.ok(program.run("check", self.output))

    def test_a_stage_alone_rejects_as_well(self):
        self.ok(self.cook("--keep-work"))
        self.ok(program.run("bake", self.output, "-o", self.path("work.hdf")))
        before = self.output.read_bytes()
        self.fails(program.run("gates", self.path("work.hdf"), "-o", self.output, "--set", "min_dihedral_deg.fail=60",
                               "--enforce", "true"), 4, "GATE_MIN_DIHEDRAL", "out.rejected.hdf")
        self.assertEqual(self.output.read_bytes(), before)
        self.assertEqual(program.run("check", self.rejected).returncode, 4)

    def test_a_result_that_cannot_be_kept_is_still_exit_4(self):
        output = self.path("a" * 250 + ".hdf")
        self.fails(self.cook(*STRICT, output=output), 4, "could not be kept")

    def test_the_same_bytes_at_any_number_of_threads(self):
        contents = set()
        for jobs in ["1", "2", "8"]:
            self.fails(self.cook(*STRICT, "--jobs", jobs), 4)
            contents.add(self.rejected.read_bytes())
        self.assertEqual(len(contents), 1)

    def test_an_unknown_gate_names_the_nearest(self):
        self.fails(self.cook("--set", "gates.volume_eror.fail=1"), 1, "gates.volume_error")
        self.fails(self.cook("--set", "gates.volume_error.fial=1"), 1, "gates.volume_error.fail")


class Baseline(program.Case):
    def setUp(self):
        super().setUp()
        self.ok(self.cook())
        self.baseline = self.path("baseline.json")

    def check(self, *words):
        process = program.run("check", self.output, "--baseline", self.baseline, *words, "--format", "json")
        return process.returncode, json.loads(process.stdout)["files"][0]

    def change(self, **figures):
        content = json.loads(self.baseline.read_text())
        content["assets"]["out"].update(figures)
        self.baseline.write_text(json.dumps(content))

    def codes(self, check):
        return [finding["code"] for finding in check["findings"]]

    def test_it_is_written_and_then_met(self):
        self.assertEqual(self.check("--update-baseline")[0], 0)
        content = json.loads(self.baseline.read_text())
        self.assertEqual(sorted(content["assets"]["out"]), ["pcg_soft", "pcg_stiff", "tets", "volume"])
        code, check = self.check()
        self.assertEqual(code, 0)
        self.assertFalse([code for code in self.codes(check) if "PCG" in code or "TETS" in code or "CHANGED" in code])

    def test_other_assets_stay_in_the_file(self):
        self.check("--update-baseline")
        content = json.loads(self.baseline.read_text())
        content["assets"]["bike"] = content["assets"]["out"]
        self.baseline.write_text(json.dumps(content))
        self.check("--update-baseline")
        self.assertEqual(sorted(json.loads(self.baseline.read_text())["assets"]), ["bike", "out"])

    def test_two_assets_of_one_name_are_refused(self):
        other = self.path("b") / "out.hdf"
        other.parent.mkdir()
        other.write_bytes(self.output.read_bytes())
        words = ["check", self.output, other, "--baseline", self.baseline]
        said = [f"{self.output} and {other}", "'out'", "another name"]
        self.fails(program.run(*words, "--update-baseline"), 1, *said)
        self.assertFalse(self.baseline.exists())
        self.check("--update-baseline")
        self.fails(program.run(*words), 1, *said)
        self.ok(program.run("check", self.output, other))

    def test_more_iterations_warn_and_then_fail(self):
        self.check("--update-baseline")
        now = json.loads(self.baseline.read_text())["assets"]["out"]["pcg_stiff"]
        self.change(pcg_stiff=int(now / 1.3))
        code, check = self.check()
        self.assertEqual(code, 0)
        self.assertIn("GATE_PCG_STIFF", self.codes(check))
        self.change(pcg_stiff=int(now / 2))
        code, check = self.check()
        self.assertEqual((code, check["exit_code"]), (4, 4))
        self.assertIn("GATE_PCG_STIFF", self.codes(check))

    def test_a_change_of_volume_fails(self):
        self.check("--update-baseline")
        self.change(volume=1.1 * json.loads(self.baseline.read_text())["assets"]["out"]["volume"])
        code, check = self.check()
        self.assertEqual(code, 4)
        self.assertIn("GATE_VOLUME_CHANGED", self.codes(check))

    def test_more_tets_are_warned_of_however_many(self):
        self.check("--update-baseline")
        self.change(tets=json.loads(self.baseline.read_text())["assets"]["out"]["tets"] // 4)
        code, check = self.check()
        self.assertEqual(code, 0)
        self.assertIn("GATE_TETS", self.codes(check))

    def test_an_asset_it_does_not_know_is_warned_of(self):
        self.baseline.write_text('{"assets": {}}')
        code, check = self.check()
        self.assertEqual(code, 0)
        self.assertIn("BASELINE_MISSING", self.codes(check))

    def test_it_is_strict_json(self):
        for text, *parts in [('{"assets": {"out": {"pcg": 1}}}', "assets.out.pcg", "pcg_soft"), ("{", "line 1"),
                             ('{"schema": "crumple/check/1"}', "crumple/baseline/1"),
                             ('{"assets": {"out": {"tets": -1}}}', "assets.out.tets", "out of range"),
                             ('{"assets": {"out": {}}}', "assets.out.tets", "--update-baseline"),
                             ('{"assets": {"out": {"tets": 5}}}', "assets.out.volume", "--update-baseline"),
                             ('{"assets": {"out": {"tets": 5, "volume": 1, "pcg_stiff": 9}}}', "assets.out.pcg_soft",
                              "--update-baseline"),
                             ('{"assets": {"out": {"tets": 5, "volume": 1, "pcg_soft": 9}}}', "assets.out.pcg_stiff",
                              "--update-baseline")]:
            self.baseline.write_text(text)
            self.fails(program.run("check", self.output, "--baseline", self.baseline), 1, "baseline.json", *parts)

    def test_what_it_lacks_an_update_adds(self):
        self.baseline.write_text('{"assets": {"out": {"tets": 5, "volume": 1}}}')
        self.assertEqual(self.check("--update-baseline")[0], 0)
        self.assertEqual(self.check()[0], 0)
        for figure in json.loads(self.baseline.read_text())["assets"]["out"].values():
            self.assertGreater(figure, 0)

    def test_files_that_are_not_there(self):
        self.fails(program.run("check", self.output, "--baseline", self.path("none.json")), 2, "none.json")
        self.fails(program.run("check", self.output, "--update-baseline"), 1, "--baseline FILE")
        self.fails(program.run("check", self.output, "--baseline", self.output, "--update-baseline"), 1, "would replace")
        self.fails(program.run("check", self.output, "--baseline", "-", "--update-baseline"), 1, "--baseline -", "./-")

    def test_a_damaged_file_changes_nothing(self):
        self.check("--update-baseline")
        before = self.baseline.read_text()
        self.output.write_bytes(self.output.read_bytes()[:3000])
        self.assertEqual(self.check("--update-baseline")[0], 7)
        self.assertEqual(self.baseline.read_text(), before)


class Inspect(program.Case):
    def test_it_shows_the_figures(self):
        self.ok(self.cook())
        report = self.json_of(program.run("inspect", self.output, "--format", "json"))
        self.assertTrue(report["has_figures"])
        self.assertGreater(report["figures"]["cost"]["dt_ratio"], 0)
        text = self.ok(program.run("inspect", self.output)).stdout
        for word in ["pcg_stiff", "hausdorff_out", "non_manifold_edges", "bound_wrongly"]:
            self.assertIn(word, text)


if __name__ == "__main__":
    unittest.main()
