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

# Before and after the stage finish: what it leaves undone fails the gates, and is drawn all the same.
for mode in none full; do
    build/release/crumple cook samples/recipes/car.json -q --keep-work --set "finish.mode=$mode" --set gates.enforce=false \
        -o "build/sample/car_finish_$mode.hdf" --shell samples/car/car_shell.glb --visual samples/car/car_visual.glb
    draw samples/car/car_shell.glb "build/sample/car_finish_$mode.hdf" -o "samples/pictures/quality_$mode.png" --wire \
        --ghost car_shell --field min_dihedral_deg --range 0,40 --below 15
done

# After a pole at 15 m/s.
build/release/crumple cook samples/recipes/car.json -q --keep-work -o build/sample/car_work.hdf \
    --shell samples/car/car_shell.glb --visual samples/car/car_visual.glb
build/release/crumple simulate build/sample/car_work.hdf --scene pole -o build/sample/crash.hdf -q
scripts/last_frame.py build/sample/crash.hdf car_visual -o build/sample/crashed.obj
draw build/sample/crashed.obj -o samples/pictures/crashed.png --smooth

# The same with a car of others where the real input is: for looking at, since its licence is not that of samples/.
if [ -d "${CRUMPLE_DATA:-../shared/data}/open" ]; then
    CRUMPLE=build/release/crumple tests/cli/crash.py --runs 1 --keep build/sample/crash
    scripts/last_frame.py build/sample/crash/suv_crash.hdf suv_visual -o build/sample/crash/suv_crashed.obj
    for car in suv_visual suv_crashed; do
        draw "build/sample/crash/$car.obj" -o "build/sample/$car.png" --smooth
    done
fi
