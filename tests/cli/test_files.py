# SPDX-License-Identifier: GPL-3.0-or-later
"""crumple check, inspect, compare and export; what other programs make of a bundle."""
import json
import random
import resource
import struct
import unittest

import blob_reader
import program

try:
    import h5py
except ImportError:
    h5py = None
try:
    import vtk
except ImportError:
    vtk = None


class Check(program.Case):
    def setUp(self):
        super().setUp()
        self.ok(self.cook())

    def check(self, *paths, **options):
        process = program.run("check", *paths, "--format", "json", **options)
        return process.returncode, json.loads(process.stdout)

    def test_what_was_cooked_passes_with_its_figures(self):
        code, report = self.check(self.output)
        self.assertEqual((code, report["exit_code"], len(report["files"])), (0, 0, 1))
        self.assertEqual(report["files"][0]["problems"], [])
        self.assertEqual(report["files"][0]["figures"]["shape"]["inverted"], 0)
        self.assertGreater(report["files"][0]["figures"]["cost"]["pcg_stiff"], 0)
        self.assertEqual([stage["name"] for stage in report["files"][0]["record"]], program.stages())

    def test_figures_that_need_the_shell_come_from_the_stored_report(self):
        _, report = self.check(self.output)
        stages = {stage["name"]: stage["report"] for stage in report["files"][0]["record"]}
        self.assertGreater(stages["cull"]["shell_volume"], 0)
        self.assertIn("findings", stages["import"])
        self.assertEqual(report["files"][0]["shell"], "stored")
        self.assertEqual(report["files"][0]["figures"], stages["gates"]["figures"])

    def test_figures_that_need_the_shell_are_measured_where_it_is(self):
        _, stored = self.check(self.output)
        self.ok(self.cook("--keep-work"))
        _, measured = self.check(self.output)
        self.assertEqual(measured["files"][0]["shell"], "measured")
        self.assertEqual(measured["files"][0]["figures"], stored["files"][0]["figures"])
        self.assertEqual(measured["files"][0]["findings"], stored["files"][0]["findings"])

    def test_a_work_file_that_was_never_held_against_gates_passes_and_says_so(self):
        self.ok(self.cook("--keep-work"))
        again = self.path("again.hdf")
        self.ok(program.run("bake", self.output, "-o", again))
        code, report = self.check(again)
        self.assertEqual(code, 0)
        self.assertIn("GATES_NOT_ASKED", [finding["code"] for finding in report["files"][0]["findings"]])
        judged = self.path("judged.hdf")
        self.ok(program.run("gates", again, "-o", judged, "--enforce", "false"))
        code, report = self.check(judged)
        self.assertNotIn("GATES_NOT_ASKED", [finding["code"] for finding in report["files"][0]["findings"]])

    def test_a_file_that_is_not_there_is_exit_2(self):
        code, report = self.check(self.path("none.hdf"))
        self.assertEqual(code, 2)
        self.assertIn("none.hdf", report["files"][0]["error"])

    def test_a_damaged_file_is_named_once(self):
        self.output.write_bytes(self.output.read_bytes()[:3000])
        process = program.run("check", self.output)
        self.assertEqual(process.returncode, 7)
        self.assertEqual(process.stdout.count("out.hdf"), 1, process.stdout)
        self.assertNotIn("(0, 0, 0)", process.stdout)
        self.assertIn("3000", process.stdout)
        process = program.run("check", self.path("none.hdf"))
        self.assertEqual(process.stdout.count("none.hdf"), 1, process.stdout)

    def test_damage_is_exit_7(self):
        content = bytearray(self.output.read_bytes())
        damaged = self.path("damaged.hdf")
        for case in [bytearray(), bytearray(b"hello"), content[:-1], content[:512], content + b"x", bytearray(len(content))]:
            damaged.write_bytes(case)
            code, report = self.check(damaged)
            self.assertEqual(code, 7, len(case))
            self.assertTrue(report["files"][0]["error"])
            self.fails(program.run("inspect", damaged), 7, "damaged.hdf")
            self.fails(program.run("compare", self.output, damaged), 7, "damaged.hdf")

    def test_a_flipped_bit_anywhere_is_exit_7(self):
        content = self.output.read_bytes()
        damaged = self.path("damaged.hdf")
        seed = random.randrange(1 << 30)
        numbers = random.Random(seed)
        for _ in range(200 if program.FULL else 20):
            at = numbers.randrange(len(content))
            flipped = bytearray(content)
            flipped[at] ^= 1 << numbers.randrange(8)
            damaged.write_bytes(flipped)
            self.assertEqual(program.run("check", damaged).returncode, 7, f"byte {at}, seed {seed}")

    def test_over_many_files_the_most_important_code_wins(self):
        damaged = self.path("damaged.hdf")
        damaged.write_bytes(b"nothing")
        none = self.path("none.hdf")
        self.assertEqual(self.check(self.output, self.output)[0], 0)
        self.assertEqual(self.check(self.output, damaged, self.output)[0], 7)
        self.assertEqual(self.check(damaged, none, self.output)[0], 2)
        self.assertEqual([file["exit_code"] for file in self.check(damaged, none, self.output)[1]["files"]], [7, 2, 0])

    @unittest.skipUnless(program.OPTIMIZED, "AddressSanitizer's own mappings exclude a limit on the address space")
    def test_too_little_memory_is_no_damage(self):
        samples = program.SOURCE / "samples" / "car"
        self.ok(program.run("cook", "smoke", "--shell", samples / "car_shell.glb", "--visual", samples / "car_visual.glb",
                            "--keep-work", "-o", self.output))
        codes = set()
        for mebibytes in range(50, 110, 3):
            for verb in "check", "inspect":
                limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (mebibytes << 20, mebibytes << 20))
                process = program.run(verb, self.output, preexec_fn=limit)
                self.assertIn(process.returncode, (0, 6), f"{verb} {mebibytes} MiB: {process.stdout}{process.stderr}")
                codes.add(process.returncode)
        self.assertEqual(codes, {0, 6})

    def test_text_names_each_file_and_what_is_wrong(self):
        damaged = self.path("damaged.hdf")
        damaged.write_bytes(self.output.read_bytes()[:-5])
        process = program.run("check", self.output, damaged)
        self.assertIn(f"{self.output}: ok", process.stdout)
        self.assertIn(f"{damaged}: DAMAGED", process.stdout)

    def test_no_file_is_a_wrong_call(self):
        self.fails(program.run("check"), 1, "BUNDLE")


class Compare(program.Case):
    def test_equal_files_are_exit_0(self):
        self.ok(self.cook())
        report = self.json_of(program.run("compare", self.output, self.output, "--format", "json"))
        self.assertEqual((report["is_equal"], report["differing"]), (True, []))

    def test_the_first_and_the_largest_difference_are_named(self):
        other = self.path("other.hdf")
        self.ok(self.cook())
        self.ok(self.cook("--set", "bake.stiffness_by_component.shell=3", output=other))
        process = program.run("compare", self.output, other, "--format", "json")
        report = json.loads(process.stdout)
        self.assertEqual(process.returncode, 7)
        names = [difference["path"] for difference in report["differing"]]
        self.assertIn("/bundle/stiffness_scale", names)
        self.assertTrue(report["first"].startswith("/bundle/"))
        self.assertEqual((report["largest"], report["largest_size"]), ("/bundle/stiffness_scale", 2))
        self.assertIn("/bundle/stiffness_scale", program.run("compare", self.output, other).stdout)

    def test_files_of_other_sizes_are_compared(self):
        other = self.path("other.hdf")
        self.ok(self.cook())
        self.ok(self.cook("--set", "sample.points=40", "--keep-work", output=other))
        report = json.loads(program.run("compare", self.output, other, "--format", "json").stdout)
        kinds = {difference["kind"] for difference in report["differing"]}
        self.assertLessEqual({"shape", "only_in_second"}, kinds)

    def test_a_missing_file_is_exit_2(self):
        self.ok(self.cook())
        self.fails(program.run("compare", self.output, self.path("none.hdf")), 2, "none.hdf")
        self.fails(program.run("compare", self.output), 1)

    def test_a_blob_is_not_called_damaged(self):
        blob = self.path("out.blob")
        self.ok(self.cook())
        self.ok(program.run("export", self.output, "--blob", blob))
        self.fails(program.run("compare", self.output, blob), 1, "out.blob", "compare the bundles")

    def test_an_export_goes_to_a_file(self):
        self.ok(self.cook())
        self.fails(program.run("export", self.output, "--vtu", "-", cwd=self.folder), 1, "--vtu -", "./-")
        self.assertFalse(self.path("-").exists())


class Inspect(program.Case):
    def test_it_says_what_the_bundle_holds(self):
        self.ok(self.cook())
        report = self.json_of(program.run("inspect", self.output, "--format", "json"))
        self.assertEqual(report["bytes"], self.output.stat().st_size)
        self.assertGreater(report["bundle"]["locked_nodes"], 0)
        self.assertIn("/bundle/tets", [dataset["path"] for dataset in report["datasets"]])
        text = self.ok(program.run("inspect", self.output)).stdout
        self.assertIn("locked_nodes", text)
        self.assertNotIn("/bundle/tets", text)
        self.assertIn("/bundle/tets", self.ok(program.run("inspect", self.output, "--datasets")).stdout)


class Export(program.Case):
    def setUp(self):
        super().setUp()
        self.ok(self.cook())

    def test_it_says_where_to_or_what(self):
        self.fails(program.run("export", self.output), 1, "--vtu")
        self.fails(program.run("export", self.output, "-o", self.path("x.stl")), 1, "x.stl")
        self.fails(program.run("export", self.path("none.hdf"), "-o", self.path("x.vtu")), 2, "none.hdf")
        self.fails(program.run("export", self.output, "--vtu", self.output), 1, "would replace")
        self.fails(program.run("export", self.output, "--vtu", self.path("none/x.vtu")), 2)

    def test_the_exported_boundary_imports_with_the_same_locks(self):
        self.ok(program.run("export", self.output, "-o", self.path("boundary.obj")))
        first = self.json_of(program.run("inspect", self.output, "--format", "json"))["bundle"]
        again = self.path("again.hdf")
        report = self.json_of(program.run("cook", "smoke", "--shell", self.path("boundary.obj"), "-o", again, "--format", "json", "-q"))
        self.assertEqual(report["stages"][0]["report"]["locked"], first["locked_nodes"])

    def test_a_blob_is_as_good_as_its_bundle(self):
        blob = self.path("car.blob")
        self.ok(program.run("export", self.output, "--blob", blob))
        self.assertEqual(blob.stat().st_size % 64, 0)
        checked = self.ok(program.run("check", blob)).stdout
        self.assertIn("ok", checked)
        self.assertIn("a blob carries no record of quality gates", checked)
        inspected = [self.json_of(program.run("inspect", path, "--format", "json")) for path in (blob, self.output)]
        self.assertEqual(inspected[0]["bundle"], inspected[1]["bundle"])
        for name, source in (("a", self.output), ("b", blob)):
            self.ok(program.run("export", source, "--vtu", self.path(name + ".vtu")))
            self.ok(program.run("export", source, "-o", self.path(name + ".blob")))
        for ending in (".vtu", ".blob"):
            self.assertEqual(self.path("a" + ending).read_bytes(), self.path("b" + ending).read_bytes())

    @unittest.skipUnless(h5py, "h5py is not installed")
    def test_a_reader_written_from_the_blobs_document_finds_the_same_arrays(self):
        self.ok(self.cook(recipe=self.sensor_recipe()))
        self.ok(program.run("export", self.output, "--blob", self.path("car.blob")))
        arrays = blob_reader.read(self.path("car.blob").read_bytes())
        with h5py.File(self.output) as file:
            expected = []
            file["bundle"].visititems(lambda name, item: expected.append(name) if isinstance(item, h5py.Dataset) else None)
            self.assertEqual(sorted(expected), sorted(arrays))
            for name in expected:
                stored = file["bundle/" + name][()]
                if stored.dtype.kind == "S":
                    stored = [text.decode() for text in stored]
                self.assertEqual(list(map(str, stored)), list(map(str, arrays[name])), name)

    def sensor_recipe(self):
        path = self.path("sensor.json")
        recipe = json.loads((program.SOURCE / "pipelines" / "smoke.json").read_text())
        recipe.setdefault("bake", {})["sensors"] = [{"name": "top", "by": "box", "box_low": [-2, 0, -2], "box_high": [2, 2, 2]}]
        path.write_text(json.dumps(recipe))
        return path

    def test_a_damaged_blob_is_refused(self):
        blob = self.path("car.blob")
        self.ok(program.run("export", self.output, "--blob", blob))
        damaged = bytearray(blob.read_bytes())
        damaged[5000] ^= 1
        blob.write_bytes(damaged)
        checked = program.run("check", blob)
        self.assertEqual(checked.returncode, 7)
        self.assertIn("damaged", checked.stdout)
        self.fails(program.run("inspect", blob), 7, "damaged")

    def test_exporting_twice_gives_the_same_bytes(self):
        for name in ["x.vtu", "x.msh", "x.obj"]:
            self.ok(program.run("export", self.output, "-o", self.path(name)))
            first = self.path(name).read_bytes()
            self.ok(program.run("export", self.output, "-o", self.path(name)))
            self.assertEqual(self.path(name).read_bytes(), first)

    @unittest.skipUnless(vtk, "no VTK")
    def test_vtk_reads_the_vtu(self):
        self.ok(program.run("export", self.output, "--vtu", self.path("x.vtu")))
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(self.path("x.vtu")))
        reader.Update()
        bundle = self.json_of(program.run("inspect", self.output, "--format", "json"))["bundle"]
        grid = reader.GetOutput()
        self.assertEqual((grid.GetNumberOfPoints(), grid.GetNumberOfCells()), (bundle["nodes"], bundle["tets"]))
        self.assertTrue(grid.GetPointData().HasArray("locked"))


class Readers(program.Case):
    """Other people's readers open our files as they are."""

    @unittest.skipUnless(h5py, "no h5py")
    def test_h5py_reads_the_bundle(self):
        for layout in ["chunked", "contiguous"]:
            self.ok(self.cook("--layout", layout))
            with h5py.File(self.output) as file:
                bundle = file["bundle"]
                self.assertEqual(bundle["tets"].shape[1], 4)
                self.assertEqual(bundle["rest_positions"].dtype, "float32")
                self.assertEqual(len(bundle["mass"]), len(bundle["rest_positions"]))
                self.assertIn("visual", bundle)

    @unittest.skipUnless(vtk and hasattr(vtk, "vtkHDFReader"), "no VTK with a VTKHDF reader")
    def test_paraview_s_reader_opens_bundles_and_work_files(self):
        self.ok(self.cook("--keep-work"))
        work = self.path("work.hdf")
        self.path("points.xyz").write_text("0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n")
        self.ok(program.run("delaunay", self.path("points.xyz"), "-o", work))
        for path in [self.output, work]:
            reader = vtk.vtkHDFReader()
            self.assertTrue(reader.CanReadFile(str(path)))
            reader.SetFileName(str(path))
            reader.Update()
            self.assertGreater(reader.GetOutput().GetNumberOfCells(), 0)
            self.assertEqual(reader.GetOutput().GetCellType(0), vtk.VTK_TETRA)


if __name__ == "__main__":
    unittest.main()
