# SPDX-License-Identifier: GPL-3.0-or-later
"""Real input through the whole program. Skipped, visibly, where the data is absent."""
import json
import struct
import unittest

import cook_assets
import program

try:
    import h5py
except ImportError:
    h5py = None

LOCKS = program.DATA / "locks" / "car_body"
EXACT = """ascii_rgb_u8.ply ascii_rgba_u8.ply ascii_rgb_f32.ply bin_rgba_u8.ply be_rgba_u8.ply bin_rgba_u16.ply
    bin_rgba_f32.ply bin_posf64_rgba_u8.ply float.obj 3dec.obj int255.obj rgb_u8n.glb rgba_u8n.glb rgba_u16n.glb rgba_f32.glb
    flat_rgba_u8n.glb twoprims_u8n.glb hand.dae viaassimp.x coff_float.off coff_int.off""".split()


def vertices(name="truth.bin"):
    """Rows of x y z r g b a, as float32."""
    content = (LOCKS / name).read_bytes()
    count = struct.unpack_from("<i", content)[0]
    return [struct.unpack_from("<7f", content, 4 + 28 * i) for i in range(count)]


def truth(name="truth.bin"):
    """Positions of the locked vertices: red below half an 8-bit step."""
    return {row[:3] for row in vertices(name) if row[3] < 0.5 / 255}


@program.needs_data
@unittest.skipUnless(h5py, "no h5py")
class Locks(program.Case):
    """What the artist painted is locked in the bundle, exactly where the file says."""

    def locked(self, name, *words):
        self.ok(program.run("cook", "smoke", "--shell", LOCKS / f"car_body.{name}", "-o", self.output, "-q", *words))
        with h5py.File(self.output) as file:
            listed = {tuple(map(float, row)) for row in file["bundle/locked_positions"][:]}
            nodes = {tuple(map(float, row)) for row in file["bundle/rest_positions"][:][file["bundle/locked"][:] == 1]}
        self.assertEqual(listed, nodes, name)
        self.ok(program.run("check", self.output))
        return listed

    def test_every_format_gives_the_84_locks_exactly(self):
        expected = truth()
        self.assertEqual(len(expected), 84)
        for name in EXACT:
            with self.subTest(name):
                self.assertEqual(self.locked(name), expected)

    def test_fbx_is_in_centimetres(self):
        expected = sorted((tuple(0.01 * x for x in p)) for p in truth())
        found = sorted(self.locked("viaassimp.fbxa.fbx"))
        self.assertEqual(len(found), 84)
        for a, b in zip(expected, found):
            for x, y in zip(a, b):
                self.assertAlmostEqual(x, y, delta=max(abs(x) * 2**-23, 1e-12))


    def import_report(self, name, *words):
        report = self.json_of(program.run("cook", "smoke", "--shell", LOCKS / f"car_body.{name}", "-o", self.output, "-q",
                                          "--format", "json", *words))
        return report["stages"][0]["report"]

    def test_variants_by_their_own_truth(self):
        also = {row[:3] for i, row in enumerate(vertices()) if i in (0, 1, 2, 3, 7)}
        self.assertEqual(self.locked("weirdred_f32.ply"), truth() | also)
        self.assertEqual(self.locked("tiny1e-6_rgba_u8.ply"), truth("truth_tiny.bin"))
        self.assertEqual(self.locked("color1_only_u8n.glb", "--color-set", "1"), truth())
        self.assertEqual(len(self.locked("2dec.obj")), 109)

    def test_transforms_keep_the_number_of_locks_and_a_positive_volume(self):
        for name in ["mirrored_u8n.glb", "nodexform_u8n.glb"]:
            self.assertEqual(len(self.locked(name)), 84, name)
        report = self.import_report("mirrored_u8n.glb")
        self.assertTrue(all(component["volume"] > 0 for component in report["components"]))

    def test_what_paints_nothing_is_told(self):
        for name in ["viaassimp.stl", "color1_only_u8n.glb"]:
            report = self.import_report(name)
            self.assertEqual(report["locked"], 0, name)
            self.assertTrue(report["findings"], name)

    def test_what_cannot_be_read_is_exit_3_and_says_why(self):
        for name, word in [("partial.obj", "line"), ("partial_unlocked.obj", "line"), ("rgba.obj", "line"),
                           ("viaassimp.x3d", "obj"), ("viaassimp.3mf", "obj"), ("viaassimp.assbin", "obj"),
                           ("viaassimp.fbx", ""), ("viaassimp.plyb.ply", "")]:
            with self.subTest(name):
                process = program.run("cook", "smoke", "--shell", LOCKS / f"car_body.{name}", "-o", self.output)
                self.fails(process, 3, name)
                self.assertIn(word, process.stderr.lower())
                self.assertFalse(self.output.exists())


@program.needs_data
class Assets(program.Case):
    def test_the_twelve_cook_and_pass_check(self):
        for shell, visual in cook_assets.ASSETS:
            if shell.startswith("mengersponge") and not program.FULL:
                continue  # 8 000 vertices on cospherical grids: seconds
            recipe = "car_body" if program.FULL or program.OPTIMIZED else "smoke"
            with self.subTest(shell):
                row = cook_assets.cook(shell, visual, recipe, self.folder)
                self.assertEqual((row["exit"], row["check"]), (0, 0), row)
                self.assertGreater(row["tets"], 0)

    def test_everything_cooks_or_is_refused_with_a_reason(self):
        formats = {".obj", ".ply", ".off", ".stl", ".gltf", ".glb", ".dae", ".fbx", ".x"}
        files = [path for path in sorted(program.DATA.rglob("*.*")) if path.suffix in formats | {".3mf", ".x3d", ".assbin", ".json", ".md"}]
        self.assertGreater(len(files), 50)
        for path in files:
            if path.stat().st_size > 200_000 and not program.FULL:
                continue
            with self.subTest(path.name):
                output = self.path("out.hdf")
                process = program.run("cook", "smoke", "--shell", path, "-o", output, "-q", timeout=600)
                self.assertIn(process.returncode, [0, 3], process.stderr)
                if process.returncode == 3:
                    self.assertIn(path.name, process.stderr)
                    self.assertGreater(len(process.stderr), len(path.name) + 30)
                else:
                    self.assertEqual(program.run("check", output).returncode, 0)


@program.needs_data
class Density(program.Case):
    def test_the_tets_asked_for_are_the_tets_in_the_bundle(self):
        for shell in ["spot", "carbody", "cow"]:
            for tets in [3000, 5000]:
                with self.subTest(shell, tets=tets):
                    self.ok(program.run("cook", "car_body", "--shell", program.DATA / "quality" / f"{shell}.obj", "-o",
                                        self.output, "-q", "--set", f"sample.points=tets:{tets}", "--set",
                                        "gates.enforce=false"))
                    bundle = self.json_of(program.run("inspect", self.output, "--format", "json"))["bundle"]
                    self.assertAlmostEqual(bundle["tets"] / tets, 1, delta=0.1)


@program.needs_data
class Dirty(program.Case):
    """Shells that are not closed: refused with what to try, and what was named works."""

    def test_an_open_car_is_refused_and_put_in_a_cage(self):
        shell = program.DATA / "open" / "suv_visual.obj"
        words = ["cook", "car_body", "--shell", shell, "--visual", f"car={shell}", "-o", self.output, "-q"]
        self.fails(program.run(*words), 3, "SHELL_LEAKS", "import.thicken", "import.cage")
        self.assertFalse(self.output.exists())
        self.ok(program.run(*words, "--set", "import.cage=16"))
        self.ok(program.run("check", self.output))
        bundle = self.json_of(program.run("inspect", self.output, "--format", "json"))["bundle"]
        self.assertEqual([visual["outside"] for visual in bundle["visuals"]], [0])


if __name__ == "__main__":
    unittest.main()
