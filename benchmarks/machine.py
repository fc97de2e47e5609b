# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a benchmark ran on: processor, cores, memory, versions. Never a name or a path of the machine."""

import ctypes
import os
import platform
import re
import subprocess
from datetime import date
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

PACKAGES = ("pymeshlab", "meshlib", "vtk", "open3d", "bpy", "openmesh", "fast-simplification", "libigl", "numpy")
CGAL_VERSION_HEADER = Path("/usr/include/CGAL/version.h")


def processor() -> str:
    """The model's name."""
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def memory_gib() -> int:
    """Main memory, rounded."""
    return round(os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30)


def system() -> str:
    """The distribution's own name for itself."""
    return platform.freedesktop_os_release().get("PRETTY_NAME", platform.system())


def compiler() -> str:
    """First line of the compiler's version."""
    return subprocess.run(["g++", "--version"], capture_output=True, text=True, check=True).stdout.splitlines()[0]


def versions(peers: Path) -> dict:
    """Version of every tool that is there."""
    found = {}
    for package in PACKAGES:
        try:
            found[package] = version(package)
        except PackageNotFoundError:
            found[package] = "not installed"
    if CGAL_VERSION_HEADER.exists():
        found["CGAL"] = re.search(r"CGAL_VERSION (\S+)", CGAL_VERSION_HEADER.read_text(encoding="utf-8")).group(1)
    for name, label in (("meshoptimizer_debian", "Debian"), ("meshoptimizer_newest", "newest")):
        path = peers / f"{name}.so"
        if path.exists():
            number = ctypes.CDLL(str(path)).MeshoptimizerVersion()
            found[f"meshoptimizer ({label})"] = f"{number // 1000}.{number % 1000 // 10}"
    return found


def describe(peers: Path) -> dict:
    """Everything of the page's head."""
    return {
        "date": date.today().isoformat(),
        "processor": processor(),
        "cores": os.cpu_count(),
        "memory_gib": memory_gib(),
        "system": system(),
        "compiler": compiler(),
        "versions": versions(peers),
    }
