#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: ./uninstall.sh [MESHLAB]
# Removes what install.sh with the same argument has put there, and the folders that are empty then.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/find_folder.sh"

folder=$(find_folder "${1-}")
[[ -e $folder/$plugin ]] || die "$folder/$plugin is not there"
[[ -w $folder ]] || die "$folder belongs to root, so please run: sudo $here/uninstall.sh ${1-}"
rm "$folder/$plugin"
while [[ $folder == */VCG* ]] && rmdir "$folder" 2>/dev/null; do folder=$(dirname "$folder"); done
say "Removed: $plugin"
