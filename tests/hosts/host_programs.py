# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The MeshLabs of other Debian releases, started from where scripts/hosts has unpacked them.

Each runs by its release's own loader. MeshLab looks for its plugins relative to the running executable, which then
is the loader, so a prefix of symbolic links around a copy of the loader is a MeshLab installation of its own.
"""

from __future__ import annotations

import os
import shutil
from dataclasses import dataclass
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
CACHE = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "laplacian-simplify"


def built_plugin(preset: str) -> Path:
    """The plugin that the preset has built."""
    return PROJECT / "build" / preset / "plugins" / "libfilter_laplacian_simplify.so"


@dataclass(frozen=True)
class HostProgram:
    """MeshLab of one version in a prefix of its own, with one more plugin."""

    version: str
    prefix: Path
    home: Path

    @property
    def libraries(self) -> Path:
        """The folder of the release's libraries; every release has one for its architecture."""
        return next((_root(self.version) / "usr" / "lib").glob("*-linux-gnu*"))

    @property
    def test_programs(self) -> Path:
        """What is built from this folder for the version."""
        return PROJECT / "build" / f"meshlab-{self.version}" / "tests" / "hosts"

    def command(self, program: str, *arguments: str | Path) -> list[str]:
        """The command line of ``meshlab`` or ``meshlabserver``."""
        return self.command_of(self.prefix / "bin" / program, *arguments)

    def command_of(self, executable: Path, *arguments: str | Path) -> list[str]:
        """The command line that runs an executable with the release's loader and libraries."""
        folders = [self.libraries / "meshlab", self.libraries, _root(self.version) / "lib" / self.libraries.name]
        loader = [self.prefix / "bin" / "ld-meshlab.so", "--library-path", ":".join(map(str, folders))]
        return [str(part) for part in (*loader, executable, *arguments)]

    def environment(self, display: str) -> dict[str, str]:
        """A user of their own, in English, on the given display."""
        runtime = self.home / "run"
        runtime.mkdir(mode=0o700, exist_ok=True)
        return {
            "PATH": os.environ["PATH"],
            "HOME": str(self.home),
            "XDG_RUNTIME_DIR": str(runtime),
            "DISPLAY": display,
            "LC_ALL": "C.UTF-8",
            "QT_PLUGIN_PATH": f"{self.libraries / 'qt5' / 'plugins'}:{self.test_programs}",
            "LIBGL_DRIVERS_PATH": str(self.libraries / "dri"),
            "LIBGL_ALWAYS_SOFTWARE": "1",
            "QT_LOGGING_RULES": "*.debug=true;qt.*=false",
        }


def install_host(version: str, folder: Path, plugin: Path) -> HostProgram:
    """Puts MeshLab of that version, with the plugin, into an empty folder, the way its users would.

    2020.09 knows plugins of its installation only; later ones look into the user's home, too.
    """
    root = _root(version)
    host = HostProgram(version, folder / "usr", folder / "home")
    host.home.mkdir(parents=True)
    (host.prefix / "bin").mkdir(parents=True)
    shutil.copy2(root / "usr" / "bin" / "ld-meshlab.so", host.prefix / "bin")
    for program in (root / "usr" / "bin").glob("meshlab*"):
        (host.prefix / "bin" / program.name).symlink_to(program)
    (host.prefix / "share").symlink_to(root / "usr" / "share")
    installed = host.libraries / "meshlab" / "plugins"
    plugins = host.prefix / "lib" / host.libraries.name / "meshlab" / "plugins"
    plugins.mkdir(parents=True)
    for library in installed.glob("*.so"):
        (plugins / library.name).symlink_to(library)
    if version != "2020.09":
        plugins = host.home / ".local/share/VCG/MeshLab_64bit_fp/MeshLabExtraPlugins" / version
        plugins.mkdir(parents=True)
    shutil.copy2(plugin, plugins)
    return host


def _root(version: str) -> Path:
    return CACHE / "hosts" / f"meshlab-{version}" / "root"
