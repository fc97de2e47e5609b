# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash

# build_target PRESET [TARGET]: configures where that is needed, then builds what has changed, in build/PRESET.
build_target() {
    local folder=$top/build/$1
    # A tree that was configured before its host moved would go on building against the old place.
    if [[ ! -f $folder/build.ninja || -n $(find "$cache/hosts" -name host.cmake -newer "$folder/build.ninja") ]]; then
        rm -rf "$folder"
        (cd "$top" && cmake --preset "$1")
    fi
    cmake --build "$folder" --target "${2:-all}" -- -k 0
}

build_preset() { build_target "$1" all; }

# Prints the plugin that the preset has built.
plugin_of() { printf '%s\n' "$top/build/$1/plugins/libfilter_laplacian_simplify.so"; }
