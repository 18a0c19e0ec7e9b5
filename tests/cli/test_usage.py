# SPDX-License-Identifier: GPL-3.0-or-later
"""Manners: help, versions, exit codes, where text goes."""
import json
import os
import pty
import re
import subprocess
import unittest

import program

STAGES = ["import", "sample", "delaunay", "relax", "recover", "cull", "finish", "bind", "bake", "gates"]
VERBS = ["cook", "check", "inspect", "compare", "export", "simulate", "dev", *STAGES]


class Usage(program.Case):
    def test_no_verb_is_a_wrong_call(self):
        self.fails(program.run(), 1, "no verb", "Example:")

    def test_an_unknown_verb_names_the_nearest(self):
        self.fails(program.run("cok"), 1, "no verb 'cok'", "'cook'", "see crumple --help")
        self.fails(program.run("chek", "a.hdf"), 1, "no verb 'chek'", "'check'")
        self.fails(program.run("dev", "schma"), 1, "crumple dev has no verb 'schma'", "'schema'")

    def test_an_unknown_option_names_the_nearest_and_where_help_is(self):
        self.fails(program.run("cook", "--shel", "x"), 1, "no option '--shel'", "'--shell'", "see crumple cook --help")
        self.fails(self.cook("--jbos", "3"), 1, "crumple cook has no option '--jbos'", "'--jobs'")
        self.fails(self.cook("--jbos=3"), 1, "'--jobs'")
        self.fails(self.cook("--vebrose"), 1, "'--verbose'")
        self.fails(program.run("--vershion"), 1, "'--version'")

    def test_an_option_or_word_too_many_is_named(self):
        self.fails(self.cook("-o", "other.hdf"), 1, "--output: takes no more than 1, found 2")
        self.fails(program.run("compare", "a.hdf"), 1, "wants at least 2, found 1")
        self.fails(program.run("inspect", "a.hdf", "b.hdf"), 1, "'b.hdf'")

    def test_help_lists_every_verb(self):
        help_text = self.ok(program.run("--help")).stdout
        listed = help_text[help_text.index("\nSubcommands:"):]
        self.assertEqual(re.findall(r"^  (\w+) ", listed, re.MULTILINE), VERBS)

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
        self.assertEqual([stage["name"] for stage in info["stages"]], STAGES)

    def test_a_program_gets_a_wrong_call_as_a_line_of_json(self):
        for words in [["cok", "--progress", "json"], ["--bogus", "cook", "--progress=json"]]:
            line, = self.fails(program.run(*words), 1).stderr.splitlines()
            event = json.loads(line)
            self.assertEqual(event["event"], "error", words)
            self.assertIn("has no option" if "--bogus" in words else "no verb", event["message"])

    def test_a_wrong_choice_or_number_is_a_wrong_call(self):
        self.fails(self.cook("--layout", "continuous"), 1, "--layout", "chunked, contiguous", "nearest: 'contiguous'")
        self.fails(self.cook("--jobs", "-1"), 1, "--jobs")
        self.fails(self.cook("--jobs", "many"), 1, "--jobs")
        self.fails(self.cook("--timeout", "0"), 1, "--timeout")
        self.fails(self.cook("--progress", "jsn"), 1, "--progress", "auto, json, tty, none", "nearest: 'json'")
        self.fails(self.cook("--format", "xml"), 1, "--format", "text, json")
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
        try:
            ours, theirs = pty.openpty()
        except OSError as error:  # a container without /dev/pts
            self.skipTest(f"no terminal to be had here: {error}")
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

    def test_a_message_is_one_safe_line_whatever_names_hold(self):
        for name in ["a\nb\x1b[31m.ply", "x" * 200 + ".ply"]:
            self.shell = self.path(name)
            self.shell.write_text("ply\nnonsense")
            process = self.fails(self.cook(), 3)
            self.assertEqual(len(process.stderr.splitlines()), 1, process.stderr)
            self.assertNotIn("\x1b", process.stderr)
        self.assertNotIn("\x1b", self.fails(self.cook("--set", "relax.\x1b[2Jswps=3"), 1).stderr)
        process = program.run("check", self.path("no\x1b[31m\n.hdf"))
        self.assertEqual(process.returncode, 2)
        self.assertNotIn("\x1b", process.stdout + process.stderr)

    def test_a_long_word_is_not_repeated_at_length(self):
        long = "k" * 100000
        recipe = self.path("long.json")
        for text in [f'{{"{long}": 1}}', f'{{"relax": {{"method": "{long}"}}}}', f'{{"a": {{"{long}": 1, "{long}": 2}}}}',
                     f'{{"description": "{long}", x', f'{{"sample": {{"points": "{long}"}}}}']:
            recipe.write_text(text)
            process = self.fails(self.cook(recipe=str(recipe)), 1)
            self.assertLess(len(process.stderr), 2000, process.stderr[:300])
        for words in [["--set", f"{long}=1"], ["--set", f"relax.sweeps={long}"], [f"--{long}"], ["--layout", long]]:
            process = self.fails(self.cook(*words), 1)
            self.assertLess(len(process.stderr), 2000, process.stderr[:300])

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

    def test_what_fits_no_field_is_said_with_what_would(self):
        self.fails(self.cook("--unit", "abc"), 1, "--unit abc", "import.unit", "expected a number, found abc")
        self.fails(self.cook("--set", "relax.sweeps=abc"), 1, "expected a whole number, found abc")
        self.fails(self.cook("--set", "relax.sweeps="), 1, "found nothing")
        self.fails(self.cook("--up", "w"), 1, "--up w", "import.up", "'w' is not one of")
        self.fails(self.cook(recipe=self.recipe('{"$schema": 5}')), 1, "$schema", "expected", "text")

    def test_text_may_be_quoted_as_in_json(self):
        report = self.json_of(self.cook("--set", 'sample.points="7"', "--set", 'relax.method="odt"', "--format", "json"))
        self.assertEqual(report["params"]["sample"]["points"], "7")
        self.assertEqual(report["params"]["relax"]["method"], "odt")

    def test_values_that_say_nothing_are_refused_before_any_work(self):
        """By recipe and by --set, in a dry run and in a real one."""
        self.shell = self.path("none.ply")  # would be exit 2
        for setting, *parts in [("sample.points=tets:0", "sample.points", "tets:0"),
                                ("sample.points=garbage", "sample.points", "garbage"),
                                ("bake.material_by_role.rigid=engin", "bake.material_by_role.rigid", "nearest: 'engine'"),
                                ("bake.material_by_role.rigidd=engine", "bake.material_by_role.rigidd", "nearest: 'rigid'"),
                                ("bake.material_by_component.hood=", "bake.material_by_component.hood")]:
            for words in [[], ["--dry-run"]]:
                self.fails(self.cook("--set", setting, *words, recipe="car_body"), 1, *parts)
        for text, *parts in [('{"bake": {"materials": []}}', "bake.materials", "empty"),
                             ('{"bake": {"materials": [{"name": "steel"}, {"name": "steel"}]}}', "bake.materials[1].name"),
                             ('{"bake": {"material_by_role": {"solid": "stel"}}}', "nearest: 'steel'"),
                             ('{"bake": {"sensors": [{"name": "a"}, {"name": "a"}]}}', "bake.sensors[1].name")]:
            for words in [[], ["--dry-run"]]:
                self.fails(self.cook(*words, recipe=self.recipe(text)), 1, "recipe.json", *parts)

    def test_the_schema_knows_what_a_count_looks_like(self):
        schema = json.loads(self.ok(program.run("dev", "schema", "recipe")).stdout)
        pattern = schema["properties"]["sample"]["properties"]["points"]["pattern"]
        for good in ["auto", "0", "500", "tets:5000"]:
            self.assertRegex(good, pattern)
        for bad in ["", "garbage", "tets:0", "tets:", "-1", "500 "]:
            self.assertNotRegex(bad, pattern)

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
