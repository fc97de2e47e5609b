# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The C function on plain arrays, by ctypes: other Python threads run in the meantime, and no MeshLab is loaded.

``python/library/simplify_arrays.h`` says what the fields of the structures mean.
"""

import ctypes
from collections.abc import Callable, Mapping
from ctypes import c_char, c_char_p, c_double, c_int32, c_uint32, c_uint64, c_void_p
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

Progress = Callable[[int, str], object]
"""Called with percent and stage; False asks the run to stop."""

_DONE, _REFUSED, _NO_MEMORY = 0, 1, 2
_CANCELLED = 3
_CALLBACK = ctypes.CFUNCTYPE(c_int32, c_int32, c_char_p)


class _Mesh(ctypes.Structure):
    _fields_: ClassVar = [
        ("positions", c_void_p),
        ("faces", c_void_p),
        ("vertex_count", c_uint64),
        ("face_count", c_uint64),
        ("double_positions", c_int32),
        ("index_bytes", c_int32),
        ("fixed_vertices", c_void_p),
        ("shared_seams", c_int32),
        ("selected_faces", c_void_p),
        ("stored_quality", c_void_p),
    ]


class _Parameters(ctypes.Structure):
    _fields_: ClassVar = [
        ("target_faces", c_uint64),
        ("max_error", c_double),
        ("feature_weight", c_double),
        ("effort", c_int32),
        ("descriptor", c_int32),
        ("boundary", c_int32),
        ("preserve_topology", c_int32),
        ("avoid_self_intersections", c_int32),
        ("clean_input", c_int32),
        ("weld_distance", c_double),
        ("measure_error", c_int32),
        ("threads", c_int32),
        ("cost_limit", c_double),
        ("descriptor_scale", c_double),
        ("progress", _CALLBACK),
    ]


class _Step(ctypes.Structure):
    _fields_: ClassVar = [("cost", c_double), ("faces", c_uint64)]


class _Result(ctypes.Structure):
    _fields_: ClassVar = [
        ("vertex_count", c_uint64),
        ("face_count", c_uint64),
        ("positions", ctypes.POINTER(c_double)),
        ("faces", ctypes.POINTER(c_uint32)),
        ("vertex_origin", ctypes.POINTER(c_uint32)),
        ("face_origin", ctypes.POINTER(c_uint32)),
        ("target_reached", c_int32),
        ("stop_reason", c_int32),
        ("non_manifold_edges", c_uint64),
        ("boundary_edges", c_uint64),
        ("has_distances", c_int32),
        ("hausdorff", c_double),
        ("rms", c_double),
        ("feature_rms", c_double),
        ("folded", c_uint64),
        ("has_self_intersections", c_int32),
        ("self_intersections", c_uint64),
        ("has_self_intersections_before", c_int32),
        ("self_intersections_before", c_uint64),
        ("has_cleaning", c_int32),
        ("welded_vertices", c_uint64),
        ("dropped_faces", c_uint64),
        ("has_certificate", c_int32),
        ("certified_error", c_double),
        ("seconds", c_double),
        ("step_count", c_uint64),
        ("steps", ctypes.POINTER(_Step)),
        ("descriptor_scale", c_double),
        ("storage", c_void_p),
        ("message", c_char * 512),
    ]


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
    shared_seams: bool = False
    """Locked vertices are those of other meshes, too: no new edge joins two of them, as another mesh might make it."""


@dataclass(frozen=True, eq=False)
class Outcome:
    """What the C function made; the arrays are copies, empty after a cancelled run."""

    vertices: np.ndarray[Any, Any]
    faces: np.ndarray[Any, Any]
    vertex_origin: np.ndarray[Any, Any]
    face_origin: np.ndarray[Any, Any]
    report: dict[str, Any]
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
    result = _Result()
    caught: list[BaseException] = []
    asked_to_stop = False

    def call(percent: int, stage: bytes) -> int:
        nonlocal asked_to_stop
        try:
            asked_to_stop = progress is not None and _is_false(progress(percent, stage.decode()))
        except BaseException as error:  # it cannot cross the C++ frames
            caught.append(error)
        return not (asked_to_stop or caught)

    given = _Parameters(**parameters, progress=_CALLBACK(call))
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


def _as_given(mesh: MeshArrays) -> _Mesh:
    def place(array: np.ndarray[Any, Any] | None) -> int | None:
        return None if array is None else array.ctypes.data

    return _Mesh(
        positions=place(mesh.vertices),
        faces=place(mesh.faces),
        vertex_count=len(mesh.vertices),
        face_count=len(mesh.faces),
        double_positions=mesh.vertices.dtype == np.float64,
        index_bytes=mesh.faces.itemsize,
        fixed_vertices=place(mesh.locked),
        selected_faces=place(mesh.selected),
        stored_quality=place(mesh.quality),
        shared_seams=mesh.shared_seams,
    )


def _raise_failure(status: int, result: _Result) -> None:
    message = result.message.decode()
    if status == _REFUSED:
        raise ValueError(message)
    if status == _NO_MEMORY:
        raise MemoryError(message)
    if status != _DONE:
        raise RuntimeError(message)


def _outcome(mesh: MeshArrays, result: _Result) -> Outcome:
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
        report,
        tuple((result.steps[k].cost, result.steps[k].faces) for k in range(result.step_count)),
        result.descriptor_scale,
    )


def _copied(first: Any, shape: tuple[int, ...], dtype: Any) -> np.ndarray[Any, Any]:
    if shape[0] == 0:
        return np.empty(shape, dtype)
    return np.ctypeslib.as_array(first, shape).astype(dtype)


@cache
def _library() -> ctypes.CDLL:
    library = ctypes.CDLL(str(Path(__file__).parent / "liblaplacian_simplify.so"))
    library.laplacian_simplify_arrays.argtypes = [
        ctypes.POINTER(_Mesh),
        ctypes.POINTER(_Parameters),
        ctypes.POINTER(_Result),
    ]
    library.laplacian_simplify_arrays.restype = c_int32
    library.laplacian_simplify_release.argtypes = [ctypes.POINTER(_Result)]
    library.laplacian_simplify_release.restype = None
    return library
