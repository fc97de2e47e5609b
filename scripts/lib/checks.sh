# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash

# The checks of scripts/test: counted, timed, and not run again where nothing that they read has changed since they
# passed. A check that is not run again says so in its line and in the totals.

passed=0
failed=0
unchanged=0
run_all=
times=$logs/seconds.txt

# check LOG TITLE [PATH...] -- COMMAND...: a step after whose failure the others still run. The paths, from the top
# of the project, are what it reads; without any it always runs.
check() {
    local log=$1 title=$2 paths=() stamp=$top/build/passed/$1 inputs='' status=0
    shift 2
    while [[ $1 != -- ]]; do
        paths+=("$1")
        shift
    done
    shift
    if ((${#paths[@]})); then inputs=$(fingerprint "${paths[@]}"); fi
    if [[ -n $inputs && -z $run_all && -f $stamp && $(<"$stamp") == "$inputs" && -f $logs/$log.log ]]; then
        printf '%-62s  unchanged since it passed\n' "$title" >&2
        count "$log" 0
        unchanged=$((unchanged + counts[0]))
        return
    fi
    rm -f "$stamp"
    set +e
    step "$log" "$title" "$@"
    status=$?
    set -e
    count "$log" "$status"
    if ((status == 0)) && [[ -n $inputs ]]; then
        mkdir -p "$(dirname "$stamp")"
        printf '%s\n' "$inputs" >"$stamp"
    fi
}

# count LOG STATUS: adds to the totals. A log of tests has its own; another check counts as one. A program that
# crashed has no totals.
count() {
    read -ra counts < <(count_tests "$logs/$1.log")
    if (($2 == 0 && counts[0] + counts[1] == 0)); then counts[0]=1; fi
    if (($2 != 0 && counts[1] == 0)); then counts[1]=1; fi
    passed=$((passed + counts[0]))
    failed=$((failed + counts[1]))
}

# Prints how many tests of QtTest and pytest passed and failed, by the log.
count_tests() {
    awk '
        /Totals: [0-9]+ passed, [0-9]+ failed/ || /^=* *[0-9]+ (passed|failed|error).* in [0-9.]+s/ {
            for (i = 2; i <= NF; ++i) {
                word = $i; gsub(",", "", word)
                if (word == "passed") passed += $(i - 1)
                else if (word ~ /^(failed|errors?)$/) failed += $(i - 1)
            }
        }
        END {print passed + 0, failed + 0}' "$1"
}

# fingerprint PATH...: prints a hash of the files under the paths, of the scripts, and of what is installed.
fingerprint() {
    {
        printf '%s\n' "$installed"
        cd "$top"
        git ls-files -z --cached --others --exclude-standard -- scripts CMakePresets.json "$@" |
            xargs -0 sha256sum 2>&1 || true # a file that was deleted is a change, too
    } | sha256sum
}

# Prints what is installed: packages of the distribution, of Python, and the hosts.
describe_installed() {
    uname -m
    nproc
    dpkg-query -W "$@" 2>/dev/null || true
    cat "$cache"/{hosts,sources}/*/complete "$python_environment"/{complete,development}
    if [[ -f $python_environment/docs ]]; then cat "$python_environment/docs"; fi # scripts/package does without
}

# Prints where the time went: the steps of at least a second, the longest first.
print_times() {
    say "Where the time went:"
    sort -t $'\t' -k1,1nr "$times" | awk -F '\t' '$1 > 0 {printf "%6d s  %s\n", $1, $2}' >&2
}
