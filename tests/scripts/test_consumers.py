# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Another project gets the headers in every usual way, compiles them without a warning, and its programs run.

What is built stays in build/consumers, so that a second run compiles only what has changed.
"""

import json
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[2]
CONSUMERS = PROJECT / "tests" / "consumers"
BUILDS = PROJECT / "build" / "consumers"
CACHE = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "laplacian-simplify"
VCGLIB = CACHE / "sources" / "meshlab-2025.07" / "src" / "vcglib"
COMPILERS = ["g++", "clang++-14"]
STANDARDS = [17, 20]
NOTHING_BUT_A_COMPILER = {f"CMAKE_DISABLE_FIND_PACKAGE_{name}": "ON" for name in ("Eigen3", "Qt5", "OpenMP")}


def run(*command: object) -> subprocess.CompletedProcess:
    environment = {**os.environ, "CCACHE_BASEDIR": str(PROJECT)}
    if shutil.which("ccache"):
        environment["CMAKE_CXX_COMPILER_LAUNCHER"] = "ccache"
    return subprocess.run(list(map(str, command)), env=environment, capture_output=True, text=True)


def configure(source: Path, build: Path, **settings: object) -> subprocess.CompletedProcess:
    return run("cmake", "-S", source, "-B", build, "-G", "Ninja", *(f"-D{k}={v}" for k, v in settings.items()))


def build_consumer(way: str, compiler: str, **settings: object) -> Path:
    """The folder with the programs of tests/consumers/``way``."""
    build = BUILDS / f"{way}-{compiler}"
    done = configure(CONSUMERS / way, build, CMAKE_CXX_COMPILER=compiler, **settings)
    assert done.returncode == 0, done.stderr
    done = run("cmake", "--build", build)
    assert done.returncode == 0, done.stdout
    return build


@pytest.fixture(scope="session")
def prefix() -> Path:
    """Where the headers are installed by a build that finds neither MeshLab nor Eigen, Qt or OpenMP."""
    folder = BUILDS / "prefix"
    shutil.rmtree(folder, ignore_errors=True)
    done = configure(PROJECT, BUILDS / "headers", CMAKE_INSTALL_PREFIX=folder, **NOTHING_BUT_A_COMPILER)
    assert done.returncode == 0, done.stderr
    done = run("cmake", "--build", BUILDS / "headers", "--target", "install")
    assert done.returncode == 0, done.stdout
    return folder


@pytest.fixture(scope="session")
def assert_same_bytes() -> object:
    """Whatever the way, the compiler, the standard and the threads, the first result is that of all."""
    results: list[bytes] = []

    def check(program: Path, file: Path) -> None:
        done = run(program, 1000, file)
        assert done.returncode == 0, done.stderr
        # The last collapse takes two faces: one too many, where an earlier one took a single face of the border.
        assert done.stdout in ("180000 faces became 1000\n", "180000 faces became 999\n")
        results.append(file.read_bytes())
        assert results[-1] == results[0]

    return check


@pytest.mark.parametrize(("compiler", "standard"), list(zip(COMPILERS, STANDARDS, strict=True)))
def test_subdirectory_with_its_functions_in_a_library(
    tmp_path: Path, compiler: str, standard: int, assert_same_bytes: object
) -> None:
    settings = {"LAPLACIAN_SIMPLIFY_DIR": PROJECT, "STANDARDS": standard, "LAPLACIAN_SIMPLIFY_COMPILED": "ON"}
    if compiler == "g++":
        settings["VCGLIB_DIR"] = VCGLIB
    build = build_consumer("subdirectory", compiler, **settings)
    assert_same_bytes(build / f"simplify_arrays_{standard}", tmp_path / "result.off")


@pytest.mark.parametrize(("compiler", "standard"), list(zip(COMPILERS, reversed(STANDARDS), strict=True)))
def test_fetch_content_without_eigen_qt_and_openmp(
    tmp_path: Path, compiler: str, standard: int, assert_same_bytes: object
) -> None:
    settings = {"LAPLACIAN_SIMPLIFY_DIR": PROJECT, "STANDARDS": standard, **NOTHING_BUT_A_COMPILER}
    build = build_consumer("fetch_content", compiler, **settings)
    assert_same_bytes(build / f"simplify_arrays_{standard}", tmp_path / "result.off")


@pytest.mark.parametrize(("compiler", "standard"), list(zip(COMPILERS, STANDARDS, strict=True)))
def test_find_package(tmp_path: Path, prefix: Path, compiler: str, standard: int, assert_same_bytes: object) -> None:
    """Also for a program with a VCG mesh of its own, and with the arithmetic that the same bytes need."""
    settings = {"CMAKE_PREFIX_PATH": prefix, "VCGLIB_DIR": VCGLIB, "STANDARDS": standard}
    build = build_consumer("find_package", compiler, **settings)
    assert_same_bytes(build / f"simplify_arrays_{standard}", tmp_path / "result.off")
    assert run(build / f"simplify_vcg_mesh_{standard}").stdout == "20480 faces became 1000\n"


def test_package_asks_for_exact_arithmetic_only(prefix: Path) -> None:
    """Warnings, standards and optimization are the consumer's own."""
    build = BUILDS / "flags"
    settings = {"CMAKE_PREFIX_PATH": prefix, "CMAKE_EXPORT_COMPILE_COMMANDS": "ON", **NOTHING_BUT_A_COMPILER}
    assert configure(CONSUMERS / "find_package", build, **settings).returncode == 0
    commands = json.loads((build / "compile_commands.json").read_text())
    words = {word for entry in commands for word in entry["command"].split() if word.startswith("-")}
    own = {"-Wall", "-Wextra", "-Wshadow", "-Werror", "-std=c++17", "-std=c++20", "-c", "-o"}
    assert words - own == {"-ffp-contract=off", "-fno-math-errno", f"-I{prefix}/include"}


@pytest.mark.parametrize("version", ["0.2", "1.0"])
def test_another_minor_version_is_refused(tmp_path: Path, prefix: Path, version: str) -> None:
    settings = {"CMAKE_PREFIX_PATH": prefix, "LAPLACIAN_SIMPLIFY_VERSION": version}
    done = configure(CONSUMERS / "find_package", tmp_path, **settings)
    assert done.returncode != 0
    assert f'requested version "{version}"' in " ".join(done.stderr.split())


@pytest.mark.parametrize("standard", STANDARDS)
@pytest.mark.parametrize("compiler", COMPILERS)
def test_ten_lines_and_the_headers_alone(tmp_path: Path, compiler: str, standard: int) -> None:
    program, dependencies, compiled = (tmp_path / name for name in ("octahedron", "octahedron.d", "octahedron.o"))
    warnings = ["-Wall", "-Wextra", "-Wshadow", "-Werror"]
    source = CONSUMERS / "bare" / "octahedron.cpp"
    command = [compiler, f"-std=c++{standard}", *warnings, "-I", PROJECT, "-MMD", "-MF", dependencies, "-c", source]
    done = run(*command, "-o", compiled)
    assert done.returncode == 0, done.stderr
    assert run(compiler, compiled, "-o", program).returncode == 0
    assert run(program).returncode == 0
    symbols = run("nm", "-C", compiled).stdout.splitlines()
    assert any(" W vcg_ext::Simplify(" in symbol for symbol in symbols), "inline: other files may include it, too"
    assert [symbol for symbol in symbols if re.search(r" [TDB] .*\bvcg_ext::", symbol)] == []
    headers = [Path(word) for word in dependencies.read_text().split() if word.endswith(".h")]
    assert headers
    assert all(header.is_relative_to(PROJECT / "vcg_ext" / "core") for header in headers)


@pytest.mark.parametrize("backwards", [False, True])
def test_headers_of_the_core_in_either_order_hide_nothing_of_each_other(tmp_path: Path, backwards: bool) -> None:
    headers = sorted((PROJECT / "vcg_ext" / "core").rglob("*.h"), reverse=backwards)
    everything = tmp_path / "everything.cpp"
    everything.write_text("".join(f'#include "{header.relative_to(PROJECT)}"\n' for header in headers))
    warnings = ["-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Werror"]
    done = run("g++", "-std=c++17", "-fopenmp", "-fsyntax-only", *warnings, "-I", PROJECT, everything)
    assert done.returncode == 0, done.stderr
