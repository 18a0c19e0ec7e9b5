#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds, and runs every test: in Release, then with sanitizers and warnings as errors.
#
#   scripts/test.sh                both
#   scripts/test.sh release|dev    one of them
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

presets=("$@")
[ ${#presets[@]} -gt 0 ] || presets=(release dev)
for preset in "${presets[@]}"; do
    case "$preset" in
        release | dev | clang) ;;
        *) echo "test.sh: unknown preset '$preset'; there are: release, dev, clang" >&2; exit 1 ;;
    esac
done

scripts/install_packages.sh build test
for preset in "${presets[@]}"; do
    echo "== $preset: build" >&2
    scripts/build.sh "$preset"
    echo "== $preset: test" >&2
    ctest --preset "$preset" --parallel "$(nproc)"
done
echo "every test passed" >&2
