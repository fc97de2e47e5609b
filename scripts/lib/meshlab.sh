# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash

# Where a MeshLab program has its library and looks for plugins. The zips for MeshLab carry this file, too.

# Prints libmeshlab-common.so of a MeshLab program, which lies beside it in one of the places that are usual.
library_of() {
    local prefix library
    prefix=$(dirname "$(dirname "$(readlink -f "$1")")")
    for library in "$prefix"/lib/{*/meshlab,meshlab,*,}/libmeshlab-common.so; do
        if [[ -f $library ]]; then
            printf '%s\n' "$library"
            return
        fi
    done
}

# Prints the version of a libmeshlab-common.so, with a "d" where it computes in double.
version_of() { grep -aoE '20[0-9]{2}\.[0-9]{2}d?' "$1" | head -n 1 || true; }

# plugin_folder VERSION LIBRARY: prints where MeshLab of that version looks for plugins. From 2022 on that is in the
# user's home, and the library does not matter.
plugin_folder() {
    local version=$1 library=$2 suffix=fp
    if [[ $version == 2020.09 ]]; then
        printf '%s\n' "$(dirname "$library")/plugins"
        return
    fi
    [[ $version != *d ]] || suffix=dp
    printf '%s\n' "${XDG_DATA_HOME:-$HOME/.local/share}/VCG/MeshLab_64bit_$suffix/MeshLabExtraPlugins/$version"
}
