# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture and the page as outputs: what is checked before all work, and how they come to be."""

import ctypes
import os
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import asdict, dataclass
from importlib.util import find_spec
from os import PathLike
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

from ..child import Child, ChildCrashError
from ..comparison.arguments import SAMPLES
from ..file_arguments import check_apart
from ..files.errors import printable
from ..files.staging import check_target, staged_output

if TYPE_CHECKING:
    from .scene import Facts, Scene

VTK_WINDOW = "VTK_DEFAULT_OPENGL_WINDOW"
"""The variable with VTK's name of a window, of somebody who knows better."""
_NEEDED = ("matplotlib", "pyvista")
# What VTK draws with where there is no display, the first that is there: a library, and VTK's name for its window.
_OFF_SCREEN = (("libEGL.so.1", "vtkEGLRenderWindow"), ("libOSMesa.so.8", "vtkOSOpenGLRenderWindow"))


@dataclass(frozen=True)
class Outputs:
    """Which of the two are asked for; false where neither is."""

    picture: str | PathLike[str] | None = None
    page: str | PathLike[str] | None = None
    names: tuple[str, str] = ("--picture", "--report")
    """How messages name the two arguments."""

    def __bool__(self) -> bool:
        return self.picture is not None or self.page is not None

    def check(self, others: Mapping[str, str] | None = None) -> None:
        """Refuses what cannot be written.

        Args:
            others: files of the run that neither may replace, with the names of their arguments.

        Raises:
            ValueError: a name is of another format, or is that of another file of the run.
            OSError: no file can be written there.
            ImportError: what draws is not installed.
        """
        if not self:
            return
        _check_name(self.names[0], self.picture, (".png",), "a picture is PNG")
        _check_name(self.names[1], self.page, (".html", ".htm"), "the page is HTML")
        self.check_apart(others or {})
        require_pictures()
        for path in (self.picture, self.page):
            if path is not None:
                check_target(path)

    def check_apart(self, others: Mapping[str, str]) -> None:
        """
        Raises:
            ValueError: one of the two would replace one of these files, which are named as messages name them.
        """
        for name, path in zip(self.names, (self.picture, self.page), strict=True):
            if path is not None:
                check_apart(name, os.fspath(path), others)

    @contextmanager
    def staged(self) -> Iterator[dict[str, str | None]]:
        """Where both are written before they appear, as arguments for drawing.

        Raises:
            OSError: nothing can be written there.
        """
        with ExitStack() as stack:
            paths = {
                name: None if path is None else str(stack.enter_context(staged_output(path)))
                for name, path in (("picture", self.picture), ("page", self.page))
            }
            yield paths

    def write(self, scene: "Scene", facts: "Facts", samples: int, threads: int) -> None:
        """Measures at so many points a side and draws, in a process of its own; a file appears whole or not at all.

        Raises:
            OSError: a file cannot be written.
            RuntimeError: drawing failed.
        """
        with self.staged() as staged, TemporaryDirectory(prefix="laplacian-simplify-") as scratch:
            path = Path(scratch) / "scene.npz"
            scene.save(path)
            child = Child(DRAW, drawing(path, facts, staged, samples, threads), scratch=scratch)
            try:
                child.answer()
            except ChildCrashError as crash:
                raise RuntimeError(f"{self.shown} cannot be drawn: {end_of_drawing(crash.cause)}") from None
            finally:
                child.end()

    @property
    def shown(self) -> str:
        """How messages name them."""
        return " and ".join(printable(os.fspath(path)) for path in (self.picture, self.page) if path is not None)


DRAW = "pictures.work:draw"
"""The function that draws, for a process of its own."""


def drawing(
    scene: Path, facts: "Facts", staged: dict[str, str | None], samples: int = SAMPLES, threads: int = 0
) -> dict[str, Any]:
    """Its arguments."""
    return {"scene": str(scene), "facts": asdict(facts), **staged, "samples": samples, "threads": threads}


def end_of_drawing(cause: str) -> str:
    """What became of the process that draws, which ended without an answer."""
    if cause == "SIGKILL":
        return "the process that draws was killed (SIGKILL), as happens where memory runs out"
    return f"the process that draws ended ({cause})"


def require_pictures() -> None:
    """Refuses to go on where what draws is not installed.

    Raises:
        ImportError: it says how to get it.
    """
    for name in _NEEDED:
        if find_spec(name) is None:
            raise ImportError(
                f"a picture or a report needs {name}, which is not installed: "
                "python -m pip install 'laplacian-simplify[pictures]'",
                name=name,
            )
    if VTK_WINDOW not in os.environ:
        off_screen_window()


def off_screen_window() -> str:
    """VTK's name for the window to draw in, which nobody sees.

    Raises:
        ImportError: there is no library for one.
    """
    for library, window in _OFF_SCREEN:
        with suppress(OSError):
            ctypes.CDLL(library)
            return window
    raise ImportError(
        "a picture or a report needs the library libEGL, to draw without a display, which is not installed: "
        "apt-get install libegl1 (Fedora: dnf install mesa-libEGL)"
    )


def _check_name(option: str, path: str | PathLike[str] | None, suffixes: tuple[str, ...], what: str) -> None:
    if path is not None and not os.fspath(path).lower().endswith(suffixes):
        raise ValueError(f"{option} {printable(os.fspath(path))}: {what}, so its name has to end with {suffixes[0]}")
