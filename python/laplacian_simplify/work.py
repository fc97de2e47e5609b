# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command's process for the work does: it reads, filters and writes one mesh."""

import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import filters as functions
from .child import Stage
from .error_bound import in_percent
from .files.errors import MeshFileError
from .files.output_formats import output_format
from .files.reading import read
from .files.writing import keeps_polygons, save
from .plugin import load

if TYPE_CHECKING:
    import pymeshlab

    from .comparison.surface import Surface
    from .files.reading import Reading

_DECIMATIONS = ("simplify", "weighted", "levels_of_detail")  # which leave hardly a polygon


def run(
    stage: Stage,
    *,
    function: str,
    source: str,
    staged: str,
    shown_source: str,
    shown_target: str,
    values: dict[str, Any],
    scene: str | None = None,
) -> dict[str, Any]:
    """Does the work.

    Args:
        function: of this package, by its name.
        source: the file to read, - for standard input.
        staged: the file to write, with a plain name in a folder of its own.
        shown_source: how messages name the source.
        shown_target: how messages name what the staged file is for.
        values: parameters of the function.
        scene: a file to write both meshes to for drawing them, if they are to be drawn.

    Returns:
        The numbers of the report, notes on what was left out, and the names of the textures.
    """
    mesh_set, reading = _read(stage, source)
    before = _surface(mesh_set, shown_source) if scene else None
    report = _work(stage, function, mesh_set, values, shown_source)
    stage("writing")
    if before and scene:
        from .pictures.scene import Scene  # only here, for it takes its time

        Scene(before, _surface(mesh_set, shown_target)).save(Path(scene))
    notes = _write(mesh_set, reading, function, staged, shown_target)
    return {
        "report": report.to_dict(),
        "notes": [f"{shown_source}: {note}" for note in reading.notes] + notes,
        "textures": [texture.name for texture in reading.textures],
    }


def run_levels(
    stage: Stage,
    *,
    function: str,
    source: str,
    staged: list[str],
    shown_source: str,
    shown_targets: list[str],
    values: dict[str, Any],
) -> dict[str, Any]:
    """The same with a file, and a report, for every level.

    Args:
        function, source, shown_source, values: as for run.
        staged: a file for every level.
        shown_targets: how messages name what each staged file is for.
    """
    mesh_set, reading = _read(stage, source)
    reports = _work(stage, function, mesh_set, values, shown_source)
    stage("writing")
    notes = [f"{shown_source}: {note}" for note in reading.notes]
    for report, path, shown in zip(reports, staged, shown_targets, strict=True):
        mesh_set.set_current_mesh(report.mesh_id)
        notes += _write(mesh_set, reading, function, path, shown)
    return {"report": [report.to_dict() for report in reports], "notes": notes}


def _read(stage: Stage, source: str) -> "tuple[pymeshlab.MeshSet, Reading]":
    stage("reading")
    reading = read(source)
    load()
    return reading.mesh_set, reading


def _work(stage: Stage, function: str, mesh_set: "pymeshlab.MeshSet", values: dict[str, Any], shown_source: str) -> Any:
    stage("working")
    mesh_set.set_verbosity(True)  # then progress is written, which the command follows
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # the command has said it, and "error" would make it one
            report = getattr(functions, function)(mesh_set, **in_percent(values, mesh_set))
    except RuntimeError as error:
        raise MeshFileError(f"{shown_source} cannot be used: {error}") from None
    mesh_set.set_verbosity(False)
    return report


def _surface(mesh_set: "pymeshlab.MeshSet", shown: str) -> "Surface":
    from .comparison.surface import checked_surface

    mesh = mesh_set.current_mesh()
    try:
        return checked_surface(shown, mesh.vertex_matrix(), mesh.face_matrix())
    except ValueError as error:
        raise MeshFileError(f"{error}; it cannot be drawn") from None


def _write(
    mesh_set: "pymeshlab.MeshSet", reading: "Reading", function: str, staged: str, shown_target: str
) -> list[str]:
    row = output_format(staged)
    lost = save(mesh_set, Path(staged), row, shown=shown_target, textures=reading.textures)
    if reading.has_polygons and function not in _DECIMATIONS and not keeps_polygons(row, mesh_set.current_mesh()):
        lost.append("polygons are written as triangles")
    return [f"{shown_target}: {note}" for note in lost]
