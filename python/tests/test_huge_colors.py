# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Colors of a mesh in blocks: as near to those before as in memory, and the same bytes however it is worked on."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import run_command
from huge_meshes import painted, read_painted, torus, write_ply

import laplacian_simplify as ls

pytest.importorskip("distributed")

from laplacian_simplify.files.ply import as_bytes
from laplacian_simplify.huge.colors import counted_area, expected_face, run_with_colors, weight_in_part
from laplacian_simplify.huge.plan import sizes_for
from laplacian_simplify.huge.ply_source import PlySource
from laplacian_simplify.library import MeshArrays

FACES, BLOCK = 40_000, 6_000
COLOR_RMS, RMS = 1.1, 1.1  # of the in-memory run


@pytest.fixture(scope="module")
def mesh() -> tuple[np.ndarray, np.ndarray]:
    return torus(160, 125)


@pytest.fixture(scope="module")
def source(mesh: Any, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("colors") / "torus.ply"
    write_ply(path, *mesh, colors=painted(mesh[0]))
    return path


def simplified(source: Path, output: Path, percent: float, **options: Any) -> tuple[bytes, Any]:
    report = ls.simplify_huge(source, output, target_percent=percent, block_faces=BLOCK, **options)
    return output.read_bytes(), report


@pytest.fixture(scope="module")
def first(source: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[bytes, Any]:
    return simplified(source, tmp_path_factory.mktemp("first") / "small.ply", 4, workers=2)


def color_rms(vertices: Any, colors: Any, small: Any, faces: Any, small_colors: Any) -> float:
    """Between some vertices before and about the closest points of a result, in 0 to 255."""
    picked = np.arange(3, len(vertices), 7)
    a, b, c = (small[faces[:, k]].astype(np.float64) for k in range(3))
    middle = (a + b + c) / 3
    squares = []
    for part in np.array_split(picked, 40):
        points = vertices[part].astype(np.float64)
        far = ((points[:, None] - middle) ** 2).sum(axis=2)
        near = np.argpartition(far, 8, axis=1)[:, :8]
        weights = _barycentric(points[:, None], a[near], b[near], c[near])
        places = np.einsum("pkc,pkcx->pkx", weights, np.stack([a[near], b[near], c[near]], axis=2))
        best = ((points[:, None] - places) ** 2).sum(axis=2).argmin(axis=1)[:, None]
        face = np.take_along_axis(near, best, axis=1)[:, 0]
        weight = np.take_along_axis(weights, best[..., None], axis=1)[:, 0]
        found = np.einsum("pc,pcx->px", weight, small_colors[faces[face]].astype(np.float64))
        squares.append(((found - colors[part]) ** 2).mean(axis=1))
    return float(np.sqrt(np.concatenate(squares).mean()))


def _barycentric(points: Any, a: Any, b: Any, c: Any) -> Any:
    """Of the points above triangles; those beside one are brought to its border."""
    normal = np.cross(b - a, c - a)
    size = (normal**2).sum(axis=-1)
    u = (np.cross(c - b, points - b) * normal).sum(axis=-1) / size
    v = (np.cross(a - c, points - c) * normal).sum(axis=-1) / size
    weights = np.clip(np.stack([u, v, 1 - u - v], axis=-1), 0, None)
    return weights / weights.sum(axis=-1, keepdims=True)


@pytest.mark.parametrize("percent", [4, 25])
def test_colors_are_as_good_as_in_memory(percent: int, mesh: Any, source: Path, first: Any, tmp_path: Path) -> None:
    """Also where the result is refined in blocks."""
    colors = painted(mesh[0])
    _, report = first if percent == 4 else simplified(source, tmp_path / "small.ply", percent)
    output = tmp_path / "small.ply"
    if percent == 4:
        output.write_bytes(first[0])
    assert report.notes == [] or "refined in blocks" in report.notes[0]
    assert len(report.rounds) >= 1
    vertices, faces, after = read_painted(output)
    assert after.shape == (report.vertices, 3)
    in_memory = ls.simplify(*mesh, target_percent=percent, vertex_attributes={"color": colors}, threads=1)
    wanted = color_rms(mesh[0], colors, *in_memory, in_memory.vertex_attributes["color"])
    assert color_rms(mesh[0], colors, vertices, faces, after) < COLOR_RMS * wanted
    assert report.rms < RMS * in_memory.report.rms


@pytest.mark.parametrize("arguments", [("--workers", "1"), ("--workers", "3", "--chunk-faces", "3500")])
def test_the_bytes_depend_neither_on_workers_nor_on_chunks(
    arguments: tuple[str, ...], source: Path, first: Any, tmp_path: Path
) -> None:
    words = ("--percent", "4", "--block-faces", BLOCK, *arguments, "--no-measure-error")
    done = run_command("huge", source, tmp_path / "small.ply", *words)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "small.ply").read_bytes() == first[0]


def test_a_run_that_was_stopped_goes_on_with_its_colors(source: Path, first: Any, tmp_path: Path) -> None:
    def stop(stage: str, done: int, _total: int) -> None:
        if stage == "collapse" and done == 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        simplified(source, tmp_path / "small.ply", 4, progress=stop)
    assert simplified(source, tmp_path / "small.ply", 4)[0] == first[0]


def test_what_fits_is_painted_as_by_simplify(mesh: Any, source: Path, tmp_path: Path) -> None:
    """With attributes that guide, and where vertices keep theirs."""
    for keep in (True, False):
        ls.simplify_huge(source, tmp_path / "small.ply", target_faces=2000, block_faces=FACES, keep_attributes=keep)
        colors = {"color": painted(mesh[0])}
        in_memory = ls.simplify(*mesh, target_faces=2000, vertex_attributes=colors, keep_attributes=keep)
        vertices, faces, after = read_painted(tmp_path / "small.ply")
        assert np.array_equal(vertices, in_memory.vertices)
        assert np.array_equal(faces, in_memory.faces)
        assert np.array_equal(after, in_memory.vertex_attributes["color"])


def test_vertices_keep_their_colors_where_these_are_not_to_be_kept_up(mesh: Any, source: Path, tmp_path: Path) -> None:
    """Each color of the result is one that the input has."""
    simplified(source, tmp_path / "small.ply", 4, keep_attributes=False)
    after = read_painted(tmp_path / "small.ply")[2]
    assert {tuple(row) for row in after.tolist()} <= {tuple(row) for row in painted(mesh[0]).tolist()}


@pytest.mark.parametrize("largest", [1, 255, 65535])
def test_colors_of_other_types_become_bytes_as_simplify_makes_them(largest: int, mesh: Any, tmp_path: Path) -> None:
    """What real numbers mean is known from all of them: of the faces that are read here none is bright."""
    vertices, faces = mesh
    numbers = largest * np.linspace(0, 1, len(vertices)) ** 2
    colors = np.stack([numbers, numbers[::-1], numbers * 0, numbers], axis=1)
    colors = colors.astype(np.uint16 if largest > 255 else np.float32)
    write_ply(tmp_path / "mesh.ply", vertices, faces, colors=colors, order=">")
    source = PlySource(str(tmp_path / "mesh.ply"))
    assert (source.colors, source.notes) == (4, [])
    boxes = [source.bounds(begin, begin + 5000) for begin in range(0, len(vertices), 5000)]
    brightest = [max(box.brightest[k] for box in boxes) for k in range(4)]
    chunk = source.chunk(0, 50, brightest)
    wanted = [as_bytes(colors[:, k], colors.dtype.str[1:])[chunk.ids] for k in range(4)]
    assert np.array_equal(chunk.colors, np.stack(wanted, axis=1))
    assert chunk.colors[:, 1].min() > 250


def test_a_weight_means_the_same_in_each_part() -> None:
    """Of a part whose faces are expected four times as large as those of the whole half the weight, twice as large
    coordinates or not: in its own frame a color then counts as the same length."""
    vertices, faces = torus(40, 25)
    mesh = MeshArrays(vertices, faces.astype(np.uint32))
    area = counted_area(vertices, faces, 4.0) * 16 / 2**40
    assert area == pytest.approx(sum(counted_area(vertices, faces[k::3], 4.0) for k in range(3)) * 16 / 2**40, rel=1e-9)
    assert weight_in_part(1, expected_face(area, 400, 2000), mesh, 100) == pytest.approx(0.5, rel=1e-5)
    assert weight_in_part(1, expected_face(area, 100, 2000), mesh, 100) == pytest.approx(1, rel=1e-5)
    assert expected_face(area, 1, 2000) == expected_face(area, 40, 2000)  # as the engine expects a fiftieth at least
    assert weight_in_part(1, 0, mesh, 100) == 1


def test_areas_of_tiny_meshes_are_counted() -> None:
    vertices, faces = torus(40, 25)
    area = counted_area(vertices, faces, 4.0)
    assert counted_area(1e-170 * vertices.astype(np.float64), faces, 4e-170) == pytest.approx(area, rel=1e-12)


def test_fixed_vertices_keep_the_bits_of_their_colors() -> None:
    """Other blocks have them, too."""
    vertices, faces = torus(40, 25)
    colors = (painted(vertices) / np.float32(255)).astype(np.float32)
    fixed = np.arange(len(vertices)) % 25 == 0
    mesh = MeshArrays(vertices, faces.astype(np.uint32), fixed, shared_seams=True)
    parameters = {"target_faces": 600, "effort": 0, "attribute_weight": 1, "threads": 1, "feature_weight": 2}
    outcome, after = run_with_colors(mesh, colors, parameters, guide=True)
    assert after is not None
    kept = fixed[outcome.vertex_origin]
    assert np.count_nonzero(kept) == np.count_nonzero(fixed)
    assert np.array_equal(after[kept], colors[outcome.vertex_origin][kept])
    assert not np.array_equal(after[~kept], colors[outcome.vertex_origin][~kept])


def test_colors_take_memory() -> None:
    plain, colored = (sizes_for(2 << 30, None, colored=colored) for colored in (False, True))
    assert colored.block < plain.block
    assert colored.last < plain.last
    assert colored.block_memory(1000) > plain.block_memory(1000)
    # Each fits into the share that it is made for.
    assert 4 * colored.block_memory(colored.block) <= 2 << 30
    assert colored.last_memory(colored.last) <= 2 << 30
