# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The hosts that run a script of filters without anybody looking on."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from host_programs import HostProgram, built_plugin

SECONDS = 120
"""Longer than any run of a sample mesh takes on a busy machine."""


@dataclass(frozen=True)
class ScriptRun:
    """How a run ended and what it printed. Not every host's status tells of a failure."""

    status: int
    output: str


ScriptHost = Callable[[Path, Path, Path], ScriptRun]
"""Runs a script on a mesh file and writes the result to another."""


def meshlabserver(host: HostProgram, display: str) -> ScriptHost:
    """The command that comes with 2020.09; later ones have none. It needs a display with OpenGL."""

    def run(script: Path, mesh: Path, output: Path) -> ScriptRun:
        command = host.command("meshlabserver", "-i", mesh, "-o", output, "-m", "vq", "vc", "wt", "-s", script)
        return _run(command, env=host.environment(display))

    return run


def script_runner(host: HostProgram, display: str, *options: str, plugin_folder: Path | None = None) -> ScriptHost:
    """Our own small program on the libraries of a version whose only program is the graphical one.

    The plugin is the one that was built, or that of the folder.
    """
    runner = host.test_programs / "script_runner"

    def run(script: Path, mesh: Path, output: Path) -> ScriptRun:
        plugins = [host.prefix / "lib" / host.libraries.name / "meshlab" / "plugins"]
        plugins.append(plugin_folder or built_plugin(f"meshlab-{host.version}").parent)
        command = host.command_of(runner, *options, mesh, script, output, *plugins)
        return _run(command, env=host.environment(display) | {"QT_QPA_PLATFORM": "offscreen"})

    return run


def pymeshlab(script: Path, mesh: Path, output: Path) -> ScriptRun:
    """pymeshlab in a process of its own, with the plugin as it was built."""
    program = (
        "import sys, pymeshlab\n"
        "plugin, mesh, script, output = sys.argv[1:]\n"
        "pymeshlab.load_plugin(plugin)\n"
        "meshes = pymeshlab.MeshSet(verbose=True)\n"
        "meshes.load_new_mesh(mesh)\n"
        "meshes.load_filter_script(script)\n"
        "meshes.apply_filter_script()\n"
        "meshes.save_current_mesh(output)\n"
    )
    plugin = built_plugin("pymeshlab-2025.7")
    return _run([sys.executable, "-c", program, *map(str, (plugin, mesh, script, output))])


def _run(command: list[str], env: dict[str, str] | None = None) -> ScriptRun:
    done = subprocess.run(
        command, env=env, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", timeout=SECONDS
    )
    return ScriptRun(done.returncode, done.stdout)
