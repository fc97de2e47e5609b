# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""simplify(vertices, faces): the filter's bytes without MeshLab, and what is refused by name."""

import dataclasses
import json
import pickle
import resource
import signal
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from array_meshes import mesh_set_of, sample_arrays, wave
from conftest import SAMPLE_NAMES, positions_and_faces

import laplacian_simplify as ls
from laplacian_simplify.arrays import _MESH_SETS_ONLY
from laplacian_simplify.library import MeshArrays, Outcome, run
from laplacian_simplify.library_structures import ParametersStructure
from laplacian_simplify.tables import filter_named

ROW = filter_named("meshing_decimation_laplacian_quadric_edge_collapse")
COUNTS = ("faces_before", "faces", "vertices", "non_manifold_edges", "boundary_edges", "folded")


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


V, F = wave(5)
HUGE = np.broadcast_to(np.zeros((1, 3)), (2**31, 3)), np.broadcast_to(np.zeros((1, 3), np.int32), (2**29, 3))


@pytest.mark.parametrize(
    ("arguments", "error", "said"),
    [
        ((V, F), ValueError, "there is no target: give target_faces=5000, "),
        ((V, F, {"target_faces": 5, "target_percent": 10}), ValueError, "are two targets: give one of them"),
        ((V, F, {"target_percent": 0}), ValueError, r"target_percent = 0 is outside \(0, 100\]"),
        ((V, F, {"target_percent": float("nan")}), ValueError, "target_percent = nan is outside"),
        ((V, F, {"target_percent": "10"}), TypeError, "target_percent must be a number, not str"),
        ((V, F, {"target_faces": [5]}), TypeError, "target_faces must be a whole number, not list"),
        ((V, None, {"target_faces": 5}), TypeError, "the faces are missing"),
        ((V[:, :2], F, {"target_faces": 5}), ValueError, r"vertices has the shape \(25, 2\), not \(n, 3\)"),
        ((V, F.ravel(), {"target_faces": 5}), ValueError, r"faces has the shape \(96,\), not \(m, 3\)"),
        ((V, F[:0], {"target_faces": 5}), ValueError, r"the mesh has no faces \(25 vertices\)"),
        ((V[:0], F[:0], {"target_faces": 5}), ValueError, r"the mesh has no faces \(0 vertices\)"),
        ((V[:0], F, {"target_faces": 5}), ValueError, r"of 32 of 32 faces are outside \[0, 0\)"),
        ((V, F + 1, {"target_faces": 5}), ValueError, r"of 2 of 32 faces are outside \[0, 25\); the first .* face 15"),
        ((V, F - 1, {"target_faces": 5}), ValueError, "of 2 of 32 faces are outside"),
        ((V, (F - 1).astype("i4"), {"target_faces": 5}), ValueError, "of 2 of 32 faces are outside"),
        ((V, F + 2**32, {"target_faces": 5}), ValueError, "of 32 of 32 faces are outside"),
        ((V, F.astype("u8") + 2**63, {"target_faces": 5}), ValueError, "of 32 of 32 faces are outside"),
        ((np.where(V[7] == V, np.nan, V), F, {"target_faces": 5}), ValueError, "25 vertices are not finite"),
        ((np.where(V == 0, np.inf, V), F, {"target_faces": 5}), ValueError, "of 9 of 25 vertices are not finite"),
        ((V * 1e19, F, {"target_faces": 5}), ValueError, "not finite or larger than 1e18"),
        (
            (V.astype(int), F, {"target_faces": 5}),
            TypeError,
            "vertices must be an array of float32 or float64, not of i",
        ),
        ((V.astype("f2"), F, {"target_faces": 5}), TypeError, "not of float16"),
        ((V.astype("g"), F, {"target_faces": 5}), TypeError, "not of float128"),
        ((V.astype(object), F, {"target_faces": 5}), TypeError, "not of object"),
        ((np.ma.array(V), F, {"target_faces": 5}), TypeError, "vertices must be a NumPy array"),
        ((V, F.tolist(), {"target_faces": 5}), TypeError, "faces must be a NumPy array of integers, not list"),
        ((V, F.astype(float), {"target_faces": 5}), TypeError, "faces must be an array of integers, not of float64"),
        ((V, F > 3, {"target_faces": 5}), TypeError, "faces must be an array of integers, not of bool"),
        ((V, F.astype("m8"), {"target_faces": 5}), TypeError, "not of timedelta64"),
        ((*HUGE, {"target_faces": 5}), ValueError, "536,870,912 faces and 2,147,483,648 vertices are too many"),
        ((V, F, {"target_faces": 5, "locked": [True]}), TypeError, "locked must be a NumPy array of bool"),
        ((V, F, {"target_faces": 5, "locked": np.ones(25, int)}), TypeError, "locked must be an array of bool"),
        ((V, F, {"target_faces": 5, "locked": np.ones(24, bool)}), ValueError, r"\(24,\), not \(25,\)"),
        ((V, F, {"target_faces": 5, "selected": np.ones(25, bool)}), ValueError, r"selected has the shape \(25,\)"),
        ((V, F, {"target_faces": 5, "selected": np.zeros(32, bool)}), ValueError, "no face is selected"),
        ((V, F, {"target_faces": 5, "selected_only": True}), ValueError, "no face is selected"),
        ((V, F, {"target_faces": 5, "quality": np.ones(25)}), ValueError, "given together or not at all"),
        ((V, F, {"target_faces": 5, "descriptor": "vertex_quality"}), ValueError, "given together or not at all"),
        (
            (V, F, {"target_faces": 5, "descriptor": "vertex_quality", "quality": np.full(25, np.nan)}),
            ValueError,
            "the quality is not finite at 25 of 25 vertices",
        ),
        ((V, F, {"target_faces": 5, "order": 1}), ValueError, "order = strict is for a pymeshlab.MeshSet or a"),
        ((V, F, {"target_faces": 5, "descriptor": "mean_curvature"}), ValueError, "descriptor = mean_curvature is for"),
        ((V, F, {"target_faces": 5, "new_layer": True}), ValueError, "new_layer = True is for a pymeshlab.MeshSet"),
        ((V, F, {"target_faces": 5, "progress": 3}), TypeError, "progress must be a callable or True, not int"),
        ((V, F, {"target_faces": 5, "return_result": True}), TypeError, "return_result is for meshes of other"),
        (([[0.0, 0, 0]], [[0, 0, 0]], {"target_faces": 5}), TypeError, "list cannot be simplified; accepted are two"),
        ((V, F, {"no_such": 5}), TypeError, "no_such"),
    ],
)
def test_refused_by_name(arguments, error: type[Exception], said: str) -> None:
    *arrays, options = arguments if isinstance(arguments[-1], dict) else (*arguments, {})
    with pytest.raises(error, match=said):
        ls.simplify(*arrays, **options)


def test_every_parameter_of_the_filter_is_known_here() -> None:
    """A new one has to be handed on, or refused where it is given."""
    handed_on = {name for name, *_ in ParametersStructure._fields_} | {
        "target_percent",
        "selected_only",
        "keep_attributes",
    }
    assert {parameter.id for parameter in ROW.parameters} <= handed_on | set(_MESH_SETS_ONLY)


def test_a_report_is_a_plain_value() -> None:
    report = ls.simplify(*wave(), target_percent=10).report
    copy = pickle.loads(pickle.dumps(report))
    assert copy == report
    assert dataclasses.asdict(copy) == dataclasses.asdict(report)
    assert report.stop_reason is ls.StopReason.TARGET
    assert all(type(getattr(report, name)) is int for name in COUNTS)
    assert json.loads(report.to_json())["stop_reason"] == 0
    text = str(report)
    assert text.startswith("faces     1,682 -> 167 (9.93 %), target reached\ndistance  rms ")
    assert text.splitlines()[-1].endswith(" s")
    assert f"<tr><th>faces</th><td>{report.faces}</td></tr>" in report._repr_html_()
    with pytest.raises(AttributeError, match="holds no mesh set"):
        _ = report.mesh_set


@pytest.mark.parametrize("refusal", [False, np.False_])
def test_progress_that_returns_false_stops_the_run(refusal) -> None:
    calls = []

    def progress(percent: int, stage: str) -> object:
        calls.append((percent, stage))
        return refusal if percent > 0 else None

    vertices, faces = wave(100)
    result = ls.simplify(vertices, faces, target_percent=10, progress=progress)
    assert result.report.stop_reason is ls.StopReason.CANCELLED
    assert calls[0] == (0, "Collapsing edges")
    assert calls[-1][0] > 0
    assert all(0 <= percent <= 100 for percent, _ in calls)
    assert np.array_equal(result.vertices, vertices)
    assert not np.shares_memory(result.vertices, vertices)
    assert np.array_equal(result.vertex_origin, np.arange(len(vertices)))
    assert result.report.faces == result.report.faces_before == len(result.faces)
    assert "canceled" in str(result.report)


def test_what_progress_raises_is_raised() -> None:
    with pytest.raises(ZeroDivisionError):
        ls.simplify(*wave(), target_percent=10, progress=lambda percent, _: percent // 0)


def test_ctrl_c_ends_a_run() -> None:
    def progress(_percent: int, _stage: str) -> None:
        signal.raise_signal(signal.SIGINT)

    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell in the background may ignore it
    try:
        with pytest.raises(KeyboardInterrupt):
            ls.simplify(*wave(), target_percent=10, progress=progress)
    finally:
        signal.signal(signal.SIGINT, before)


def test_a_bar_of_progress(capsys) -> None:
    assert ls.simplify(*wave(), target_percent=10, progress=True).report.target_reached
    assert "Refining" in capsys.readouterr().err


def test_two_runs_at_a_time() -> None:
    """Each waits within its run for the other: neither holds a lock."""
    both = threading.Barrier(2, timeout=60)

    def work(_: int) -> int:
        waited = []

        def progress(_percent: int, _stage: str) -> None:
            if not waited:
                waited.append(both.wait())

        return ls.simplify(*wave(), target_percent=10, threads=1, progress=progress).report.faces

    with ThreadPoolExecutor(2) as pool:
        assert set(pool.map(work, range(2))) == {167}


def test_eight_threads_at_a_time() -> None:
    meshes = [sample_arrays(name) for name in SAMPLE_NAMES]

    def work(k: int) -> bytes:
        vertices, faces = ls.simplify(*meshes[k % len(meshes)], target_percent=10, threads=1 + k % 3)
        return vertices.tobytes() + faces.tobytes()

    alone = [work(k) for k in range(len(meshes))]
    with ThreadPoolExecutor(8) as pool:
        for k, found in enumerate(pool.map(work, range(16))):
            assert found == alone[k % len(meshes)], k


def test_a_part_of_a_mesh_stops_at_a_cost_and_keeps_its_seams() -> None:
    vertices, faces = wave()
    locked = np.zeros(len(vertices), dtype=bool)
    locked[::3] = True
    parameters = {"target_faces": 1, "feature_weight": 2, "boundary": 1}

    def outcome(shared_seams: bool = False, **more: float) -> Outcome:
        return run(MeshArrays(vertices, faces, locked, shared_seams=shared_seams), {**parameters, **more}, None)

    def new_seams(result: Outcome) -> set[tuple[int, int]]:
        old, new = (
            {tuple(sorted((a, b))) for t in at.tolist() for a, b in zip(t, [*t[1:], t[0]], strict=True)}
            for at in (faces, result.vertex_origin[result.faces])
        )
        return {(a, b) for a, b in new - old if locked[a] and locked[b]}

    free = outcome()
    assert free.steps[-1][1] == len(free.faces)
    assert new_seams(free)
    assert not new_seams(outcome(shared_seams=True))
    limited = outcome(cost_limit=free.steps[len(free.steps) // 2][0])
    assert limited.report["stop_reason"] == ls.StopReason.ERROR_BOUND
    assert len(free.faces) < len(limited.faces) < len(faces)
    assert outcome(descriptor_scale=free.descriptor_scale).vertices.tobytes() == free.vertices.tobytes()
    assert outcome(descriptor_scale=1e-3).vertices.tobytes() != free.vertices.tobytes()
