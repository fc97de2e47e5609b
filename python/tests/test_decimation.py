# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the guided decimation promises, seen from Python."""

import igl
import numpy as np
import pymeshlab
import pytest
from conftest import SAMPLE_MESHES, SAMPLE_NAMES, non_manifold_edges, positions_and_faces, run_command

import laplacian_simplify as ls


@pytest.mark.parametrize("percent", [50, 10, 2])
@pytest.mark.parametrize("sample", SAMPLE_NAMES)
def test_target_and_edges(sample: str, percent: float, load_sample) -> None:
    mesh_set = load_sample(sample)
    _, faces_before = positions_and_faces(mesh_set)
    report = ls.simplify(mesh_set, target_percent=percent)
    positions, faces = positions_and_faces(mesh_set)
    assert report.target_reached, report
    assert report.stop_reason_text == "target reached"
    assert report.faces_before == len(faces_before)
    target = percent / 100 * len(faces_before)
    assert target - 2 <= report.faces == len(faces) <= target + 1
    assert report.vertices == len(positions)
    assert report.non_manifold_edges == non_manifold_edges(faces) <= non_manifold_edges(faces_before)
    corners = np.sort(faces, axis=1)
    assert (corners[:, 0] < corners[:, 1]).all()
    assert (corners[:, 1] < corners[:, 2]).all()
    assert len(np.unique(corners, axis=0)) == len(corners)


@pytest.mark.parametrize("order", ["sweeps", "strict"])
@pytest.mark.parametrize("sample", ["flange.ply", "relief_scan.ply", "leaves_and_cones.ply"])
def test_same_result_again_and_with_any_number_of_threads(sample: str, order: str, load_sample) -> None:
    results = []
    for threads in (1, 2, 3, 1):
        mesh_set = load_sample(sample)
        ls.simplify(mesh_set, target_percent=10, threads=threads, order=order, measure_error=False)
        results.append(positions_and_faces(mesh_set))
    for positions, faces in results[1:]:
        assert np.array_equal(positions, results[0][0])
        assert np.array_equal(faces, results[0][1])


def test_the_command_writes_the_same_bytes_again(tmp_path) -> None:
    outputs = [tmp_path / "once.ply", tmp_path / "again.ply"]
    for output, threads in zip(outputs, (1, 2), strict=True):
        source = SAMPLE_MESHES / "relief_scan.ply"
        done = run_command("simplify", source, output, "--percent", 10, "--threads", threads)
        assert done.returncode == 0, done.stderr
    assert outputs[0].read_bytes() == outputs[1].read_bytes()


def test_new_layer_keeps_the_original(load_sample) -> None:
    """Its name is the original's, it has no quality and color that that has not, and that is hidden."""
    mesh_set = load_sample("flange.ply")
    original = positions_and_faces(mesh_set)
    report = ls.simplify(mesh_set, target_percent=10, new_layer=True)
    assert mesh_set.mesh_number() == 2
    assert [mesh.label() for mesh in mesh_set] == ["flange.ply", "flange_simplified.ply"]
    assert [mesh.is_visible() for mesh in mesh_set] == [False, True]
    assert not mesh_set.current_mesh().has_vertex_scalar()
    assert not mesh_set.current_mesh().has_vertex_color()
    assert mesh_set.current_mesh().face_number() == report.faces
    mesh_set.set_current_mesh(0)
    for kept, before in zip(positions_and_faces(mesh_set), original, strict=True):
        assert np.array_equal(kept, before)


@pytest.mark.parametrize(
    "options",
    [
        {},
        {"new_layer": True},
        {"order": "strict"},
        {"effort": "best"},
        {"selected_only": True},
        {"keep_attributes": False},
        {"threads": 3},
    ],
    ids=str,
)
def test_the_error_as_quality_is_the_distance_to_the_original(options: dict, load_sample) -> None:
    """As libigl finds it, in double precision: but for rounding at coordinates of the size of the mesh."""
    mesh_set = load_sample("relief_scan.ply")
    if "selected_only" in options:
        mesh_set.compute_selection_by_condition_per_face(condselect="(x0 + x1 + x2) < 0")
    positions, faces = (array.copy() for array in positions_and_faces(mesh_set))
    ls.simplify(mesh_set, target_percent=10, error_as_quality=True, measure_error=False, **options)
    mesh = mesh_set.current_mesh()
    squares, *_ = igl.point_mesh_squared_distance(mesh.vertex_matrix(), positions, faces)
    quality = mesh.vertex_scalar_array()
    assert np.abs(quality - np.sqrt(squares)).max() < 1e-9 * mesh.bounding_box().diagonal()
    assert quality.max() > 1e-4 * mesh.bounding_box().diagonal()
    red, blue = mesh.vertex_color_matrix()[[quality.argmin(), quality.argmax()]]
    assert list(red) == [1, 0, 0, 1]
    assert list(blue) == [0, 0, 1, 1]


def test_the_error_as_quality_changes_nothing_else(load_sample) -> None:
    outcomes = []
    for options in (
        {},
        {"error_as_quality": False},
        {"error_as_quality": True, "threads": 1},
        {"error_as_quality": True},
    ):
        mesh_set = load_sample("flange.ply")
        ls.simplify(mesh_set, target_percent=10, **options)
        mesh = mesh_set.current_mesh()
        assert mesh.has_vertex_scalar() == mesh.has_vertex_color() == options.get("error_as_quality", False)
        colored = [mesh.vertex_scalar_array(), mesh.vertex_color_matrix()] if mesh.has_vertex_scalar() else []
        outcomes.append([array.tobytes() for array in [*positions_and_faces(mesh_set), *colored]])
    without, off, one_thread, on = outcomes
    assert without == off == on[:2]
    assert one_thread == on


def test_the_command_writes_the_error_as_quality(tmp_path) -> None:
    output = tmp_path / "out.ply"
    done = run_command(
        "simplify", SAMPLE_MESHES / "flange.ply", output, "--percent", 10, "--error-as-quality", "--no-measure-error"
    )
    assert done.returncode == 0, done.stderr
    mesh_set = pymeshlab.MeshSet()
    mesh_set.load_new_mesh(str(output))
    mesh = mesh_set.current_mesh()
    assert mesh.vertex_scalar_array().max() > 0
    assert len(np.unique(mesh.vertex_color_matrix(), axis=0)) > 20


def test_only_the_selection_changes(load_sample) -> None:
    mesh_set = load_sample("relief_scan.ply")
    mesh_set.compute_selection_by_condition_per_face(condselect="(x0 + x1 + x2) < 0")
    selected = mesh_set.current_mesh().selected_face_number()
    positions, faces = positions_and_faces(mesh_set)
    outside = positions[faces].sum(axis=1)[:, 0] >= 0
    report = ls.simplify(mesh_set, target_percent=10)
    after_positions, after_faces = positions_and_faces(mesh_set)
    assert report.faces == pytest.approx(len(faces) - 0.9 * selected, abs=2)
    before = {tuple(triangle.ravel()) for triangle in positions[faces[outside]]}
    after = {tuple(triangle.ravel()) for triangle in after_positions[after_faces]}
    assert before <= after


def test_selected_vertices_can_be_locked(load_sample) -> None:
    """Bits are compared, of arrays with locked= too: both lock the same vertices, so the result is the same."""
    mesh_set = load_sample("relief_scan.ply")
    positions, faces = positions_and_faces(mesh_set)
    with pytest.raises(ValueError, match="lock_selected_vertices = true, but no vertex is selected"):
        ls.simplify(mesh_set, target_percent=10, lock_selected_vertices=True)
    mesh_set.compute_selection_by_condition_per_vertex(condselect="x * y > 0.1")
    locked = mesh_set.current_mesh().vertex_selection_array()
    ls.simplify(mesh_set, target_percent=20, lock_selected_vertices=True)
    after, faces_after = positions_and_faces(mesh_set)
    assert 0 < locked.sum() < len(locked) / 2
    assert set(map(tuple, positions[locked])) <= set(map(tuple, after))
    arrays = ls.simplify(positions, faces.astype("u4"), target_percent=20, locked=locked)
    assert np.array_equal(arrays.vertices, after)
    assert np.array_equal(arrays.faces, faces_after)


def test_locked_borders_stay_and_preserved_ones_keep_their_course(load_sample) -> None:
    for boundary, tolerance in (("lock", 0.0), ("preserve", 1e-3)):
        mesh_set = load_sample("folded_sheet.ply")
        ls.simplify(mesh_set, target_percent=20, boundary=boundary)
        mesh_set.compute_selection_from_mesh_border()
        mesh = mesh_set.current_mesh()
        border = mesh.vertex_matrix()[mesh.vertex_selection_array()]
        outer = border[np.hypot(border[:, 0] - 0.45, border[:, 1] + 0.3) > 0.4]
        assert abs(abs(outer[:, :2]).max(axis=1) - 1).max() <= tolerance
        if boundary == "lock":
            assert len(outer) == 4 * 90


def test_preserve_topology_keeps_handle_and_components(load_sample) -> None:
    mesh_set = load_sample("flange.ply")
    ls.simplify(mesh_set, target_faces=60, preserve_topology=True)
    assert mesh_set.get_topological_measures()["genus"] == 1


def test_a_target_out_of_reach_is_a_report(tmp_path) -> None:
    source = SAMPLE_MESHES / "folded_sheet.ply"
    done = run_command("simplify", source, tmp_path / "out.ply", "--faces", 1, "--boundary", "lock")
    assert done.returncode == 0, done.stderr
    assert "target NOT reached: no further collapse possible without damage" in done.stdout
    assert (tmp_path / "out.ply").is_file()


def test_features_are_kept_better_than_by_plain_decimation(load_sample) -> None:
    """The edges of the bracket, at a strong reduction, against feature_weight = 0."""
    guided = ls.simplify(load_sample("bracket_quads.ply"), target_percent=10, feature_weight=4)
    plain = ls.simplify(load_sample("bracket_quads.ply"), target_percent=10, feature_weight=0)
    assert guided.feature_rms is not None
    assert plain.feature_rms is not None
    assert guided.feature_rms <= plain.feature_rms


def test_unmeasured_distances_are_absent(load_sample) -> None:
    report = ls.simplify(load_sample("flange.ply"), target_percent=50, measure_error=False)
    assert report.rms is None
    assert "rms" not in report.to_dict()


def test_no_more_faces_than_there_are_leaves_the_mesh(load_sample) -> None:
    mesh_set = load_sample("painted_box.obj")
    before = positions_and_faces(mesh_set)
    report = ls.simplify(mesh_set, target_faces=10_000)
    assert report.faces == report.faces_before == 3072
    for now, then in zip(positions_and_faces(mesh_set), before, strict=True):
        assert np.array_equal(now, then)
