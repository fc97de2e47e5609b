# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Takes the pictures of docs/tutorials/meshlab.md in a real MeshLab, without a screen.

    scripts/python docs/make_screenshots.py

after `scripts/hosts` and `cmake --preset meshlab-2025.07 && cmake --build --preset meshlab-2025.07`.
"""

import shutil
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

TOP = Path(__file__).parents[1]
sys.path.insert(0, str(TOP / "tests" / "hosts"))

from display import Display, running_display, wait_for  # noqa: E402
from host_programs import HostProgram, built_plugin, install_host  # noqa: E402
from test_dialogs import opened_mesh  # noqa: E402

VERSION = "2025.07"
PICTURES = TOP / "docs" / "images" / "tutorial"
MESH = "flange.ply"
SIMPLIFY = "Simplification: Laplacian-Guided Quadric Edge Collapse"
DESCRIPTOR = "Laplacian Shape Descriptor"
TARGET = 2368  # faces: a tenth
WIREFRAME = (402, 62)  # the button of the toolbar that draws edges
WIDTH = 1000  # of the pictures, pixels


def main() -> None:
    PICTURES.mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory() as scratch, running_display(Path(scratch) / "display.log") as display:
        shutil.copy(TOP / "sample_meshes" / MESH, scratch)  # the log shows where it lies
        host = install_host(VERSION, Path(scratch) / "meshlab", built_plugin(f"meshlab-{VERSION}"))
        take_search(host, display, Path(scratch))
        take_descriptor(host, display, Path(scratch))
        take_simplified(host, display, Path(scratch))


def take_search(host: HostProgram, display: Display, scratch: Path) -> None:
    """The search box with what it finds."""
    with opened_mesh(host, display, scratch / MESH, scratch / "search.log"):
        display.keys("Escape", "ctrl+f")
        display.type("Laplacian")
        save(display, "search")


def take_descriptor(host: HostProgram, display: Display, scratch: Path) -> None:
    """The mesh in the colors of its descriptor."""
    with opened_mesh(host, display, scratch / MESH, scratch / "descriptor.log") as meshlab:
        dialog = meshlab.open_dialog(DESCRIPTOR)
        meshlab.apply(DESCRIPTOR)
        close(display, dialog)
        save(display, "descriptor")


def take_simplified(host: HostProgram, display: Display, scratch: Path) -> None:
    """The dialog with a target, and the edges of what remains. Tabs lead to the first field of the dialog."""
    with opened_mesh(host, display, scratch / MESH, scratch / "simplified.log") as meshlab:
        dialog = meshlab.open_dialog(SIMPLIFY)
        display.activate(dialog)
        display.keys("Tab", "Tab", "Tab", "ctrl+a")
        display.type(str(TARGET))
        save(display, "dialog")
        meshlab.apply(SIMPLIFY)
        if f"{TARGET:,} faces" not in meshlab.log():
            raise RuntimeError(f"the target did not arrive in the dialog: {meshlab.log()}")
        close(display, dialog)
        display.click(*WIREFRAME)
        save(display, "simplified")


def close(display: Display, dialog: str) -> None:
    """Clicks on Close, which is at the lower left of every dialog."""
    left, top, width, height = display.geometry(dialog)
    display.click(left + width // 4, top + height - 22)
    wait_for(lambda: dialog not in display.windows("."), 10, "the end of the dialog")


def save(display: Display, name: str) -> None:
    file = PICTURES / f"{name}.png"
    display.screenshot(file)
    subprocess.run(["convert", file, "-resize", f"{WIDTH}x", "-strip", "-colors", "64", file], check=True)


if __name__ == "__main__":
    main()
