# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""simplify(vertices, faces): the filter's bytes without MeshLab."""

import resource
from pathlib import Path

import numpy as np
import pytest
from array_meshes import mesh_set_of, sample_arrays, wave
from conftest import SAMPLE_NAMES, positions_and_faces

import laplacian_simplify as ls


def assert_same_as_filter(result: ls.Simplified, mesh_set, report: ls.DecimationReport) -> None:
    vertices, faces = positions_and_faces(mesh_set)
    assert result.vertices.tobytes() == vertices.tobytes()
    assert np.array_equal(result.faces, faces)
    numbers = [{**r.to_dict(), "seconds": 0} for r in (result.report, report)]
    assert numbers[0] == numbers[1]


@pytest.mark.parametrize("effort", ["fast", "balanced"])
@pytest.mark.parametrize("sample", SAMPLE_NAMES)
def test_the_bytes_of_the_filter(sample: str, effort: str) -> None:
    mesh_set = mesh_set_of(*sample_arrays(sample))
    report = ls.simplify(mesh_set, target_percent=10, effort=effort)
    assert_same_as_filter(ls.simplify(*sample_arrays(sample), target_percent=10, effort=effort), mesh_set, report)


@pytest.mark.parametrize(
    "options",
    [
        {"target_faces": 301},
        {"target_percent": 12.5, "feature_weight": 0},
        {"target_percent": 5, "boundary": "free"},
        {"target_percent": 5, "boundary": "lock"},
        {"target_faces": 3, "preserve_topology": True},
        {"target_percent": 10, "descriptor": "normalised_umbrella"},
        {"target_percent": 10, "descriptor": "curvature_estimation"},
        {"target_percent": 10, "measure_error": False},
        {"target_percent": 10, "threads": 3},
        {"target_percent": 100},
    ],
    ids=str,
)
def test_every_option_does_what_it_does_in_the_filter(options) -> None:
    arrays = sample_arrays("folded_sheet.ply")
    mesh_set = mesh_set_of(*arrays)
    report = ls.simplify(mesh_set, **options)
    assert_same_as_filter(ls.simplify(*arrays, **options), mesh_set, report)


def test_a_stored_quality_guides_as_in_the_filter() -> None:
    vertices, faces = sample_arrays("flange.ply")
    quality = np.hypot(vertices[:, 0], vertices[:, 1])
    mesh_set = mesh_set_of(vertices, faces, v_scalar_array=quality)
    report = ls.simplify(mesh_set, target_percent=10, descriptor="vertex_quality")
    result = ls.simplify(vertices, faces, target_percent=10, descriptor="vertex_quality", quality=quality)
    assert_same_as_filter(result, mesh_set, report)


@pytest.mark.parametrize("selected_only", [None, True, False])
def test_a_selection_is_simplified_as_in_the_filter(selected_only: bool | None) -> None:
    vertices, faces = sample_arrays("relief_scan.ply")
    mesh_set = mesh_set_of(vertices, faces)
    mesh_set.compute_selection_by_condition_per_face(condselect="(x0 + x1 + x2) < 0")
    selected = mesh_set.current_mesh().face_selection_array().astype(bool)
    assert 0 < selected.sum() < len(faces)
    options = {"target_percent": 10, "selected_only": selected_only}
    report = ls.simplify(mesh_set, **options)
    assert_same_as_filter(ls.simplify(vertices, faces, selected=selected, **options), mesh_set, report)


@pytest.mark.parametrize("clean_input", [True, False])
def test_loose_vertices_go_with_the_rest_that_is_unclean_as_in_the_filter(clean_input: bool) -> None:
    vertices, faces = wave()
    vertices = np.insert(vertices, [0, 100, len(vertices)], [[7.0, 8.0, 9.0], [1e3, 0, 0], [0, 0, -5]], axis=0)
    faces = faces + 1 + (faces >= 100)
    mesh_set = mesh_set_of(vertices, faces)
    options = {"target_percent": 10, "clean_input": clean_input}
    report = ls.simplify(mesh_set, **options)
    result = ls.simplify(vertices, faces, **options)
    assert_same_as_filter(result, mesh_set, report)
    assert {0, 101, len(vertices) - 1} & set(result.vertex_origin) == (
        set() if clean_input else {0, 101, len(vertices) - 1}
    )


def test_soup_is_welded() -> None:
    vertices, faces = wave()
    options = {"target_percent": 10, "measure_error": False}
    soup = ls.simplify(vertices[faces].reshape(-1, 3), np.arange(faces.size).reshape(-1, 3), **options)
    assert soup.report.target_reached
    assert soup.report.welded_vertices == faces.size - len(vertices)
    assert soup.report.boundary_edges == ls.simplify(vertices, faces, **options).report.boundary_edges


def test_borders_within_the_weld_distance_are_joined() -> None:
    vertices, faces = wave()
    other = np.add(vertices, [np.ptp(vertices[:, 0]) + 1e-4, 0, 0])
    other[:, 2] = 0  # the borders are as close as they are flat
    vertices = np.concatenate([np.where([True, True, False], vertices, 0), other])
    faces = np.concatenate([faces, faces + len(other)])
    options = {"target_percent": 50, "measure_error": False}
    welded = ls.simplify(vertices, faces, weld_distance=0.1, **options).report
    assert welded.welded_vertices > 10
    assert welded.boundary_edges < ls.simplify(vertices, faces, **options).report.boundary_edges


@pytest.mark.parametrize("vertex_type", [np.float32, np.float64, ">f4", ">f8"])
@pytest.mark.parametrize("face_type", ["i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", ">i4", ">u8"])
def test_types_come_back(vertex_type, face_type) -> None:
    vertices, faces = wave(11)
    result = ls.simplify(vertices.astype(vertex_type), faces.astype(face_type), target_percent=20)
    assert result.vertices.dtype == vertex_type
    assert result.faces.dtype == face_type
    expected = ls.simplify(vertices.astype(vertex_type).astype(np.float64), faces, target_percent=20)
    assert np.array_equal(result.vertices, expected.vertices.astype(vertex_type))
    assert np.array_equal(result.faces, expected.faces)


def test_it_unpacks_and_knows_where_everything_was() -> None:
    vertices, faces = wave()
    result = ls.simplify(vertices, faces, target_percent=20, effort="fast")
    new_vertices, new_faces = result
    assert new_vertices is result.vertices
    assert new_faces is result.faces
    for origin, count, before in ((result.vertex_origin, len(new_vertices), len(vertices)),
                                  (result.face_origin, len(new_faces), len(faces))):  # fmt: skip
        assert len(origin) == count
        assert (np.diff(origin) > 0).all()
        assert origin[-1] < before
    kept = (new_vertices == vertices[result.vertex_origin]).all(axis=1)
    assert 0 < kept.sum() < len(kept)  # some stay to the last bit, others move


def test_locked_vertices_stay() -> None:
    vertices, faces = wave()
    locked = np.zeros(len(vertices), dtype=bool)
    locked[200:260] = True
    result = ls.simplify(vertices, faces, target_percent=10, locked=locked)
    at = np.searchsorted(result.vertex_origin, np.flatnonzero(locked))
    assert np.array_equal(result.vertices[at], vertices[locked])
    assert result.report.target_reached


@pytest.mark.parametrize(
    "layout",
    [
        lambda a: a,
        np.asfortranarray,
        lambda a: np.repeat(a, 2, axis=0)[::2],
        lambda a: np.pad(a, ((0, 0), (0, 1)))[:, :3],
        lambda a: a[::-1][::-1],
        lambda a: np.frombuffer(b"\0" + a.tobytes(), np.uint8)[1:].view(a.dtype).reshape(a.shape),  # not aligned
    ],
)
def test_arrays_are_read_however_they_lie_and_never_changed(layout) -> None:
    expected = ls.simplify(*wave(), target_percent=10)
    vertices, faces = (layout(array) for array in wave())
    for array in (vertices, faces):
        array.setflags(write=False)
    result = ls.simplify(vertices, faces, target_percent=10)
    assert result.vertices.tobytes() == expected.vertices.tobytes()
    assert np.array_equal(result.faces, expected.faces)
    assert np.array_equal(vertices, wave()[0])
    assert result.vertices.flags.writeable
    assert not np.shares_memory(result.vertices, vertices)


def test_nothing_is_kept_of_a_run() -> None:
    """What 60 results need, 3.6 MB each, would be 200 MB; an allocator may hold on to some of it."""
    arrays = wave(220)

    def resident() -> int:
        return int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize()

    for k in range(70):
        if k == 10:
            before = resident()
        ls.simplify(*arrays, target_percent=100, measure_error=False)
    assert resident() - before < 100e6


def test_numbers_of_numpy_are_numbers() -> None:
    options = {"target_percent": np.float32(10), "feature_weight": np.int8(2), "threads": np.uint64(1)}
    result = ls.simplify(*wave(), **options, measure_error=np.False_, effort=np.str_("fast"))
    assert result.report.rms is None
    assert result.report.faces == len(result.faces)
