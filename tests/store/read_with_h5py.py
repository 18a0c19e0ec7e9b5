# SPDX-License-Identifier: MIT
"""Reads a bundle with h5py alone, by FORMAT.md: arrays, invariants, filters, digests, seal."""
import hashlib
import sys

try:
    import h5py
    import numpy as np
except ImportError as missing:
    print("skipped:", missing)
    sys.exit(77)


def digest_of(dataset):
    """SHA-256 of type, shape and bytes, as FORMAT.md says."""
    values = np.asarray(dataset[()])
    if values.dtype.kind == "S":
        name = "text%d" % values.dtype.itemsize
    else:
        assert values.dtype.newbyteorder("<") == values.dtype
        name = values.dtype.kind + str(8 * values.dtype.itemsize)
    shape = "x".join(str(n) for n in values.shape)
    return hashlib.sha256((name + " " + shape + "\n").encode() + values.tobytes()).digest()


def check_seal(path):
    data = open(path, "rb").read()
    assert data[:8] == b"CRUMPLE\n"
    assert int.from_bytes(data[8:12], "little") == 1
    assert int.from_bytes(data[16:24], "little") == len(data)
    assert hashlib.sha256(data[:24] + data[512:]).digest() == data[24:56]
    assert data[56:512] == bytes(456)


def check_digests(file):
    paths = [p.decode() for p in file["digest/path"][()]]
    digests = file["digest/sha256"][()]
    lines = "".join(p + "\t" + bytes(d).hex() + "\n" for p, d in zip(paths, digests))
    assert hashlib.sha256(lines.encode()).digest() == bytes(file["digest/all"][0])
    datasets = 0
    for path, digest in zip(paths, digests):
        if "@" not in path:
            assert digest_of(file[path]) == bytes(digest), path
            datasets += 1
    found = []
    for group in ("bundle", "VTKHDF"):
        file[group].visititems(lambda name, item: found.append(name) if isinstance(item, h5py.Dataset) else None)
    assert len(set(found)) <= len(found) <= datasets


def check_arrays(b):
    positions = b["rest_positions"][()].astype(float)
    tets = b["tets"][()]
    corners = positions[tets]
    dm = np.stack([corners[:, k] - corners[:, 0] for k in (1, 2, 3)], axis=2)
    volume = np.linalg.det(dm) / 6
    assert (volume > 0).all() and np.allclose(volume, b["volume"][()], rtol=1e-6)
    inverse = b["inverse_rest"][()].reshape(-1, 3, 3)
    assert np.abs(inverse @ dm - np.eye(3)).max() < 1e-5
    density = b["materials/density_kg_m3"][()][b["material"][()]]
    mass = np.zeros(len(positions))
    np.add.at(mass, tets.ravel(), np.repeat(density * volume / 4, 4))
    assert np.allclose(mass, b["mass"][()], rtol=1e-6)
    locked = positions[b["locked"][()] == 1]
    painted = b["locked_positions"][()].astype(float)
    assert sorted(map(tuple, locked)) == list(map(tuple, painted))
    row, column = b["row_start"][()], b["column"][()]
    rows = np.repeat(np.arange(len(positions)), np.diff(row))
    solver = tets[: b["solver_tet_count"][0]]
    assert (rows[b["element_slots"][()]].reshape(-1, 4, 4) == solver[:, :, None]).all()
    assert (column[b["element_slots"][()]].reshape(-1, 4, 4) == solver[:, None, :]).all()


def main(folder):
    for name in ("small.hdf", "contiguous.hdf"):
        path = folder + "/" + name
        check_seal(path)
        with h5py.File(path, "r") as file:
            assert list(file["bundle"].attrs["schema_version"]) == [1, 0]
            check_digests(file)
            check_arrays(file["bundle"])
            names = [n.decode() for n in file["bundle/visual_names"][()]]
            assert names == ["paint"] and file["bundle/visual/paint/tet"].shape == (201,)
            assert file["VTKHDF/Points"] == file["bundle/rest_positions"], "one dataset under two names"
            tets = file["bundle/tets"]
            if name == "small.hdf":
                assert tets.chunks and tets.shuffle and tets.compression == "gzip" and tets.compression_opts == 1 and tets.fletcher32
            else:
                offset = tets.id.get_offset()
                assert tets.chunks is None and offset % 64 == 0, "aligned for mapping"
                with open(path, "rb") as raw:
                    raw.seek(offset)
                    assert raw.read(16 * len(tets)) == tets[()].tobytes()
    print("h5py", h5py.__version__, "reads both layouts")


main(sys.argv[1])
