#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Holds the layers and the licences of lib/README.md:

- a module includes headers of itself and of the modules its CMakeLists.txt says it USES, nothing else of ours;
- heavy packages stay where they live, and out of every header that another module includes;
- every source says its licence, the one of its module; an MIT module reaches MIT modules only.

    scripts/check_layers.py [ROOT]

Prints one line an offence and exits 1 when there is one.
"""
import pathlib
import re
import sys

# Package header -> modules that may include it. Test programs may include any.
PACKAGES = {
    r"CGAL/|boost/|gmp": set(),  # the tests' oracle and the benchmarks' peer
    r"assimp/": {"importer", "formats"},  # formats: its parser of numbers alone
    r"hdf5|H5": {"store"},
    r"openssl/": {"store"},
    r"nlohmann/": {"report", "formats"},  # formats: glTF is JSON
    r"pugixml": {"formats"},  # COLLADA is XML; assimp reads it with the same
    r"zlib": {"formats"},  # FBX compresses arrays
    r"CLI/": {"cli"},
    r"Eigen/": {"reference"},
}
SPDX = {"MIT": "SPDX-License-Identifier: MIT", "GPL": "SPDX-License-Identifier: GPL-3.0-or-later"}
SOURCES = {".h", ".cpp", ".py", ".sh", ".cmake"}
GENERATED = ("build", ".git")


class Module:
    def __init__(self, folder, text):
        call = re.search(r"crumple_module\(\s*(\w+)([^)]*)\)", text)
        self.folder = folder
        self.name = call.group(1)
        words = call.group(2).split()
        self.uses = set(section(words, "USES"))
        self.licence = "MIT" if section(words, "LICENSE") == ["MIT"] else "GPL"


def section(words, keyword):
    if keyword not in words:
        return []
    rest = words[words.index(keyword) + 1:]
    ends = [i for i, word in enumerate(rest) if word in ("HOT", "LICENSE", "SOURCES", "USES", "PACKAGES")]
    return rest[:ends[0]] if ends else rest


def without_comments(text):
    return "\n".join(line.split("#")[0] for line in text.splitlines())


def read_modules(root):
    modules = {}
    for path in sorted(root.glob("lib/*/CMakeLists.txt")) + [root / "samples/CMakeLists.txt"]:
        text = without_comments(path.read_text()) if path.exists() else ""
        if "crumple_module(" in text:
            module = Module(path.parent, text)
            modules[module.name] = module
    return modules


def sources_below(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in SOURCES and p.is_file())


def is_of_another_project(path, folder):
    """Below a module's folder may lie a program of its own that uses us from outside."""
    between = [parent for parent in path.parents if parent != folder and folder in parent.parents]
    return any("project(" in without_comments((parent / "CMakeLists.txt").read_text())
               for parent in between if (parent / "CMakeLists.txt").exists())


def includes_of(path):
    for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        if match:
            yield number, match.group(1), match.group(2)


def reach(modules, name, seen=None):
    """The module and everything it uses, directly or not."""
    seen = set() if seen is None else seen
    if name not in seen:
        seen.add(name)
        for used in modules[name].uses & modules.keys():
            reach(modules, used, seen)
    return seen


def packaged_headers(modules):
    """Headers through which a package would reach whoever includes them: theirs to keep within their module."""
    headers = {str(path.relative_to(module.folder.parent)): list(includes_of(path))
               for module in modules.values() for path in sources_below(module.folder) if path.suffix == ".h"}
    found = {name for name, includes in headers.items()
             if any(bracket == "<" and re.match("|".join(PACKAGES), target) for _, bracket, target in includes)}
    while True:
        more = {name for name, includes in headers.items() if any(target in found for _, _, target in includes)} - found
        if not more:
            return found
        found |= more


def check_includes(root, modules, module, packaged):
    for path in sources_below(module.folder):
        if is_of_another_project(path, module.folder):
            continue
        where = path.relative_to(root)
        for number, _, target in includes_of(path):
            owner = target.split("/")[0]
            if owner in modules and owner != module.name and owner not in module.uses:
                yield f"{where}:{number}: {module.name} includes {target} but does not say USES {owner}"
            if owner != module.name and target in packaged:
                yield f"{where}:{number}: {target} brings a heavy package along; only {owner} may include it"
        yield from check_packages(where, path, module.name)


def check_packages(where, path, owner):
    for number, bracket, target in includes_of(path):
        for pattern, allowed in PACKAGES.items():
            if bracket == "<" and re.match(pattern, target) and owner not in allowed:
                yield f"{where}:{number}: {owner} includes <{target}>; only {', '.join(sorted(allowed)) or 'tests'} may"


def check_licences(modules, module):
    if module.licence == "MIT":
        for name in sorted(reach(modules, module.name)):
            if modules[name].licence != "MIT":
                yield f"{module.name} is MIT and reaches {name}, which is GPL"


def check_spdx(root, modules):
    owner = {module.folder: module for module in modules.values()}
    for path in sources_below(root):
        where = path.relative_to(root)
        if where.parts[0].startswith(GENERATED):
            continue
        head = "\n".join(path.read_text(errors="replace").splitlines()[:2])
        module = owner.get(path.parent)
        if module and SPDX[module.licence] not in head:
            yield f"{where}: the first lines lack '{SPDX[module.licence]}', the licence of {module.name}"
        elif not any(line in head for line in SPDX.values()):
            yield f"{where}: the first lines lack 'SPDX-License-Identifier'"


def offences(root):
    modules = read_modules(root)
    packaged = packaged_headers(modules)
    for module in modules.values():
        yield from check_includes(root, modules, module, packaged)
        yield from check_licences(modules, module)
    if (root / "cli").is_dir():
        for path in sources_below(root / "cli"):
            yield from check_packages(path.relative_to(root), path, "cli")
    yield from check_spdx(root, modules)


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
    found = list(offences(root))
    print("\n".join(found) if found else "layers and licences hold")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
