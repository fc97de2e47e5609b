# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every filter on every sample mesh, every choice and every switch, in the real pymeshlab."""

import dataclasses
import json
import pickle

import numpy as np
import pytest
from conftest import SAMPLE_MESHES, SAMPLE_NAMES, faces_in, run_command
from test_tables import FUNCTIONS, target_for

import laplacian_simplify as ls
from laplacian_simplify.options import commands
from laplacian_simplify.tables import filter_named, filters

NAMES = [row.python_name for row in filters()]
CHOICES = [
    pytest.param(row.python_name, parameter.id, value, id=f"{row.name}: {parameter.id} = {value}")
    for row in filters()
    for parameter in row.parameters
    for value in ([option.id for option in parameter.options] or ([False, True] if parameter.type == "boolean" else []))
]


def one_report(report):
    """Of levels of detail the last one's."""
    return report[-1] if isinstance(report, list) else report


@pytest.mark.parametrize("sample", SAMPLE_NAMES)
@pytest.mark.parametrize("name", NAMES)
def test_every_filter_on_every_sample(name: str, sample: str, load_sample) -> None:
    mesh_set = load_sample(sample)
    report = one_report(FUNCTIONS[name](mesh_set, **target_for(name)))
    assert report.mesh_set is mesh_set
    assert report.seconds >= 0
    assert np.isfinite(mesh_set.current_mesh().vertex_matrix()).all()
    assert json.loads(report.to_json()) == json.loads(json.dumps(report.to_dict()))


@pytest.mark.parametrize("row", filters(), ids=lambda row: row.name)
def test_a_report_is_a_plain_value(row, load_sample) -> None:
    report = one_report(FUNCTIONS[row.python_name](load_sample("painted_box.obj"), **target_for(row.python_name)))
    copy = pickle.loads(pickle.dumps(report))  # without the mesh set
    assert copy == report
    assert dataclasses.asdict(copy) == dataclasses.asdict(report)
    with pytest.raises(AttributeError, match="holds no mesh set"):
        _ = copy.mesh_set
    for result in row.results:
        if result.type == "integer":
            value = getattr(report, result.id)
            assert isinstance(value, int) or (result.optional and value is None)
    assert all(type(size) is int for size in getattr(report, "class_sizes", ()))
    assert str(report).splitlines()[-1] == f"time      {report.seconds:.2f} s"
    assert all(f"<th>{result.id}</th>" in report._repr_html_() for result in row.results if not result.optional)


@pytest.mark.parametrize(("name", "parameter", "value"), CHOICES)
def test_every_choice_and_switch(name: str, parameter: str, value: object, load_sample) -> None:
    mesh_set = load_sample("painted_box.obj")
    mesh_set.compute_scalar_by_geodesic_distance_from_given_point_per_vertex()  # a quality to be guided by
    mesh_set.set_selection_all()
    report = one_report(FUNCTIONS[name](mesh_set, **{parameter: value, **target_for(name)}))
    assert np.isfinite(mesh_set.current_mesh().vertex_matrix()).all()
    meshes = 4 if filter_named(name).has("percents") else 1
    assert mesh_set.mesh_number() == (2 if (parameter, value) == ("new_layer", True) else meshes)
    assert set(report.to_dict()) >= {"seconds"}


@pytest.mark.parametrize("command", commands(), ids=lambda command: command.name)
def test_every_command(command, tmp_path) -> None:
    target = ("--percent", 20) if command.filter.has("target_faces") else ()
    if command.has_levels:
        target = ("--percents", 20)
    done = run_command(command.name, SAMPLE_MESHES / "flange.ply", tmp_path / "out.ply", *target)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert len(done.stdout.splitlines()) >= 2
    assert faces_in(tmp_path / "out.ply") > 0


def test_a_path_is_left_as_it_is() -> None:
    before = (SAMPLE_MESHES / "flange.ply").read_bytes()
    report = ls.simplify(SAMPLE_MESHES / "flange.ply", target_percent=10)
    assert report.faces <= 2368
    assert report.mesh_set.current_mesh().face_number() == report.faces
    assert (SAMPLE_MESHES / "flange.ply").read_bytes() == before


def test_the_descriptor_is_zero_where_flat_and_large_on_edges() -> None:
    report = ls.descriptor(SAMPLE_MESHES / "flange.ply")
    mesh = report.mesh_set.current_mesh()
    values, positions = mesh.vertex_scalar_array(), mesh.vertex_matrix()
    radii = np.hypot(positions[:, 0], positions[:, 1])
    top_of_boss = (abs(positions[:, 2] - 2.6) < 1e-6) & (radii > 1.25) & (radii < 1.6)
    rim_of_boss = (abs(positions[:, 2] - 2.6) < 1e-6) & (radii > 1.69)
    assert abs(values[top_of_boss]).max() < 1e-4
    assert values[rim_of_boss].min() > 0.05
    assert report.minimum == pytest.approx(values.min())
    assert report.maximum == pytest.approx(values.max())
    assert report.mean == pytest.approx(values.mean())


def test_rescaled_values_fill_the_unit_interval() -> None:
    report = ls.descriptor(SAMPLE_MESHES / "relief_scan.ply", rescale=True)
    values = report.mesh_set.current_mesh().vertex_scalar_array()
    assert values.min() == pytest.approx(0)
    assert values.max() == pytest.approx(1)


def test_classes_are_counted_and_selected() -> None:
    report = ls.classify(SAMPLE_MESHES / "flange.ply", classes=3, class_as_quality=True)
    mesh = report.mesh_set.current_mesh()
    assert sum(report.class_sizes) == mesh.vertex_number()
    assert report.selected == mesh.selected_vertex_number() == report.class_sizes[-1]
    assert list(report.centers) == sorted(report.centers)
    assert len(report.thresholds) == 2
    counts = np.bincount(mesh.vertex_scalar_array().astype(int), minlength=3)
    assert counts.tolist() == [int(size) for size in report.class_sizes]


def test_refinement_only_adds() -> None:
    plain = ls.classify(SAMPLE_MESHES / "bracket_quads.ply")
    refined = ls.classify(SAMPLE_MESHES / "bracket_quads.ply", refine=True)
    before = plain.mesh_set.current_mesh().vertex_selection_array()
    after = refined.mesh_set.current_mesh().vertex_selection_array()
    assert (after | before == after).all()
    assert refined.promoted == after.sum() - before.sum()


def test_normal_dependent_smoothing_moves_along_normals_only() -> None:
    mesh_set = ls.read_mesh(SAMPLE_MESHES / "flange.ply")
    before = mesh_set.current_mesh().vertex_matrix().copy()
    report = ls.smooth(mesh_set, operator="normal_dependent", steps=3)
    after = report.mesh_set.current_mesh().vertex_matrix()
    moved = np.linalg.norm(after - before, axis=1)
    radii = np.hypot(before[:, 0], before[:, 1])
    inside_the_flat_bottom = (before[:, 2] == 0) & (radii > 2) & (abs(before[:, :2]).max(axis=1) < 2.2)
    assert moved[inside_the_flat_bottom].max() < 1e-6
    assert report.moved > 0
    diagonal = np.linalg.norm(before.max(axis=0) - before.min(axis=0))
    assert report.largest_movement == pytest.approx(100 * moved.max() / diagonal, rel=1e-4)


def test_fixed_borders_stay() -> None:
    mesh_set = ls.read_mesh(SAMPLE_MESHES / "folded_sheet.ply")
    mesh_set.compute_selection_from_mesh_border()
    border = mesh_set.current_mesh().vertex_selection_array().copy()
    before = mesh_set.current_mesh().vertex_matrix().copy()
    mesh_set.set_selection_none()
    ls.smooth(mesh_set, boundary="fixed")
    after = mesh_set.current_mesh().vertex_matrix()
    assert (after[border] == before[border]).all()
    assert (after[~border] != before[~border]).any()


@pytest.mark.parametrize("name", NAMES)
def test_unusable_meshes_are_refused_with_the_count(name: str) -> None:
    import pymeshlab

    points = pymeshlab.MeshSet()
    points.add_mesh(pymeshlab.Mesh(np.zeros((5, 3))))
    with pytest.raises(RuntimeError, match=r"no faces \(5 vertices\)"):
        FUNCTIONS[name](points, **target_for(name))
    not_finite = pymeshlab.MeshSet()
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, np.nan, 0], [np.inf, 1, 0]])
    not_finite.add_mesh(pymeshlab.Mesh(corners, np.array([[0, 1, 2], [0, 1, 3]])))
    with pytest.raises(RuntimeError, match="2 of 4 vertices"):
        FUNCTIONS[name](not_finite, **target_for(name))
    with pytest.raises(RuntimeError, match="empty"):
        FUNCTIONS[name](pymeshlab.MeshSet(), **target_for(name))
