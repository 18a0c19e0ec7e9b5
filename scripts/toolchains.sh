#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds what a game embeds (core material bundle solver) with every compiler it may meet, warnings as errors, and runs
# its tests: natively, under wine and under qemu.
#
#   scripts/toolchains.sh [--no-install] [TOOLCHAIN...]
#
# Toolchains, all of them by default: gcc clang mingw aarch64. Everything is left in build/toolchains/. Under qemu the
# tests run with CRUMPLE_EMULATED_TESTS=1: those that repeat a thing many times repeat it less often.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

install=true toolchains=()
while [ $# -gt 0 ]; do
    case "$1" in
        --no-install) install=false ;;
        gcc | clang | mingw | aarch64) toolchains+=("$1") ;;
        *) sed -n '4,9s/^# \{0,1\}//p' "$0" >&2; exit 1 ;;
    esac
    shift
done
[ ${#toolchains[@]} -gt 0 ] || toolchains=(gcc clang mingw aarch64)
if $install; then scripts/install_packages.sh build test check toolchains; fi

launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi

compiler_flags() {
    case "$1" in
        gcc) echo -DCMAKE_C_COMPILER=gcc -DCMAKE_CXX_COMPILER=g++ ;;
        clang) echo -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ ;;
        mingw) echo "-DCMAKE_TOOLCHAIN_FILE=$PWD/scripts/cmake/toolchain-x86_64-w64-mingw32.cmake" ;;
        aarch64) echo "-DCMAKE_TOOLCHAIN_FILE=$PWD/scripts/cmake/toolchain-aarch64-linux-gnu.cmake" ;;
    esac
}

run_with() {
    case "$1" in
        gcc | clang) "${@:2}" ;;
        mingw) "$(command -v wine64 || command -v wine || echo /usr/lib/wine/wine64)" "${@:2}" ;;
        # Emulated, tests take a hundred times as long: those that can do less.
        aarch64) CRUMPLE_EMULATED_TESTS=1 qemu-aarch64 -L /usr/aarch64-linux-gnu "${@:2}" ;;
    esac
}

# Debian packages GoogleTest for other systems as sources only.
build_googletest() {
    local folder="build/toolchains/$1/googletest"
    [ -e "$folder/done" ] && return
    # shellcheck disable=SC2046  # the flags are words
    cmake -S /usr/src/googletest -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_GMOCK=OFF \
        -DCMAKE_INSTALL_PREFIX="$PWD/$folder" $(compiler_flags "$1") >/dev/null
    cmake --build "$folder/build" --target install >/dev/null
    touch "$folder/done"
}

build_runtime() {
    local folder="build/toolchains/$1/crumple"
    # shellcheck disable=SC2046
    cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCRUMPLE_RUNTIME_ONLY=ON -DCRUMPLE_WERROR=ON \
        -DCMAKE_GTEST_DISCOVER_TESTS_DISCOVERY_MODE=PRE_TEST \
        -DGTest_DIR="$PWD/$(dirname "$(find "build/toolchains/$1/googletest/lib" -name GTestConfig.cmake)")" \
        "${launcher[@]}" $(compiler_flags "$1") >/dev/null
    cmake --build "$folder"
}

# wine keeps its registry in a folder of ours and is quiet.
export WINEPREFIX="$PWD/build/toolchains/wine" WINEDEBUG=-all

# One line a test program; what failed is told in full. Every module has one, and a program that passed says how many
# tests it ran.
failed=()
run_tests() {
    local module program summary passed
    for module in core material bundle solver; do
        program="build/toolchains/$1/crumple/tests/$module/test_$module"
        [ -f "$program" ] || program+=.exe
        if summary="$(run_with "$1" "$program" --gtest_brief=1 2>&1 | tr -d '\r')" &&
            passed="$(grep -o '\[  PASSED  \] [1-9].*' <<<"$summary")"; then
            printf '%-8s %-14s %s\n' "$1" "test_$module" "$passed"
        else
            echo "$summary" >&2
            failed+=("$1: test_$module")
        fi
    done
}

for toolchain in "${toolchains[@]}"; do
    echo "== $toolchain" >&2
    build_googletest "$toolchain"
    build_runtime "$toolchain" >&2
    run_tests "$toolchain"
done
if [ ${#failed[@]} -gt 0 ]; then
    echo "toolchains.sh: failed, or not there: $(printf '%s; ' "${failed[@]}")" >&2
    exit 1
fi
echo "every toolchain passed: ${toolchains[*]}" >&2
