# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash

# Packages of other Debian releases, read from the archive that this machine already uses, through an apt of our
# own in a scratch folder: nothing of the system is touched, no root is needed, and the archive's signature is
# checked by apt with Debian's keys. A mirror that stands still is good enough (Check-Valid-Until): versions are
# pinned here.

archive_keys=/usr/share/keyrings/debian-archive-keyring.gpg

# Prints the addresses of the archives that may be Debian's own, most likely first.
archive_candidates() {
    local release
    # shellcheck source=/dev/null
    release=$(. /etc/os-release && printf '%s' "${VERSION_CODENAME:-stable}")
    # shellcheck disable=SC2016 # apt fills these in
    apt-get indextargets --format '$(CREATED_BY) $(COMPONENT) $(RELEASE) $(REPO_URI)' |
        awk -v release="$release" '$1 == "Packages" && $2 == "main" &&
            $3 ~ "^(" release "|bookworm|trixie|forky|sid|oldstable|stable|testing|unstable)$" && !seen[$4]++ {print $4}'
}

# Writes the settings of a private apt into the folder: empty package state, the machine's way to the network.
write_private_apt() {
    local folder=$1
    mkdir -p "$folder"/{etc/{apt.conf.d,preferences.d,sources.list.d,trusted.gpg.d},lists/partial,archives/partial}
    : >"$folder/status"
    {
        apt-config dump | grep -E '^Acquire::(https?|ftp|socks|Retries|ForceIPv)' || true
        cat <<EOF
Dir::Etc "$folder/etc";
Dir::Etc::netrc "/etc/apt/auth.conf";
Dir::Etc::netrcparts "/etc/apt/auth.conf.d";
Dir::State "$folder";
Dir::State::lists "$folder/lists";
Dir::State::status "$folder/status";
Dir::Cache "$folder";
Dir::Cache::archives "$folder/archives";
Acquire::Languages "none";
Acquire::Check-Valid-Until "false";
Acquire::Retries "3";
APT::Install-Recommends "false";
APT::Sandbox::User "";
APT::Update::Error-Mode "any";
Debug::NoLocking "true";
EOF
    } >"$folder/apt.conf"
}

# open_archive FOLDER KIND SUITE: a private apt that knows one suite; KIND is deb or deb-src.
open_archive() {
    local folder=$1 kind=$2 suite=$3 address
    [[ -f $archive_keys ]] || die "$archive_keys is missing: hosts are fetched from Debian's archive only"
    write_private_apt "$folder"
    for address in $(archive_candidates); do
        echo "$kind [signed-by=$archive_keys] $address $suite main" >"$folder/etc/sources.list"
        if APT_CONFIG=$folder/apt.conf apt-get -q update; then return 0; fi
    done
    return 1
}

# fetch_source FILE SHA256 FOLDER SUITE...: the source tarball from the first suite that still has it, unpacked.
fetch_source() {
    local file=$1 hash=$2 folder=$3 suite address scratch
    shift 3
    for suite in "$@"; do
        scratch=$folder/apt-$suite
        open_archive "$scratch" deb-src "$suite" || continue
        address=$(APT_CONFIG=$scratch/apt.conf apt-get source --print-uris --download-only --only-source meshlab |
            sed -n "s|^'\([^']*\)' $file .*|\1|p" | head -n 1) || true
        [[ -n $address ]] || continue
        APT_CONFIG=$scratch/apt.conf /usr/lib/apt/apt-helper download-file "$address" "$folder/$file" "SHA256:$hash"
        tar -xf "$folder/$file" -C "$folder" --strip-components=1 --no-same-owner
        rm -rf "$folder"/apt-* "${folder:?}/$file"
        return 0
    done
    say "$file is in none of the suites $* any more"
    return 1
}

# fetch_packages VERSION FOLDER SUITE... -- PACKAGE...: unpacks meshlab of that version, the packages and all that
# they depend on into FOLDER/root, from the first suite that still has the version.
fetch_packages() {
    local version=$1 folder=$2 system=$2/root suites=() suite scratch archive
    shift 2
    while [[ $1 != -- ]]; do
        suites+=("$1")
        shift
    done
    shift
    for suite in "${suites[@]}"; do
        scratch=$folder/apt-$suite
        open_archive "$scratch" deb "$suite" || continue
        APT_CONFIG=$scratch/apt.conf apt-get -qy --download-only install "meshlab=$version*" "$@" || continue
        mkdir -p "$system"
        for archive in "$scratch"/archives/*.deb; do dpkg-deb -x "$archive" "$system"; done
        (cd "$scratch/archives" && printf '%s\n' *.deb) >"$folder/packages.txt"
        rm -rf "$folder"/apt-* "$system"/usr/share/{doc,man,info,locale}
        return 0
    done
    say "meshlab $version is in none of the suites ${suites[*]} any more"
    return 1
}
