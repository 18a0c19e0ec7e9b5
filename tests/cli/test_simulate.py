# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes end to end: every built-in one runs, bad ones say where, other programs open what comes out."""
import json
import resource
import struct
import unittest

import h5py
import vtk

import program

SCENES = sorted(path.stem for path in (program.SOURCE / "pipelines" / "scenes").glob("*.json"))


class Simulate(program.Case):
    def setUp(self):
        super().setUp()
        self.ok(self.cook("--keep-work", recipe="smoke"))
        self.run_file = self.path("run.hdf")

    def simulate(self, scene, *words):
        return program.run("simulate", self.output, "--scene", scene, "-o", self.run_file, *words)

    def scene(self, **fields):
        path = self.path("scene.json")
        path.write_text(json.dumps(fields))
        return path

    def test_every_built_in_scene_runs_and_reads_back(self):
        for name in SCENES:
            with self.subTest(name):
                result = self.simulate(name)
                self.ok(result)
                self.assertIn("deepest dent", result.stderr)
                with h5py.File(self.run_file) as file:
                    frames = len(file["run/time_s"])
                    self.assertGreater(frames, 10)
                    nodes = file["run/nodes"][...]
                    self.assertEqual(nodes.shape[0] % frames, 0)
                    self.assertTrue((abs(nodes) < 1e6).all())

    def test_a_bad_scene_is_refused_with_the_path_of_the_key(self):
        for fields, path in [({"secnds": 1}, "secnds"), ({"seconds": -1}, "seconds"),
                             ({"obstacles": [{"shape": "ball"}]}, "obstacles[0].shape"),
                             ({"obstacles": [{"shape": "capsule"}]}, "obstacles[0].radius_m"),
                             ({"handles": [{"times_s": [1, 0]}]}, "handles[0].times_s"),
                             ({"velocity": [0, 0, 1e5]}, "velocity"), ({"gravity": [0, 1e308, 0]}, "gravity"),
                             ({"obstacles": [{"axis": [-1e200, 0, 0]}]}, "obstacles[0].axis"),
                             ({"handles": [{"times_s": [0], "box_low": [5, 5, 5]}]}, "handles[0]")]:
            result = self.simulate(self.scene(**fields))
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertIn(path, result.stderr)
            self.assertFalse(self.run_file.exists())
        broken = self.path("broken.json")
        broken.write_text('{"seconds": 1')
        self.assertEqual(self.simulate(broken).returncode, 1)
        self.assertNotEqual(self.simulate("no_such_scene").returncode, 0)

    def test_a_full_disk_leaves_no_folder_without_files(self):
        def little_room():
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))
        self.fails(program.run("simulate", self.output, "--scene", "wall", "-o", self.run_file, preexec_fn=little_room), 2,
                   "run_series")
        self.assertEqual([path.name for path in self.run_file.parent.glob("run*")], [])

    def test_paraview_opens_the_series(self):
        self.ok(self.simulate("wall"))
        folder = self.path("run_series")
        indices = sorted(folder.glob("*.series"))
        self.assertGreaterEqual(len(indices), 2)
        for index in indices:
            files = json.loads(index.read_text())["files"]
            times = [entry["time"] for entry in files]
            self.assertEqual(times, sorted(times))
            for entry in (files[0], files[-1]):
                reader = vtk.vtkHDFReader()
                reader.SetFileName(str(folder / entry["name"]))
                reader.Update()
                self.assertGreater(reader.GetOutput().GetNumberOfPoints(), 0)

    def test_a_shorter_run_takes_the_frames_of_a_longer_one_away(self):
        folder = self.path("run_series")
        self.ok(self.simulate(self.scene(seconds=0.5)))
        longer = {path.name for path in folder.iterdir()}
        foreign = {"notes.txt", "run_control.hdf", "run_control_7.hdf", "other_control_00099.hdf"}
        for name in foreign:
            (folder / name).write_text("mine")
        (folder / "run_gone_00000.hdf").write_text("of a mesh that is gone")
        self.ok(self.simulate(self.scene(seconds=0.2)))
        left = {path.name for path in folder.iterdir()}
        self.assertTrue(foreign < left)
        self.assertLess(left - foreign, longer)
        named = {entry["name"] for index in folder.glob("*.series") for entry in json.loads(index.read_text())["files"]}
        self.assertEqual(left - foreign - {path.name for path in folder.glob("*.series")}, named)

    def test_a_file_in_the_way_of_the_series_stops_before_anything_is_written(self):
        self.path("run_series").write_text("in the way")
        result = self.simulate("wall")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("run_series", result.stderr)
        self.assertFalse(self.run_file.exists())
        self.assertEqual(self.path("run_series").read_text(), "in the way")
        self.ok(self.simulate("wall", "--no-series"))

    def test_damage_is_exit_7_as_in_every_verb_that_reads_a_bundle(self):
        whole = self.output.read_bytes()
        for damaged in [b"", b"no HDF5", whole[:5000], whole[:-1], whole[:9000] + bytes([whole[9000] ^ 1]) + whole[9001:]]:
            self.output.write_bytes(damaged)
            self.fails(self.simulate("wall"), 7, "out.hdf")
            self.fails(program.run("export", self.output, "--blob", self.path("out.blob")), 7, "out.hdf")
            self.assertFalse(self.run_file.exists())
        self.output.unlink()
        self.fails(self.simulate("wall"), 2, "out.hdf")

    def test_a_file_without_a_bundle_is_an_input_that_is_refused(self):
        shell = self.path("shell.hdf")
        self.ok(program.run("import", "--shell", program.SOURCE / "samples" / "car" / "car_shell.glb", "-o", shell))
        for words in (["simulate", shell, "--scene", "wall", "-o", self.run_file],
                      ["export", shell, "--blob", self.path("car.blob")],
                      ["gates", shell, "-o", self.path("g.hdf")]):
            result = program.run(*words)
            self.assertEqual(result.returncode, 3, result.stderr)
            self.assertIn("there is no", result.stderr)
            self.assertIn("run crumple bake first", result.stderr)

    def test_the_animation_is_whole(self):
        self.ok(self.simulate("pole", "--export", "gltf"))
        glb = self.path("run.glb").read_bytes()
        magic, version, size, json_size, kind = struct.unpack("<4sIII4s", glb[:20])
        self.assertEqual((magic, version, size, kind), (b"glTF", 2, len(glb), b"JSON"))
        document = json.loads(glb[20:20 + json_size])
        binary_size, binary_kind = struct.unpack("<I4s", glb[20 + json_size:28 + json_size])
        self.assertEqual((binary_size, binary_kind), (len(glb) - 28 - json_size, b"BIN\0"))
        sizes = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
        parts = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
        for view in document["bufferViews"]:
            self.assertLessEqual(view.get("byteOffset", 0) + view["byteLength"], binary_size)
        for accessor in document["accessors"]:
            needed = accessor["count"] * sizes[accessor["componentType"]] * parts[accessor["type"]]
            view = document["bufferViews"][accessor["bufferView"]]
            self.assertLessEqual(accessor.get("byteOffset", 0) + needed, view["byteLength"])
        for mesh in document["meshes"]:
            for primitive in mesh["primitives"]:
                count = document["accessors"][primitive["attributes"]["POSITION"]]["count"]
                for target in primitive["targets"]:
                    self.assertEqual(document["accessors"][target["POSITION"]]["count"], count)


if __name__ == "__main__":
    unittest.main()
