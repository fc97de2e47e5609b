# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash

# build_target PRESET [TARGET]: configures where that is needed, then builds what has changed, in build/PRESET.
build_target() {
    local folder=$top/build/$1 stamp=$top/build/$1/configured
    # A tree that was configured before its host moved would go on building against the old place.
    if [[ ! -f $stamp || -n $(find "$cache/hosts" -name host.cmake -newer "$stamp") ]]; then rm -rf "$folder"; fi
    # CMake itself does not notice that a preset has changed.
    if [[ ! -f $stamp || $top/CMakePresets.json -nt $stamp ]]; then
        (cd "$top" && cmake --preset "$1")
        touch "$stamp"
    fi
    cmake --build "$folder" --target "${2:-all}" -- -k 0
}

build_preset() { build_target "$1" all; }

# build_presets PRESET...: as many at a time as there are processors. A plugin is hardly more than one file that takes
# a minute and a half, so that one preset alone would keep one processor busy.
build_presets() {
    local preset running=0 status=0
    for preset in "$@"; do
        if ((running == $(nproc))); then
            wait -n || status=$?
            running=$((running - 1))
        fi
        CMAKE_BUILD_PARALLEL_LEVEL=1 build_preset "$preset" &
        running=$((running + 1))
    done
    for (( ; running > 0; --running)); do wait -n || status=$?; done
    return "$status"
}
