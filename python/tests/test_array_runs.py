# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of arrays: their reports, their progress, several at a time, and parts of a mesh."""

import dataclasses
import json
import pickle
import signal
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from array_meshes import sample_arrays, wave
from conftest import SAMPLE_NAMES

import laplacian_simplify as ls
from laplacian_simplify.library import MeshArrays, Outcome, run

COUNTS = ("faces_before", "faces", "vertices", "non_manifold_edges", "boundary_edges", "folded")


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
    assert calls[0] == (0, "Reading the mesh")
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
    assert "Measuring distances ██████████ 100 %" in capsys.readouterr().err


def test_the_bar_is_that_of_a_notebook_where_there_is_one(monkeypatch: pytest.MonkeyPatch) -> None:
    import tqdm.auto

    shown = []

    class Bar(tqdm.auto.tqdm):
        def update(self, n: float = 1) -> None:
            shown.append(n)

    monkeypatch.setattr(tqdm.auto, "tqdm", Bar)
    ls.simplify(*wave(), target_percent=10, progress=True)
    assert shown


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


def test_a_summary_of_attributes() -> None:
    """Those of arrays have names, those of the host an order."""
    numbers = {"seconds": 1.0, "faces_before": 9, "faces": 8, "vertices": 7, "target_reached": True, "stop_reason": 0}
    texture = {"texture_deviation": 0.25, "largest_texture_deviation": 1.5, "turned_texture_faces": 2}
    named = ls.DecimationReport.of({**numbers, **texture, "attribute_rms": {"uv": 0.5, "color": 12}})
    assert (
        "values    uv rms 0.5, color rms 12, texture off by rms 0.25 %, largest 1.5 % of the bounding box's diagonal, "
        "2 faces with turned texture"
    ) in str(named)
    assert "values    rms 0.5 / 12\n" in str(ls.DecimationReport.of({**numbers, "attribute_rms": [0.5, 12.0]}))
