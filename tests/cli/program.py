# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the built program for the tests in this folder.

CRUMPLE names the program, CRUMPLE_DATA the folder of real input; tests that need it skip visibly where it is absent.
CRUMPLE_OPTIMIZED=0 says that the program is a slow one, of a debug build: what takes long in Release is asked smaller.
"""
import json
import math
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

PROGRAM = os.environ.get("CRUMPLE", "crumple")
SOURCE = pathlib.Path(__file__).resolve().parents[2]
DATA = pathlib.Path(os.environ.get("CRUMPLE_DATA", SOURCE.parent / "shared" / "data"))
FULL = os.environ.get("CRUMPLE_FULL_TESTS") == "1"
OPTIMIZED = os.environ.get("CRUMPLE_OPTIMIZED", "1") == "1"


def run(*words, timeout=300, **options):
    """The finished process; stdout and stderr as text."""
    words = [PROGRAM, *map(str, words)]
    return subprocess.run(words, capture_output=True, text=True, timeout=timeout, **options)


def stages():
    """Names of the stages, in the order they run."""
    return [stage["name"] for stage in json.loads(run("--version", "--json").stdout)["stages"]]


def needs_data(test):
    return unittest.skipUnless(DATA.is_dir(), f"no real input at {DATA}")(test)


def sphere_obj(path, rings=8, around=12, radius=1.0, locked_below=-0.5, centre=(0, 0, 0)):
    """A closed shell, counter-clockwise from outside; vertices below a height are painted red 0."""
    points = [(0, radius, 0)]
    for i in range(1, rings):
        polar = math.pi * i / rings
        for j in range(around):
            turn = 2 * math.pi * j / around
            points.append((radius * math.sin(polar) * math.cos(turn), radius * math.cos(polar),
                           -radius * math.sin(polar) * math.sin(turn)))
    points.append((0, -radius, 0))
    ring = lambda i, j: 2 + (i - 1) * around + j % around
    faces = [(1, ring(1, j), ring(1, j + 1)) for j in range(around)]
    for i in range(1, rings - 1):
        for j in range(around):
            faces.append((ring(i, j), ring(i + 1, j), ring(i + 1, j + 1)))
            faces.append((ring(i, j), ring(i + 1, j + 1), ring(i, j + 1)))
    last = len(points)
    faces += [(last, ring(rings - 1, j + 1), ring(rings - 1, j)) for j in range(around)]
    with open(path, "w") as file:
        for x, y, z in points:
            color = "0 0 0" if y < locked_below * radius else "1 1 1"
            file.write(f"v {x + centre[0]:.6f} {y + centre[1]:.6f} {z + centre[2]:.6f} {color}\n")
        for face in faces:
            file.write("f %d %d %d\n" % face)
    return path


class Case(unittest.TestCase):
    """A test with a folder of its own, a small painted shell and a visual mesh inside it."""

    maxDiff = None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="crumple_test_"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.shell = sphere_obj(self.folder / "shell.obj")
        self.visual = sphere_obj(self.folder / "visual.obj", rings=12, around=20, radius=0.7)
        self.output = self.folder / "out.hdf"

    def path(self, name):
        return self.folder / name

    def cook(self, *words, recipe="smoke", output=None, **options):
        return run("cook", recipe, "--shell", self.shell, "--visual", self.visual, "-o", output or self.output, *words,
                   **options)

    def ok(self, process):
        self.assertEqual(process.returncode, 0, process.stdout + process.stderr)
        return process

    def fails(self, process, code, *parts):
        """Ends with the code and says each part on stderr; says nothing on stdout."""
        self.assertEqual(process.returncode, code, process.stdout + process.stderr)
        for part in parts:
            self.assertIn(part, process.stderr)
        self.assertEqual(process.stdout, "")
        return process

    def json_of(self, process):
        self.ok(process)
        return json.loads(process.stdout)

    def leftovers(self):
        """Temporary files that something left behind: no other file here is hidden."""
        return [name for name in os.listdir(self.folder) if name.startswith(".")]
