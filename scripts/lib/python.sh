# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash

# The project's Python: a virtual environment in the cache folder with the pinned packages of others, and the
# project's own package in build/python of this checkout, so that two checkouts do not get into each other's way.
# What checks the project (pytest, mypy and so on), Dask for the command batch, what draws pictures, and Sphinx are put
# into the environment only where they are asked for.

python_environment=$cache/python
python_requirements=$top/scripts/requirements.txt
batch_requirements=$top/scripts/requirements-batch.txt
pictures_requirements=$top/scripts/requirements-pictures.txt
development_requirements=$top/scripts/requirements-development.txt
docs_requirements=$top/scripts/requirements-docs.txt
project_package=$top/build/python

python_packages_folder() { printf '%s\n' "$python_environment"/lib/python3.*/site-packages; }

# ensure_python: the environment with the pinned packages that running needs.
ensure_python() {
    local recipe
    recipe="2 $(/usr/bin/python3 -V) $(sha256sum <"$python_requirements")"
    is_complete "$python_environment" "$recipe" && return 0
    announce_packages "$python_requirements"
    step python "Python packages" create_python_environment
    printf '%s\n' "$recipe" >"$python_environment/complete"
}

# ensure_batch: and those of the command batch.
ensure_batch() { ensure_more batch "Python packages of the command batch" "$batch_requirements"; }

# ensure_pictures: and those that --picture and --report draw with.
ensure_pictures() { ensure_more pictures "Python packages that draw" "$pictures_requirements"; }

# asks_for_pictures ARGUMENT...: whether an option of the command asks for a picture or a page.
asks_for_pictures() {
    local word
    for word in "$@"; do
        case $word in --picture | --picture=* | --report | --report=*) return 0 ;; esac
    done
    return 1
}

# ensure_development: and those that check the project.
ensure_development() {
    ensure_batch
    ensure_pictures
    ensure_more development "Python packages that check the project" "$development_requirements"
}

# ensure_docs: and those that build the documentation.
ensure_docs() { ensure_more docs "Python packages that build the documentation" "$docs_requirements"; }

# ensure_more NAME TITLE REQUIREMENTS: a further list of packages in the environment.
ensure_more() {
    local stamp=$python_environment/$1 recipe
    ensure_python
    recipe=$(sha256sum <"$3")
    [[ -f $stamp && $(<"$stamp") == "$recipe" ]] && return 0
    announce_packages "$3"
    step "python-$1" "$2" install_pinned "$3"
    printf '%s\n' "$recipe" >"$stamp"
}

# Says which packages of a list of pinned ones are about to be installed.
announce_packages() {
    say "Installing with pip into $python_environment:" \
        "$(sed -n 's/^\([a-z][^ ]*\)==\([^ ]*\).*/\1 \2,/p' "$1" | tr '\n' ' ')"
}

create_python_environment() {
    rm -rf "$python_environment"
    /usr/bin/python3 -m venv "$python_environment"
    install_pinned "$python_requirements"
}

install_pinned() {
    "$python_environment/bin/python" -m pip --disable-pip-version-check install --no-input --only-binary :all: \
        --require-hashes -r "$1"
}

# ensure_package: laplacian_simplify with the plugin for pymeshlab inside, built again where a source is newer.
ensure_package() {
    ensure_host pymeshlab-2025.7
    if ! package_is_current; then step python-package "Python package with the plugin" build_package; fi
}

package_is_current() {
    local stamp=$project_package/complete
    [[ -f $stamp && $stamp -nt $cache/hosts/pymeshlab-2025.7/complete ]] &&
        [[ -z $(find "$top"/{CMakeLists.txt,pyproject.toml,cmake,vcg_ext,filter_laplacian_simplify,python} \
            -newer "$stamp" -not -name '*.pyc' -not -name __pycache__ -print -quit) ]]
}

build_package() {
    rm -rf "$project_package.new"
    build_preset pymeshlab-2025.7
    "$python_environment/bin/python" -m pip --disable-pip-version-check install --no-input --no-deps --no-index \
        --no-build-isolation --target "$project_package.new" "$top"
    touch "$project_package.new/complete"
    rm -rf "$project_package"
    mv "$project_package.new" "$project_package"
}

# run_python ARGUMENT...: Python of the environment with laplacian_simplify in it, in place of this shell.
run_python() {
    PYTHONPATH=$project_package${PYTHONPATH:+:$PYTHONPATH} exec "$python_environment/bin/python" "$@"
}

# build_docs BUILDER: the documentation by that builder of Sphinx, into build/docs or build/docs-BUILDER. All pages are
# read again (-E): Sphinx does not repeat the warnings of a page that has not changed.
build_docs() {
    local output=$top/build/docs
    [[ $1 == html ]] || output+=-$1
    rm -rf "$output" # a page that was removed
    "$python_environment/bin/python" -m sphinx -W --keep-going -q -E -b "$1" -d "$top/build/docs-state" \
        "$top/docs" "$output"
}
