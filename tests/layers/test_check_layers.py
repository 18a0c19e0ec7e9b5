# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows scripts/check_layers.py small trees with one offence each: test_check_layers.py SCRIPTS_FOLDER"""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, sys.argv.pop(1))
import check_layers

GPL = "// SPDX-License-Identifier: GPL-3.0-or-later\n"
MIT = "// SPDX-License-Identifier: MIT\n"


class CheckLayers(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        self.module("core", "LICENSE MIT SOURCES core.cpp")
        self.write("lib/core/core.h", MIT)
        self.module("mesh", "SOURCES mesh.cpp USES core PACKAGES Threads::Threads")
        self.write("lib/mesh/mesh.h", GPL + '#include "core/core.h"\n')

    def tearDown(self):
        self.folder.cleanup()

    def write(self, path, text):
        path = self.root / path
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def module(self, name, words):
        self.write(f"lib/{name}/CMakeLists.txt", f"crumple_module({name} {words})\n")

    def found(self):
        return list(check_layers.offences(self.root))

    def expect_one(self, *words):
        found = self.found()
        self.assertEqual(len(found), 1, found)
        for word in words:
            self.assertIn(word, found[0])

    def test_a_clean_tree_has_no_offence(self):
        self.assertEqual(self.found(), [])

    def test_include_of_a_module_that_is_not_used(self):
        self.module("cull", "SOURCES cull.cpp USES core")
        self.write("lib/cull/cull.cpp", GPL + '#include "mesh/mesh.h"\n')
        self.expect_one("lib/cull/cull.cpp:2", "mesh/mesh.h", "USES mesh")

    def test_include_upwards(self):
        self.write("lib/core/bad.h", MIT + '#include "mesh/mesh.h"\n')
        self.expect_one("lib/core/bad.h:2", "mesh/mesh.h")

    def test_package_outside_its_module(self):
        self.write("lib/mesh/bad.cpp", GPL + "#include <CGAL/Surface_mesh.h>\n")
        self.expect_one("lib/mesh/bad.cpp:2", "CGAL")

    def test_package_that_a_header_brings_to_another_module(self):
        self.module("store", "SOURCES g.cpp USES core")
        self.write("lib/store/hdf5_types.h", GPL + "#include <hdf5.h>\n")
        self.write("lib/store/file.h", GPL + '#include "store/hdf5_types.h"\n')
        self.write("lib/store/g.cpp", GPL + '#include "store/file.h"\n')
        self.assertEqual(self.found(), [])
        self.module("cull", "SOURCES cull.cpp USES core store")
        self.write("lib/cull/cull.cpp", GPL + '#include "store/file.h"\n')
        self.expect_one("lib/cull/cull.cpp:2", "store/file.h", "heavy package")

    def test_mit_module_that_reaches_a_gpl_one_through_another(self):
        self.module("bundle", "LICENSE MIT SOURCES b.cpp USES solver")
        self.module("solver", "LICENSE MIT SOURCES s.cpp USES mesh")
        found = self.found()
        self.assertTrue(any("bundle is MIT and reaches mesh" in line for line in found), found)
        self.assertTrue(any("solver is MIT and reaches mesh" in line for line in found), found)

    def test_gpl_file_in_an_mit_module(self):
        self.write("lib/core/bad.cpp", GPL)
        self.expect_one("lib/core/bad.cpp", "MIT")

    def test_file_without_a_licence(self):
        self.write("tests/core/test_core.cpp", "int main() {}\n")
        self.expect_one("tests/core/test_core.cpp", "SPDX")

    def test_package_that_the_command_line_may_not_include(self):
        self.write("cli/main.cpp", GPL + "#include <CLI/CLI.hpp>\n#include <nlohmann/json.hpp>\n")
        self.expect_one("cli/main.cpp:3", "nlohmann")


if __name__ == "__main__":
    unittest.main()
