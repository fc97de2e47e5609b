# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash

# Ground of every script: where things are, how a step is shown, what stops a script. Sourced, never run.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
HOME=${HOME:-$(getent passwd "$(id -u)" | cut -d: -f6)}
export HOME
cache=${XDG_CACHE_HOME:-$HOME/.cache}/laplacian-simplify
logs=$top/build/logs
export LC_ALL=C.UTF-8 LANG=C.UTF-8 # one language in logs, one decimal point; ccache takes other languages for other files
PATH=$PATH:/usr/sbin:/sbin
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export CCACHE_BASEDIR=$top # two checkouts share what they compile

# Asked for help, a script prints the comment at its top; two hand the question on to what they run.
case ${0##*/}:${1-} in
simplify:* | python:*) ;;
*:-h | *:--help)
    sed -n '/^# Usage/,/^[^#]/ s/^# \{0,1\}//p' "$0"
    exit
    ;;
esac

say() { printf '%s\n' "$*" >&2; }

die() {
    say "error: $*"
    exit 1
}

# step LOG TITLE COMMAND...: runs the command quietly, its output in build/logs/LOG.log, and prints one line with
# the seconds that it took. On failure the end of the log is shown and the status is that of the command.
step() {
    local log=$logs/$1.log title=$2 start=$SECONDS status flags=$-
    shift 2
    mkdir -p "$logs"
    printf '%-62s' "$title" >&2
    # A subshell in a condition would lose "set -e", so the status is collected by hand.
    set +e
    (
        set -e
        "$@"
    ) >"$log" 2>&1
    status=$?
    [[ $flags != *e* ]] || set -e
    if [[ -n ${times-} ]]; then printf '%d\t%s\n' $((SECONDS - start)) "$title" >>"$times"; fi
    if ((status == 0)); then
        printf '%5d s\n' $((SECONDS - start)) >&2
    else
        printf '%5d s  FAILED\n' $((SECONDS - start)) >&2
        say "--- end of $log"
        tail -n 40 "$log" >&2
        say "---"
    fi
    return $status
}

# One process at a time changes the cache folder; the others wait. locked COMMAND...
locked() {
    mkdir -p "$cache"
    (
        flock 9
        "$@" 9>&-
    ) 9>"$cache/lock"
}

# is_complete FOLDER RECIPE: whether the folder was finished from exactly this recipe.
is_complete() { [[ -f $1/complete && $(<"$1/complete") == "$2" ]]; }

# Makes a folder to fetch into, in place of those that interrupted runs left behind. Only under the lock.
new_scratch_folder() {
    rm -rf "$cache"/fetching.*
    mktemp -d "$cache/fetching.XXXXXX"
}

# finish FOLDER TARGET RECIPE: marks the folder as complete and puts it, whole, in the place of the target.
finish() {
    printf '%s\n' "$3" >"$1/complete"
    rm -rf "$2"
    mkdir -p "$(dirname "$2")"
    mv "$1" "$2"
}

. "$top/scripts/lib/prerequisites.sh"
. "$top/scripts/lib/debian.sh"
. "$top/scripts/lib/hosts.sh"
. "$top/scripts/lib/python.sh"
. "$top/scripts/lib/build.sh"
