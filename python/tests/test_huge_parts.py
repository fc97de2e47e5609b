# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of what simplifies huge meshes, on meshes whose answers are known."""

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from huge_meshes import torus, write_ply

pytest.importorskip("distributed")

from laplacian_simplify.files.errors import MeshFileError
from laplacian_simplify.huge import finish, surface_library, tasks
from laplacian_simplify.huge.array_file import ArrayFile, is_whole, save_arrays
from laplacian_simplify.huge.collapse import Engine
from laplacian_simplify.huge.comparison import Surface, nearest_in_parts
from laplacian_simplify.huge.edges import edges_between_blocks, edges_of_block
from laplacian_simplify.huge.gather import count_foreign, gather
from laplacian_simplify.huge.grid import SIDE, CellTable, Grid, Layout, cells_of, paths_of
from laplacian_simplify.huge.layout import Histogram, divide
from laplacian_simplify.huge.plan import block_memory, common_cost, held_back, next_round, shares, sizes_for
from laplacian_simplify.huge.ply_source import PlySource
from laplacian_simplify.huge.report import HugeReport
from laplacian_simplify.huge.runs import _without_leftovers
from laplacian_simplify.huge.samples import spread
from laplacian_simplify.huge.scatter import scatter
from laplacian_simplify.huge.stages import Task
from laplacian_simplify.huge.welding import check_collisions, hashed
from laplacian_simplify.huge.work_folder import SchedulerGoneError, WorkFolder
from laplacian_simplify.options import as_option
from laplacian_simplify.report import StopReason

SQUARE = np.array([[0.0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]])
TWO = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)


def test_distances_to_a_square() -> None:
    points = np.array([[1.0, 1, 3], [7, 4, 4], [2, 2, 0], [-3, -4, 0]])
    # The search is in single precision where it decides, the distance in double.
    assert surface_library.distances(SQUARE, TWO, points, 2) == pytest.approx([3, 5, 0, 5], rel=1e-14, abs=1e-14)


class InThisProcess:
    """Stages whose tasks are done at once."""

    def __init__(self, folder: Path) -> None:
        self.path, self.keys, self.work, self.most = folder, [], self, 1000

    def do(self, _stage: str, key: str, given: list[Task]) -> list[dict[str, object]]:
        self.keys.append((key, len(given)))
        assert len(self.keys) <= self.most
        return [tasks.run(print, task.function, {"folder": str(self.path), **task.arguments}) for task in given]


def test_distances_to_a_surface_in_parts_are_those_to_the_whole(tmp_path: Path) -> None:
    """However small the reach is that is tried first; parts that are far from all points are not looked at."""
    offsets = np.array([0.0, 40, 1000, -6])
    surfaces = []
    for k, x in enumerate(offsets):
        positions = SQUARE + np.array([x, 0, 0])
        triangles = TWO[: 1 if k == 0 else 2]  # the first one lacks a corner of its box
        save_arrays(tmp_path / f"{k}.block", {"positions": positions, "triangles": triangles})
        box = {"low": positions.min(axis=0).tolist(), "high": positions.max(axis=0).tolist()}
        surfaces.append(Surface([], f"{k}.block", box, 2))
    points = np.array([[2.0, 2, 0.01], [3, 2, 3], [19, 2, 0], [26, 2, 0], [42, 2, 0], [-0.05, 4, 0]])
    stages = InThisProcess(tmp_path)
    found = nearest_in_parts(stages, "there", surfaces, points, 0.1, "mesh")
    assert found == pytest.approx([0.01, 3, 15, 14, 0, 1.95], rel=1e-12)
    assert stages.keys[0] == ("there-0", 2)
    assert len(stages.keys) > 2


def test_a_reach_of_nothing_gets_wider(tmp_path: Path) -> None:
    """As of a result whose faces have no area."""
    save_arrays(tmp_path / "0.block", {"positions": np.zeros((3, 3)), "triangles": TWO[:1]})
    surfaces = [Surface([], "0.block", {"low": [0.0] * 3, "high": [0.0] * 3}, 1)]
    stages = InThisProcess(tmp_path)
    stages.most = 20
    assert nearest_in_parts(stages, "there", surfaces, np.array([[0.0, 3, 4]]), 0, "mesh") == pytest.approx([5])


def test_the_descriptor_sees_the_tip() -> None:
    """A pyramid: flat nowhere, and the borders of a square in a plane are."""
    assert surface_library.descriptor(SQUARE, TWO) == pytest.approx(np.zeros(4), abs=1e-12)
    tip = np.append(SQUARE, [[2.0, 2, 5]], axis=0)
    fan = np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]], np.uint32)
    assert np.argmax(surface_library.descriptor(tip, fan)) == 4


def test_edges_within_and_between_blocks() -> None:
    """Two squares with a common side, each a block, and a fin on that side in the first one."""
    ids = np.array([10, 11, 12, 13, 20])
    positions = np.append(SQUARE, [[4.0, 2, 3]], axis=0)
    fixed = np.array([False, True, True, False, False])
    first = edges_of_block(ids, positions, np.append(TWO, [[1, 2, 4]], axis=0).astype(np.uint32), fixed)
    assert (first.boundary, first.non_manifold) == (5, 0)
    assert first.shared["edge_ends"].tolist() == [[11, 12]]
    assert first.shared["edge_faces"].tolist() == [2]
    second = edges_of_block(
        np.array([11, 12, 15, 16]), SQUARE, np.array([[0, 1, 3], [1, 2, 3]], np.uint32), np.arange(4) < 2
    )
    both = [first.shared, second.shared]
    ends, faces = [row["edge_ends"] for row in both], [row["edge_faces"] for row in both]
    assert edges_between_blocks(ends, faces) == (0, 1)
    assert edges_between_blocks(ends[1:], faces[1:]) == (1, 0)
    assert edges_between_blocks([], []) == (0, 0)


def test_samples_are_spread_by_area() -> None:
    """One of two triangles has a hundredth of the area."""
    positions = np.array([[0.0, 0, 0], [10, 0, 0], [0, 10, 0], [20, 0, 0], [21, 0, 0], [20, 1, 0]])
    points, area = spread(positions, np.array([[0, 1, 2], [3, 4, 5]]), 1010)
    assert area == pytest.approx(50.5)
    assert np.count_nonzero(points[:, 0] >= 20) == 10
    assert (points[:, 0] + points[:, 1] <= np.where(points[:, 0] >= 20, 21, 10) + 1e-9).all()


def test_areas_add_up_in_single_precision_too() -> None:
    """A strip of faces with equal areas, each a 40,000th: single precision loses much of that on the way."""
    count = 20_000
    x = np.arange(count + 1, dtype=np.float32) / count
    positions = np.stack(
        [np.tile(x, 2), np.repeat(np.float32([0, 1]), count + 1), np.zeros_like(x, shape=2 * count + 2)]
    )
    a = np.arange(count)
    b = a + count + 1
    faces = np.concatenate([np.stack([a, a + 1, b], axis=1), np.stack([a + 1, b + 1, b], axis=1)])
    # Coordinates have 24 bits: what is left is theirs, and the sum of widths is exact.
    assert spread(positions.T, faces, 1)[1] == pytest.approx(1, rel=1e-7)


def test_the_last_run_asks_for_no_threads_that_gain_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where address space is bounded the stacks of so many may not fit, which ends the process."""
    write_ply(tmp_path / "two.ply", SQUARE, TWO)
    asked: list[float] = []

    def run(_engine: Engine, _mesh: object, _colors: object, parameters: dict[str, float]) -> None:
        asked.append(parameters["threads"])
        raise InterruptedError

    monkeypatch.setattr(Engine, "run", run)
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: range(64))
    item = ["input", str(tmp_path / "two.ply"), 0, 2]
    with pytest.raises(InterruptedError):
        finish.last_run(tmp_path, [], item, 1, False, False, Engine(2, 0, 0), 0, "two", "last.block")
    assert asked == [1]


def test_the_memory_of_who_started_the_process_does_not_count(tmp_path: Path) -> None:
    write_ply(tmp_path / "two.ply", SQUARE, TWO)
    child = (
        "import sys; from pathlib import Path; from laplacian_simplify.huge import tasks\n"
        "source = {'source': sys.argv[1], 'begin': 0, 'end': 4, 'folder': '.'}\n"
        "print(tasks.run(print, 'bounds', source)['peak_memory'])"
    )
    parent = (
        "import subprocess, sys; large = b'x' * (1 << 30)\n"
        "subprocess.run([sys.executable, '-c', *sys.argv[1:]], check=True)"
    )
    done = subprocess.run(
        [sys.executable, "-c", parent, child, tmp_path / "two.ply"], capture_output=True, text=True, check=True
    )
    assert 1 << 20 < int(done.stdout) < block_memory(0)  # what is planned for a process before it reads anything


def test_whole_numbers_of_32_bits_keep_them(tmp_path: Path) -> None:
    """Single precision has 24, which are enough for those of 16."""
    for name, kind, is_single in (("int", "<i4", False), ("ushort", "<u2", True), ("float", "<f4", True)):
        largest = 2**24 + 1 if name == "int" else 1001
        rows = np.array([[0, 0, 0], [largest, 0, 0], [0, largest, 0]], kind)
        head = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n"
        head += "".join(f"property {name} {axis}\n" for axis in "xyz")
        head += "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
        face = 2 * (b"\3" + np.array([0, 1, 2], "<i4").tobytes())
        (tmp_path / "mesh.ply").write_bytes(head.encode() + rows.tobytes() + face)
        source = PlySource(str(tmp_path / "mesh.ply"))
        assert source.single == is_single
        assert np.array_equal(source.chunk(0, 2).positions, rows)


def test_a_work_folder_that_is_removed_in_part_begins_anew(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As one is where a run is killed while it removes it."""
    folder = tmp_path / "work"

    def killed(*_: object, **__: object) -> None:
        raise InterruptedError

    with WorkFolder(folder, {"input": "one"}) as work:
        work.add("checksums", [1])
        (folder / "0.block").write_bytes(b"")
        plain = Path.unlink
        monkeypatch.setattr(
            Path, "unlink", lambda path, **how: (killed if path.suffix == ".block" else plain)(path, **how)
        )
        with pytest.raises(InterruptedError):
            work.remove()
        monkeypatch.undo()
    with WorkFolder(folder, {"input": "another"}) as work:
        assert work.get("checksums") is None


def test_what_is_done_is_kept_where_the_scheduler_is_gone(tmp_path: Path) -> None:
    """However little it is; where the input is refused, that little is removed."""
    for error, is_kept in ((SchedulerGoneError("gone"), True), (MeshFileError("refused"), False)):
        with WorkFolder(tmp_path / "work", {}) as work:
            with pytest.raises(MeshFileError), _without_leftovers(work):
                raise error
            assert (tmp_path / "work").exists() == is_kept


def test_the_report_spells_remedies_as_its_reader_does() -> None:
    numbers = dict.fromkeys(("dropped_faces", "peak_memory", "seconds", "non_manifold_edges", "vertices"), 0)
    report = HugeReport(
        **numbers, faces_before=100, faces=60, target_reached=False, stop_reason=StopReason.NO_LEGAL_COLLAPSE,
        boundary_edges=40, rounds=[], processor_seconds={}, notes=[],
    )  # fmt: skip
    assert "boundary='free' lets borders shrink" in str(report)
    assert "--boundary free lets borders shrink" in report.text(as_option)
    apart = replace(report, boundary_edges=180)
    assert str(apart).splitlines()[0].endswith("180 of 180 edges are open: the faces share no vertices")


def test_cells_of_a_level_are_within_those_above() -> None:
    grid = Grid.around([-1.0, 5.0, 0.0], [3.0, 6.0, 0.5])
    places = grid.places(np.array([[-1.0, 5, 0], [3, 6, 0.5], [1.01, 5.5, 0.25]]))
    assert places[0].tolist() == [0, 0, 0]
    assert places[1, 0] == SIDE**3 - 1  # the far side is inside
    assert (paths_of(places, 2) >> 21 == paths_of(places, 1)).all()
    assert (paths_of(places, 1) >> 21 == cells_of(places, 0)).all()


def test_a_divided_cell_has_a_table_of_its_own() -> None:
    grid = Grid.around([0.0, 0, 0], [1.0, 1, 1])
    tables = np.zeros((2, SIDE**3), np.int32)
    tables[0, 0], tables[1] = -3, 7
    tables[1, 0] = 9
    points = np.array([[0.5, 0.5, 0.5], [0.007, 0, 0], [0.0, 0, 0]])
    assert CellTable(tables).at(grid.places(points)).tolist() == [0, 7, 9]


def _histogram(faces: dict[tuple[int, int, int], int]) -> Histogram:
    histogram = Histogram()
    for cell, count in faces.items():
        histogram.faces[cell] = count
    return histogram


def test_blocks_have_at_most_so_many_faces_and_planes_avoid_seams() -> None:
    histogram = _histogram({(i, 0, 0): 10 for i in range(20)})
    plain = divide(histogram, 120)
    assert sorted(plain.sizes) == [100, 100]
    assert sum(plain.sizes) == histogram.total
    histogram.seams[9:11, 0, 0] = 30
    moved = divide(histogram, 120)
    cut = int(np.flatnonzero(np.diff(moved.blocks[0].reshape((SIDE,) * 3)[:20, 0, 0]))[0])
    assert cut not in (8, 9, 10)
    assert max(moved.sizes) <= 120


def test_a_full_cell_is_divided_by_the_level_below() -> None:
    histogram = _histogram({(3, 4, 5): 100, (90, 90, 90): 5})
    path = (3 * SIDE + 4) * SIDE + 5
    assert histogram.too_full(0, 40) == [path]
    histogram.add_inner(0, (path << 21) + np.arange(10), np.full(10, 10))
    division = divide(histogram, 40)
    assert sum(division.sizes) == 105
    assert max(division.sizes) <= 40
    assert len(division.blocks) == 2
    del histogram.inner[(0, path)]
    with pytest.raises(MeshFileError, match="more than 40 faces are at one place"):
        divide(histogram, 40)


def test_every_face_is_in_one_block_and_knows_which_vertices_are_shared(tmp_path: Path) -> None:
    vertices, faces = torus(60, 40)
    write_ply(tmp_path / "torus.ply", vertices, faces)
    grid = Grid.around(vertices.min(axis=0).tolist(), vertices.max(axis=0).tolist())
    histogram = Histogram()
    centroids = grid.centroid_places(vertices, faces)
    cells, counts = np.unique(cells_of(centroids, 0), return_counts=True)
    histogram.add(cells, counts)
    division = divide(histogram, 1000)
    Layout.save(tmp_path / "0.layout", division.blocks, division.pilots)
    parts: dict[int, list[list[object]]] = {}
    for k, begin in enumerate(range(0, len(faces), 700)):
        item = ["input", str(tmp_path / "torus.ply"), begin, min(begin + 700, len(faces))]
        for number, *row in scatter(tmp_path, item, grid, "0.layout", True, f"{k}.chunk")["toc"]:
            parts.setdefault(number, []).append([f"{k}.chunk", *row])
    found, users, fixed_in = [], [set() for _ in vertices], [set() for _ in vertices]
    home = Layout.read(tmp_path / "0.layout").blocks.at(grid.places(vertices))
    for block, size in enumerate(division.sizes):
        mesh = gather(tmp_path, parts[block], "torus")
        assert np.array_equal(mesh.positions, vertices[mesh.ids])
        assert len(mesh.triangles) == size
        assert count_foreign(tmp_path, parts[block]) == len(mesh.foreign)
        assert len(gather(tmp_path, parts[-1 - block], "torus").triangles) > 0
        found.append(mesh.ids[mesh.triangles])
        for vertex in mesh.ids:
            users[vertex].add(block)
            if home[vertex] != block or vertex in mesh.foreign:
                fixed_in[vertex].add(block)
    assert np.array_equal(np.sort(np.concatenate(found), axis=0), np.sort(faces, axis=0))
    assert all(fixed == used for used, fixed in zip(users, fixed_in, strict=True) if len(used) > 1)
    alone = sum(len(used) == 1 for used in users)
    fixed_alone = sum(len(used) == 1 and bool(fixed) for used, fixed in zip(users, fixed_in, strict=True))
    assert fixed_alone < 0.1 * alone  # few too many


def test_one_cost_for_all_blocks() -> None:
    """Blocks of 1,000 faces, of which one keeps a share of 1 / cost and the other of 1 / (100 cost)."""
    cost = np.geomspace(1, 1e4, 50)
    pilots = [
        {"block": 0, "curve": np.stack([100 * cost, 1 / cost], axis=1).tolist()},
        {"block": 1, "curve": np.stack([cost, 1 / cost], axis=1).tolist()},
    ]
    # 1000 * 100 / c + 1000 / c = 202: what is left of the first is a hundred times as much.
    assert common_cost(pilots, [1000, 1000], 202) == pytest.approx(500, rel=1e-3)


def test_shares_add_up() -> None:
    surveys = [
        {"faces": 1000, "curve": [(1.0, 900), (10.0, 300), (100.0, 100)]},
        {"faces": 333, "curve": [(1.0, 330), (10.0, 320), (100.0, 90)]},
        {"faces": 50, "curve": []},
    ]
    for target in (1200, 700, 301):
        assert sum(shares(surveys, target)) == target
    assert sum(shares(surveys, 5)) == 100 + 90 + 50  # what the seams hold


def test_rounds() -> None:
    sizes = sizes_for(2 << 30, None)
    assert sizes.block > 1_000_000
    assert next_round(sizes.last, 1000, sizes, []) is None
    first = next_round(17_000_000, 170_000, sizes, [])
    assert first is not None
    assert (first.kind, first.goal) == ("collapse", 12 * 170_000)
    largest = max(target for target in range(100_000, sizes.last, 10_000) if sizes.in_memory(target))
    least = next_round(100_000_000, largest, sizes, [])
    assert least is not None
    assert least.goal >= 2.5 * largest  # what the last run sees
    assert held_back(first, 17_000_000, 300_000) == 10 * 300_000  # seams cannot shrink in their own round
    stuck = [{"kind": "collapse", "before": 9_000_000, "after": 8_900_000}]
    with pytest.raises(MeshFileError, match="give more by --memory"):
        next_round(8_900_000, 340_000, sizes, stuck)
    kinds, done, faces = [], [], 100_000_000
    while plan := next_round(faces, 5_000_000, sizes, done):
        kinds.append(plan.kind)
        done.append({"kind": plan.kind, "before": faces, "after": plan.goal})
        faces = plan.goal
    assert kinds == ["collapse", "first", "second"]
    assert faces == 5_000_000


def test_different_vertices_with_one_hash_are_refused() -> None:
    points = np.array([[1, 2, 3], [1, 3, 2], [2, 1, 3], [0, 0, 0]], np.float32)
    assert len(set(hashed(points).tolist())) == 4
    assert (hashed(points) >= 0).all()
    with pytest.raises(MeshFileError, match="two different vertices have the same hash"):
        check_collisions(points, points[::-1], "mesh.stl")


def test_files_of_arrays(tmp_path: Path) -> None:
    arrays = {"a": np.arange(12.0).reshape(4, 3), "none": np.empty((0, 2), np.int64), "b": np.arange(5, dtype=np.int32)}
    written = save_arrays(tmp_path / "x.block", arrays)
    file = ArrayFile(tmp_path / "x.block")
    for name, array in arrays.items():
        assert np.array_equal(file.read(name), array)
        assert file.read(name).dtype == array.dtype
    assert file.read("a", 1, 3).tolist() == arrays["a"][1:3].tolist()
    assert is_whole(tmp_path, written)
    with (tmp_path / "x.block").open("r+b") as stream:
        stream.seek(-1, 2)
        stream.write(b"\7")
    assert not is_whole(tmp_path, written)
    (tmp_path / "x.block").write_bytes(b"\xff" * 9)
    with pytest.raises(MeshFileError, match="is damaged"):
        ArrayFile(tmp_path / "x.block")
