# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads OBJ, PLY, GLB and cooked HDF files into plain parts for the pictures. Needs numpy and VTK."""
import json
import pathlib
import struct
from dataclasses import dataclass

import numpy


@dataclass
class Part:
    name: str
    points: numpy.ndarray     # V x 3
    triangles: numpy.ndarray  # F x 3, or T x 4 tets
    colors: numpy.ndarray     # V x 3 from 0 to 255, or T x 3 for tets, or empty
    locked: numpy.ndarray     # V bool: red is 0


def part_of(name, points, triangles, colors):
    colors = numpy.asarray(colors, dtype=float).reshape(-1, 3)
    locked = colors[:, 0] < 0.5 if len(colors) == len(points) else numpy.zeros(len(points), bool)
    return Part(name, numpy.asarray(points, float).reshape(-1, 3), numpy.asarray(triangles, int), colors, locked)


def read_obj(path):
    names, faces, points, colors = [], [], [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if not words:
            continue
        if words[0] == "v":
            points.append([float(word) for word in words[1:4]])
            if len(words) >= 7:
                colors.append([255 * float(word) for word in words[4:7]])
        elif words[0] in ("o", "g"):
            names.append(" ".join(words[1:]))
            faces.append([])
        elif words[0] == "f":
            if not faces:
                names.append(path.stem)
                faces.append([])
            corners = [int(word.split("/")[0]) for word in words[1:]]
            corners = [c - 1 if c > 0 else c + len(points) for c in corners]
            faces[-1] += [[corners[0], corners[i], corners[i + 1]] for i in range(1, len(corners) - 1)]
    return [split(name, points, colors, face) for name, face in zip(names, faces) if face]


def split(name, points, colors, faces):
    """Only the vertices that the faces use."""
    used, inverse = numpy.unique(numpy.asarray(faces), return_inverse=True)
    picked = numpy.asarray(colors)[used] if len(colors) == len(points) else []
    return part_of(name, numpy.asarray(points)[used], inverse.reshape(-1, 3), picked)


def read_ply(path):
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
    reader = vtk.vtkPLYReader()
    reader.SetFileName(str(path))
    reader.Update()
    mesh = reader.GetOutput()
    scalars = mesh.GetPointData().GetScalars()
    colors = vtk_to_numpy(scalars)[:, :3] if scalars else []
    faces = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return [part_of(path.stem, vtk_to_numpy(mesh.GetPoints().GetData()), faces, colors)]


def read_glb(path):
    data = path.read_bytes()
    json_size = struct.unpack_from("<I", data, 12)[0]
    gltf = json.loads(data[20:20 + json_size])
    binary = data[20 + json_size + 8:]
    kinds = {5121: "u1", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
    widths = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}

    def array(index):
        accessor = gltf["accessors"][index]
        view = gltf["bufferViews"][accessor["bufferView"]]
        begin = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        width = widths[accessor["type"]]
        values = numpy.frombuffer(binary, kinds[accessor["componentType"]], accessor["count"] * width, begin)
        return values.reshape(-1, width)

    parts = []
    for mesh in gltf["meshes"]:
        for primitive in mesh["primitives"]:
            colors = primitive["attributes"].get("COLOR_0")
            colors = array(colors)[:, :3] if colors is not None else []
            points = array(primitive["attributes"]["POSITION"])
            parts.append(part_of(mesh.get("name", "mesh"), points, array(primitive["indices"]).reshape(-1, 3), colors))
    return parts


PALETTE = numpy.array([[120, 170, 220], [230, 120, 60], [110, 190, 120], [220, 190, 80], [170, 130, 200], [90, 180, 180],
                       [210, 110, 140], [150, 150, 150]])


# From bad to good: red, orange, yellow, green, blue. Linear light.
SCALE = numpy.array([[170, 5, 5], [235, 90, 10], [240, 200, 30], [40, 150, 50], [15, 70, 160]])


def scale_color(share):
    """Colours of values that run from 0 (bad) to 1 (good)."""
    stops = numpy.linspace(0, 1, len(SCALE))
    return numpy.stack([numpy.interp(numpy.clip(share, 0, 1), stops, SCALE[:, k]) for k in range(3)], axis=-1)


def read_hdf(path, field=None, limits=(0, 1), below=None):
    """The tets of a bundle, a part each region, through the reader that ParaView uses. Coloured by region, or by a field
    of the tets from limits[0] (bad) to limits[1] (good); only those `below` if that is given."""
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
    reader = vtk.vtkHDFReader()
    reader.SetFileName(str(path))
    reader.Update()
    mesh = reader.GetOutput()
    tets = vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).reshape(-1, 4)
    region = vtk_to_numpy(mesh.GetCellData().GetArray("region"))
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    locked = vtk_to_numpy(mesh.GetPointData().GetArray("locked")) != 0
    colors = PALETTE[region % len(PALETTE)]
    shown = numpy.ones(len(tets), bool)
    if field:
        array = mesh.GetCellData().GetArray(field)
        if not array:
            raise SystemExit(f"{path}: the tets have no field '{field}'; cook with --keep-work")
        values = vtk_to_numpy(array)
        colors = scale_color((values - limits[0]) / (limits[1] - limits[0]))
        if below is not None:
            shown = values < below
    parts = []
    for number in numpy.unique(region):
        own = (region == number) & shown
        parts.append(part_of(f"region_{number}", points, tets[own], colors[own]))
        parts[-1].locked = locked
    return parts


READERS = {".obj": read_obj, ".ply": read_ply, ".glb": read_glb, ".hdf": read_hdf}


def read(path, **options):
    path = pathlib.Path(path)
    if path.suffix.lower() not in READERS:
        raise SystemExit(f"{path}: can draw {', '.join(READERS)} only")
    return READERS[path.suffix.lower()](path, **(options if path.suffix.lower() == ".hdf" else {}))
