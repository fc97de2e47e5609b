# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The guided decimation of NumPy arrays: what is asked for and what comes back, checked. No MeshLab is loaded."""

import math
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import Any, Literal, TypeAlias

import numpy as np

from .attributes import Attributes, Channels
from .library import MeshArrays, Outcome, Progress, run
from .report import DecimationReport, StopReason
from .small import Small
from .tables import Filter

Array: TypeAlias = np.ndarray[Any, Any]

# The engine's limits, as in vcg_ext/core/collapse/load.h; here they are checked before anything is copied.
_MOST_VERTICES, _MOST_FACES = 2**30 - 1, 2**29 - 1

# Parameters of the filter that have no meaning for arrays, or values that need VCG: what helps then.
_MESH_SETS_ONLY: dict[str, tuple[int, ...]] = {
    "order": (1,),
    "descriptor": (2, 3),
    "new_layer": (1,),
    "lock_selected_vertices": (1,),
    "error_as_quality": (1,),
}
_STORED_QUALITY = "vertex_quality"


@dataclass(frozen=True, eq=False)
class Simplified:
    """A simplified mesh of arrays. It unpacks as the two that it was made from: ``vertices, faces = ...``."""

    vertices: Array = field(repr=False)
    """(n, 3), of the type that the input's have."""
    faces: Array = field(repr=False)
    """(m, 3), of the type that the input's have."""
    report: DecimationReport
    vertex_origin: Array = field(repr=False)
    """The input vertex that each vertex was, ascending; most of them have moved. Vertices that are split along a seam
    have the same."""
    face_origin: Array = field(repr=False)
    """The input face that each face was, ascending; most of them have other corners now."""
    vertex_attributes: dict[str, Array] = field(repr=False, default_factory=dict)
    """What the arrays at vertices have become, under their names and of their types, (n,) or (n, k)."""
    corner_attributes: dict[str, Array] = field(repr=False, default_factory=dict)
    """What the arrays at corners have become, (m, 3) or (m, 3, k)."""
    face_labels: Array | None = field(repr=False, default=None)
    """(m,), of the type that the input's have."""

    def __iter__(self) -> Iterator[Array]:
        return iter((self.vertices, self.faces))


@dataclass(frozen=True, eq=False)
class ArrayOptions:
    """What only arrays and meshes of other libraries can be given: a mesh set has all of this itself."""

    selected: Any = None
    locked: Any = None
    quality: Any = None
    progress: Any = None
    attributes: Attributes = field(default_factory=Attributes)


def simplify_arrays(
    row: Filter, vertices: Any, faces: Any, numbers: Mapping[str, float], options: ArrayOptions
) -> Simplified:
    """Simplifies a mesh of arrays, which stay as they are.

    Args:
        row: the filter, for the defaults of what is not among the numbers.
        vertices: (n, 3), float32 or float64.
        faces: (m, 3), integers.
        numbers: checked values of the filter's parameters.
        options: the rest.

    Raises:
        TypeError: something is of another type.
        ValueError: something has another shape, or cannot be used; the text names it.
    """
    values: dict[str, Any] = {
        parameter.id: numbers.get(parameter.id, parameter.default) for parameter in row.parameters
    }
    _refuse_what_needs_mesh_sets(row, values)
    mesh = _checked_mesh(vertices, faces, options)
    channels = _channels(mesh, options.attributes, bool(values["keep_attributes"]))
    mesh, target = _target(mesh, numbers)
    if needs_quality(row, numbers) != (mesh.quality is not None):
        raise ValueError(f"descriptor = {_STORED_QUALITY} and the array quality are given together or not at all")
    passed = (
        "max_error",
        "feature_weight",
        "effort",
        "descriptor",
        "boundary",
        "attribute_weight",
        "seams",
        "preserve_topology",
        "avoid_self_intersections",
        "clean_input",
        "weld_distance",
        "measure_error",
        "threads",
    )
    parameters = {name: values[name] or 0 for name in passed}
    if channels.are_there and values["keep_attributes"]:
        mesh = _with_attributes(mesh, channels)
    with _progress(options.progress) as progress:
        outcome = run(mesh, {**parameters, "target_faces": target}, progress)
    return _simplified(vertices, faces, outcome, channels)


def _refuse_what_needs_mesh_sets(row: Filter, values: Mapping[str, Any]) -> None:
    for name, refused in _MESH_SETS_ONLY.items():
        if values[name] in refused:
            options = row.parameter(name).options
            shown = options[int(values[name])].id if options else str(bool(values[name]))
            raise ValueError(f"{name} = {shown} is for a pymeshlab.MeshSet or a file, not for arrays and other meshes")


def needs_quality(row: Filter, numbers: Mapping[str, float]) -> bool:
    """Whether the vertex quality is what guides."""
    options = row.parameter("descriptor").options
    return options[int(numbers.get("descriptor", 0))].id == _STORED_QUALITY


def _checked_mesh(vertices: Any, faces: Any, options: ArrayOptions) -> MeshArrays:
    _require_array(
        "vertices", vertices, "of float32 or float64", lambda dtype: dtype.kind + str(dtype.itemsize) in ("f4", "f8")
    )
    _require_array("faces", faces, "of integers", lambda dtype: dtype.kind in "iu")
    _require_shape("vertices", vertices, "(n, 3)", vertices.ndim == 2 and vertices.shape[1] == 3)
    _require_shape("faces", faces, "(m, 3)", faces.ndim == 2 and faces.shape[1] == 3)
    if len(vertices) > _MOST_VERTICES or len(faces) > _MOST_FACES:
        raise ValueError(
            f"{len(faces):,} faces and {len(vertices):,} vertices are too many: "
            f"at most {_MOST_FACES:,} faces (2^29 - 1) and {_MOST_VERTICES:,} vertices (2^30 - 1)"
        )
    integer = faces.dtype if faces.itemsize in (4, 8) else np.dtype(np.int64)
    return MeshArrays(
        _contiguous(vertices, vertices.dtype),
        _contiguous(faces, integer),
        _flags("locked", options.locked, len(vertices)),
        _flags("selected", options.selected, len(faces)),
        _quality(options.quality, len(vertices)),
    )


def _channels(mesh: MeshArrays, attributes: Attributes, keep: bool) -> Channels:
    """The checked attributes; those of what remains where they are not to be kept."""
    channels = Channels(attributes, len(mesh.vertices), len(mesh.faces))
    return channels if keep else channels.unused()


def _with_attributes(mesh: MeshArrays, channels: Channels) -> MeshArrays:
    """The mesh with what guides the collapse."""
    indices = mesh.faces if mesh.faces.dtype.kind == "i" else mesh.faces.astype(np.int64)
    if len(indices) and not (indices.min() >= 0 and indices.max() < len(mesh.vertices)):
        return mesh  # which the run refuses
    values = channels.at_corners(indices)
    kinds = None if values is None else np.array(channels.kinds, np.int32)
    of_vertices, of_corners = channels.normals()
    return replace(
        mesh,
        corner_values=values,
        channel_kinds=kinds,
        labels=channels.labels,
        vertex_normals=of_vertices,
        corner_normals=of_corners,
    )


def _require_array(name: str, value: Any, kind: str, fits: Callable[[np.dtype[Any]], bool]) -> None:
    if isinstance(value, np.ma.MaskedArray) or not isinstance(value, np.ndarray):
        raise TypeError(f"{name} must be a NumPy array {kind}, not {type(value).__name__}")
    if not fits(value.dtype):
        raise TypeError(f"{name} must be an array {kind}, not of {value.dtype}")


def _require_shape(name: str, value: Array, expected: str, fits: bool) -> None:
    if not fits:
        raise ValueError(f"{name} has the shape {value.shape}, not {expected}")


def _contiguous(array: Array, dtype: np.dtype[Any]) -> Array:
    """The array itself where it lies in memory as the C function reads it."""
    return np.require(np.asarray(array), dtype.newbyteorder("="), ["C_CONTIGUOUS", "ALIGNED"])


def _flags(name: str, value: Any, count: int) -> Array | None:
    if value is None:
        return None
    _require_array(name, value, "of bool", lambda dtype: dtype.kind == "b")
    _require_shape(name, value, f"({count},)", value.shape == (count,))
    return _contiguous(value, value.dtype)


def _quality(value: Any, count: int) -> Array | None:
    if value is None:
        return None
    _require_array("quality", value, "of numbers", lambda dtype: dtype.kind in "fiu")
    _require_shape("quality", value, f"({count},)", value.shape == (count,))
    quality = _contiguous(value, np.dtype(np.float64))
    if bad := int(np.count_nonzero(~np.isfinite(quality))):
        raise ValueError(f"the quality is not finite at {bad:,} of {count:,} vertices")
    return quality


def _target(mesh: MeshArrays, numbers: Mapping[str, float]) -> tuple[MeshArrays, int]:
    """The mesh without a selection that is not meant, and the faces to keep of all. Percent are of the selection."""
    selected_only = numbers.get("selected_only", mesh.selected is not None)
    selected = 0 if mesh.selected is None else int(np.count_nonzero(mesh.selected))
    if selected_only and selected == 0:
        raise ValueError("selected_only = true, but no face is selected")
    if not selected_only:
        mesh = replace(mesh, selected=None)
    among = selected if selected_only else len(mesh.faces)
    target = numbers.get("target_faces", 0) or rounded(numbers["target_percent"] / 100 * among)
    return mesh, len(mesh.faces) - among + max(int(target), 1)


def rounded(value: float) -> int:
    """Halves go up, as in the filter."""
    return math.floor(value) + (value - math.floor(value) >= 0.5)


def _simplified(vertices: Array, faces: Array, outcome: Outcome, channels: Channels) -> Simplified:
    report = DecimationReport.of({**outcome.report, **_attribute_report(outcome, channels)})
    if report.stop_reason is StopReason.CANCELLED:
        origins = np.arange(len(vertices)), np.arange(len(faces))
        return Simplified(np.array(vertices), np.array(faces), report, *origins, **channels.results(None, *origins))
    values, small, origin = outcome.corner_values, outcome.faces, outcome.vertex_origin
    positions = outcome.vertices
    if values is not None or outcome.corner_sides is not None:
        old, small = channels.split(small, values, len(positions), outcome.corner_sides)
        positions, origin = positions[old], origin[old]
        report = replace(report, vertices=len(positions))
    unchanged = not outcome.steps and len(small) == len(faces)
    made = None if unchanged else Small(positions, small, outcome.corner_sides)
    return Simplified(
        positions.astype(vertices.dtype, copy=False),
        small.astype(faces.dtype, copy=False),
        report,
        origin,
        outcome.face_origin,
        **channels.results(values, origin, outcome.face_origin, made),
    )


def _attribute_report(outcome: Outcome, channels: Channels) -> dict[str, Any]:
    """The numbers of the report on attributes."""
    found = outcome.attributes
    if found is None:
        return {}
    numbers: dict[str, Any] = {"faces_held_by_seams": found.held_faces}
    if found.rms:
        numbers["attribute_rms"] = channels.rms(found.rms)
    if channels.has_texture:
        numbers["turned_texture_faces"] = found.turned_faces
    if found.textures:
        numbers["texture_deviation"] = max(rms for rms, _ in found.textures)
        numbers["largest_texture_deviation"] = max(largest for _, largest in found.textures)
    return numbers


@contextmanager
def _progress(given: Progress | Literal[True] | None) -> Iterator[Progress | None]:
    """What is called with progress: what was given, or a bar for True."""
    if given is not True:
        if given is not None and not callable(given):
            raise TypeError(f"progress must be a callable or True, not {type(given).__name__}")
        yield given
        return
    from tqdm.auto import tqdm

    with tqdm(total=100, bar_format="{desc:<20}{bar} {n:.0f} %") as bar:

        def show(percent: int, stage: str) -> None:
            bar.set_description_str(stage, refresh=False)
            bar.update(percent - bar.n)

        yield show
        bar.update(100 - bar.n)
