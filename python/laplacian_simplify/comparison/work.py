# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command's process for a comparison does."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from time import perf_counter
from typing import Any

from ..child import Stage
from ..files.errors import MeshFileError
from ..pictures.scene import Facts, Scene
from .distances import measure
from .report import report_of
from .sources import surface_of
from .surface import Surface


def compare(stage: Stage, *, shown_source: str, a: str, b: str, samples: int, threads: int, scene: str | None) -> Any:
    """Reads two files and compares them.

    Args:
        stage: is told what is done.
        shown_source: how messages name both.
        a: the first file, - for standard input.
        b: the other one.
        samples: points a side.
        threads: 0 all.
        scene: a file to write both meshes to for drawing them, if they are to be drawn.

    Returns:
        The numbers of the report, the lines of the summary, and what is written beside a picture.
    """
    del shown_source  # for who waits
    stage("reading")
    surfaces = _read(a), _read(b)
    stage("working")
    start = perf_counter()
    found = measure(*surfaces, samples, threads)
    with _named():
        report = report_of(*surfaces, found, samples, perf_counter() - start)
    if scene:
        Scene(*surfaces).save(Path(scene))
    facts = Facts.of_comparison(report, {"samples": samples})
    return {"report": report.to_dict(), "lines": report.lines(), "facts": asdict(facts)}


def _read(path: str) -> Surface:
    with _named():
        return surface_of(path, "")


@contextmanager
def _named() -> Iterator[None]:
    """A mesh that is of no use is that of a file here."""
    try:
        yield
    except ValueError as error:
        raise MeshFileError(f"{error}; it cannot be compared") from None
