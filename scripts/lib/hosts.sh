# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash

# The MeshLabs that the plugin is built for and tested in, each with its sources, in the cache folder:
#   sources/meshlab-<version>/   source tree with its vcglib
#   hosts/<host>/host.cmake      where sources and library are, read by cmake/FindMeshLab.cmake
#   hosts/<host>/root            programs and libraries of a Debian release, run by that release's own loader

all_hosts=(meshlab-2020.09 meshlab-2022.02 meshlab-2025.07 pymeshlab-2025.7)

# Per version: the tarball's name, its SHA256 and the suites that may have it, newest home last.
declare -A source_tarballs=(
    [2020.09]="meshlab_2020.09+dfsg1.orig.tar.xz d6715352ff65caffdec0292858d4263eb0c3cbbf3b1e5c2e2bab218e3f234630 bookworm"
    [2022.02]="meshlab_2022.02+dfsg1.orig.tar.xz 11da26ec46c3fbbbc806d410a3221542ec21ec13fdcc55d624304600029435fd trixie"
    [2025.07]="meshlab_2025.07~dfsg.orig.tar.xz d22c98d362f2a284e481af8dbfc272b2222f5b9c67b3cf8bec57d1c3161886f4 forky sid"
)
# Libraries that MeshLab's own plugins load although its package does not depend on them. One that is missing
# would stop the scan of plugins.
declare -A further_packages=(
    [2020.09]="libgomp1 libmuparser2v5 lib3ds-1-3 libopenctm1 libqhull-r8.0"
    [2022.02]="libgomp1 libmuparser2v5 lib3ds-1-3 libopenctm1 libqhull-r8.0 libmpfr6 libgmp10 libxerces-c3.2t64"
    [2025.07]="libgomp1 libmuparser2v5 lib3ds-1-3 libopenctm1 libqhull-r8.0"
)

# ensure_source VERSION
ensure_source() {
    local version=$1 target=$cache/sources/meshlab-$1 recipe="1 ${source_tarballs[$1]}" scratch
    is_complete "$target" "$recipe" && return 0
    say "Fetching the sources of MeshLab $version into $target"
    scratch=$(new_scratch_folder)
    # shellcheck disable=SC2086 # a row of the table is several words
    set -- ${source_tarballs[$version]}
    step "source-$version" "Sources of MeshLab $version" fetch_source "$1" "$2" "$scratch" "${@:3}"
    finish "$scratch" "$target" "$recipe"
}

# ensure_program VERSION: MeshLab as that Debian release ships it.
ensure_program() {
    local version=$1 target=$cache/hosts/meshlab-$1 scratch row recipe
    # shellcheck disable=SC2206 # a row of the table is several words
    row=(${source_tarballs[$version]})
    recipe="1 $version ${row[*]:2} ${further_packages[$version]}"
    is_complete "$target" "$recipe" && return 0
    say "Fetching MeshLab $version of Debian ${row[2]} into $target (about 100 MB)"
    scratch=$(new_scratch_folder)
    # shellcheck disable=SC2086
    step "host-$version" "MeshLab $version" \
        fetch_program "$version" "$scratch" "${row[*]:2}" ${further_packages[$version]}
    describe_host "$scratch" "$version" \
        "$target/$(cd "$scratch" && find root/usr/lib -name 'libmeshlab-common.so' -print -quit)"
    finish "$scratch" "$target" "$recipe"
}

# fetch_program VERSION FOLDER SUITES PACKAGE...: also puts the release's loader beside the programs, because
# MeshLab finds its plugins from the folder of the running executable, which then is the loader.
fetch_program() {
    local version=$1 folder=$2 system=$2/root suite_names=$3 loader
    shift 3
    # shellcheck disable=SC2086 # several words
    fetch_packages "$version" "$folder" $suite_names -- "$@"
    loader=$(find "$system" -path '*/lib/*-linux-gnu*' -name 'ld-linux-*.so.*' -type f -print -quit)
    cp "$loader" "$system/usr/bin/ld-meshlab.so"
    check_libraries "$system"
}

# Prints the folders, joined by colons, in which a program of the unpacked release looks for libraries.
library_folders() {
    local folder found=()
    for folder in "$1"/usr/lib/*-linux-gnu*/{meshlab,,blas,lapack,pulseaudio} "$1"/lib/*-linux-gnu*; do
        [[ -d $folder ]] && found+=("${folder%/}")
    done
    (
        IFS=:
        printf '%s' "${found[*]}"
    )
}

# Fails, naming the library, where a plugin of MeshLab lacks one.
check_libraries() {
    local root=$1 missing
    missing=$(for plugin in "$root"/usr/lib/*/meshlab/plugins/*.so; do
        "$root/usr/bin/ld-meshlab.so" --library-path "$(library_folders "$root")" --list "$plugin" |
            sed -n "s|\(.*\) => not found|$(basename "$plugin") needs\1|p"
    done)
    [[ -z $missing ]] || { say "$missing" && return 1; }
}

# describe_host FOLDER VERSION LIBRARY
describe_host() {
    cat >"$1/host.cmake" <<EOF
set(HOST_MESHLAB_SOURCE_DIR [[$cache/sources/meshlab-$2]])
set(HOST_MESHLAB_COMMON_LIBRARY [[$3]])
EOF
}

# pymeshlab's wheel carries its own libmeshlab-common, so the Python environment is the host.
ensure_pymeshlab() {
    local target=$cache/hosts/pymeshlab-2025.7 recipe library scratch
    ensure_python
    library=$(python_packages_folder)/pymeshlab/lib/libmeshlab-common.so
    recipe="1 $library"
    is_complete "$target" "$recipe" && return 0
    [[ -f $library ]] || die "pymeshlab has no $library"
    scratch=$(new_scratch_folder)
    describe_host "$scratch" 2025.07 "$library"
    finish "$scratch" "$target" "$recipe"
}

# ensure_host HOST: everything that the preset of that name needs. No call of apt or pip where all is there.
ensure_host() {
    case $1 in
    meshlab-2020.09 | meshlab-2022.02 | meshlab-2025.07)
        ensure_source "${1#meshlab-}"
        ensure_program "${1#meshlab-}"
        ;;
    pymeshlab-2025.7)
        ensure_source 2025.07
        ensure_pymeshlab
        ;;
    *) die "unknown host '$1': it is one of ${all_hosts[*]}" ;;
    esac
}
