#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# From a fresh Debian 12 machine to a cooked car: installs what is missing, builds, cooks the sample, says what came out.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

scripts/install_packages.sh build
scripts/build.sh release crumple
crumple=build/release/crumple

out=build/sample
mkdir -p "$out"
echo "== cook: samples/car with the recipe samples/recipes/car.json" >&2
"$crumple" cook samples/recipes/car.json \
    --shell samples/car/car_shell.glb --visual samples/car/car_visual.glb \
    -o "$out/car.hdf" --report "$out/car.report.json"
"$crumple" check "$out/car.hdf"

echo
echo "== what it holds"
"$crumple" inspect "$out/car.hdf"
cat <<END

The bundle:  $PWD/$out/car.hdf
The report:  $PWD/$out/car.report.json
The program: $PWD/$crumple

The bundle is HDF5: ParaView opens it as it is, any HDF5 library reads it (lib/bundle/FORMAT.md).
Next: README.md, "A first cook, explained" and "How to paint locks".
END
