# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every filter, used as people do: found by its name in MeshLab's search, looked at, applied by a click.

The pictures stay in build/screenshots, for whoever wants to see the dialogs.
"""

from __future__ import annotations

import json
import re
import subprocess
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest

from display import SCREEN, Display, ended_process, wait_for
from host_programs import PROJECT, HostProgram
from mesh_checks import EXPECTATIONS

SCREENSHOTS = PROJECT / "build" / "screenshots"
VERSIONS = ["2020.09", "2022.02", "2025.07"]
START_SECONDS = 60
ANSWER_SECONDS = 10
APPLY_SECONDS = 60
LOOK_SECONDS = 0.3  # longer than the probe waits between two looks


@dataclass(frozen=True)
class Widget:
    """What a person reads or uses in a dialog, in pixels of the screen; a part of it may be cut off."""

    kind: str
    text: str
    tooltip: str
    left: int
    top: int
    width: int
    height: int
    needs_width: int
    needs_height: int
    is_cut: bool

    @property
    def middle(self) -> tuple[int, int]:
        return self.left + self.width // 2, self.top + self.height // 2

    @property
    def is_whole(self) -> bool:
        """Whether all of it is there, on the screen, and its text has the space that it needs."""
        right, bottom = self.left + self.width, self.top + self.height
        on_screen = self.left >= 0 and self.top >= 0 and right <= SCREEN[0] and bottom <= SCREEN[1]
        return on_screen and not self.is_cut and self.width >= self.needs_width and self.height >= self.needs_height


class MeshLabWindow:
    """A running MeshLab with an opened mesh."""

    def __init__(self, display: Display, version: str, log: Path, probe: Path) -> None:
        self._display = display
        self._log = log
        self._probe = probe
        self._main = display.wait_for_window(f"^MeshLab {version}", START_SECONDS)
        wait_for(lambda: "All files opened" in self.log(), START_SECONDS, "the mesh")

    def log(self) -> str:
        """All that MeshLab has said so far."""
        return self._log.read_text(errors="replace")

    def _shown(self, is_there: Callable[[dict], bool], what: str) -> dict:
        """What dialog_probe.cpp sees, once it is there and two looks saw the same."""
        looks: list[dict] = [{}]

        def settled() -> bool:
            time.sleep(LOOK_SECONDS)
            looks.append(json.loads(self._probe.read_text()) if self._probe.exists() else {})
            return looks[-1] != {} and looks[-1] == looks[-2] and is_there(looks[-1])

        wait_for(settled, ANSWER_SECONDS, what)
        return looks[-1]

    def open_search(self, words: str) -> list[str]:
        """Types into MeshLab's search and returns what it lists. Asks again where the window was not listening yet."""
        for attempt in range(3):
            self._display.activate(self._main)
            self._display.keys("Escape", "ctrl+f")
            self._display.type(words)
            try:
                return self._shown(lambda shown: any(shown["menu"]), f"what is found by {words}")["menu"]
            except TimeoutError:
                if attempt == 2:
                    raise
        raise AssertionError("unreachable")

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

    def widgets(self, name: str) -> list[Widget]:
        """Those of the open dialog of that name."""
        shown = self._shown(lambda shown: shown["title"] == name, f"the dialog {name}")
        return [
            Widget(
                row["class"],
                row["text"],
                row["tooltip"],
                row["x"],
                row["y"],
                row["width"],
                row["height"],
                row["needs_width"],
                row["needs_height"],
                row["is_cut"],
            )
            for row in shown["widgets"]
        ]

    def click(self, name: str, text: str) -> None:
        """Clicks on the button with that text in the open dialog."""
        (widget,) = [widget for widget in self.widgets(name) if widget.text == text]
        self._display.click(*widget.middle)

    def tick(self, name: str, text: str) -> None:
        """Clicks on the check box: it has the text itself, or is beside a label that has it."""
        widgets = self.widgets(name)
        (label,) = [widget for widget in widgets if widget.text == text]
        beside = [box for box in widgets if box.kind == "QCheckBox" and abs(box.middle[1] - label.middle[1]) < 5]
        (box,) = beside
        self._display.click(box.left + 8, box.middle[1])

    def apply(self, name: str) -> None:
        """Clicks on Apply and waits for the filter to end."""
        self.click(name, "Apply")
        wait_for(lambda: "Applied filter" in self.log(), APPLY_SECONDS, "the end of the filter")


@contextmanager
def opened_mesh(host: HostProgram, display: Display, mesh: Path, log: Path) -> Iterator[MeshLabWindow]:
    command = host.command("meshlab", mesh)
    probe = log.with_suffix(".json")
    environment = host.environment(display.name) | {
        "QT_QPA_GENERIC_PLUGINS": "dialog_probe",
        "DIALOG_PROBE": str(probe),
    }
    with (
        log.open("w") as output,
        ended_process(command, env=environment, stdout=output, stderr=output) as process,
    ):
        yield MeshLabWindow(display, host.version, log, probe)
        assert process.poll() is None, "MeshLab is still running"


def colours(picture: Path, left: int, top: int, width: int, height: int) -> int:
    """How many different colours a part of the picture has; a few where nothing was drawn."""
    crop = f"{width}x{height}+{left}+{top}"
    command = ["convert", str(picture), "-crop", crop, "+repage", "-format", "%k", "info:"]
    return int(subprocess.run(command, check=True, capture_output=True, text=True, timeout=60).stdout)


def saturation(picture: Path, left: int, top: int, width: int, height: int) -> float:
    """The mean of how colorful a part of the picture is, from 0, gray, to 1."""
    crop = f"{width}x{height}+{left}+{top}"
    command = ["convert", str(picture), "-crop", crop, "+repage", "-colorspace", "HSL", "-channel", "G", "-separate"]
    command += ["-format", "%[fx:mean]", "info:"]
    return float(subprocess.run(command, check=True, capture_output=True, text=True, timeout=60).stdout)


def cut_off(widgets: list[Widget]) -> list[str]:
    """The widgets that a person does not see or read as a whole."""
    return [f"{widget.kind} {widget.text}: {widget}" for widget in widgets if not widget.is_whole]


@pytest.mark.parametrize("version", VERSIONS)
def test_dialog(
    version: str,
    filter_row: dict,
    display: Display,
    installed_host: Callable[[str], HostProgram],
    part: Path,
    tmp_path: Path,
) -> None:
    """It fits on the screen, shows what it is about and what its parameters are, and does it by a click."""
    name = filter_row["name"]
    picture = SCREENSHOTS / f"{version}-{filter_row['id']}.png"
    with opened_mesh(installed_host(version), display, part, tmp_path / "meshlab.log") as meshlab:
        dialog = meshlab.open_dialog(name)
        widgets = meshlab.widgets(name)
        geometry = display.geometry(dialog)
        display.screenshot(picture)
        meshlab.apply(name)
        assert f"{name} in " in meshlab.log()
        assert re.search(EXPECTATIONS[filter_row["id"]].log_of_defaults, meshlab.log()), meshlab.log()
    assert colours(picture, *geometry) > 50, "the dialog was drawn"
    assert colours(picture, 100, 200, 300, 400) > 50, "the mesh was drawn"
    left, top, width, height = geometry
    assert left >= 0
    assert top >= 0
    assert left + width <= SCREEN[0]
    assert top + height <= SCREEN[1]
    assert cut_off(widgets) == []
    texts = [widget.text for widget in widgets]
    hidden = version != "2020.09"  # later ones have a button for what is rarely used
    for row in filter_row["parameters"]:
        assert (row["label"] in texts) == (not (hidden and row["advanced"])), row["label"]
    sliders = [row for row in filter_row["parameters"] if row["slider"] and not (hidden and row["advanced"])]
    assert [widget.kind for widget in widgets].count("QSlider") == len(sliders)
    labels = {row["label"] for row in filter_row["parameters"]}
    tooltips = {widget.tooltip for widget in widgets if widget.text in labels}
    if version == "2020.09":
        tooltips.discard("")  # of choices and sliders, which have none there
    assert tooltips
    assert all(tooltip.startswith("<span>") for tooltip in tooltips), "HTML: no other is wrapped"


@pytest.mark.parametrize("words", ["decimation", "simplif"])
@pytest.mark.parametrize("version", VERSIONS)
def test_search(
    version: str,
    words: str,
    filters: list[dict],
    display: Display,
    installed_host: Callable[[str], HostProgram],
    part: Path,
    tmp_path: Path,
) -> None:
    """The decimations are among what MeshLab lists for the words that people know them by."""
    with opened_mesh(installed_host(version), display, part, tmp_path / "meshlab.log") as meshlab:
        found = meshlab.open_search(words)
    for row in filters:
        if row["name"].startswith("Simplification: "):
            assert row["name"] in found


@pytest.mark.parametrize("version", VERSIONS)
def test_new_layer_colored_by_its_error(
    version: str,
    filters: list[dict],
    display: Display,
    installed_host: Callable[[str], HostProgram],
    part: Path,
    tmp_path: Path,
) -> None:
    """It is shown in colors, and the original, gray, is hidden."""
    name = next(row["name"] for row in filters if row["id"] == "simplify")
    picture = SCREENSHOTS / f"{version}-error-as-quality.png"
    scan = part.with_name("relief_scan.ply")  # rough everywhere
    with opened_mesh(installed_host(version), display, scan, tmp_path / "meshlab.log") as meshlab:
        meshlab.open_dialog(name)
        meshlab.tick(name, "New layer")
        meshlab.tick(name, "Error as quality")
        meshlab.apply(name)
        meshlab.click(name, "Close")
        display.screenshot(picture)
        assert "Distance of the vertices to the original, as quality: from " in meshlab.log()
    assert saturation(picture, 200, 200, 600, 400) > 0.3
