# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command's process for the work does: it reads, filters and writes one mesh."""

from pathlib import Path
from typing import Any

from . import filters as functions
from .child import Stage
from .error_bound import in_percent
from .files.errors import MeshFileError
from .files.output_formats import output_format
from .files.reading import read
from .files.writing import keeps_polygons, save
from .plugin import load

_DECIMATIONS = ("simplify", "weighted")  # which leave hardly a polygon


def run(
    stage: Stage,
    *,
    function: str,
    source: str,
    staged: str,
    shown_source: str,
    shown_target: str,
    values: dict[str, Any],
) -> dict[str, Any]:
    """Does the work.

    Args:
        function: of this package, by its name.
        source: the file to read, - for standard input.
        staged: the file to write, with a plain name in a folder of its own.
        shown_source: how messages name the source.
        shown_target: how messages name what the staged file is for.
        values: parameters of the function.

    Returns:
        The numbers of the report, and notes on what was left out.
    """
    stage("reading")
    reading = read(source)
    mesh_set = reading.mesh_set
    load()
    stage("working")
    mesh_set.set_verbosity(True)  # then progress is written, which the command follows
    try:
        report = getattr(functions, function)(mesh_set, **in_percent(values, mesh_set))
    except RuntimeError as error:
        raise MeshFileError(f"{shown_source} cannot be used: {error}") from None
    mesh_set.set_verbosity(False)
    stage("writing")
    row = output_format(staged)
    lost = save(mesh_set, Path(staged), row, shown=shown_target, textures=reading.textures)
    if reading.has_polygons and function not in _DECIMATIONS and not keeps_polygons(row, mesh_set.current_mesh()):
        lost.append("polygons are written as triangles")
    notes = [f"{shown_source}: {note}" for note in reading.notes] + [f"{shown_target}: {note}" for note in lost]
    return {"report": report.to_dict(), "notes": notes}
