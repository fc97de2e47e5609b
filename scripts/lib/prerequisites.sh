# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash

# Packages of the distribution that the project needs: the only part that wants root.
# shellcheck disable=SC2034 # not every script builds
build_packages=(g++ cmake ninja-build qtbase5-dev libqt5opengl5-dev libeigen3-dev libglew-dev
    python3 python3-venv libgl1 libopengl0 ca-certificates dpkg-dev xz-utils)
# shellcheck disable=SC2034 # not every script draws
# VTK draws with it where there is no display.
picture_packages=(libegl1)
# shellcheck disable=SC2034 # not every script tests
# chromium: opens the page of --report. libomp: OpenMP of Clang. locales: the sources of one with a decimal comma.
test_packages=(git ccache clang-14 clang-format-14 libomp-14-dev shellcheck locales xvfb xauth openbox
    xdotool imagemagick libegl1 chromium)
# shellcheck disable=SC2034 # not every script fuzzes
# The sanitizers and libFuzzer of Clang; llvm: the names in their reports.
fuzz_packages=(libclang-rt-14-dev llvm-14)

# Prints those of the given packages that are not installed.
missing_packages() {
    local package
    for package in "$@"; do
        [[ $'\n'$installed_packages$'\n' == *$'\n'"$package ii "$'\n'* ]] || printf '%s\n' "$package"
    done
}

# ensure_packages PACKAGE...: installs what is missing, as root or through sudo; otherwise says what to ask for.
ensure_packages() {
    local installed_packages missing privilege=()
    if ! command -v dpkg-query >/dev/null; then
        say "No apt here: the packages $* (Debian's names) are taken to be installed."
        return
    fi
    installed_packages=$(dpkg-query -W -f '${Package} ${db:Status-Abbrev}\n' "$@" 2>/dev/null || true)
    mapfile -t missing < <(missing_packages "$@")
    ((${#missing[@]})) || return 0
    say "Installing with apt: ${missing[*]}"
    if ((EUID != 0)); then
        sudo -n true 2>/dev/null || die "not root, so please have these installed first:" \
            "apt-get install ${missing[*]}"
        privilege=(sudo -n)
    fi
    step apt "Packages of the distribution" install_packages "${missing[@]}"
}

install_packages() {
    "${privilege[@]}" apt-get -q update
    "${privilege[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get -qy -o DPkg::Lock::Timeout=300 install --no-install-recommends "$@"
}
