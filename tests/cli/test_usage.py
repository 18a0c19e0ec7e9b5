# SPDX-License-Identifier: GPL-3.0-or-later
"""Manners: help, versions, exit codes, where text goes."""
import json
import os
import pty
import subprocess
import unittest

import program

VERBS = ["cook", "check", "inspect", "compare", "export", "dev", "import", "sample", "delaunay", "relax", "cull", "bind",
         "bake"]


class Usage(program.Case):
    def test_no_verb_is_a_wrong_call(self):
        self.fails(program.run(), 1, "no verb", "Example:")

    def test_an_unknown_verb_is_a_wrong_call(self):
        self.fails(program.run("cok"), 1, "cok")

    def test_an_unknown_option_is_a_wrong_call_and_names_where_help_is(self):
        self.fails(program.run("cook", "--shel", "x"), 1, "see crumple cook --help")

    def test_help_goes_to_stdout_fits_a_screen_and_ends_with_an_example(self):
        for words in [[], *[[verb] for verb in VERBS], ["dev", "schema"], ["dev", "sample"]]:
            process = self.ok(program.run(*words, "--help"))
            lines = process.stdout.rstrip().splitlines()
            self.assertIn("Example: crumple", lines[-1], words)
            self.assertLessEqual(len(lines), 48, words)
            self.assertLessEqual(max(map(len, lines)), 132, words)
            self.assertEqual(process.stderr, "")

    def test_version_as_text_and_as_json(self):
        text = self.ok(program.run("--version")).stdout
        info = self.json_of(program.run("--version", "--json"))
        self.assertEqual(text, f"crumple {info['version']}\n")
        self.assertEqual([stage["name"] for stage in info["stages"]], VERBS[6:])

    def test_a_wrong_choice_or_number_is_a_wrong_call(self):
        self.fails(self.cook("--layout", "tiled"), 1, "--layout")
        self.fails(self.cook("--jobs", "-1"), 1, "--jobs")
        self.fails(self.cook("--jobs", "many"), 1, "--jobs")
        self.fails(self.cook("--timeout", "0"), 1, "--timeout")
        self.fails(self.cook("--progress", "loud"), 1, "--progress")
        self.assertFalse(self.output.exists())

    def test_quiet_says_nothing_when_all_is_well(self):
        process = self.ok(self.cook("-q"))
        self.assertEqual((process.stdout, process.stderr), ("", ""))

    def test_talk_goes_to_stderr_and_results_to_stdout(self):
        process = self.ok(self.cook())
        self.assertEqual(process.stdout, "")
        self.assertIn("stage", process.stderr)
        self.assertNotIn("\033", process.stderr)
        self.assertNotIn("\r", process.stderr)

    def test_verbose_shows_the_stages_reports(self):
        process = self.ok(self.cook("-v"))
        self.assertIn("lock_conflicts", process.stderr)

    def on_a_terminal(self, **environment):
        """What a cook says when stderr is a terminal."""
        ours, theirs = pty.openpty()
        words = [program.PROGRAM, "cook", "smoke", "--shell", str(self.shell), "-o", str(self.output)]
        process = subprocess.Popen(words, stderr=theirs, stdout=subprocess.DEVNULL, env={**os.environ, **environment})
        os.close(theirs)
        said = b""
        try:
            while chunk := os.read(ours, 65536):
                said += chunk
        except OSError:  # how a terminal says that nobody writes to it any more
            pass
        os.close(ours)
        self.assertEqual(process.wait(), 0)
        return said

    def test_progress_renews_one_line_on_a_terminal(self):
        said = self.on_a_terminal()
        self.assertIn(b"\rrelax", said.replace(b"\r\033[K", b"\r"))

    def test_no_color_is_honoured(self):
        self.assertIn(b"\033[3", self.on_a_terminal(NO_COLOR=""))
        self.assertNotIn(b"\033[3", self.on_a_terminal(NO_COLOR="1"))

    def test_arguments_may_come_from_a_file(self):
        arguments = self.path("cook.args")
        arguments.write_text(f"--shell\n{self.shell}\n\n-o\n{self.output}\r\n")
        self.ok(program.run("cook", "smoke", f"@{arguments}"))
        self.assertTrue(self.output.exists())
        self.fails(program.run("cook", "@" + str(self.path("none.args"))), 2, "none.args")


class Recipes(program.Case):
    def recipe(self, text):
        path = self.path("recipe.json")
        path.write_text(text)
        return str(path)

    def test_an_unknown_recipe_names_the_nearest(self):
        self.fails(self.cook(recipe="carbody"), 1, "'car_body'", "smoke")

    def test_a_recipe_that_is_not_there_is_a_file_error(self):
        self.fails(self.cook(recipe=str(self.path("none.json"))), 2, "none.json")

    def test_an_unknown_key_names_its_path_and_the_nearest(self):
        self.fails(self.cook(recipe=self.recipe('{"relax": {"sweep": 5}}')), 1, "relax.sweep", "relax.sweeps")
        self.fails(self.cook(recipe=self.recipe('{"relx": {}}')), 1, "relx", "'relax'")
        self.assertFalse(self.output.exists())

    def test_a_wrong_type_names_its_path(self):
        self.fails(self.cook(recipe=self.recipe('{"relax": {"sweeps": "5"}}')), 1, "relax.sweeps", "whole number")

    def test_a_number_out_of_range_names_its_path(self):
        self.fails(self.cook(recipe=self.recipe('{"relax": {"sweeps": -1}}')), 1, "relax.sweeps", "out of range")

    def test_broken_json_names_line_and_column(self):
        self.fails(self.cook(recipe=self.recipe('{\n"relax": }')), 1, "line 2")

    def test_a_key_that_comes_twice_is_refused(self):
        self.fails(self.cook(recipe=self.recipe('{"relax": {}, "relax": {}}')), 1, "relax", "twice")

    def test_set_is_as_strict_as_the_recipe(self):
        self.fails(self.cook("--set", "relax.sweep=5"), 1, "relax.sweeps")
        self.fails(self.cook("--set", "relax.sweeps=-5"), 1, "out of range")
        self.fails(self.cook("--set", "relax.sweeps"), 1, "path=value")

    def test_set_and_flags_reach_the_stages(self):
        report = self.json_of(self.cook("--set", "relax.sweeps=3", "--unit", "0.01", "--format", "json"))
        self.assertEqual(report["params"]["relax"]["sweeps"], 3)
        self.assertEqual(report["params"]["import"]["unit"], 0.01)

    def test_every_recipe_of_the_project_is_valid_by_path_and_by_name(self):
        paths = sorted((program.SOURCE / "pipelines").glob("*.json"))
        self.assertGreaterEqual({path.stem for path in paths}, {"car_body", "soft_body", "preview", "smoke"})
        for path in paths:
            by_name = self.json_of(self.cook("--dry-run", "--format", "json", recipe=path.stem))
            by_path = self.json_of(self.cook("--dry-run", "--format", "json", recipe=str(path)))
            self.assertEqual(by_name, by_path)
            self.assertTrue(json.loads(path.read_text())["description"])


if __name__ == "__main__":
    unittest.main()
