# SPDX-License-Identifier: GPL-3.0-or-later
"""crumple cook: what it writes, what it refuses, what it says."""
import hashlib
import json
import os
import shutil
import subprocess
import unittest

import program


class Output(program.Case):
    def test_a_cook_gives_a_bundle_that_check_passes(self):
        self.ok(self.cook())
        self.ok(program.run("check", self.output))
        self.assertEqual(self.leftovers(), [])

    def test_the_output_must_end_in_hdf(self):
        self.fails(self.cook(output=self.path("out.h5")), 1, "out.h5", ".hdf")

    def test_a_missing_folder_is_said_before_any_work(self):
        process = self.fails(self.cook("--progress", "json", output=self.path("none/out.hdf")), 2, "none")
        self.assertNotIn("begin", process.stderr)

    def test_a_folder_as_output_is_refused(self):
        self.path("folder.hdf").mkdir()
        self.fails(self.cook(output=self.path("folder.hdf")), 2, "folder.hdf")

    def test_an_output_that_is_an_input_is_refused(self):
        shell = self.path("shell.hdf")
        os.link(self.shell, shell)
        before = shell.read_bytes()
        self.fails(self.cook(output=shell), 1, "would replace an input")
        os.symlink(self.visual, self.path("link.hdf"))
        self.fails(self.cook(output=self.path("link.hdf")), 1, "would replace an input")
        self.assertEqual(shell.read_bytes(), before)

    def test_a_report_may_not_replace_an_input_or_the_output(self):
        self.fails(self.cook("--report", self.shell), 1, "would replace")
        self.fails(self.cook("--report", self.output), 1, "--report and -o name the same file")
        self.fails(self.cook("--report", self.path("none/r.json")), 2, "none")

    def test_no_two_outputs_are_the_same_file(self):
        report = self.path("report.json")
        other = f"{self.folder}/../{self.folder.name}/report.json"
        self.fails(self.cook("--report", report, "--depfile", other), 1, "--depfile and --report name the same file")
        self.fails(self.cook("--depfile", self.output), 1, "--depfile and -o")
        self.assertFalse(report.exists())

    def test_an_output_that_is_read_only_is_not_replaced(self):
        self.output.write_text("precious")
        self.output.chmod(0o444)
        process = self.fails(self.cook("--progress", "json"), 2, "out.hdf", "read-only")
        self.assertNotIn("begin", process.stderr)
        self.assertEqual(self.output.read_text(), "precious")
        report = self.path("report.json")
        report.write_text("precious")
        report.chmod(0o444)
        self.fails(self.cook("--report", report, output=self.path("other.hdf")), 2, "report.json", "read-only")

    def test_the_output_may_be_given_with_an_equals_sign(self):
        self.ok(program.run("cook", "smoke", "--shell", self.shell, f"-o={self.output}"))
        self.assertTrue(self.output.exists())

    def test_a_name_of_255_bytes_is_fine_and_one_of_256_is_said_before_any_work(self):
        output = self.path("a" * 251 + ".hdf")
        self.ok(self.cook(output=output))
        self.assertTrue(output.exists())
        process = self.fails(self.cook("--progress", "json", output=self.path("a" * 252 + ".hdf")), 2, "File name too long")
        self.assertNotIn("begin", process.stderr)

    def test_empty_names_are_no_names(self):
        self.fails(program.run("cook", "smoke", "--shell", "", "-o", self.output), 2)
        self.fails(program.run("cook", "smoke", "--shell", self.shell, "-o", ""), 1, "names no file")

    def test_a_shell_that_is_not_there_is_exit_2(self):
        self.shell = self.path("none.ply")
        self.fails(self.cook(), 2, "none.ply")
        self.visual = self.path("folder")
        self.visual.mkdir()
        self.fails(self.cook(), 2)

    def test_a_shell_that_is_nonsense_is_exit_3(self):
        for name, content in [("a.ply", b"ply\nnonsense"), ("b.obj", b""), ("c.glb", b"\0" * 100), ("d.xyz", b"1 2 3")]:
            self.shell = self.path(name)
            self.shell.write_bytes(content)
            self.fails(self.cook(), 3, name)
        self.assertFalse(self.output.exists())

    def test_an_output_whose_bytes_are_equal_is_not_touched(self):
        self.ok(self.cook())
        os.utime(self.output, (1, 1))
        process = self.ok(self.cook())
        self.assertIn("unchanged", process.stderr)
        self.assertEqual(os.stat(self.output).st_mtime, 1)
        self.ok(self.cook("--set", "sample.seed=2"))
        self.assertNotEqual(os.stat(self.output).st_mtime, 1)

    def test_a_failed_cook_leaves_the_old_file(self):
        self.ok(self.cook())
        before = self.output.read_bytes()
        self.shell.write_text("v 0 0 0\nf 1 1 1\n")
        self.fails(self.cook(), 3)
        self.assertEqual(self.output.read_bytes(), before)
        self.assertEqual(self.leftovers(), [])

    def test_the_output_keeps_no_path_time_or_host(self):
        self.ok(self.cook("--keep-work", "--layout", "contiguous"))
        content = self.output.read_bytes()
        for word in [str(self.folder), os.uname().nodename, "/tmp"]:
            self.assertNotIn(word.encode(), content)

    def test_work_groups_are_kept_only_when_asked_for(self):
        self.ok(self.cook())
        self.assertEqual(self.json_of(program.run("inspect", self.output, "--format", "json"))["groups"], ["bundle"])
        self.ok(self.cook("--keep-work"))
        groups = self.json_of(program.run("inspect", self.output, "--format", "json"))["groups"]
        self.assertEqual(groups, ["asset", "points", "tets", "bindings", "bundle"])
        self.ok(program.run("check", self.output))

    def test_both_layouts_hold_the_same(self):
        other = self.path("other.hdf")
        self.ok(self.cook())
        self.ok(self.cook("--layout", "contiguous", output=other))
        self.ok(program.run("compare", self.output, other))
        self.assertNotEqual(self.output.read_bytes(), other.read_bytes())

    def test_several_visual_meshes_get_their_names(self):
        self.ok(self.cook("--visual", f"wheel={self.visual}"))
        report = self.json_of(program.run("inspect", self.output, "--format", "json"))
        self.assertEqual([visual["name"] for visual in report["bundle"]["visuals"]], ["visual", "wheel"])
        self.assertEqual([input["name"] for input in report["record"]["inputs"]], ["shell", "visual/visual", "visual/wheel"])

    def test_visual_names_must_differ(self):
        for words in [[], ["--dry-run"]]:
            self.fails(self.cook("--visual", self.visual, *words), 1, "two visual meshes are named 'visual'")

    def test_a_cook_without_visual_meshes_works(self):
        self.ok(program.run("cook", "smoke", "--shell", self.shell, "-o", self.output))
        self.ok(program.run("check", self.output))

    def test_a_path_left_empty_is_a_wrong_call(self):
        for option in ["--report", "--depfile", "--visual"]:
            self.fails(self.cook(option, ""), 1, option, "it names no file")
        process = program.run("cook", "smoke", "--shell", "", "-o", self.output)
        self.fails(process, 2, "is empty")

    def test_the_depfile_lists_what_was_read(self):
        depfile = self.path("out.d")
        self.ok(self.cook("--depfile", depfile, recipe=str(program.SOURCE / "pipelines/smoke.json")))
        self.assertEqual(depfile.read_text().split(),
                         [f"{self.output}:", str(self.shell), str(self.visual), str(program.SOURCE / "pipelines/smoke.json")])

    def test_what_has_the_name_of_a_builtin_recipe_is_not_read_and_no_input(self):
        self.path("smoke").write_text("notes")
        self.path("preview").mkdir()
        for recipe in ["smoke", "preview"]:
            self.ok(self.cook("--depfile", "dep.d", recipe=recipe, cwd=self.folder))
            self.assertEqual(self.path("dep.d").read_text().split(), [f"{self.output}:", str(self.shell), str(self.visual)])

    def cook_with_odd_names(self):
        """Inputs whose names a rule has to quote, older than the output."""
        folder = self.path("a b#c$d:e")
        folder.mkdir()
        self.shell = self.shell.rename(folder / "sh ell.obj")
        self.visual = self.visual.rename(self.path("back\\slash+,_~(){}%@[]!-\u00fc.obj"))
        self.ok(self.cook("--depfile", "dep.d", output="out.hdf", cwd=self.folder))
        for path in [self.shell, self.visual]:
            os.utime(path, (1, 1))

    def tool(self, name):
        return shutil.which(name) or self.skipTest(f"no {name}")

    def test_the_depfile_is_read_by_make_whatever_the_names(self):
        make = self.tool("make")
        self.cook_with_odd_names()
        self.path("Makefile").write_text("out.hdf:\n\ttouch $@\ninclude dep.d\n")
        plan = lambda: subprocess.run([make, "-q", "out.hdf"], cwd=self.folder, capture_output=True).returncode
        self.assertEqual(plan(), 0, "nothing to do")
        for path in [self.shell, self.visual]:
            os.utime(path, (2**32, 2**32))
            self.assertEqual(plan(), 1, path)
            os.utime(path, (1, 1))

    def test_the_depfile_is_read_by_ninja_whatever_the_names(self):
        ninja = self.tool("ninja")
        self.cook_with_odd_names()
        self.path("build.ninja").write_text(
            "rule cook\n  command = touch $out && cp dep.d used.d\n  depfile = used.d\nbuild out.hdf: cook\n")
        plan = lambda *words: subprocess.run([ninja, *words], cwd=self.folder, capture_output=True, text=True).stdout
        plan()
        self.assertIn("no work to do", plan("-n"))
        for path in [self.shell, self.visual]:
            os.utime(path, (2**32, 2**32))
            self.assertIn("touch", plan("-n", "-v"), path)
            os.utime(path, (1, 1))

    def test_what_make_or_ninja_would_misread_is_refused_by_a_depfile(self):
        shell = self.shell
        for name, word in [("two\nlines", "line break"), ("a\tb", "tab"), ("a=b", "'='"), ("a;b", "';'"), ("a|b", "'|'"),
                           ("a&b", "'&'"), ("a*b", "'*'"), ("a'b", "cannot name"), ("a\\#b", "'\\#'")]:
            self.shell = shell.rename(self.path(name + ".obj"))
            self.fails(self.cook("--depfile", self.path("dep.d")), 1, "--depfile", word)
            self.assertFalse(self.output.exists())
            self.shell.rename(shell)
        self.shell = shell
        self.fails(self.cook("--depfile", self.path("dep.d"), output=self.path("a%b.hdf")), 1, "--depfile", "'%'")


class Same(program.Case):
    def test_the_same_bytes_twice_and_at_any_number_of_threads(self):
        digests = set()
        for jobs in ["1", "1", "2", "8"]:
            output = self.path(f"out{len(os.listdir(self.folder))}.hdf")
            self.ok(self.cook("--keep-work", "--jobs", jobs, recipe="car_body", output=output))
            digests.add(hashlib.sha256(output.read_bytes()).hexdigest())
        self.assertEqual(len(digests), 1)

    def test_the_folders_of_inputs_and_output_do_not_matter(self):
        self.ok(self.cook("--keep-work", recipe="preview"))
        moved = self.path("elsewhere")
        moved.mkdir()
        self.shell = self.shell.rename(moved / "shell.obj")
        self.visual = self.visual.rename(moved / "visual.obj")
        self.ok(self.cook("--keep-work", recipe="preview", output=moved / "other.hdf"))
        self.assertEqual((moved / "other.hdf").read_bytes(), self.output.read_bytes())

    def test_a_file_s_own_name_matters_only_where_it_names_something(self):
        self.ok(self.cook())
        first = self.output.read_bytes()
        renamed = self.visual.rename(self.path("other.obj"))
        process = program.run("cook", "smoke", "--shell", self.shell, "--visual", f"visual={renamed}", "-o", self.output)
        self.ok(process)
        self.assertEqual(self.output.read_bytes(), first)
        # The region is named after the shell's file, which names nothing itself.
        self.visual, self.shell = renamed.rename(self.visual), self.shell.rename(self.path("body.obj"))
        self.ok(self.cook())
        self.assertNotEqual(self.output.read_bytes(), first)
        regions = self.json_of(program.run("inspect", self.output, "--format", "json"))["bundle"]["regions"]
        self.assertEqual([region["name"] for region in regions], ["body"])

    def test_check_determinism_cooks_twice_and_says_so(self):
        report = self.json_of(self.cook("--check-determinism", "--jobs", "2", "--format", "json"))
        self.assertEqual((report["jobs"], report["determinism_jobs"]), (2, 1))
        report = self.json_of(self.cook("--check-determinism", "--jobs", "1", "--format", "json"))
        self.assertEqual((report["jobs"], report["determinism_jobs"]), (1, 3))


class Report(program.Case):
    def test_the_report_tells_every_stage_with_its_cost(self):
        path = self.path("report.json")
        self.ok(self.cook("--report", path, "--jobs", "1"))
        report = json.loads(path.read_text())
        self.assertEqual([stage["name"] for stage in report["stages"]],
                         program.stages())
        for stage in report["stages"]:
            self.assertGreaterEqual(stage["usage"]["cpu_s"], 0)
            self.assertGreater(stage["usage"]["wall_s"], 0)
            self.assertGreater(stage["usage"]["peak_memory_mb"], 1)
        self.assertEqual(report["exit_code"], 0)
        self.assertEqual(report["output"]["sha256"], hashlib.sha256(self.output.read_bytes()).hexdigest())
        self.assertEqual(report["inputs"][0]["sha256"], hashlib.sha256(self.shell.read_bytes()).hexdigest())
        self.assertGreater(report["stages"][0]["report"]["locked"], 0)

    def test_one_triangle_that_was_turned_is_told_as_one(self):
        lines = self.shell.read_text().splitlines()
        word, a, b, c = lines[-1].split()
        self.shell.write_text("\n".join(lines[:-1] + [f"{word} {a} {c} {b}"]) + "\n")
        report = self.json_of(self.cook("--format", "json"))
        self.assertIn("1 triangle faced the other way than its neighbours and was turned",
                      [finding["message"] for finding in report["stages"][0]["findings"]])

    def test_a_failed_cook_reports_why(self):
        path = self.path("report.json")
        self.shell.write_text("v 0 0 0\nf 1 1 1\n")
        self.fails(self.cook("--report", path), 3)
        report = json.loads(path.read_text())
        self.assertEqual(report["exit_code"], 3)
        self.assertIn("shell.obj", report["error"])

    def test_progress_as_lines_of_json(self):
        process = self.ok(self.cook("--progress", "json", "-q"))
        lines = [json.loads(line) for line in process.stderr.splitlines()]
        stages = program.stages()
        self.assertEqual([line["stage"] for line in lines if line["event"] == "begin"], stages)
        self.assertEqual([line["stage"] for line in lines if line["event"] == "end"], stages)
        for line in lines:
            self.assertTrue(0 <= line["fraction"] <= 1, line)


class DryRun(program.Case):
    def dry(self, *words, **options):
        return self.json_of(self.cook("--dry-run", "--format", "json", *words, **options))

    def test_it_says_why_and_writes_nothing(self):
        report = self.dry()
        self.assertTrue(report["would_change"])
        self.assertIn("not there", report["reasons"][0])
        self.assertFalse(self.output.exists())

    def test_what_is_up_to_date_stays(self):
        self.ok(self.cook())
        self.assertEqual((self.dry()["would_change"], self.dry()["reasons"]), (False, []))
        self.assertIn("up to date", self.ok(self.cook("--dry-run")).stdout)

    def test_a_changed_parameter_is_named_with_both_values(self):
        self.ok(self.cook())
        reasons = self.dry("--set", "relax.sweeps=7")["reasons"]
        self.assertEqual(reasons, ["relax.sweeps changed from 1 to 7"])

    def test_a_changed_input_is_named(self):
        self.ok(self.cook())
        self.visual.write_text(self.visual.read_text() + "# touched\n")
        self.assertEqual(self.dry()["reasons"], ["input visual/visual changed"])

    def test_another_layout_is_a_reason(self):
        self.ok(self.cook())
        self.assertEqual(self.dry("--layout", "contiguous")["reasons"], ["--layout changed from chunked to contiguous"])
        self.ok(self.cook("--layout", "contiguous"))
        self.assertEqual(self.dry("--layout", "contiguous")["reasons"], [])
        self.assertEqual(self.dry()["reasons"], ["--layout changed from contiguous to chunked"])

    def test_another_order_of_the_visual_meshes_is_a_reason(self):
        self.ok(self.cook("--visual", f"wheel={self.visual}"))
        self.assertEqual(self.dry("--visual", f"wheel={self.visual}")["reasons"], [])
        report = self.json_of(program.run("cook", "smoke", "--shell", self.shell, "--visual", f"wheel={self.visual}",
                                          "--visual", self.visual, "-o", self.output, "--dry-run", "--format", "json"))
        self.assertEqual(report["reasons"], ["the visual meshes came in another order"])

    def test_another_name_of_the_shell_s_file_is_a_reason_where_regions_are_named_after_it(self):
        self.ok(self.cook())
        self.shell = self.shell.rename(self.path("body.obj"))
        self.assertEqual(self.dry()["reasons"], ["the shell's file was renamed: what it does not name is now 'body'"])
        self.shell.write_text("o car\n" + self.shell.read_text())
        self.ok(self.cook())
        before = self.output.read_bytes()
        self.shell = self.shell.rename(self.path("other.obj"))
        self.assertEqual(self.dry()["reasons"], [])
        self.ok(self.cook())
        self.assertEqual(self.output.read_bytes(), before)

    def test_a_damaged_output_is_a_reason(self):
        self.ok(self.cook())
        self.output.write_bytes(self.output.read_bytes()[:1000])
        self.assertIn("cannot be read", self.dry()["reasons"][0])

    def test_missing_inputs_and_bad_outputs_are_refused(self):
        self.fails(self.cook("--dry-run", output=self.path("none/out.hdf")), 2)
        self.shell = self.path("none.obj")
        self.fails(self.cook("--dry-run"), 2, "none.obj")


class Budget(program.Case):
    def test_too_little_time_is_exit_6_and_leaves_the_old_file(self):
        report = self.path("report.json")
        self.fails(self.cook("--timeout", "0.001", "--report", report), 6, "--timeout")
        self.assertFalse(self.output.exists())
        self.assertEqual(json.loads(report.read_text())["exit_code"], 6)
        self.output.write_text("old")
        self.fails(self.cook("--timeout", "0.001"), 6)
        self.assertEqual(self.output.read_text(), "old")
        self.assertEqual(self.leftovers(), [])

    def test_too_little_memory_is_exit_6_and_leaves_the_old_file(self):
        self.output.write_text("old")
        self.fails(self.cook("--max-memory", "1"), 6, "--max-memory")
        self.assertEqual(self.output.read_text(), "old")
        self.assertEqual(self.leftovers(), [])

    def test_the_report_of_an_ended_cook_says_how_far_it_came(self):
        self.shell = program.sphere_obj(self.path("fine.obj"), rings=60, around=90)
        path = self.path("report.json")
        process = self.fails(self.cook("--timeout", "1", "--report", path, "--jobs", "1", "--set", "relax.sweeps=1000",
                                       "--set", "relax.tolerance=0", "--set", "sample.points=20000"), 6)
        report = json.loads(path.read_text())
        self.assertIn(report["stopped_in"], ["sample", "delaunay", "relax"])
        self.assertIn("in " + report["stopped_in"], process.stderr)
        names = program.stages()
        self.assertEqual([stage["name"] for stage in report["stages"]], names[:names.index(report["stopped_in"])])
        self.assertGreater(report["stages"][0]["report"]["locked"], 0)
        self.assertEqual(report["params"]["relax"]["sweeps"], 1000)
        self.assertEqual([record["name"] for record in report["inputs"]], ["shell", "visual/visual"])
        self.assertGreater(report["usage"]["wall_s"], 0.9)

    def test_enough_of_both_changes_nothing(self):
        self.ok(self.cook())
        first = self.output.read_bytes()
        report = self.json_of(self.cook("--timeout", "600", "--max-memory", "100000", "--format", "json"))
        self.assertTrue(report["output"]["is_unchanged"])
        self.assertEqual(self.output.read_bytes(), first)

    def test_the_reader_s_own_limits_end_in_3(self):
        self.fails(self.cook("--set", "import.time_s=0.001"), 3)

    def test_other_failures_keep_their_code_under_a_budget(self):
        self.shell.write_text("v 0 0 0\nf 1 1 1\n")
        self.fails(self.cook("--timeout", "600"), 3, "shell.obj")


if __name__ == "__main__":
    unittest.main()
