# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The C function on plain arrays, by ctypes: other Python threads run in the meantime, and no MeshLab is loaded."""

import ctypes
from collections.abc import Callable, Mapping
from ctypes import c_int32
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from .library_structures import CALLBACK, MeshStructure, ParametersStructure, ResultStructure

Progress = Callable[[int, str], object]
"""Called with percent and stage; False asks the run to stop."""

_DONE, _REFUSED, _NO_MEMORY = 0, 1, 2
_CANCELLED = 3


@dataclass(frozen=True, eq=False)
class MeshArrays:
    """A mesh as the C function takes it: arrays that are contiguous, in the machine's byte order, and only read."""

    vertices: np.ndarray[Any, Any]
    """float32 or float64, (n, 3)."""
    faces: np.ndarray[Any, Any]
    """Integers of 4 or 8 bytes, (m, 3)."""
    locked: np.ndarray[Any, Any] | None = None
    """bool, (n,): vertices that stay."""
    selected: np.ndarray[Any, Any] | None = None
    """bool, (m,): the faces that are simplified."""
    quality: np.ndarray[Any, Any] | None = None
    """float64, (n,)."""
    corner_values: np.ndarray[Any, Any] | None = None
    """float32, (m, 3, k)."""
    channel_kinds: np.ndarray[Any, Any] | None = None
    """int32, (k,)."""
    labels: np.ndarray[Any, Any] | None = None
    """int32, (m,)."""
    vertex_normals: np.ndarray[Any, Any] | None = None
    """float32, (n, 3)."""
    corner_normals: np.ndarray[Any, Any] | None = None
    """float32, (m, 3, 3)."""
    shared_seams: bool = False
    """Locked vertices are those of other meshes, too: no new edge joins two of them, as another mesh might make it."""


@dataclass(frozen=True)
class AttributeNumbers:
    """What the C function says of the attributes."""

    rms: list[float]
    """Of every channel; empty where it was not measured, as the next."""
    textures: list[tuple[float, float]]
    """The texture deviation of every pair of texture coordinates, rms and largest, in percent of the diagonal."""
    charts: int
    turned_faces: int
    held_faces: int


@dataclass(frozen=True, eq=False)
class Outcome:
    """What the C function made; the arrays are copies, empty after a cancelled run."""

    vertices: np.ndarray[Any, Any]
    faces: np.ndarray[Any, Any]
    vertex_origin: np.ndarray[Any, Any]
    face_origin: np.ndarray[Any, Any]
    corner_values: np.ndarray[Any, Any] | None
    """float32, (m, 3, k); None where there were none, and where nothing was done."""
    corner_sides: np.ndarray[Any, Any] | None
    """uint32, (m, 3): those of a vertex differ where it is on a hard edge; None where there is no hard edge."""
    report: dict[str, Any]
    attributes: AttributeNumbers | None
    """None where there were none, and where nothing was done."""
    steps: tuple[tuple[float, int], ...]
    """After every sweep what a collapse cost at most, in length to the fourth power, and how many faces were left."""
    descriptor_scale: float
    """1 / the descriptor that counted as 1."""


def run(mesh: MeshArrays, parameters: Mapping[str, float], progress: Progress | None) -> Outcome:
    """Runs the C function.

    Args:
        mesh: it stays as it is.
        parameters: numbers for the fields of the structure, target_faces of the whole mesh; others are 0. For a mesh
            that is a part of one, cost_limit and descriptor_scale, in the units of Outcome.
        progress: called in this thread; what it raises ends the run and is raised here.

    Raises:
        ValueError: mesh or parameters cannot be used; the text says why.
        MemoryError: there is not enough memory.
    """
    result = ResultStructure()
    caught: list[BaseException] = []
    asked_to_stop = False

    def call(percent: int, stage: bytes) -> int:
        nonlocal asked_to_stop
        try:
            asked_to_stop = progress is not None and _is_false(progress(percent, stage.decode()))
        except BaseException as error:  # it cannot cross the C++ frames
            caught.append(error)
        return not (asked_to_stop or caught)

    given = ParametersStructure(**parameters, progress=CALLBACK(call))
    library = _library()
    try:
        status = library.laplacian_simplify_arrays(
            ctypes.byref(_as_given(mesh)), ctypes.byref(given), ctypes.byref(result)
        )
        if caught:
            raise caught[0]
        _raise_failure(status, result)
        if result.stop_reason == _CANCELLED and not asked_to_stop:
            raise KeyboardInterrupt  # Ctrl+C came before the first line of the callback
        return _outcome(mesh, result)
    finally:
        library.laplacian_simplify_release(ctypes.byref(result))


def _is_false(answer: object) -> bool:
    return answer is False or (isinstance(answer, np.bool_) and not answer)


def _as_given(mesh: MeshArrays) -> MeshStructure:
    def place(array: np.ndarray[Any, Any] | None) -> int | None:
        return None if array is None else array.ctypes.data

    return MeshStructure(
        positions=place(mesh.vertices),
        faces=place(mesh.faces),
        vertex_count=len(mesh.vertices),
        face_count=len(mesh.faces),
        double_positions=mesh.vertices.dtype == np.float64,
        index_bytes=mesh.faces.itemsize,
        fixed_vertices=place(mesh.locked),
        selected_faces=place(mesh.selected),
        stored_quality=place(mesh.quality),
        corner_values=place(mesh.corner_values),
        channel_kinds=place(mesh.channel_kinds),
        channel_count=0 if mesh.channel_kinds is None else len(mesh.channel_kinds),
        face_labels=place(mesh.labels),
        vertex_normals=place(mesh.vertex_normals),
        corner_normals=place(mesh.corner_normals),
        shared_seams=mesh.shared_seams,
    )


def _raise_failure(status: int, result: ResultStructure) -> None:
    message = result.message.decode()
    if status == _REFUSED:
        raise ValueError(message)
    if status == _NO_MEMORY:
        raise MemoryError(message)
    if status != _DONE:
        raise RuntimeError(message)


def _outcome(mesh: MeshArrays, result: ResultStructure) -> Outcome:
    cancelled = result.stop_reason == _CANCELLED
    report: dict[str, Any] = {
        "faces_before": len(mesh.faces),
        "faces": len(mesh.faces) if cancelled else result.face_count,
        "vertices": len(mesh.vertices) if cancelled else result.vertex_count,
        "target_reached": bool(result.target_reached),
        "stop_reason": result.stop_reason,
        "seconds": result.seconds,
    }
    names = [] if cancelled else ["non_manifold_edges", "boundary_edges"]
    names += ["hausdorff", "rms", "feature_rms", "folded"] if result.has_distances else []
    names += ["self_intersections"] if result.has_self_intersections else []
    names += ["self_intersections_before"] if result.has_self_intersections_before else []
    names += ["welded_vertices", "dropped_faces"] if result.has_cleaning else []
    names += ["certified_error"] if result.has_certificate else []
    report |= {name: getattr(result, name) for name in names}
    return Outcome(
        _copied(result.positions, (result.vertex_count, 3), mesh.vertices.dtype),
        _copied(result.faces, (result.face_count, 3), mesh.faces.dtype),
        _copied(result.vertex_origin, (result.vertex_count,), np.intp),
        _copied(result.face_origin, (result.face_count,), np.intp),
        _corner_values(mesh, result),
        _copied(result.corner_sides, (result.face_count, 3), np.uint32) if result.corner_sides else None,
        report,
        _attribute_numbers(result),
        tuple((result.steps[k].cost, result.steps[k].faces) for k in range(result.step_count)),
        result.descriptor_scale,
    )


def _corner_values(mesh: MeshArrays, result: ResultStructure) -> np.ndarray[Any, Any] | None:
    if mesh.channel_kinds is None or not result.corner_values:
        return None
    return _copied(result.corner_values, (result.face_count, 3, len(mesh.channel_kinds)), np.float32)


def _attribute_numbers(result: ResultStructure) -> AttributeNumbers | None:
    if not result.has_attributes:
        return None
    return AttributeNumbers(
        [result.attribute_rms[k] for k in range(result.rms_count)],
        [(result.textures[k].rms, result.textures[k].largest) for k in range(result.texture_count)],
        result.charts,
        result.turned_faces,
        result.held_faces,
    )


def _copied(first: Any, shape: tuple[int, ...], dtype: Any) -> np.ndarray[Any, Any]:
    if shape[0] == 0:
        return np.empty(shape, dtype)
    return np.ctypeslib.as_array(first, shape).astype(dtype)


@cache
def _library() -> ctypes.CDLL:
    library = ctypes.CDLL(str(Path(__file__).parent / "liblaplacian_simplify.so"))
    library.laplacian_simplify_arrays.argtypes = [
        ctypes.POINTER(MeshStructure),
        ctypes.POINTER(ParametersStructure),
        ctypes.POINTER(ResultStructure),
    ]
    library.laplacian_simplify_arrays.restype = c_int32
    library.laplacian_simplify_release.argtypes = [ctypes.POINTER(ResultStructure)]
    library.laplacian_simplify_release.restype = None
    return library
