#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The long runs, hours in all. scripts/test.sh is the quick part.
#
#   scripts/check_all.sh [--fuzz-minutes N] [STEP...]
#
# Steps, all of them by default:
#   release     every test in its long form (CRUMPLE_FULL_TESTS=1)
#   sanitized   the same with ASan and UBSan
#   toolchains  what a game embeds with gcc, clang, mingw under wine and aarch64 under qemu
#   compilers   the suite with clang, and the sample car cooked by gcc and by clang: same bytes
#   fuzz        each libFuzzer target for N minutes, 10 by default, as many at once as there are cores
#   bench       every benchmark at its full size, figures in build/bench/*.json
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

minutes=10 steps=()
while [ $# -gt 0 ]; do
    case "$1" in
        --fuzz-minutes) minutes="${2:?--fuzz-minutes: how many?}"; shift ;;
        release | sanitized | toolchains | compilers | fuzz | bench) steps+=("$1") ;;
        *) sed -n '4,14s/^# \{0,1\}//p' "$0" >&2; exit 1 ;;
    esac
    shift
done
[ ${#steps[@]} -gt 0 ] || steps=(release sanitized toolchains compilers fuzz bench)

# Preset.
test_in_full() {
    scripts/build.sh "$1"
    CRUMPLE_FULL_TESTS=1 ctest --preset "$1" --parallel "$(nproc)" --timeout 36000
}

run_release() { test_in_full release; }

run_sanitized() { test_in_full dev; }

cook_with() {
    "build/$1/crumple" cook pipelines/car_body.json --shell samples/car/car_shell.glb --visual samples/car/car_visual.glb \
        -q -o "build/$1/car.hdf"
}

run_toolchains() { scripts/toolchains.sh; }

run_compilers() {
    scripts/test.sh clang
    scripts/build.sh release crumple
    cook_with release
    cook_with clang
    cmp build/release/car.hdf build/clang/car.hdf
    echo "gcc and clang cook the same bytes" >&2
}

fuzz_one() {
    local name="$1" corpora=("build/fuzz/corpus/$1")
    mkdir -p "${corpora[0]}"
    if [ -d "tests/fuzz/corpus/$name" ]; then corpora+=("tests/fuzz/corpus/$name"); fi
    local log="build/fuzz/$name.log" failed=0
    "build/fuzz/tests/fuzz/$name" -max_total_time=$((minutes * 60)) -timeout=30 -print_final_stats=1 \
        -artifact_prefix="build/fuzz/$name-" "${corpora[@]}" >"$log" 2>&1 || failed=1
    { echo "== $name: $minutes minutes"; if [ "$failed" = 1 ]; then tail -n 60 "$log"; else grep '^stat::' "$log"; fi; } >&2
    return "$failed"
}

run_fuzz() {
    scripts/build.sh fuzz fuzz_targets
    export -f fuzz_one
    export minutes
    find build/fuzz/tests/fuzz -maxdepth 1 -name 'fuzz_*' -type f -executable -printf '%f\n' | sort |
        xargs -P "$(nproc)" -I NAME bash -c 'fuzz_one NAME'
}

run_bench() {
    local name
    mkdir -p build/bench
    for name in $(sed -n 's/^crumple_bench(\([a-z_]*\).*/\1/p' tests/bench/CMakeLists.txt); do
        scripts/bench.sh "$name" --json "build/bench/$name.json"
    done
}

scripts/install_packages.sh build test bench check
for step in "${steps[@]}"; do
    echo "== check_all: $step" >&2
    "run_$step"
done
echo "every step passed: ${steps[*]}" >&2
