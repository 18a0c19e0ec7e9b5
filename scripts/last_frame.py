#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the last frame of a visual mesh of `crumple simulate` as OBJ, in the frame the car started in.

    scripts/last_frame.py crash.hdf car_visual -o crashed.obj

Reads crash.hdf and the series beside it, so the bundle must have been cooked with --keep-work. Where the run has a sensor
"engine", the car is put back where it began.
"""
import argparse
import glob
import os
import sys

import h5py
import numpy


def turn_of(x, y, z, w):
    return numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run")
    parser.add_argument("visual")
    parser.add_argument("-o", "--out", required=True)
    args = parser.parse_args()
    stem = os.path.splitext(args.run)[0]
    frames = sorted(glob.glob(f"{stem}_series/{os.path.basename(stem)}_{args.visual}_?????.hdf"))
    if not frames:
        sys.exit(f"{stem}_series holds no frame of {args.visual}")
    with h5py.File(frames[-1]) as frame:
        points = frame["VTKHDF/Points"][:]
        cells = frame["VTKHDF/Connectivity"][:]
        triangles = cells.reshape(-1, 3) if (frame["VTKHDF/Types"][:] == 5).all() else []
    with h5py.File(args.run) as run:
        if "run/sensor/engine" in run:
            origins = run["run/sensor/engine/origin"][:]
            turn = turn_of(*run["run/sensor/engine/orientation"][-1])
            points = (points - origins[-1]) @ turn + origins[0]
    with open(args.out, "w") as out:
        out.writelines("v %g %g %g\n" % tuple(p) for p in points)
        out.writelines("f %d %d %d\n" % tuple(t + 1) for t in triangles)


if __name__ == "__main__":
    main()
