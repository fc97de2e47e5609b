# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the guided decimation promises about parts of a mesh, layers and threads, bit by bit in every host."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import igl
import numpy as np
import pytest

from filter_scripts import ForeignStep, Step, values_of, write_script
from mesh_checks import MeshData
from script_hosts import ScriptHost

SIDE = 16
"""Faces along a side of the sheet, and of the ring around its cross-section."""


def sheet() -> tuple[np.ndarray, np.ndarray]:
    """A wavy square with an open border. Coordinates are floats, as a host may keep nothing else."""
    x, y = np.meshgrid(np.arange(SIDE + 1.0), np.arange(SIDE + 1.0))
    points = np.column_stack([x.ravel(), y.ravel(), np.sin(x * 0.9).ravel() * np.cos(y * 0.7).ravel()])
    corner = (np.arange(SIDE)[:, None] * (SIDE + 1) + np.arange(SIDE)).ravel()
    right, up, across = corner + 1, corner + SIDE + 1, corner + SIDE + 2
    faces = np.vstack([np.column_stack([corner, right, across]), np.column_stack([corner, across, up])])
    return points.astype("f4"), faces


def tube() -> tuple[np.ndarray, np.ndarray]:
    """A torus."""
    u, v = np.meshgrid(np.arange(SIDE) * 2 * np.pi / SIDE, np.arange(SIDE) * 2 * np.pi / SIDE)
    radius = 1 + 0.4 * np.cos(v)
    points = np.column_stack([(radius * np.cos(u)).ravel(), (radius * np.sin(u)).ravel(), 0.4 * np.sin(v).ravel()])
    i, j = np.meshgrid(np.arange(SIDE), np.arange(SIDE))
    corner, right = (j * SIDE + i).ravel(), (j * SIDE + (i + 1) % SIDE).ravel()
    up, across = ((j + 1) % SIDE * SIDE + i).ravel(), ((j + 1) % SIDE * SIDE + (i + 1) % SIDE).ravel()
    faces = np.vstack([np.column_stack([corner, right, across]), np.column_stack([corner, across, up])])
    return points.astype("f4"), faces


def write_ply(file: Path, points: np.ndarray, faces: np.ndarray) -> Path:
    axes = "".join(f"property float {axis}\n" for axis in "xyz")
    head = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n{axes}"
    head += f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    rows = np.empty(len(faces), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    rows["count"], rows["corners"] = 3, faces
    file.write_bytes(head.encode() + points.astype("<f4").tobytes() + rows.tobytes())
    return file


def select(kind: str, condition: str) -> ForeignStep:
    """Vertices or faces by a filter that every host has."""
    return ForeignStep(f"Conditional {kind} Selection", (("condSelect", "RichString", condition),))


def flatten(only_visible: str) -> ForeignStep:
    """Puts layers into one, in their order: those that are shown, or all."""
    return ForeignStep(
        "Flatten Visible Layers",
        (
            ("MergeVisible", "RichBool", only_visible),
            ("DeleteLayer", "RichBool", "true"),
            ("MergeVertices", "RichBool", "false"),
            ("AlsoUnreferenced", "RichBool", "true"),
        ),
    )


FLATTEN, FLATTEN_VISIBLE = flatten("false"), flatten("true")


@pytest.fixture
def result_of(filters: list[dict], run_script: ScriptHost, tmp_path: Path) -> Callable[..., MeshData]:
    """Runs filters of other plugins, ours with the given values, and others again, on a mesh of arrays."""

    def run(
        mesh: tuple[np.ndarray, np.ndarray],
        *,
        row: str = "simplify",
        first: tuple[Step, ...] = (),
        then: tuple[Step, ...] = (),
        **values: object,
    ) -> MeshData:
        ours = next(filter_row for filter_row in filters if filter_row["id"] == row)
        script = write_script(tmp_path / "script.mlx", *first, (ours, values_of(ours, **values)), *then)
        output = tmp_path / "output.ply"
        done = run_script(script, write_ply(tmp_path / "input.ply", *mesh), output)
        assert done.status == 0, done.output
        assert output.exists(), done.output
        return MeshData.read(output)

    return run


def corners(points: np.ndarray, faces: np.ndarray) -> set[tuple[float, ...]]:
    """Every face as the coordinates of its corners, the lowest vertex first."""
    turned = [np.roll(face, -int(np.argmin(face))) for face in faces]
    return {tuple(points[face].astype("f4").ravel().tolist()) for face in turned}


def rows(points: np.ndarray) -> set[tuple[float, ...]]:
    return set(map(tuple, points.astype("f4").tolist()))


def same(one: MeshData, other: MeshData) -> bool:
    return np.array_equal(one.vertices, other.vertices) and np.array_equal(one.faces, other.faces)


def on_border(points: np.ndarray) -> np.ndarray:
    return (points[:, :2] % SIDE == 0).any(axis=1)


def euler_characteristic(mesh: MeshData) -> int:
    edges = np.sort(mesh.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    return len(np.unique(mesh.faces)) - len(np.unique(edges, axis=0)) + len(mesh.faces)


def test_selected_vertices_stay_locked(result_of: Callable[..., MeshData]) -> None:
    points, faces = sheet()
    locked = points[(points[:, 0] < 4) & (points[:, 1] > 5)]
    chosen = select("Vertex", "x < 4 && y > 5")
    free = result_of((points, faces), first=(chosen,), target_percent=20)
    kept = result_of((points, faces), first=(chosen,), target_percent=20, lock_selected_vertices=True)
    assert not rows(locked) <= rows(free.vertices)
    assert rows(locked) <= rows(kept.vertices)
    assert len(kept.faces) <= 0.2 * len(faces)


def test_a_locked_border_stays(result_of: Callable[..., MeshData]) -> None:
    points, faces = sheet()
    border = points[on_border(points)]
    kept = result_of((points, faces), target_percent=30, boundary=2)
    assert not rows(border) <= rows(result_of((points, faces), target_percent=30, boundary=0).vertices)
    assert rows(border) == rows(kept.vertices[on_border(kept.vertices)])


def test_preserve_topology_keeps_hole_and_handle(result_of: Callable[..., MeshData]) -> None:
    """As few faces as it gets. A torus without a face has the Euler characteristic -1, one without a hole 0."""
    points, faces = tube()
    few = {"target_faces": 1, "effort": 0, "boundary": 0}
    kept = result_of((points, faces[1:]), preserve_topology=True, **few)
    closed = result_of((points, faces[1:]), preserve_topology=False, **few)
    assert (euler_characteristic(kept), euler_characteristic(closed)) == (-1, 0)
    assert len(kept.faces) < 40


def test_only_the_selection_changes(result_of: Callable[..., MeshData]) -> None:
    points, faces = sheet()
    outside = faces[points[faces][:, :, 0].min(axis=1) >= 6]
    chosen = select("Face", "x0 < 6 || x1 < 6 || x2 < 6")
    kept = result_of((points, faces), first=(chosen,), target_percent=20, selected_only=True)
    expected = len(outside) + 0.2 * (len(faces) - len(outside))
    assert expected - 2 <= len(kept.faces) <= expected + 1
    assert corners(points, outside) <= corners(kept.vertices, kept.faces)


def test_a_new_layer_keeps_the_original(result_of: Callable[..., MeshData]) -> None:
    """It is hidden: two meshes at one place flicker."""
    points, faces = sheet()
    alone = result_of((points, faces), target_percent=25)
    both = result_of((points, faces), target_percent=25, new_layer=True, then=(FLATTEN,))
    assert same(alone, result_of((points, faces), target_percent=25, new_layer=True, then=(FLATTEN_VISIBLE,)))
    assert np.array_equal(both.vertices, np.vstack([points, alone.vertices]))
    assert np.array_equal(both.faces, np.vstack([faces, alone.faces + len(points)]))


def test_levels_are_layers_and_the_original_stays(result_of: Callable[..., MeshData]) -> None:
    points, faces = sheet()
    alone = result_of((points, faces), target_percent=50)
    every = result_of((points, faces), row="lod", percents="50,20", then=(FLATTEN,))
    first, last = slice(len(points), len(points) + len(alone.vertices)), len(faces) + len(alone.faces)
    assert np.array_equal(every.vertices[: first.start], points)
    assert np.array_equal(every.faces[: len(faces)], faces)
    assert np.array_equal(every.vertices[first], alone.vertices)
    assert np.array_equal(every.faces[len(faces) : last] - first.start, alone.faces)
    assert 0.2 * len(faces) - 2 <= len(every.faces) - last <= 0.2 * len(faces) + 1
    shown = result_of((points, faces), row="lod", percents="50,20", then=(FLATTEN_VISIBLE,))
    assert len(shown.faces) == len(every.faces) - last, "the last one"


@pytest.mark.parametrize("new_layer", [False, True])
def test_the_error_as_quality(result_of: Callable[..., MeshData], new_layer: bool) -> None:
    """The file has, in single precision, the distance of every vertex to the original, as libigl finds it."""
    points, faces = sheet()
    plain = result_of((points, faces), target_percent=15)
    result = result_of((points, faces), target_percent=15, error_as_quality=True, new_layer=new_layer)
    assert same(plain, result)
    squares, *_ = igl.point_mesh_squared_distance(result.vertices, points.astype("f8"), faces)
    distances = np.sqrt(squares)
    assert distances.max() > 0.1
    # the rounding of a vertex that a double precision host writes as single, and of the distance itself
    assert np.abs(result.quality - distances).max() < np.finfo("f4").eps * np.abs(points).max()


@pytest.mark.parametrize("row", ["simplify", "lod"])
def test_threads_do_not_show(row: str, result_of: Callable[..., MeshData]) -> None:
    target = {"target_percent": 20} if row == "simplify" else {"percents": "50,20"}
    one = result_of(sheet(), row=row, threads=1, **target)
    assert same(one, result_of(sheet(), row=row, threads=3, **target))
