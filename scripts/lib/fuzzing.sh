# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash

# libFuzzer on the targets of tests/hostile: fuzz_*.cpp, built by the preset "fuzz", and fuzz_files.py.

fuzzing_requirements=$top/scripts/requirements-fuzzing.txt

# ensure_fuzzing: what fuzzes Python code.
ensure_fuzzing() { ensure_more fuzzing "Python package that fuzzes" "$fuzzing_requirements"; }

# fuzz TARGET MINUTES: from its seeds and what earlier nights have learned. Fails where something is found.
fuzz() {
    scratch=$(mktemp -d -p "$([[ -w /dev/shm ]] && echo /dev/shm || echo "${TMPDIR:-/tmp}")")
    trap 'rm -rf "$scratch"' EXIT # of the subshell of the step
    TMPDIR=$scratch run_fuzzer "$@"
}

# run_fuzzer TARGET MINUTES: the same with $TMPDIR for its files, which may remain there.
run_fuzzer() {
    local learned=$top/build/fuzzed/$1 findings=$top/build/findings/$1 program=("$top/build/fuzz/tests/hostile/$1")
    local python=("$python_environment/bin/python")
    export PYTHONPATH=$project_package
    mkdir -p "$learned" "$findings"
    case $1 in
    fuzz_core | fuzz_arrays) "${python[@]}" "$top/tests/hostile/mesh_bytes.py" "$learned" ;;
    fuzz_files)
        program=("${python[@]}" "$top/tests/hostile/fuzz_files.py")
        "${program[@]}" --seeds "$learned"
        ;;
    esac
    "${program[@]}" -max_total_time=$((60 * $2)) -timeout=60 -rss_limit_mb=4096 -max_len=8192 \
        -artifact_prefix="$findings/" -print_final_stats=1 "$learned"
}

# last_coverage TARGET: prints how many inputs a fuzzer has run and what they covered, from its log.
last_coverage() {
    local log=$logs/$1.log
    say "    $(grep -oE 'cov: [0-9]+ ft: [0-9]+ corp: [^ ]+' "$log" | tail -n 1)," \
        "$(grep -oE 'number_of_executed_units: *[0-9]+' "$log" | grep -oE '[0-9]+' || echo no) inputs"
}
