# SPDX-License-Identifier: MIT
"""A reader of blobs written from lib/bundle/FORMAT_BLOB.md alone."""
import struct

TYPES = {1: "<u1", 2: "<u2", 3: "<u4", 4: "<f4", 5: "<f8"}
ARRAYS = {16: "rest_positions", 17: "mass", 18: "locked", 19: "node_to_mesh", 20: "mesh_to_node", 21: "locked_positions",
          32: "tets", 33: "inverse_rest", 34: "volume", 35: "stiffness_scale", 36: "material", 37: "region",
          48: "row_start", 49: "column", 50: "diagonal", 51: "element_slots", 52: "edges", 53: "edge_slots",
          54: "edge_start", 55: "edge_tet", 56: "edge_corners"}
VISUAL = {64: "tet", 65: "barycentric", 66: "inside", 67: "distance", 68: "tet_start", 69: "vertices_by_tet"}
SENSOR = {80: "node", 81: "weight"}
MATERIAL = ["young_pa", "poisson", "density_kg_m3", "yield_pa", "creep_per_s", "hardening_pa", "max_plastic_strain",
            "alpha_per_s", "beta_s"]

MASK = (1 << 64) - 1
P1, P2, P3, P4, P5 = (0x9E3779B185EBCA87, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9, 0x85EBCA77C2B2AE63,
                      0x27D4EB2F165667C5)


def rotate(x, bits):
    return (x << bits | x >> 64 - bits) & MASK


def lane(accumulator, word):
    return rotate((accumulator + word * P2) & MASK, 31) * P1 & MASK


def xxh64(data):
    """[Collet, xxHash specification]; all our ranges are longer than 31 bytes."""
    lanes = [(P1 + P2) & MASK, P2, 0, -P1 & MASK]
    whole = len(data) // 32 * 32
    for words in struct.iter_unpack("<4Q", data[:whole]):
        lanes = [lane(a, w) for a, w in zip(lanes, words)]
    value = sum(rotate(a, bits) for a, bits in zip(lanes, (1, 7, 12, 18)))
    for a in lanes:
        value = ((value ^ lane(0, a)) * P1 + P4) & MASK
    value = value + len(data) & MASK
    rest = data[whole:]
    for (word,) in struct.iter_unpack("<Q", rest[:len(rest) // 8 * 8]):
        value = (rotate(value ^ lane(0, word), 27) * P1 + P4) & MASK
    assert len(rest) % 8 == 0
    for shift, prime in ((33, P2), (29, P3)):
        value = (value ^ value >> shift) * prime & MASK
    return value ^ value >> 32


def read(data):
    """Arrays by the names of FORMAT.md: {"tets": ..., "visual/<name>/tet": ..., "materials/young_pa": ...}."""
    import numpy

    magic, major, minor, order, count, size, body, _, _, head = struct.unpack_from("<8s4I2Q2QQ", data)
    assert (magic, major, minor, order, size) == (b"CRUMBLOB", 1, 0, 0x01020304, len(data))
    assert xxh64(data[64:]) == body and xxh64(data[:56]) == head
    raw, end = {}, 64 + 32 * count
    for row in range(count):
        number, item, kind, columns, offset, rows = struct.unpack_from("<4I2Q", data, 64 + 32 * row)
        assert offset == -(-end // 64) * 64 and not any(data[end:offset])
        values = numpy.frombuffer(data, TYPES[kind], rows * columns, offset)
        raw[number, item] = values.reshape(rows, columns) if columns > 1 else values
        end = offset + values.nbytes
    assert -(-end // 64) * 64 == len(data) and not any(data[end:])

    solver_tets, regions, materials, visuals, sensors, stages, inputs, _ = raw[1, 0][0]
    text = raw[3, 0].tobytes()
    texts = [text[a:b - 1].decode() for a, b in zip(raw[2, 0], raw[2, 0][1:])]
    take = lambda n: [texts.pop(0) for _ in range(n)]
    arrays = {name: raw[number, 0] for number, name in ARRAYS.items()}
    arrays["solver_tet_count"] = numpy.array([solver_tets])
    arrays["regions"], arrays["materials/name"] = take(regions), take(materials)
    for kind, names, columns in (("visual", take(visuals), VISUAL), ("sensor", take(sensors), SENSOR)):
        arrays[kind + "_names"] = names
        for i, name in enumerate(names):
            arrays |= {f"{kind}/{name}/{column}": raw[number, i] for number, column in columns.items()}
            if kind == "sensor":
                arrays[f"sensor/{name}/rest_origin"] = raw[5, 0].reshape(-1, 12)[i:i + 1, :3]
                arrays[f"sensor/{name}/rest_axes"] = raw[5, 0].reshape(-1, 12)[i:i + 1, 3:]
    arrays |= {"materials/" + name: raw[4, 0].reshape(-1, 9)[:, i] for i, name in enumerate(MATERIAL)}
    arrays["provenance/tool_version"], arrays["provenance/recipe"] = take(1), take(1)
    for group, number in (("stage_versions", stages), ("input_digests", inputs)):
        pairs = take(2 * number)
        arrays[f"provenance/{group}/name"], arrays[f"provenance/{group}/value"] = pairs[::2], pairs[1::2]
    assert not texts
    return arrays
