#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Draws the pictures of README.md into samples/pictures, from the samples and a bundle cooked from them.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

scripts/install_packages.sh build pictures
scripts/build.sh release crumple
mkdir -p build/sample samples/pictures
build/release/crumple cook samples/recipes/car.json -q -o build/sample/car.hdf \
    --shell samples/car/car_shell.glb --visual samples/car/car_visual.glb

draw() { scripts/render_mesh.py "$@" --size 800x500 --zoom 1.1; }
draw samples/car/car_shell.glb -o samples/pictures/shell.png --wire --locks --ghost body
draw samples/car/car_visual.glb -o samples/pictures/visual.png --smooth
draw build/sample/car.hdf -o samples/pictures/tets.png --wire --cut 'x>0.02' --cut-part region_0
