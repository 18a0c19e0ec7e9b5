#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing of the given sections of scripts/packages.txt: install_packages.sh build test
# Needs no rights when nothing is missing.
set -euo pipefail
list="$(dirname "$(readlink -f "$0")")/packages.txt"

fail() { echo "install_packages.sh: $*" >&2; exit 1; }

packages_of() {
    awk -v wanted="[$1]" '/^\[/ { inside = ($1 == wanted); found = found || inside; next }
                          inside && NF && $1 !~ /^#/ { print $1 }
                          END { exit !found }' "$list"
}

is_installed() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

as_root() {
    if [ "$(id -u)" = 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        fail "missing packages: ${missing[*]}. Run this as root, or install them with: apt-get install ${missing[*]}"
    fi
}

[ $# -gt 0 ] || fail "say which sections of packages.txt: build test bench check toolchains golden pictures"
command -v dpkg-query >/dev/null || fail "works on Debian 12 and its relatives only; packages.txt lists what to install"

missing=()
for section in "$@"; do
    packages="$(packages_of "$section")" || fail "packages.txt has no section [$section]"
    for package in $packages; do
        is_installed "$package" || missing+=("$package")
    done
done
[ ${#missing[@]} -gt 0 ] || exit 0

echo "installing: ${missing[*]}" >&2
export DEBIAN_FRONTEND=noninteractive
as_root apt-get -qq update >&2 || fail "apt-get update failed; is there a network and a package source?"
# env: sudo does not pass the variable on.
as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends "${missing[@]}" >&2 ||
    fail "apt-get could not install: ${missing[*]}"
