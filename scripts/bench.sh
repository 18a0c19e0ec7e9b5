#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds Release and measures: bench.sh NAME [--quick] --json FILE
# Exits 0 whenever it measured, whatever the figures. A peer that is not there gives null.
set -euo pipefail
caller="$PWD"
cd "$(dirname "$(readlink -f "$0")")/.."

usage() {
    echo "usage: scripts/bench.sh NAME [--quick] --json FILE" >&2
    echo "NAME: $(sed -n 's/^crumple_bench(\([a-z_]*\).*/\1/p' tests/bench/CMakeLists.txt | paste -sd ' ')" >&2
    exit 1
}

name="" json="" quick=()
while [ $# -gt 0 ]; do
    case "$1" in
        --quick) quick=(--quick) ;;
        --json) json="${2:-}"; shift ;;
        -*) usage ;;
        *) [ -z "$name" ] || usage; name="$1" ;;
    esac
    shift || usage
done
[ -n "$name" ] && [ -n "$json" ] || usage
grep -q "^crumple_bench($name\b" tests/bench/CMakeLists.txt || usage
case "$json" in /*) ;; *) json="$caller/$json" ;; esac
[ -d "$(dirname "$json")" ] || { echo "bench.sh: no folder $(dirname "$json")" >&2; exit 2; }

scripts/install_packages.sh build bench
scripts/build.sh bench "bench_$name"
"build/bench/tests/bench/bench_$name" "${quick[@]}" --json "$json"
echo "figures: $json" >&2
