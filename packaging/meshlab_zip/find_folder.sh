# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash

# What install.sh and uninstall.sh share. fits.txt is written by scripts/package: the version of MeshLab that the
# plugin was built for, the versions that there are files for, and the name of such a file with VERSION in it.
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=scripts/lib/meshlab.sh
. "$here/meshlab.sh"
{
    read -r version
    read -r versions
    read -r file_name
} <"$here/fits.txt"
# shellcheck disable=SC2034 # both scripts use it
plugin=libfilter_laplacian_simplify.so

say() { printf '%s\n' "$*" >&2; }

die() {
    say "error: $*"
    exit 1
}

# refuse PROGRAM VERSION: it is another MeshLab, so says which file is for that one.
refuse() {
    if [[ " $versions " == *" $2 "* ]]; then
        die "this plugin fits MeshLab $version only, but $1 is $2; take ${file_name/VERSION/$2} instead"
    fi
    die "this plugin fits MeshLab $version only, but $1 is ${2:-of unknown version}; there are files for $versions"
}

# find_folder PROGRAM: prints where the plugin goes; without a program for the one in the PATH.
find_folder() {
    local program=${1:-$(command -v meshlab || true)} library='' found
    [[ $(uname -m) == x86_64 ]] || die "this plugin is for x86_64, and this machine is $(uname -m)"
    [[ -z $program || -f $program ]] || die "$program does not exist"
    [[ -z $program ]] || library=$(library_of "$program")
    if [[ -n $library ]]; then
        found=$(version_of "$library")
        [[ $found == "$version" ]] || refuse "$program" "$found"
    elif [[ $version == 2020.09 ]]; then
        die "MeshLab 2020.09 is not found; name it: $0 /path/to/bin/meshlab"
    else # an AppImage, or none yet: other versions do not look into the folder of this one
        say "No MeshLab is found whose version could be compared; the plugin is for $version."
    fi
    plugin_folder "$version" "$library"
}
