#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What CalculiX 2.20 says of a cantilever of linear tets (C3D4), as calculix_figures.h.

    tests/reference/calculix_figures.py > tests/reference/calculix_figures.h
    tests/reference/calculix_figures.py --mesh > tests/reference/bar_5k.txt

Needs ccx (Debian: calculix-ccx) and tetgen; the tests need neither. The bar is 8 x 1 x 1 m, clamped at x = 0, E = 1e6,
nu = .3, rho = 1000, loaded at the free end by P = k E I / L^2 spread equally over its nodes. The grid is that of
solver::test::grid_body({16, 2, 2}, {.5, .5, .5}); the fine one is TetGen's -pq1.3a0.0042, 5,326 tets. --mesh writes
that one, as floats, numbered from 0.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

YOUNG, LENGTH, INERTIA = 1e6, 8.0, 1.0 / 12
ORDERS = ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2))
BAR_POLY = """8 3 0 0
1 0 0 0\n2 8 0 0\n3 8 1 0\n4 0 1 0\n5 0 0 1\n6 8 0 1\n7 8 1 1\n8 0 1 1
6 0
1\n4 1 2 3 4\n1\n4 5 6 7 8\n1\n4 1 2 6 5\n1\n4 2 3 7 6\n1\n4 3 4 8 7\n1\n4 4 1 5 8
0\n0
"""


def grid(cells, size):
    """Nodes and tets as solver::test::grid_body makes them, numbered from 0."""
    nx, ny, nz = cells
    nodes = [(x * size, y * size, z * size) for x in range(nx + 1) for y in range(ny + 1) for z in range(nz + 1)]
    number = lambda x, y, z: (x * (ny + 1) + y) * (nz + 1) + z
    tets = []
    for x in range(nx):
        for y in range(ny):
            for z in range(nz):
                for i, order in enumerate(ORDERS):
                    at = [x, y, z]
                    tet = [number(*at)]
                    for axis in order:
                        at[axis] += 1
                        tet.append(number(*at))
                    if i >= 3:
                        tet[1], tet[2] = tet[2], tet[1]
                    tets.append(tet)
    return nodes, tets


def tetgen_bar(folder):
    (folder / "bar.poly").write_text(BAR_POLY)
    subprocess.run(["tetgen", "-pq1.3a0.0042", "bar.poly"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    rows = lambda name: [line.split() for line in (folder / name).read_text().splitlines()[1:] if line[:1] != "#"]
    nodes = [tuple(map(float, row[1:4])) for row in rows("bar.1.node")]
    tets = [[int(i) - 1 for i in row[1:5]] for row in rows("bar.1.ele")]
    for tet in tets:
        a, b, c = ([nodes[tet[i]][k] - nodes[tet[0]][k] for k in range(3)] for i in (1, 2, 3))
        cross = (b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0])
        if sum(x * y for x, y in zip(a, cross)) < 0:
            tet[2], tet[3] = tet[3], tet[2]
    return nodes, tets


def write_mesh(nodes, tets):
    print(len(nodes), len(tets))
    for row in nodes:
        print(*("%.9g" % value for value in row))
    for row in tets:
        print(*row)


def run(folder, mesh, poisson, step):
    """Writes, runs and returns job.dat."""
    nodes, tets = mesh
    ends = {"FIX": lambda p: p[0] < 1e-4, "TIP": lambda p: p[0] > LENGTH - 1e-4}
    lines = ["*NODE,NSET=NALL"] + [f"{i + 1},{x!r},{y!r},{z!r}" for i, (x, y, z) in enumerate(nodes)]
    lines += ["*ELEMENT,TYPE=C3D4,ELSET=EALL"]
    lines += [f"{i + 1}," + ",".join(str(n + 1) for n in tet) for i, tet in enumerate(tets)]
    for name, is_in in ends.items():
        lines += [f"*NSET,NSET={name}"] + [str(i + 1) for i, p in enumerate(nodes) if is_in(p)]
    lines += ["*MATERIAL,NAME=M", "*ELASTIC", f"{YOUNG},{poisson}", "*DENSITY", "1000.",
              "*SOLID SECTION,ELSET=EALL,MATERIAL=M", "*BOUNDARY", "FIX,1,3"] + step
    (folder / "job.inp").write_text("\n".join(lines) + "\n")
    subprocess.run(["ccx", "job"], cwd=folder, check=True, stdout=subprocess.DEVNULL, env={"OMP_NUM_THREADS": "1", "PATH": "/usr/bin:/bin"})
    return (folder / "job.dat").read_text()


def tip(folder, mesh, k, poisson=0.3, is_linear=False):
    """Mean displacement (x, y) of the nodes of the free end."""
    count = sum(1 for p in mesh[0] if p[0] > LENGTH - 1e-4)
    load = k * YOUNG * INERTIA / LENGTH**2
    step = ["*STEP" if is_linear else "*STEP,NLGEOM,INC=200", "*STATIC"] + ([] if is_linear else ["0.2,1.,1e-5,0.25"])
    step += ["*CLOAD", f"TIP,2,{-load / count!r}", "*NODE PRINT,NSET=TIP,FREQUENCY=1000", "U", "*END STEP"]
    last = run(folder, mesh, poisson, step).split("displacements")[-1]
    rows = [list(map(float, line.split()[1:])) for line in last.splitlines()[1:] if len(line.split()) == 4]
    assert len(rows) == count, (len(rows), count)
    return [sum(row[axis] for row in rows) / count for axis in (0, 1)]


def frequency_hz(folder, mesh):
    text = run(folder, mesh, 0.3, ["*STEP", "*FREQUENCY", "2", "*END STEP"])
    return float(re.search(r"^\s+1\s+\S+\s+\S+\s+(\S+)", text, re.MULTILINE).group(1))


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if sys.argv[1:] == ["--mesh"]:
            write_mesh(*tetgen_bar(folder))
            return 0
        coarse, fine = grid((16, 2, 2), 0.5), tetgen_bar(folder)
        print("// SPDX-License-Identifier: GPL-3.0-or-later")
        print("// Written by calculix_figures.py, which says of what; CalculiX 2.20. Displacements of the free end in metres.")
        print("#pragma once\n\nnamespace crumple::calculix {\n")
        print("struct Tip {\n    double k;\n    double along;\n    double down;\n};\n")
        print("// Large displacements (NLGEOM: Green strain, second Piola-Kirchhoff stress), nu = .3.")
        for mesh, label in ((coarse, "grid_tips"), (fine, "bar_5k_tips")):
            rows = ", ".join("{%g, %.7g, %.7g}" % (k, *tip(folder, mesh, k)) for k in (0.2, 1, 2))
            print(f"inline constexpr Tip {label}[] = {{{rows}}};")
        print("\n// Linear, k = .01.")
        print("inline constexpr double bar_5k_linear_down = %.7g;" % tip(folder, fine, 0.01, is_linear=True)[1])
        print("struct Locking {\n    double poisson;\n    double down;\n};")
        rows = ", ".join("{%g, %.7g}" % (nu, tip(folder, coarse, 0.01, nu, True)[1]) for nu in (0.3, 0.49, 0.499))
        print(f"inline constexpr Locking grid_linear[] = {{{rows}}};")
        print("\n// Lowest of *FREQUENCY, consistent masses.")
        print("inline constexpr double grid_frequency_hz = %.7g;" % frequency_hz(folder, coarse))
        print("\n}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
