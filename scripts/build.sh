#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Configures and builds one preset of CMakePresets.json into build/<preset>: build.sh release [TARGET...]
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

preset="${1:?build.sh: say which preset: release, dev, clang, bench or fuzz}"
shift

# One job a core, but no more than memory holds: a file that includes CGAL takes about 1.5 GB to compile.
jobs() {
    local cores memory
    cores="$(nproc)"
    memory="$(awk '/^MemAvailable:/ { print int($2 / 1572864) }' /proc/meminfo 2>/dev/null || echo "$cores")"
    [ "${memory:-0}" -ge 1 ] || memory=1
    echo $(( cores < memory ? cores : memory ))
}

launcher=()
if command -v ccache >/dev/null; then
    launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    export CCACHE_SLOPPINESS="${CCACHE_SLOPPINESS:-pch_defines,time_macros}"  # without, nothing that uses a precompiled header is kept
fi

cmake --preset "$preset" "${launcher[@]}" >&2
targets=()
if [ $# -gt 0 ]; then targets=(--target "$@"); fi
cmake --build --preset "$preset" --parallel "$(jobs)" "${targets[@]}" >&2
