# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How a filter of the plugin is run on a mesh set or a file."""

import sys
import warnings
from collections.abc import Mapping
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

from .answers import fraction_note
from .files.errors import printable
from .plugin import load
from .report import Report
from .tables import Filter, Parameter, filter_named
from .turns import forget_failures, turn

if TYPE_CHECKING:
    import pymeshlab

MeshSource: TypeAlias = "pymeshlab.MeshSet | str | PathLike[str]"
R = TypeVar("R", bound=Report)


def run(filter_name: str, report_type: type[R], mesh: MeshSource, **values: Any) -> R:
    """Runs a filter on the current mesh of a mesh set, or on a file, which is read into a new one.

    A value that is None is left to the filter's default. Everything is checked before the mesh is touched. Threads
    with mesh sets of their own may call it at the same time; they take turns.

    Raises:
        TypeError: it is neither, or a value is of a wrong type.
        ValueError: a value is outside its range; the text names the parameter, the value and the range.
        OSError: the file cannot be read.
        RuntimeError: the filter refused the mesh, which is unchanged; the text says why.
    """
    return report_type.of(*returned(filter_name, mesh, values))


def returned(
    filter_name: str, mesh: MeshSource, values: Mapping[str, Any]
) -> "tuple[dict[str, Any], pymeshlab.MeshSet]":
    """What the filter returned, and the mesh set that holds the result; the rest as run."""
    if not is_mesh_source(mesh):
        raise TypeError(f"the mesh must be a pymeshlab.MeshSet or the path of a mesh file, not {type(mesh).__name__}")
    load()
    row = filter_named(filter_name)
    numbers = checked(row, values)
    if not isinstance(mesh, str | PathLike):
        return apply(row, mesh, numbers), mesh
    from .files.reading import read_mesh

    mesh_set = read_mesh(mesh)
    try:
        return apply(row, mesh_set, numbers), mesh_set
    except RuntimeError as error:
        raise RuntimeError(f"{printable(fspath(mesh))} cannot be used: {error}") from None


def is_mesh_source(mesh: object) -> bool:
    """Whether it is a file or a mesh set; pymeshlab is not loaded to find out."""
    if isinstance(mesh, str | PathLike):
        return True
    mesh_set = getattr(sys.modules.get("pymeshlab"), "MeshSet", None)
    return mesh_set is not None and isinstance(mesh, mesh_set)


def with_one_target(filter_name: str, values: Mapping[str, Any]) -> dict[str, Any]:
    """The checked values of a decimation. Warns the caller's caller of a percentage that may be meant as a fraction.

    Raises:
        TypeError, ValueError: as checked, and where there is no target, or two.
    """
    numbers = checked(filter_named(filter_name), values)
    faces, percent = numbers.get("target_faces"), numbers.get("target_percent")
    if faces is None and percent is None and numbers.get("max_error"):
        return numbers | {"target_faces": 1}  # the bound alone ends it
    if faces is None and percent is None:
        raise ValueError(
            "there is no target: give target_faces=5000, target_percent=10 (percent of the faces) or, in percent of "
            "the bounding box's diagonal, max_error=0.1"
        )
    if faces is not None and percent is not None:
        raise ValueError(f"target_faces = {faces} and target_percent = {percent:g} are two targets: give one of them")
    if percent == 0:  # it would tell the filter to use its own target_faces
        raise ValueError("target_percent = 0 is outside (0, 100] (percent of the faces)")
    if note := fraction_note(percent or 0):
        warnings.warn(note, stacklevel=3)
    return numbers


def checked(row: Filter, values: Mapping[str, Any]) -> dict[str, Any]:
    """The values that are not None, as the host wants them: choices as numbers, the rest in its type.

    Raises:
        TypeError: the filter has no such parameter, or a value is of a wrong type.
        ValueError: a value is outside its range.
    """
    given = {name: value for name, value in values.items() if value is not None}
    return {name: _of_type(row.parameter(name), value) for name, value in given.items()}


def _of_type(parameter: Parameter, value: Any) -> Any:
    if parameter.type == "numbers":
        return parameter.numbers(value)
    types = {"boolean": bool, "integer": int, "real": float, "choice": int}
    return types[parameter.type](parameter.number(value))


def apply(row: Filter, mesh_set: "pymeshlab.MeshSet", numbers: Mapping[str, Any]) -> dict[str, Any]:
    """Runs a filter with checked values; errors as for run."""
    import pymeshlab

    if mesh_set.mesh_number() == 0:
        raise RuntimeError("the mesh set is empty")
    try:
        with turn():
            return dict(mesh_set.apply_filter(row.python_name, **numbers))
    except pymeshlab.PyMeshLabException as error:
        with turn():
            forget_failures()
        sentence = str(error).strip().splitlines()[-1].removeprefix("Details: ")
        names_parameter = row.has(sentence.split(" = ")[0])
        raise (ValueError if names_parameter else RuntimeError)(sentence) from None
