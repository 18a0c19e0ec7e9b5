#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives the sample car and `suv` into the pole at 15 m/s and prints what became of them.

    CRUMPLE=build/release/crumple tests/cli/crash.py [--runs 5] [--keep FOLDER]

`suv` is real input (program.DATA) that faces along x and has no paint. Its shell is turned to face along z and given an
engine block, a closed box inside it that is painted red 0 all over, as an artist would.
"""
import argparse
import itertools
import json
import pathlib
import re
import sys
import tempfile

import h5py
import numpy

import program

SAMPLES = program.SOURCE / "samples"
SUV = program.DATA / "open"
ENGINE_LOW, ENGINE_HIGH = numpy.array([-0.35, 0.1, -0.45]), numpy.array([0.35, 0.7, 0.35])
ENGINE_CELLS = 3  # along an edge, for triangles of the shell's size
ENGINE_VERTICES = (ENGINE_CELLS + 1) ** 3 - (ENGINE_CELLS - 1) ** 3


def obj_lines(path, kinds):
    with open(path) as file:
        for line in file:
            words = line.split()
            if words and words[0] in kinds:
                yield words


def turned(words):
    """A line of a vertex that looked along x with z up, looking along z with y up."""
    x, y, z = words[1:4]
    return f"{words[0]} {y} {z} {x}"


def box_obj(low, high, cells, first):
    """Vertices and triangles of a closed box, counter-clockwise from outside; `first` is the index of the first vertex."""
    index, faces = {}, []
    at = lambda corner: index.setdefault(tuple(corner), first + len(index))
    for axis, side in itertools.product(range(3), (0, cells)):
        for i, j in itertools.product(range(cells), repeat=2):
            quad = []
            for u, v in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                corner = [0, 0, 0]
                corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3] = side, u, v
                quad.append(at(corner))
            a, b, c, d = quad if side else quad[::-1]
            faces += [(a, b, c), (a, c, d)]
    return [low + (high - low) * numpy.array(corner) / cells for corner in index], faces


def write_suv(folder):
    """The suv's painted shell and its visual mesh, as the pole meets them."""
    shell, visual = folder / "suv_shell.obj", folder / "suv_visual.obj"
    source = program.DATA / "open"
    with open(shell, "w") as out:
        out.write("o body\n")
        count = 0
        for words in obj_lines(source / "suv_shell.obj", {"v", "f"}):
            count += words[0] == "v"
            out.write((turned(words) + " 1 1 1" if words[0] == "v" else " ".join(words)) + "\n")
        out.write("o engine_block\n")
        points, faces = box_obj(ENGINE_LOW, ENGINE_HIGH, ENGINE_CELLS, count + 1)
        out.writelines("v %.6g %.6g %.6g 0 0 0\n" % tuple(point) for point in points)
        out.writelines("f %d %d %d\n" % face for face in faces)
    with open(visual, "w") as out:
        for words in obj_lines(source / "suv_visual.obj", {"v", "f"}):
            corners = [word.split("/")[0] for word in words[1:]]
            out.write((turned(words) if words[0] == "v" else " ".join(["f"] + corners)) + "\n")
    return shell, visual


def cook(output, recipe, shell, visual, *words):
    done(program.run("cook", recipe, "--shell", shell, "--visual", visual, "-o", output, "-q", "--keep-work", *words))
    return output


def cook_car(folder):
    car = SAMPLES / "car"
    return cook(folder / "car.hdf", SAMPLES / "recipes" / "car.json", car / "car_shell.glb", car / "car_visual.glb")


def cook_suv(folder):
    sensor = {"name": "engine", "by": "component", "component": "engine_block"}
    return cook(folder / "suv.hdf", "car_body", *write_suv(folder), "--set", "import.roles.engine_block=rigid", "--set",
                "bake.sensors=" + json.dumps([sensor]))


def done(process):
    if process.returncode != 0:
        raise RuntimeError(process.stderr)
    return process


def rigidly_back(nodes, rest, carried):
    """The nodes put back where they began, by the rigid motion that fits the carried ones best [Kabsch 1976]."""
    here, there = nodes[carried].mean(axis=0), rest[carried].mean(axis=0)
    u, _, vt = numpy.linalg.svd((nodes[carried] - here).T @ (rest[carried] - there))
    turn = u @ numpy.diag([1, 1, numpy.linalg.det(u @ vt)]) @ vt
    return (nodes - here) @ turn + there


def crash(bundle, *words):
    """What became of it: from the nodes in the run's file, held against the bundle, not from what the program says of itself."""
    run = bundle.with_name(bundle.stem + "_crash.hdf")
    said = done(program.run("simulate", bundle, "--scene", "pole", "-o", run, *words)).stderr
    with h5py.File(bundle) as file:
        rest = file["bundle/rest_positions"][:].astype(float)
        locked = file["bundle/locked"][:] == 1
        tets = file["bundle/tets"][:]
        solver_tets = len(file["bundle/element_slots"])
    with h5py.File(run) as file:
        frames = file["run/nodes"][:].astype(float).reshape(-1, *rest.shape)
        is_at_rest = bool(file["run/is_asleep"][-1])
    frames = numpy.array([rigidly_back(nodes, rest, locked) for nodes in frames])
    way = numpy.linalg.norm(frames - rest, axis=2)
    corners = frames[-1][tets]
    median, p99 = map(float, re.search(r"a step takes (\S+) ms, 99 % under (\S+) ms", said).groups())
    return {
        "car": bundle.stem,
        "tets": solver_tets,
        "median_ms": median,
        "p99_ms": p99,
        "deepest_m": way.max(),
        "dent_m": way[-1].max(),
        "locked_at": rest[locked],
        "locked_drift": way[:, locked].max() / numpy.linalg.norm(numpy.ptp(rest, axis=0)),
        "inside_out": int((numpy.linalg.det(corners[:, 1:] - corners[:, :1]) <= 0).sum()),
        "is_at_rest": is_at_rest,
    }


COLUMNS = ["car", "tets", "ms a step: median, 99 %", "median per 1k tets", "deepest dent, and what stays", "locked nodes",
           "moved, of the size", "inside out"]


def cells(row):
    return [row["car"], f"{row['tets']:,}", f"{row['median_ms']:.2f}, {row['p99_ms']:.2f}",
            f"{1e3 * row['median_ms'] / row['tets']:.3f}", f"{row['deepest_m']:.3f} m, {row['dent_m']:.3f} m",
            str(len(row["locked_at"])), f"{row['locked_drift']:.1g}", str(row["inside_out"])]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=5, help="of each crash; the quickest is told, since others were disturbed")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for bundles, runs and their series")
    options = parser.parse_args()
    print("| " + " | ".join(COLUMNS) + " |\n" + "|---" * len(COLUMNS) + "|")
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        for cook_one in [cook_car] + [cook_suv] * SUV.is_dir():
            bundle = cook_one(folder)
            rows = [crash(bundle, *["--no-series"] * (options.keep is None)) for _ in range(options.runs)]
            print("| " + " | ".join(cells(min(rows, key=lambda row: row["median_ms"]))) + " |", flush=True)


if __name__ == "__main__":
    sys.exit(main())
