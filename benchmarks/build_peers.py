# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the peers that are C++ libraries, and this project's engine, as shared objects for ctypes.

All are compiled by the same compiler with the same flags, except Debian's meshoptimizer, which is Debian's.
"""

import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).parent
PROJECT = HERE.parent
FLAGS = ["-std=c++17", "-O3", "-DNDEBUG", "-fPIC", "-shared"]
OWN_FLAGS = ["-fopenmp", "-ffp-contract=off", "-fno-math-errno"]  # as in cmake/compiler.cmake
EIGEN = ["-isystem", "/usr/include/eigen3"]


def compile_object(folder: Path, name: str, sources: list[Path], arguments: list[str]) -> None:
    """Compiles and links name.so; on failure the compiler's message is shown and the run ends."""
    command = ["g++", *FLAGS, *map(str, sources), "-o", str(folder / f"{name}.so"), *arguments]
    subprocess.run(command, check=True)


def fetch_newest_meshoptimizer(folder: Path) -> Path | None:
    """C++ sources of the newest meshoptimizer, out of the crate that carries them; None where Cargo cannot fetch it."""
    project = folder / "newest_meshoptimizer"
    sources = project / "vendor" / "meshopt" / "vendor" / "src"
    if not sources.exists():
        if shutil.which("cargo") is None:
            print("No Cargo here: the newest meshoptimizer is left out.", file=sys.stderr)
            return None
        shutil.copytree(HERE / "peers" / "newest", project, dirs_exist_ok=True)
        fetched = subprocess.run(["cargo", "vendor", "--quiet", "vendor"], cwd=project, stdout=subprocess.DEVNULL)
        if fetched.returncode != 0:
            print("Cargo (1.85 or newer is needed) failed: the newest meshoptimizer is left out.", file=sys.stderr)
            return None
    return sources


def newest(path: Path, pattern: str = "**/*") -> float:
    """When a folder's newest file was changed."""
    return max(file.stat().st_mtime for file in path.glob(pattern) if file.is_file())


def build_engine(folder: Path, vcglib: Path) -> None:
    """The engine, again whenever a header of it has changed."""
    built = folder / "engine.so"
    changed = max(newest(PROJECT / "vcg_ext"), newest(HERE / "peers", "*"))
    if built.exists() and built.stat().st_mtime > changed:
        return
    includes = ["-I", str(PROJECT), "-isystem", str(vcglib), *EIGEN]
    compile_object(folder, "engine", [HERE / "peers" / "engine_peer.cpp"], OWN_FLAGS + includes)


def build_all(folder: Path, vcglib: Path) -> None:
    """Everything that is missing in the folder."""
    folder.mkdir(parents=True, exist_ok=True)
    peers = HERE / "peers"
    if not (folder / "cgal.so").exists():
        compile_object(folder, "cgal", [peers / "cgal_peer.cpp"], [*EIGEN, "-lgmp"])
    runner = peers / "meshoptimizer_peer.cpp"
    if not (folder / "meshoptimizer_debian.so").exists():
        compile_object(folder, "meshoptimizer_debian", [runner], ["-lmeshoptimizer"])
    sources = fetch_newest_meshoptimizer(folder)
    if sources and not (folder / "meshoptimizer_newest.so").exists():
        parts = [runner, sources / "simplifier.cpp", sources / "allocator.cpp"]
        compile_object(folder, "meshoptimizer_newest", parts, ["-I", str(sources)])
    build_engine(folder, vcglib)


def descriptor_report(folder: Path, vcglib: Path, mesh: Path, rounds: int) -> str:
    """What the descriptor's own benchmark prints for a mesh."""
    source = HERE / "descriptor_benchmark.cpp"
    program = folder / "descriptor_benchmark"
    includes = ["-I", str(PROJECT), "-isystem", str(vcglib), *EIGEN]
    subprocess.run(["g++", *FLAGS[:3], *OWN_FLAGS, *includes, str(source), "-o", str(program)], check=True)
    return subprocess.run(
        [str(program), str(mesh), str(rounds)], check=True, capture_output=True, text=True
    ).stdout.strip()
