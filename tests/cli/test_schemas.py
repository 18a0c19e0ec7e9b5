# SPDX-License-Identifier: GPL-3.0-or-later
"""schemas/ is what the program would write now, and everything it prints as JSON obeys its schema."""
import json
import unittest

import program

try:
    import jsonschema
except ImportError:
    jsonschema = None

SCHEMAS = program.SOURCE / "schemas"


class Current(program.Case):
    def test_the_files_are_what_the_program_writes(self):
        written = self.path("schemas")
        written.mkdir()
        self.ok(program.run("dev", "schema", "--write", written))
        names = sorted(path.name for path in written.iterdir())
        self.assertEqual(names, sorted(path.name for path in SCHEMAS.glob("*.json")), "run: crumple dev schema --write schemas")
        for name in names:
            self.assertEqual((written / name).read_text(), (SCHEMAS / name).read_text(),
                             f"{name} is not current; run: crumple dev schema --write schemas")

    def test_a_schema_can_be_asked_for_by_name(self):
        names = self.ok(program.run("dev", "schema")).stdout.split()
        self.assertIn("recipe", names)
        for name in names:
            self.assertEqual(self.ok(program.run("dev", "schema", name)).stdout, (SCHEMAS / f"{name}.schema.json").read_text())
        self.fails(program.run("dev", "schema", "recip"), 1, "'recipe'")


@unittest.skipUnless(jsonschema, "no jsonschema")
class Outputs(program.Case):
    def obeys(self, name, value):
        schema = json.loads((SCHEMAS / f"{name}.schema.json").read_text())
        jsonschema.Draft7Validator.check_schema(schema)
        jsonschema.validate(value, schema, cls=jsonschema.Draft7Validator)

    def test_every_schema_is_a_schema(self):
        for path in SCHEMAS.glob("*.json"):
            jsonschema.Draft7Validator.check_schema(json.loads(path.read_text()))

    def test_the_recipes_obey(self):
        for path in (program.SOURCE / "pipelines").glob("*.json"):
            self.obeys("recipe", json.loads(path.read_text()))
        with self.assertRaises(jsonschema.ValidationError):
            self.obeys("recipe", {"relax": {"sweep": 5}})
        with self.assertRaises(jsonschema.ValidationError):
            self.obeys("recipe", {"relax": {"sweeps": -5}})

    def test_the_scenes_obey(self):
        scenes = sorted((program.SOURCE / "pipelines" / "scenes").glob("*.json"))
        self.assertTrue(scenes)
        for path in scenes:
            with self.subTest(path.name):
                self.obeys("scene", json.loads(path.read_text()))

    def test_the_report_of_a_cook_and_of_every_stage_obeys(self):
        report = self.json_of(self.cook("--format", "json", "-q"))
        self.obeys("cook_report", report)
        self.obeys("recipe", report["params"])
        for stage in report["stages"]:
            self.obeys("stage_" + stage["name"], stage["report"])
            for finding in stage["findings"]:
                self.obeys("finding", finding)

    def test_the_report_of_a_failed_cook_obeys(self):
        self.shell.write_text("f 1 2 3\n")
        process = self.cook("--format", "json", "-q")
        self.assertEqual(process.returncode, 3)
        self.obeys("cook_report", json.loads(process.stdout))

    def test_everything_else_obeys(self):
        self.obeys("dry_run", self.json_of(self.cook("--dry-run", "--format", "json")))
        progress = self.ok(self.cook("--progress", "json", "-q")).stderr
        for line in progress.splitlines():
            self.obeys("progress", json.loads(line))
        other = self.path("other.hdf")
        self.ok(self.cook("--set", "sample.seed=3", output=other))
        self.obeys("check", json.loads(program.run("check", self.output, other, self.path("none"), "--format", "json").stdout))
        self.obeys("inspect", self.json_of(program.run("inspect", self.output, "--format", "json")))
        self.obeys("compare", json.loads(program.run("compare", self.output, other, "--format", "json").stdout))
        self.obeys("version", self.json_of(program.run("--version", "--json")))


if __name__ == "__main__":
    unittest.main()
