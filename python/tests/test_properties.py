# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds for every mesh and every parameter, on meshes that are drawn at random: the same ones each time."""

from typing import Any

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import laplacian_simplify as ls

FEW = settings(derandomize=True, deadline=None, max_examples=60, suppress_health_check=list(HealthCheck))

Mesh = tuple[np.ndarray, np.ndarray]
_REFUSALS = "each has the same vertex at two corners", "leaves no face"


@st.composite
def meshes(draw: st.DrawFn) -> Mesh:
    """Faces between vertices on a lattice, so that many meet, coincide, cross or have no area; or a relief."""
    vertices = draw(st.integers(3, 40))
    seed = draw(st.integers(0, 10_000))
    chance = np.random.default_rng(seed)
    spacing = draw(st.sampled_from([1.0, 1e-9, 1e9, 0.1]))
    places = chance.integers(0, draw(st.integers(1, 6)), (vertices, 3)) * spacing
    if draw(st.booleans()):
        places = places + spacing * chance.standard_normal(places.shape)
    faces = chance.integers(0, vertices, (draw(st.integers(1, 120)), 3))
    dtype = draw(st.sampled_from([np.float32, np.float64]))
    index = draw(st.sampled_from([np.int32, np.int64, np.uint32, np.uint64]))
    return places.astype(dtype), faces.astype(index)


@st.composite
def parameters(draw: st.DrawFn) -> dict[str, Any]:
    chosen: dict[str, Any] = {
        "target_faces": draw(st.integers(1, 60)),
        "effort": draw(st.sampled_from(["fast", "balanced", "best"])),
        "boundary": draw(st.sampled_from(["free", "preserve", "lock"])),
        "preserve_topology": draw(st.booleans()),
        "avoid_self_intersections": draw(st.booleans()),
        "clean_input": draw(st.booleans()),
        "weld_distance": draw(st.sampled_from([0, 0, 1, 100])),
        "feature_weight": draw(st.sampled_from([0, 2, 50])),
        "measure_error": draw(st.sampled_from([False, False, False, True])),
    }
    if draw(st.integers(0, 3)) == 0:
        chosen["max_error"] = draw(st.sampled_from([1e-6, 0.1, 5, 100]))
    return chosen


def simplified(mesh: Mesh, chosen: dict[str, Any], **more: Any) -> Any:
    """The result; None where the mesh was refused for what it is, and then in words."""
    vertices, faces = mesh[0].copy(), mesh[1].copy()
    try:
        return ls.simplify(vertices, faces, **chosen, **more)
    except ValueError as refusal:
        if not any(words in str(refusal) for words in _REFUSALS):
            raise
        return None
    finally:
        assert np.array_equal(vertices, mesh[0])
        assert np.array_equal(faces, mesh[1])


def with_a_vertex_twice(faces: np.ndarray) -> int:
    a, b, c = faces.T
    return int(((a == b) | (b == c) | (c == a)).sum())


@given(mesh=meshes(), chosen=parameters())
@FEW
def test_result_is_a_mesh_of_what_was_there(mesh: Mesh, chosen: dict[str, Any]) -> None:
    result = simplified(mesh, chosen, threads=1)
    if result is None:
        return
    vertices, faces = result.vertices, result.faces
    assert (vertices.dtype, faces.dtype) == (mesh[0].dtype, mesh[1].dtype)
    assert len(faces) <= len(mesh[1])
    assert not len(faces) or faces.max() < len(vertices)
    assert np.isfinite(vertices).all()
    assert with_a_vertex_twice(faces) <= (with_a_vertex_twice(mesh[1]) if len(faces) == len(mesh[1]) else 0)
    for origin, of in ((result.vertex_origin, mesh[0]), (result.face_origin, mesh[1])):
        assert not len(origin) or (origin.min() >= 0 and origin.max() < len(of))
        assert (np.diff(origin.astype(np.int64)) > 0).all()


@given(mesh=meshes(), chosen=parameters())
@FEW
def test_report_is_that_of_the_result(mesh: Mesh, chosen: dict[str, Any]) -> None:
    result = simplified(mesh, chosen, threads=1)
    if result is None:
        return
    report = result.report
    assert (report.faces_before, report.faces) == (len(mesh[1]), len(result.faces))
    assert report.vertices == len(result.vertices)
    assert report.target_reached == (len(result.faces) <= chosen["target_faces"])
    assert report.stop_reason in (0, 1, 2)
    assert (report.stop_reason == 0) == report.target_reached
    if report.certified_error is not None:
        assert 0 <= report.certified_error <= chosen["max_error"]
    distances = [report.hausdorff, report.rms, report.feature_rms]
    if chosen["measure_error"]:
        assert np.isfinite(distances).all()
    else:
        assert distances == [None, None, None]


@given(mesh=meshes(), chosen=parameters())
@FEW
def test_two_threads_give_the_bytes_of_one(mesh: Mesh, chosen: dict[str, Any]) -> None:
    one, two = (simplified(mesh, chosen, threads=count) for count in (1, 2))
    if one is None:
        assert two is None
        return
    assert one.vertices.tobytes() == two.vertices.tobytes()
    assert one.faces.tobytes() == two.faces.tobytes()


@given(mesh=meshes(), chosen=parameters(), seed=st.integers(0, 1000))
@FEW
def test_locked_vertices_stay_to_the_bit(mesh: Mesh, chosen: dict[str, Any], seed: int) -> None:
    locked = np.random.default_rng(seed).random(len(mesh[0])) < 0.3
    result = simplified(mesh, chosen, threads=1, locked=locked)
    if result is None:
        return
    place = {int(origin): number for number, origin in enumerate(result.vertex_origin)}
    for vertex in np.flatnonzero(locked):
        assert result.vertices[place[int(vertex)]].tobytes() == mesh[0][vertex].tobytes()


@given(mesh=meshes(), chosen=parameters(), seed=st.integers(0, 1000))
@FEW
def test_unselected_faces_keep_their_corners(mesh: Mesh, chosen: dict[str, Any], seed: int) -> None:
    selected = np.random.default_rng(seed).random(len(mesh[1])) < 0.5
    if not selected.any():
        return
    result = simplified(mesh, chosen | {"clean_input": False, "weld_distance": 0}, threads=1, selected=selected)
    if result is None:
        return
    before = mesh[0][mesh[1].astype(np.int64)]
    after = result.vertices[result.faces.astype(np.int64)]
    kept = ~selected[result.face_origin]
    assert np.array_equal(after[kept], before[result.face_origin[kept]])
    sound = np.array([len({*face}) == 3 for face in mesh[1].tolist()])
    assert (~selected & sound).sum() <= kept.sum()
