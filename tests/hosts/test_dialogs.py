# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every filter, used as people do: found by its name in MeshLab's search, looked at, applied by a click.

The pictures stay in build/screenshots, for whoever wants to see the dialogs.
"""

from __future__ import annotations

import re
import subprocess
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from display import Display, ended_process, wait_for
from host_programs import PROJECT, HostProgram
from mesh_checks import EXPECTATIONS

SCREENSHOTS = PROJECT / "build" / "screenshots"
VERSIONS = ["2020.09", "2022.02", "2025.07"]
START_SECONDS = 60
ANSWER_SECONDS = 10
APPLY_SECONDS = 60


class MeshLabWindow:
    """A running MeshLab with an opened mesh."""

    def __init__(self, display: Display, version: str, log: Path) -> None:
        self._display = display
        self._log = log
        self._main = display.wait_for_window(f"^MeshLab {version}", START_SECONDS)
        wait_for(lambda: "All files opened" in self.log(), START_SECONDS, "the mesh")

    def log(self) -> str:
        """All that MeshLab has said so far."""
        return self._log.read_text(errors="replace")

    def open_dialog(self, name: str) -> str:
        """Finds the filter by Ctrl+F and returns its dialog. Asks again where the window was not listening yet."""
        for attempt in range(3):
            self._display.activate(self._main)
            self._display.keys("Escape", "ctrl+f")
            self._display.type(name)
            self._display.keys("Down", "Return")
            try:
                return self._display.wait_for_window(f"^{re.escape(name)}$", ANSWER_SECONDS)
            except TimeoutError:
                if attempt == 2:
                    raise
        raise AssertionError("unreachable")

    def apply(self, dialog: str) -> None:
        """Clicks on Apply, which is at the lower right of every dialog, and waits for the filter to end."""
        left, top, width, height = self._display.geometry(dialog)
        self._display.click(left + width * 3 // 4, top + height - 22)
        wait_for(lambda: "Applied filter" in self.log(), APPLY_SECONDS, "the end of the filter")


@contextmanager
def opened_mesh(host: HostProgram, display: Display, mesh: Path, log: Path) -> Iterator[MeshLabWindow]:
    command = host.command("meshlab", mesh)
    with (
        log.open("w") as output,
        ended_process(command, env=host.environment(display.name), stdout=output, stderr=output) as process,
    ):
        yield MeshLabWindow(display, host.version, log)
        assert process.poll() is None, "MeshLab is still running"


def colours(picture: Path, left: int, top: int, width: int, height: int) -> int:
    """How many different colours a part of the picture has; a few where nothing was drawn."""
    crop = f"{width}x{height}+{left}+{top}"
    command = ["convert", str(picture), "-crop", crop, "+repage", "-format", "%k", "info:"]
    return int(subprocess.run(command, check=True, capture_output=True, text=True, timeout=60).stdout)


@pytest.mark.parametrize("version", VERSIONS)
def test_dialog(
    version: str,
    filter_row: dict,
    display: Display,
    installed_host: Callable[[str], HostProgram],
    part: Path,
    tmp_path: Path,
) -> None:
    picture = SCREENSHOTS / f"{version}-{filter_row['id']}.png"
    with opened_mesh(installed_host(version), display, part, tmp_path / "meshlab.log") as meshlab:
        dialog = meshlab.open_dialog(filter_row["name"])
        geometry = display.geometry(dialog)
        meshlab.apply(dialog)
        display.screenshot(picture)
        assert f"{filter_row['name']} in " in meshlab.log()
        assert re.search(EXPECTATIONS[filter_row["id"]].log_of_defaults, meshlab.log()), meshlab.log()
    assert colours(picture, *geometry) > 50, "the dialog was drawn"
    assert colours(picture, 100, 200, 500, 500) > 50, "the mesh was drawn"
