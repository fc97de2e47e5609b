#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: ./install.sh [MESHLAB]
# Puts the plugin where the MeshLab program in the PATH, or the one named, looks for plugins.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/find_folder.sh"

folder=$(find_folder "${1-}")
mkdir -p "$folder" 2>/dev/null || true
[[ -w $folder ]] || die "$folder belongs to root, so please run: sudo $here/install.sh ${1-}"
install -m 644 "$here/$plugin" "$folder"
say "Installed: $folder/$plugin"
say "Start MeshLab $version, press Ctrl+F and type \"Laplacian\"."
