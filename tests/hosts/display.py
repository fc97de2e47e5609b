# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""An X server without a screen, and hands and eyes on it."""

from __future__ import annotations

import os
import subprocess
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TypeVar

Result = TypeVar("Result")


def wait_for(condition: Callable[[], Result], seconds: float, what: str) -> Result:
    """Asks until the condition holds and returns its value; says what did not come where time is up."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        result = condition()
        if result:
            return result
        time.sleep(0.05)
    raise TimeoutError(f"{what} did not come within {seconds:g} seconds")


@contextmanager
def ended_process(command: list[str], **options) -> Iterator[subprocess.Popen]:
    """A process that has ended when the block is left, whatever happens in it."""
    process = subprocess.Popen(command, **options)
    try:
        yield process
    finally:
        process.terminate()
        try:
            process.wait(10)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()


SCREEN = (1366, 768)
"""Width and height in pixels: the smallest screen that MeshLab is at home on."""


class Display:
    """A running X server."""

    def __init__(self, name: str) -> None:
        self.name = name
        self._environment = {**os.environ, "DISPLAY": name}

    def windows(self, title: str) -> list[str]:
        """The visible windows whose title matches the regular expression."""
        return self._tool("search", "--onlyvisible", "--name", title, check=False).split()

    def wait_for_window(self, title: str, seconds: float) -> str:
        """The first visible window whose title matches, once it is there."""
        return wait_for(lambda: self.windows(title), seconds, f"a window titled {title}")[0]

    def geometry(self, window: str) -> tuple[int, int, int, int]:
        """Left, top, width and height of the window in pixels."""
        lines = self._tool("getwindowgeometry", "--shell", window).splitlines()
        values = dict(line.split("=") for line in lines)
        return int(values["X"]), int(values["Y"]), int(values["WIDTH"]), int(values["HEIGHT"])

    def activate(self, window: str) -> None:
        """Gives the keyboard to the window."""
        self._tool("windowactivate", "--sync", window)

    def keys(self, *names: str) -> None:
        """Presses keys, one after the other."""
        self._tool("key", "--delay", "30", *names)

    def type(self, text: str) -> None:
        """Types the text."""
        self._tool("type", "--delay", "15", text)

    def click(self, x: int, y: int) -> None:
        """Presses the left button there."""
        self._tool("mousemove", str(x), str(y), "click", "1")

    def screenshot(self, file: Path, seconds: float = 10) -> None:
        """Saves what is on the screen, once nothing has moved on it from one look to the next."""
        file.parent.mkdir(parents=True, exist_ok=True)
        looks = [""]

        def settled() -> bool:
            subprocess.run(["import", "-window", "root", str(file)], env=self._environment, check=True, timeout=30)
            looks.append(_signature(file))
            return looks[-1] == looks[-2]

        wait_for(settled, seconds, "a screen at rest")

    def _tool(self, *arguments: str, check: bool = True) -> str:
        done = subprocess.run(
            ["xdotool", *arguments], env=self._environment, check=check, timeout=30, capture_output=True, text=True
        )
        return done.stdout


def _signature(picture: Path) -> str:
    """The same for pictures with the same pixels."""
    command = ["identify", "-format", "%#", str(picture)]
    return subprocess.run(command, check=True, capture_output=True, text=True, timeout=30).stdout


@contextmanager
def running_display(log: Path) -> Iterator[Display]:
    """An X server with a window manager, on a display number that the server finds free itself."""
    reading, writing = os.pipe()
    screen = f"{SCREEN[0]}x{SCREEN[1]}x24"
    server = ["Xvfb", "-displayfd", str(writing), "-screen", "0", screen, "-nolisten", "tcp", "-noreset"]
    with log.open("w") as output, ended_process(server, pass_fds=[writing], stdout=output, stderr=output):
        os.close(writing)
        with os.fdopen(reading) as answer:
            number = answer.readline().strip()
        if not number:
            raise RuntimeError(f"Xvfb did not start: {log.read_text()}")
        display = Display(f":{number}")
        environment = {**os.environ, "DISPLAY": display.name}
        with ended_process(["openbox"], env=environment, stdout=output, stderr=output):
            yield display
