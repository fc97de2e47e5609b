# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Attributes of arrays guide the simplification, are interpolated, and keep their seams, names, shapes and types."""

import numpy as np
import pytest
from array_meshes import wave
from attribute_meshes import affine, cells_of, open_edges, shaded_box, sheet, side_of, textured_box

import laplacian_simplify as ls
from laplacian_simplify.attributes import Attributes, Channels
from laplacian_simplify.small import Small

FLOAT = 1e-6
"""Values pass as float32: a part in 2^24 of numbers about 1, a few times."""


def test_what_is_affine_on_a_plane_stays_so() -> None:
    vertices, faces = sheet()
    vertices += np.random.default_rng(1).uniform(-0.01, 0.01, vertices.shape) * [1, 1, 0]
    given = {"uv": affine(vertices), "height": vertices[:, 0] * 7 - 100, "pair": vertices[:, :2]}
    result = ls.simplify(vertices, faces, target_percent=10, vertex_attributes=given)
    found = result.vertex_attributes
    assert np.allclose(found["uv"], affine(result.vertices), atol=FLOAT)
    assert np.allclose(found["height"], result.vertices[:, 0] * 7 - 100, atol=30 * FLOAT)
    assert np.allclose(found["pair"], result.vertices[:, :2], atol=3 * FLOAT)
    assert {name: values.shape[1:] for name, values in found.items()} == {"uv": (2,), "height": (), "pair": (2,)}
    assert result.report.attribute_rms is not None
    assert set(result.report.attribute_rms) == set(given)
    assert max(result.report.attribute_rms.values()) < 30 * FLOAT
    assert result.report.texture_deviation is not None
    assert result.report.texture_deviation < 1e-3  # percent


def test_seams_of_doubled_vertices_stay_and_do_not_gape() -> None:
    vertices, faces, texture = textured_box()
    result = ls.simplify(vertices, faces, target_percent=10, vertex_attributes={"uv": texture})
    corners = result.vertex_attributes["uv"][result.faces]
    assert (cells_of(corners) == side_of(result.vertices[result.faces])[:, None]).all()
    assert open_edges(result.vertices, result.faces) == 0
    assert result.report.vertices == len(result.vertices) > len(np.unique(result.vertices, axis=0))
    assert (np.diff(result.vertex_origin) >= 0).all()
    assert result.report.turned_texture_faces == 0
    blind = ls.simplify(vertices, faces, target_percent=10, vertex_attributes={"uv": texture}, keep_attributes=False)
    corners = blind.vertex_attributes["uv"][blind.faces]
    assert not (cells_of(corners) == side_of(blind.vertices[blind.faces])[:, None]).all()
    assert np.array_equal(blind.vertex_attributes["uv"], texture[blind.vertex_origin])


def test_corners_of_shared_vertices_give_the_same_as_doubled_vertices() -> None:
    vertices, faces, texture = textured_box()
    places, place = np.unique(vertices, axis=0, return_inverse=True)
    welded = place.reshape(-1)[faces]
    given = {"uv": texture[faces]}
    result = ls.simplify(places, welded, target_percent=10, corner_attributes=given)
    assert result.corner_attributes["uv"].shape == (len(result.faces), 3, 2)
    assert (cells_of(result.corner_attributes["uv"]) == side_of(result.vertices[result.faces])[:, None]).all()
    assert len(np.unique(result.vertices, axis=0)) == len(result.vertices)  # none is split
    assert open_edges(result.vertices, result.faces) == 0


def test_types_come_back() -> None:
    vertices, faces = wave(20)
    rng = np.random.default_rng(2)
    given = {
        "color": np.linspace(0, 255, 3 * len(vertices)).reshape(-1, 3).astype(np.uint8),
        "wide_color": np.linspace(0, 65535, 4 * len(vertices)).reshape(-1, 4).astype(np.uint16),
        "half": vertices[:, 0].astype(np.float16),
        "single": vertices[:, 1].astype(">f4"),
        "double": vertices[:, 2],
        "id": rng.permutation(len(vertices)),
        "flag": vertices[:, 0] > 1,
        "name": np.array([f"v{k}" for k in range(len(vertices))]),
        "bytes": np.arange(len(vertices)).astype(np.uint8),
    }
    kinds = {"wide_color": "color"}
    result = ls.simplify(vertices, faces, target_percent=20, vertex_attributes=given, attribute_kinds=kinds)
    for name, values in given.items():
        found = result.vertex_attributes[name]
        assert found.dtype == values.dtype, name
        assert found.shape == (len(result.vertices), *values.shape[1:]), name
        stays = np.array_equal(found, values[result.vertex_origin])
        assert stays == (name in ("id", "flag", "name", "bytes")), name
    assert result.report.attribute_rms is not None
    assert set(result.report.attribute_rms) == {"color", "wide_color", "half", "single", "double"}


def test_colors_are_measured_in_256_steps() -> None:
    vertices, faces = wave()
    unit = np.clip(vertices[:, [0, 1, 0]] / 3, 0, 1)
    options = {"target_percent": 5, "effort": "fast"}
    floats = ls.simplify(vertices, faces, vertex_attributes={"color": unit}, **options)
    numbers = ls.simplify(vertices, faces, vertex_attributes={"color": 255 * unit}, **options)
    assert floats.report.attribute_rms is not None
    assert numbers.report.attribute_rms is not None
    assert floats.report.attribute_rms["color"] == pytest.approx(numbers.report.attribute_rms["color"], rel=1e-3)
    assert np.allclose(floats.vertex_attributes["color"] * 255, numbers.vertex_attributes["color"], atol=0.1)
    assert floats.vertex_attributes["color"].max() <= 1


def test_numbers_far_from_zero_keep_their_digits() -> None:
    vertices, faces = sheet(20)
    given = {"time": 1.7e9 + vertices[:, 0]}
    result = ls.simplify(vertices, faces, target_percent=20, vertex_attributes=given)
    assert np.allclose(result.vertex_attributes["time"] - 1.7e9, result.vertices[:, 0], atol=1e-5)


def test_what_does_not_change_keeps_its_bits() -> None:
    vertices, faces, _ = textured_box(9)
    given = {"value": np.random.default_rng(3).uniform(-1e5, 1e5, len(vertices))}
    at_corners = {"other": np.random.default_rng(4).uniform(0, 1e-5, (len(faces), 3, 2))}
    labels = np.arange(len(faces)) // 50
    options = {"vertex_attributes": given, "corner_attributes": at_corners, "face_labels": labels}
    result = ls.simplify(vertices, faces, target_percent=100, **options)
    assert result.vertex_attributes["value"].tobytes() == given["value"].tobytes()
    assert result.corner_attributes["other"].tobytes() == at_corners["other"].tobytes()
    assert np.array_equal(result.face_labels, labels)
    selected = np.arange(len(faces)) < 300
    part = ls.simplify(*wave(), target_percent=10, selected=_left(), vertex_attributes={"value": wave()[0][:, 2]})
    kept = ~_left()[part.face_origin]
    vertices_kept = np.unique(part.faces[kept])
    origin = part.vertex_origin[vertices_kept]
    assert np.array_equal(part.vertex_attributes["value"][vertices_kept], wave()[0][origin, 2])
    assert selected.any()


def _left() -> np.ndarray:
    vertices, faces = wave()
    return np.asarray(vertices[faces][:, :, 0].mean(axis=1) < 1.5)


def test_labels_make_seams() -> None:
    vertices, faces = sheet(31)  # a line of vertices at 1.5
    labels = np.where(vertices[faces][:, :, 0].mean(axis=1) < 1.5, 7, -3).astype(np.int16)
    result = ls.simplify(vertices, faces, target_percent=5, face_labels=labels)
    assert result.face_labels is not None
    assert result.face_labels.dtype == np.int16
    x = result.vertices[result.faces][:, :, 0]
    assert np.abs(np.where(result.face_labels == 7, np.maximum(x.max(axis=1), 1.5), 1.5) - 1.5).max() < 1e-6
    assert np.abs(np.where(result.face_labels == -3, np.minimum(x.min(axis=1), 1.5), 1.5) - 1.5).max() < 1e-6
    blind = ls.simplify(vertices, faces, target_percent=5, face_labels=labels, keep_attributes=False)
    assert np.array_equal(blind.face_labels, labels[blind.face_origin])
    assert blind.report.faces_held_by_seams is None


def test_seams_hold_the_target_or_are_ignored() -> None:
    vertices, faces = wave(12)
    labels = np.arange(len(faces)) // 2
    held = ls.simplify(vertices, faces, target_faces=20, face_labels=labels)
    assert held.report.stop_reason is ls.StopReason.SEAMS
    assert held.report.faces_held_by_seams == held.report.faces - 20
    assert f"{held.report.faces_held_by_seams} faces too many" in str(held.report)
    assert "seams='ignore'" in str(held.report)
    free = ls.simplify(vertices, faces, target_faces=20, face_labels=labels, seams="ignore")
    assert free.report.target_reached


def test_a_weight_of_0_guides_nothing() -> None:
    vertices, faces = wave()
    given = {"value": np.sin(9 * vertices[:, 0])}
    options = {"target_percent": 10, "effort": "fast"}
    plain = ls.simplify(vertices, faces, **options)
    carried = ls.simplify(vertices, faces, vertex_attributes=given, attribute_weight=0, **options)
    guided = ls.simplify(vertices, faces, vertex_attributes=given, attribute_weight=np.float32(10), **options)
    assert carried.vertices.tobytes() == plain.vertices.tobytes()
    assert carried.report.attribute_rms is not None
    assert guided.report.attribute_rms is not None
    assert guided.report.attribute_rms["value"] < 0.8 * carried.report.attribute_rms["value"]


@pytest.mark.parametrize("clean_input", [True, False])
def test_vertices_without_faces_keep_their_values(clean_input: bool) -> None:
    vertices, faces = wave()
    vertices = np.insert(vertices, [0, 100], [[7.0, 8.0, 9.0], [1e3, 0, 0]], axis=0)
    faces = faces + 1 + (faces >= 100)
    value = np.hypot(vertices[:, 0], vertices[:, 1])
    options = {"target_percent": 10, "clean_input": clean_input, "vertex_attributes": {"value": value}}
    result = ls.simplify(vertices, faces, **options)
    loose = np.isin(result.vertex_origin, [0, 101])
    assert loose.sum() == (0 if clean_input else 2)
    assert np.array_equal(result.vertex_attributes["value"][loose], value[[] if clean_input else [0, 101]])


def test_a_canceled_run_gives_copies() -> None:
    vertices, faces = wave(60)
    given, labels = {"value": vertices[:, 2].copy()}, np.zeros(len(faces), int)
    options = {"vertex_attributes": given, "face_labels": labels, "progress": lambda *_: False}
    result = ls.simplify(vertices, faces, target_percent=10, **options)
    assert result.report.stop_reason is ls.StopReason.CANCELLED
    assert np.array_equal(result.vertex_attributes["value"], given["value"])
    assert not np.shares_memory(result.vertex_attributes["value"], given["value"])
    assert np.array_equal(result.face_labels, labels)


def test_the_same_bytes_for_any_number_of_threads() -> None:
    vertices, faces, texture = textured_box()
    given = {"uv": texture, "value": vertices[:, 2]}
    runs = [ls.simplify(vertices, faces, target_percent=5, vertex_attributes=given, threads=k) for k in (1, 3)]
    for name in given:
        assert runs[0].vertex_attributes[name].tobytes() == runs[1].vertex_attributes[name].tobytes()
    assert runs[0].vertices.tobytes() == runs[1].vertices.tobytes()


V, F = wave(5)
UV = V[:, :2]


@pytest.mark.parametrize(
    ("options", "error", "said"),
    [
        ({"vertex_attributes": [UV]}, TypeError, "vertex_attributes must be a dictionary of names, not list"),
        ({"vertex_attributes": {"uv": UV.tolist()}}, TypeError, r"\['uv'\] must be a NumPy array, not list"),
        ({"vertex_attributes": {"uv": np.ma.array(UV)}}, TypeError, "must be a NumPy array, not MaskedArray"),
        ({"vertex_attributes": {"uv": UV[1:]}}, ValueError, r"has the shape \(24, 2\), not \(25\) or \(25, k\)"),
        ({"vertex_attributes": {"t": UV[:, :, None]}}, ValueError, r"has the shape \(25, 2, 1\), not \(25\) or"),
        (
            {"corner_attributes": {"uv": UV}},
            ValueError,
            r"corner_attributes\['uv'\] has .* not \(32, 3\) or \(32, 3, k\)",
        ),
        (
            {"vertex_attributes": {"uv": np.where(UV == 0, np.nan, UV)}},
            ValueError,
            "not finite, or too large, at 9 of 25",
        ),
        ({"vertex_attributes": {"t": np.where(UV == 0, 1e200, UV)}}, ValueError, "not finite, or too large, at"),
        (
            {"vertex_attributes": {"a": UV}, "attribute_kinds": {"a": "paint"}},
            ValueError,
            "'paint' is not one of texture",
        ),
        (
            {"vertex_attributes": {"a": UV}, "attribute_kinds": {"b": "scalar"}},
            ValueError,
            "'b', which is no attribute",
        ),
        (
            {"vertex_attributes": {"a": V}, "attribute_kinds": {"a": "texture"}},
            ValueError,
            "two columns, u and v, not 3",
        ),
        (
            {"vertex_attributes": {"a": F[:25]}, "attribute_kinds": {"a": "color"}},
            TypeError,
            "must be an array of floats, uint8 or uint16, not of int64",
        ),
        (
            {"vertex_attributes": {"a": UV}, "corner_attributes": {"a": UV[F]}},
            ValueError,
            "'a' is a name both of vertex_attributes and of corner_attributes",
        ),
        ({"face_labels": list(range(32))}, TypeError, "face_labels must be a NumPy array of integers, not list"),
        ({"face_labels": np.zeros(32)}, TypeError, "face_labels must be an array of integers, not of float64"),
        ({"face_labels": np.zeros(31, int)}, ValueError, r"face_labels has the shape \(31,\), not \(32,\)"),
        ({"attribute_weight": 101}, ValueError, r"attribute_weight = 101 is outside \[0, 100\]"),
        ({"attribute_weight": "1"}, TypeError, "attribute_weight must be a number, not str"),
        ({"seams": "mend"}, ValueError, r"seams = mend is not one of keep \(0\), ignore \(1\)"),
    ],
)
def test_refused_by_name(options, error: type[Exception], said: str) -> None:
    with pytest.raises(error, match=said):
        ls.simplify(V, F, target_faces=5, **options)


def test_faces_out_of_range_are_refused_with_attributes_too() -> None:
    with pytest.raises(ValueError, match="of 2 of 32 faces are outside"):
        ls.simplify(V, F + 1, target_faces=5, vertex_attributes={"uv": UV})
    with pytest.raises(ValueError, match="of 2 of 32 faces are outside"):
        ls.simplify(V, (F - 1).astype("u4"), target_faces=5, vertex_attributes={"uv": UV})


def test_hard_normals_of_vertices_stay_hard() -> None:
    vertices, faces, normals = shaded_box()
    given = {"normals": normals.astype(np.float32)}
    result = ls.simplify(vertices, faces, target_percent=10, vertex_attributes=given)
    found = result.vertex_attributes["normals"]
    assert found.dtype == np.float32
    assert np.allclose(np.linalg.norm(found, axis=1), 1, atol=FLOAT)
    side = side_of(result.vertices[result.faces])
    of_side = np.full(len(result.vertices), -1)
    for k in range(3):
        of_side[result.faces[:, k]] = side
    assert (of_side[result.faces] == side[:, None]).all()  # no vertex is on two sides, so none is shaded by both
    assert open_edges(result.vertices, result.faces) == 0
    outward = result.vertices[result.faces].mean(axis=1)
    assert (np.einsum("ij,ikj->ik", outward, found[result.faces]) > 0).all()
    assert result.report.attribute_rms is None  # nothing is interpolated


def test_hard_normals_of_corners_need_no_doubled_vertices() -> None:
    vertices, faces, normals = shaded_box()
    places, place = np.unique(vertices, axis=0, return_inverse=True)
    given = {"normals": normals[faces]}
    result = ls.simplify(places, place.reshape(-1)[faces], target_percent=10, corner_attributes=given)
    found = result.corner_attributes["normals"]
    assert len(np.unique(result.vertices, axis=0)) == len(result.vertices)  # none is split
    assert np.allclose(np.linalg.norm(found, axis=2), 1)
    corners, side = result.vertices[result.faces], side_of(result.vertices[result.faces])
    ends = corners.reshape(-1, 3)
    edge = (np.abs(np.abs(ends).max(axis=1) - np.sort(np.abs(ends), axis=1)[:, 1]) < 1e-9).reshape(-1, 3)
    assert edge.sum() > 20
    axis = (side % 3)[:, None]
    along = np.take_along_axis(found, np.repeat(axis[:, None], 3, axis=1), axis=2)[..., 0]
    assert (along[edge] * np.where(side < 3, 1, -1)[:, None].repeat(3, 1)[edge] > np.cos(np.pi / 4)).all()


def test_smooth_normals_are_no_seams_and_are_computed_anew() -> None:
    vertices, faces, _ = textured_box()
    smooth = vertices / np.linalg.norm(vertices, axis=1, keepdims=True)
    plain = ls.simplify(vertices, faces, target_percent=10)
    found = []
    for keep in (True, False):
        given = {"normals": smooth if keep else shaded_box()[2]}
        result = ls.simplify(vertices, faces, target_percent=10, vertex_attributes=given, keep_attributes=keep)
        assert np.array_equal(result.vertices, plain.vertices)
        found.append(result.vertex_attributes["normals"])
        assert np.allclose(np.linalg.norm(found[-1], axis=1), 1)
    assert np.array_equal(*found)
    whole = ls.simplify(vertices, faces, target_percent=100, vertex_attributes={"normals": smooth})
    assert np.array_equal(whole.vertex_attributes["normals"], smooth)


@pytest.mark.parametrize("size", [1e-160, 1.0, 1e160])
def test_normals_of_any_size_and_of_none(size: float) -> None:
    places = size * np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [2, 2, 2]])
    made = Small(places, np.array([[0, 1, 2], [3, 3, 3]]), None)
    assert np.allclose(made.corner_normals(np.arange(4)), [[[0, 0, 1]] * 3, [[0, 0, 0]] * 3])
    given = {"normals": np.full((4, 3), 0.5)}
    channels = Channels(
        Attributes(given, {"at corners": np.full((2, 3, 3), 0.5)}, None, {"at corners": "normal"}), 4, 2
    )
    found = channels.results(None, np.arange(4), np.arange(2), made)
    assert np.allclose(found["vertex_attributes"]["normals"], [[0, 0, 1]] * 3 + [[0.5] * 3])
    assert np.allclose(found["corner_attributes"]["at corners"], [[[0, 0, 1]] * 3, [[0.5] * 3] * 3])


def test_normals_are_checked() -> None:
    vertices, faces = sheet(5)
    with pytest.raises(ValueError, match=r"vertex_attributes\['n'\] must have three columns, not 2"):
        ls.simplify(
            vertices,
            faces,
            target_percent=50,
            vertex_attributes={"n": vertices[:, :2]},
            attribute_kinds={"n": "normal"},
        )
