# SPDX-License-Identifier: GPL-3.0-or-later
"""Each stage alone on a work file."""
import json
import unittest

import program

STAGES = program.stages()


class Chain(program.Case):
    def stage(self, name, output, *words, source=None):
        if name == "import":
            words = ["--shell", self.shell, "--visual", self.visual, *words]
        else:
            words = [source, *words]
        return program.run(name, *words, "-o", output)

    def chain(self, last=STAGES[-1], **words):
        """The work file after each stage up to the last."""
        source = None
        for name in STAGES[:STAGES.index(last) + 1]:
            output = self.path(f"after_{name}.hdf")
            self.ok(self.stage(name, output, *words.get(name, []), source=source))
            source = output
        return source

    def test_stage_by_stage_gives_the_bytes_of_a_cook(self):
        self.ok(self.cook("--keep-work", recipe="smoke"))
        recipe = ["--recipe", "smoke"]
        last = self.chain(**{name: recipe for name in STAGES})
        self.assertEqual(last.read_bytes(), self.output.read_bytes())

    def test_a_bundle_without_work_says_how_to_keep_it(self):
        self.ok(self.cook())
        self.fails(self.stage("sample", self.path("x.hdf"), source=self.output), 3, "sample", "/asset", "--keep-work")

    def test_every_work_file_passes_check_and_can_be_inspected_and_exported(self):
        self.chain()
        for name in STAGES:
            path = self.path(f"after_{name}.hdf")
            self.ok(program.run("check", path))
            self.ok(program.run("inspect", path))
            exported = program.run("export", path, "--vtu", self.path("x.vtu"), "--obj", self.path("x.obj"))
            if STAGES.index(name) >= STAGES.index("delaunay"):
                self.ok(exported)
            else:
                self.assertNotEqual(exported.returncode, 0)
                self.assertIn("crumple delaunay", exported.stderr)

    def test_flags_set_and_recipe_mean_the_same(self):
        start = self.chain(last="delaunay")
        outputs = []
        recipe = self.path("r.json")
        recipe.write_text('{"relax": {"sweeps": 3, "method": "odt"}}')
        for words in [["--sweeps", "3", "--method", "odt"], ["--set", "sweeps=3", "--set", "relax.method=odt"],
                      ["--recipe", recipe], ["--recipe", recipe, "--sweeps", "3"]]:
            outputs.append(self.path(f"out{len(outputs)}.hdf"))
            self.ok(self.stage("relax", outputs[-1], *words, source=start))
        self.assertEqual({path.read_bytes() for path in outputs}, {outputs[0].read_bytes()})
        self.assertNotEqual(outputs[0].read_bytes(), self.chain(last="relax").read_bytes())

    def test_a_flag_is_as_strict_as_a_recipe(self):
        start = self.chain(last="delaunay")
        self.fails(self.stage("relax", self.output, "--sweeps", "-1", source=start), 1, "out of range")
        self.fails(self.stage("relax", self.output, "--method", "opt", source=start), 1, "'opt'", "odt")
        self.fails(self.stage("relax", self.output, "--sweep", "1", source=start), 1, "--sweep")

    def test_running_a_stage_again_forgets_what_came_after(self):
        last = self.chain()
        again = self.path("again.hdf")
        self.ok(self.stage("sample", again, "--seed", "2", source=last))
        report = self.json_of(program.run("inspect", again, "--format", "json"))
        self.assertEqual(report["groups"], ["asset", "points"])
        self.assertEqual([stage["name"] for stage in report["record"]["stages"]], ["import", "sample"])

    def test_a_stage_without_its_input_says_what_to_run(self):
        start = self.chain(last="import")
        self.fails(self.stage("relax", self.output, source=start), 3, "crumple delaunay first")
        self.fails(self.stage("bake", self.output, source=start), 3, "first")

    def test_a_stage_that_changes_tets_wants_them_as_they_were(self):
        culled = self.chain(last="cull")
        self.fails(self.stage("relax", self.output, source=culled), 3, "relax already")
        self.fails(self.stage("cull", self.output, source=culled), 3, "cull already")

    def test_the_input_may_not_be_the_output(self):
        start = self.chain(last="import")
        before = start.read_bytes()
        self.fails(self.stage("sample", start, source=start), 1, "would replace an input")
        self.assertEqual(start.read_bytes(), before)

    def test_a_file_that_is_none_of_ours_is_refused(self):
        for content in [b"", b"hello", b"\x89HDF\r\n\x1a\n" + b"\0" * 2000]:
            path = self.path("other.hdf")
            path.write_bytes(content)
            self.fails(self.stage("sample", self.output, source=path), 3, "other.hdf")
        self.fails(self.stage("sample", self.output, source=self.path("none.hdf")), 2, "none.hdf")

    def test_a_stage_alone_tells_its_report(self):
        process = self.ok(self.stage("import", self.output))
        self.assertRegex(process.stderr, r"locked +[1-9]")
        self.assertEqual(process.stdout, "")

    def test_the_exported_shell_has_its_locks(self):
        start = self.chain(last="import")
        self.ok(program.run("export", start, "--obj", self.path("look.obj")))
        again = self.json_of(program.run("import", "--shell", self.path("look.obj"), "-o", self.output, "--format", "json", "-q"))
        first = self.json_of(program.run("import", "--shell", self.shell, "-o", self.output, "--format", "json", "-q"))
        self.assertEqual(again["report"]["locked"], first["report"]["locked"])

    def test_the_report_goes_to_stdout_as_json(self):
        start = self.chain(last="import")
        run = self.json_of(program.run("sample", start, "-o", self.output, "--format", "json", "-q"))
        self.assertEqual(run["name"], "sample")
        self.assertGreater(run["report"]["points"], 0)


class Points(program.Case):
    CUBE = [(x, y, z) for x in (0, 1, 2) for y in (0, 1, 2) for z in (0, 1, 2)]

    def tets_of(self, name, text):
        path = self.path(name)
        path.write_text(text)
        self.ok(program.run("delaunay", path, "-o", self.output))
        self.ok(program.run("check", self.output))
        self.ok(program.run("export", self.output, "--msh", self.path("out.msh")))
        lines = self.path("out.msh").read_text().splitlines()
        return int(lines[lines.index("$Nodes") + 1]), int(lines[lines.index("$Elements") + 1])

    def test_every_form_of_the_same_points_gives_the_same_tets(self):
        rows = [" ".join(map(str, point)) for point in self.CUBE]
        forms = {
            "a.xyz": "\n".join(rows),
            "b.xyz": f"{len(rows)}\n" + "\n".join(rows) + "\n",
            "c.csv": "x,y,z\n" + "\n".join(row.replace(" ", ",") for row in rows) + "\n",
            "d.tsv": "\n".join(row.replace(" ", "\t") for row in rows),
            "e.txt": "# made by hand\r\n\r\n" + "\r\n".join(row.replace(" ", "; ") for row in rows),
            "f.obj": "o cloud\n" + "\n".join("v " + row for row in rows),
            "g.node": f"{len(rows)} 3 0 0\n" + "\n".join(f"{i + 1} {row}" for i, row in enumerate(rows)),
        }
        counts = {self.tets_of(name, text) for name, text in forms.items()}
        self.assertEqual(len(counts), 1)
        self.assertEqual(counts.pop()[0], 27)

    def test_doubles_stay_as_they_are(self):
        text = "0 0 0\n1 0 0\n0 1 0\n0.1 0.2 0.30000000000000004\n"
        self.assertEqual(self.tets_of("a.xyz", text), (4, 1))
        try:
            import h5py
        except ImportError:
            self.skipTest("no h5py")
        with h5py.File(self.output) as file:
            self.assertEqual(file["tets/positions"][3, 2], 0.30000000000000004)

    def test_a_line_that_is_no_point_is_named(self):
        for text, line in [("0 0 0\n1 0\n", ":2:"), ("0 0 0\n\n# x\n0 nan 0\n", ":4:"), ("0 0 0\n1e999 0 0\n", ":2:"),
                           ("3\n0 0 0\n", "promises 3"), ("0 0 0\n0 0 0x\n", ":2:")]:
            path = self.path("bad.xyz")
            path.write_text(text)
            self.fails(program.run("delaunay", path, "-o", self.output), 3, "bad.xyz", line)

    def test_too_few_or_flat_points_are_refused(self):
        for text in ["", "0 0 0\n1 0 0\n0 1 0\n", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n", "0 0 0\n" * 10]:
            path = self.path("flat.xyz")
            path.write_text(text)
            self.fails(program.run("delaunay", path, "-o", self.output), 3)

    def test_the_rest_of_the_chain_asks_for_a_shell(self):
        self.tets_of("a.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
        self.fails(program.run("relax", self.output, "-o", self.path("next.hdf")), 3, "crumple import first")


if __name__ == "__main__":
    unittest.main()
