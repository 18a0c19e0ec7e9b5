# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that belong to the files one gives: buffers of glTF are inputs, material libraries are not."""
import base64
import hashlib
import json
import os
import struct
import unittest

import program


def gltf_of(obj, path, uri, buffer=None, **more):
    """The painted mesh of an OBJ of ours as glTF, its numbers in a buffer that the uri leads to."""
    words = [line.split() for line in obj.read_text().splitlines()]
    points = [list(map(float, w[1:])) for w in words if w[0] == "v"]
    faces = [[int(corner) - 1 for corner in w[1:]] for w in words if w[0] == "f"]
    parts = [b"".join(struct.pack("<3f", *p[:3]) for p in points), b"".join(struct.pack("<3f", *p[3:]) for p in points),
             b"".join(struct.pack("<3I", *f) for f in faces)]
    content = b"".join(parts)
    starts = [0, len(parts[0]), len(parts[0]) + len(parts[1])]
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 1}, "indices": 2}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": len(points)},
                      {"bufferView": 1, "componentType": 5126, "type": "VEC3", "count": len(points)},
                      {"bufferView": 2, "componentType": 5125, "type": "SCALAR", "count": 3 * len(faces)}],
        "bufferViews": [{"buffer": 0, "byteOffset": s, "byteLength": len(p)} for s, p in zip(starts, parts)],
        "buffers": [{"byteLength": len(content), "uri": uri or
                     "data:application/octet-stream;base64," + base64.b64encode(content).decode()}], **more}
    path.write_text(json.dumps(document))
    if buffer:
        buffer.write_bytes(content)
    return path


class Buffers(program.Case):
    """A shell whose numbers lie in a file of their own."""

    def setUp(self):
        super().setUp()
        self.buffer = self.path("scene.bin")
        self.gltf = gltf_of(self.shell, self.path("shell.gltf"), "scene.bin", self.buffer)

    def cook(self, *words, shell=None, output=None, **options):
        return program.run("cook", "smoke", "--shell", shell or self.gltf, "-o", output or self.output, *words, **options)

    def test_the_depfile_names_them(self):
        depfile = self.path("out.d")
        self.ok(self.cook("--depfile", depfile))
        self.assertEqual(depfile.read_text(), f"{self.output}: {self.gltf} {self.buffer}\n")

    def test_the_bundle_remembers_what_was_in_them(self):
        report = self.path("report.json")
        self.ok(self.cook("--report", report))
        digests = {file["name"]: file["sha256"] for file in json.loads(report.read_text())["inputs"]}
        self.assertEqual(digests, {name: hashlib.sha256(path.read_bytes()).hexdigest()
                                   for name, path in [("shell", self.gltf), ("shell/buffer/0", self.buffer)]})

    def test_a_dry_run_sees_that_they_changed(self):
        self.ok(self.cook())
        self.assertIn("up to date", self.ok(self.cook("--dry-run")).stdout)
        content = bytearray(self.buffer.read_bytes())
        content[2] ^= 1
        self.buffer.write_bytes(content)
        process = self.ok(self.cook("--dry-run"))
        self.assertIn("would be cooked", process.stdout)
        self.assertIn("input shell/buffer/0 changed", process.stdout)

    def test_nothing_is_written_over_them(self):
        before = self.buffer.read_bytes()
        for option in ["--report", "--depfile"]:
            self.fails(self.cook(option, self.buffer), 1, option, "would replace an input")
            self.fails(self.cook(option, self.path("shell.gltf")), 1, option, "would replace an input")
        hdf = gltf_of(self.shell, self.path("other.gltf"), "buffer.hdf", self.path("buffer.hdf"))
        self.fails(self.cook(shell=hdf, output=self.path("buffer.hdf")), 1, "would replace an input")
        process = program.run("import", "--shell", hdf, "-o", self.path("buffer.hdf"))
        self.fails(process, 1, "would replace an input")
        self.assertEqual(self.buffer.read_bytes(), before)

    def test_one_that_several_files_need_is_named_once(self):
        process = self.ok(self.cook("--visual", f"skin={self.gltf}", "--depfile", "-"))
        self.assertEqual(process.stdout, f"{self.output}: {self.gltf} {self.buffer}\n")

    def test_of_visual_meshes_they_count_too(self):
        report = self.path("report.json")
        self.ok(program.run("cook", "smoke", "--shell", self.shell, "--visual", f"skin={self.gltf}", "-o", self.output,
                            "--report", report))
        names = [file["name"] for file in json.loads(report.read_text())["inputs"]]
        self.assertEqual(names, ["shell", "visual/skin", "visual/skin/buffer/0"])

    def tets(self):
        """Nodes, tets, masses and locks of the output, as text. Where its numbers came from is not in there."""
        vtu = self.path("out.vtu")
        self.ok(program.run("export", self.output, "--vtu", vtu))
        return vtu.read_text()

    def test_paths_go_up_and_are_percent_encoded_or_not(self):
        self.ok(self.cook())
        expected = self.tets()
        inner = self.path("folder")
        inner.mkdir()
        spaced = self.path("my 100% scene.bin")
        cases = [("data", None, None), ("encoded", "my%20100%25%20scene.bin", spaced), ("plain", "my 100% scene.bin", spaced),
                 ("folder/up", "../scene.bin", self.buffer), ("folder/long", "./../folder//../scene.bin", self.buffer)]
        for name, uri, buffer in cases:
            with self.subTest(name):
                shell = gltf_of(self.shell, self.path(name + ".gltf"), uri, buffer)
                depfile = self.path("out.d")
                self.output.unlink()
                self.ok(self.cook("--depfile", depfile, shell=shell))
                self.assertEqual(depfile.read_text().count(".bin"), 0 if buffer is None else 1)
                self.assertEqual(self.tets(), expected)

    def test_what_cannot_be_read_is_refused_in_words_at_once(self):
        os.mkfifo(self.path("pipe"))
        self.path("folder").mkdir()
        self.path("short.bin").write_bytes(b"short")
        cases = [("none.bin", "No such file"), ("pipe", "device or pipe"), ("folder", "is a folder"),
                 ("short.bin", "5 bytes"), ("http://example.org/a.bin", "relative"), (str(self.buffer), "relative"),
                 ("file://" + str(self.buffer), "relative")]
        for uri, words in cases:
            shell = gltf_of(self.shell, self.path("odd.gltf"), uri)
            for verb in [["cook", "smoke"], ["import"]]:
                process = program.run(*verb, "--shell", shell, "-o", self.output, timeout=20)
                self.fails(process, 3, "odd.gltf: ", uri[:20])
            process = program.run("cook", "smoke", "--shell", shell, "-o", self.output, "--dry-run", timeout=20)
            self.fails(process, 3, "odd.gltf: ", uri[:20], words)

    def test_buffers_of_what_is_no_surface_are_no_inputs(self):
        document = json.loads(self.gltf.read_text())
        document["buffers"].append({"byteLength": 16, "uri": "walk.bin"})
        document["bufferViews"].append({"buffer": 1, "byteLength": 16})
        document["skins"] = [{"joints": [0]}]
        document["nodes"][0]["skin"] = 0
        self.gltf.write_text(json.dumps(document))
        report = self.path("report.json")
        self.ok(self.cook("--report", report))
        self.assertEqual(len(json.loads(report.read_text())["inputs"]), 2)


class MaterialLibraries(program.Case):
    def test_they_are_not_read(self):
        text = self.shell.read_text()
        self.shell.write_text("mtllib shell.mtl\nusemtl steel\n" + text)
        self.ok(self.cook())
        without = self.output.read_bytes()
        os.mkfifo(self.path("shell.mtl"))
        self.output.unlink()
        self.ok(self.cook(timeout=20))
        self.assertEqual(self.output.read_bytes(), without)


class DryRun(program.Case):
    def test_it_judges_what_it_can_without_reading_all(self):
        cases = [("a.blend", b"x", "not read"), ("a.stl", b"", "empty"), ("a.obj", b"v 0 0 0\n", "no faces"),
                 ("a.off", b"OFF\n9 9 0\n", "more than the file can hold"), ("a.glb", b"glTF", "ends within its header"),
                 ("a.ply", b"ply\n", "end_header"), ("a.dae", b"<COLLADA>\n<asset>", "damaged or cut short"),
                 ("a.fbx", b"Objects: {\n", "the file ends within 'Objects'"),
                 ("a.x", b"xof 0303txt 0032\nMesh {\n4;", "a number is missing")]
        for name, content, words in cases:
            path = self.path(name)
            path.write_bytes(content)
            process = program.run("cook", "smoke", "--shell", path, "-o", self.output, "--dry-run")
            self.fails(process, 3, name, words)


class Depfile(program.Case):
    def test_it_goes_to_stdout_as_the_report_does(self):
        process = self.ok(self.cook("--depfile", "-"))
        self.assertEqual(process.stdout, f"{self.output}: {self.shell} {self.visual}\n")
        self.assertFalse(self.path("-").exists())
        for words in [["--report", "-"], ["--format", "json"]]:
            self.fails(self.cook("--depfile", "-", *words), 1, "stdout")


if __name__ == "__main__":
    unittest.main()
