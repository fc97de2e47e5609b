# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The process for the work, as the command sees it: its progress, its answer, and its end as a sentence."""

import re
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from .child import Child, ChildCrashError
from .files.errors import MeshFileError
from .signals import signals_let_in

Progress = Callable[[int, str], None]

# pymeshlab, when it is verbose, writes what filters report as progress to standard error in this form.
_PROGRESS = re.compile(rb"LOG: \d+ (.*?)\s*\[ (\d+)% \]")


def in_a_process(
    arguments: dict[str, Any], scratch: str, function: str = "work:run", *, quiet: bool = False, drawn: str = ""
) -> dict[str, Any]:
    """Runs a function in a process of its own, with a folder for scratch files; a terminal shows progress but where it
    is to be quiet.

    Args:
        arguments: of the function; shown_source and shown_target tell how messages name its files.
        scratch: the folder.
        function: module and name.
        quiet: no progress.
        drawn: how messages name the picture that the function draws.

    Raises:
        MeshFileError: the process crashed; the sentence says over which file.
        OSError, ValueError, RuntimeError, ImportError: whatever it raised, with its text.
        KeyboardInterrupt: a signal came; the process is gone.
    """
    child = Child(function, arguments, log=True, standard_input=True, scratch=scratch)
    try:
        with _bar(quiet) as progress, signals_let_in():
            _follow(child, progress)
        answer: dict[str, Any] = child.answer()
    except ChildCrashError as crash:
        raise _crashed(crash, arguments, drawn) from None
    finally:
        child.end()
    return answer


def _follow(child: Child, progress: Progress) -> None:
    """Passes progress on until the process has closed its log."""
    assert child.log is not None
    for line in child.log:
        found = _PROGRESS.search(line)
        if found:
            progress(int(found[2]), found[1].decode(errors="replace"))


def on_a_terminal() -> bool:
    """Whether somebody may look at standard error."""
    return sys.stderr is not None and sys.stderr.isatty()


def bar_of_steps(**options: Any) -> Any:
    """A bar of tqdm, which goes at its end, without the thread that watches it."""
    from tqdm import tqdm

    class Bar(tqdm):  # type: ignore[misc]
        monitor_interval = 0

    return Bar(leave=False, **options)


@contextmanager
def _bar(quiet: bool) -> Iterator[Progress]:
    """Shows progress where standard error is a terminal."""
    if quiet or not on_a_terminal():
        yield lambda *_: None
        return
    with bar_of_steps(total=100, bar_format="{desc:<20}{bar} {n:.0f} %") as bar:

        def show(percent: int, stage: str) -> None:
            if percent < 100:  # then only the filter's name follows
                bar.set_description_str(stage, refresh=False)
            bar.update(percent - bar.n)

        yield show


def _crashed(crash: ChildCrashError, arguments: dict[str, Any], drawn: str) -> MeshFileError:
    if drawn:
        from .pictures.outputs import end_of_drawing

        return MeshFileError(f"{drawn} cannot be drawn: {end_of_drawing(crash.cause)}; nothing was written")
    name, what = {
        "reading": (arguments["shown_source"], "cannot be read: the reader"),
        "working": (arguments["shown_source"], "cannot be worked on: the filter"),
        "writing": (arguments.get("shown_target", "a level"), "cannot be written: the writer"),
    }.get(crash.stage, (arguments["shown_source"], "cannot be worked on: the process for it"))
    if crash.cause == "SIGKILL":
        return MeshFileError(f"{name} {what} was killed (SIGKILL), as happens where memory runs out")
    return MeshFileError(f"{name} {what} crashed ({crash.cause}); nothing was written; please report it with the file")
