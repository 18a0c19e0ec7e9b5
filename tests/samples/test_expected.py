# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the program on the samples and compares with samples/expected: test_expected.py PROGRAM PROJECT_FOLDER

The expected figures follow from how the samples are made, not from what the program said."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)
PROJECT = pathlib.Path(sys.argv.pop(1))


def run(*words):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, cwd=PROJECT)


def expected(name):
    return json.loads((PROJECT / "samples/expected" / name).read_text())


class Samples(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.output = pathlib.Path(self.folder.name) / "out.hdf"

    def tearDown(self):
        self.folder.cleanup()

    def test_broken_shells_are_said_to_be_what_they_are(self):
        wanted = expected("broken.json")
        files = {path.stem: path for path in (PROJECT / "samples/broken").glob("*.obj")}
        self.assertEqual(files.keys(), wanted.keys())
        for name, path in sorted(files.items()):
            with self.subTest(name):
                done = run("import", "--shell", path, "-o", self.output, "--format", "json")
                self.assertEqual(done.returncode, wanted[name]["exit_code"], done.stderr)
                if done.returncode == 0:
                    codes = [finding["code"] for finding in json.loads(done.stdout)["report"]["findings"]]
                    self.assertEqual(codes, wanted[name]["findings"])
                else:
                    self.assertIn(path.name, done.stderr)

    def test_sound_samples_cook_and_pass_check(self):
        for name, sample in expected("cooked.json").items():
            with self.subTest(name):
                done = run("cook", sample["recipe"], "--shell", sample["shell"], "--visual", sample["visual"],
                           "-o", self.output, "-q")
                self.assertEqual(done.returncode, 0, done.stderr)
                done = run("check", self.output)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.compare(sample, json.loads(run("inspect", self.output, "--format", "json").stdout)["bundle"])

    def compare(self, sample, bundle):
        self.assertEqual(bundle["locked_nodes"], sample["locked_nodes"])
        self.assertEqual([region["name"] for region in bundle["regions"]], sample["regions"])
        self.assertEqual([visual["vertices"] for visual in bundle["visuals"]], [sample["visual_vertices"]])
        self.assertEqual([visual["outside"] for visual in bundle["visuals"]], [sample["visual_vertices_outside"]])
        self.assertEqual([sensor["name"] for sensor in bundle["sensors"]], sample["sensors"])
        # The tets may cut a corner of the shell, but not much of one.
        self.assertAlmostEqual(bundle["volume_m3"] / sample["volume_m3"], 1, delta=0.005)


if __name__ == "__main__":
    unittest.main()
