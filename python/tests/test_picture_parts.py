# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What pictures and pages are made of: divided faces, the scale of colors, the view, and the checks before all work."""

import ctypes
import re
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import laplacian_simplify as ls
from laplacian_simplify.comparison.distances import Distances, OneWay
from laplacian_simplify.comparison.surface import Surface, checked_surface
from laplacian_simplify.pictures import outputs
from laplacian_simplify.pictures.error_map import color_limit, divide, error_map
from laplacian_simplify.pictures.histogram import shares
from laplacian_simplify.pictures.scene import Facts, Scene, titled
from laplacian_simplify.pictures.view import view_of

SQUARE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
TWO = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)


def areas(positions: np.ndarray, faces: np.ndarray) -> np.ndarray:
    a, b, c = (positions[faces[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def longest(positions: np.ndarray, faces: np.ndarray) -> float:
    edges = [positions[faces[:, k]] - positions[faces[:, k - 1]] for k in range(3)]
    return float(np.linalg.norm(edges, axis=-1).max())


@pytest.mark.parametrize("edge", [0.6, 0.2, 0.05])
def test_divided_faces_cover_the_same_and_have_short_edges(edge: float) -> None:
    small = np.array([[0.0, 0, 1], [0.01, 0, 1], [0, 0.01, 1]])
    positions, faces = np.concatenate([SQUARE, small]), np.concatenate([TWO, [[4, 5, 6]]]).astype(np.uint32)
    points, parts = divide(positions, faces, edge, 10**6)
    np.testing.assert_array_equal(points[:7], positions)
    assert [4, 5, 6] in parts.tolist()  # short enough as it is
    assert longest(points, parts) <= edge
    inside = areas(points, parts)
    assert inside.sum() == pytest.approx(areas(positions, faces).sum())
    assert inside.min() > 0
    center = np.average(points[parts].mean(axis=1), axis=0, weights=inside)
    np.testing.assert_allclose(
        center, np.average(positions[faces].mean(axis=1), axis=0, weights=areas(positions, faces)), atol=1e-12
    )


def test_no_more_faces_than_allowed() -> None:
    for most in (2, 3, 8, 1000):
        assert 2 <= len(divide(SQUARE, TWO, 1e-3, most)[1]) <= most
    assert len(divide(SQUARE, TWO, 1e-3, 1000)[1]) > 500  # and not far fewer


def test_the_middle_of_a_large_face_shows_its_distance() -> None:
    """Corners on the other surface, and a dent of 0.3 between them."""
    dent = np.concatenate([SQUARE, [[0.5, 0.5, -0.3]]])
    fan = np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]], np.uint32)
    shown = error_map(Surface("flat", SQUARE, TWO), Surface("dent", dent, fan), 5000)
    assert shown.errors[:4].max() == 0
    assert shown.errors.max() > 0.15
    assert len(shown.faces) == 2
    assert 1000 < len(shown.divided) <= 5000


def way(distances: list[float]) -> OneWay:
    return OneWay(np.array(distances), np.zeros(1), 1.0)


def test_the_scale_ends_at_a_round_number_that_nearly_all_is_within() -> None:
    values = np.linspace(0, 1, 1001)
    found = Distances(way(values.tolist()), way(values.tolist()), None)
    limit = color_limit(found, 50)  # a percent is 0.5
    assert limit == pytest.approx(1.0)  # 1.99 percent become 2
    assert shares(found.forward, limit)[1] == 0
    spiky = Distances(way([0.1] * 999 + [90.0]), way([0.1] * 1000), None)
    assert color_limit(spiky, 50) == pytest.approx(0.1)
    assert shares(spiky.forward, 0.1)[1] == pytest.approx(0.1)  # percent
    assert shares(spiky.forward, 0.1)[0].sum() == pytest.approx(99.9)


@pytest.mark.parametrize("diagonal", [0.0, 1e-30, 7.0])
def test_equal_surfaces_have_a_scale_too(diagonal: float) -> None:
    found = Distances(way([0.0] * 10), way([0.0] * 10), None)
    assert color_limit(found, diagonal) == pytest.approx((diagonal / 100 or 1) * 1e-4, rel=1e-9)


@pytest.mark.parametrize("thin", [0, 1, 2])
def test_a_plate_shows_its_face(thin: int) -> None:
    size = np.ones(3)
    size[thin] = 0.02
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]) * size
    plate = checked_surface("plate", corners + 1000, np.array([[0, 3, 7], [0, 4, 7]]))
    view = view_of(plate, plate)
    assert np.argmax(np.abs(view.direction)) == thin
    assert view.direction[2] > 0  # from above
    assert view.up[2] > 0
    assert np.linalg.norm(view.direction) == pytest.approx(1)
    assert view.up @ view.direction == pytest.approx(0, abs=1e-12)
    placed = view.placed(plate.positions)
    assert np.linalg.norm(np.ptp(placed, axis=0)) == pytest.approx(1)
    assert np.abs((placed - view.middle) @ view.up).max() == pytest.approx(view.height / 2)


def test_names_of_any_bytes_can_be_drawn(tmp_path: Path) -> None:
    name = str(tmp_path / "caf\udce9.off")
    Scene(checked_surface(name, SQUARE, TWO), checked_surface("B", SQUARE, TWO)).save(tmp_path / "scene.npz")
    assert Scene.load(tmp_path / "scene.npz").before.name == "caf?.off"
    facts = Facts.of_run([], {"input": name}, {})
    assert facts.numbers == [("input", name.replace("\udce9", "?"))]


@pytest.mark.parametrize("last", [[2.0, 0, 1], [0.0, 1, 1]])  # up and down, and to the sides
def test_what_is_seen_is_in_the_middle(last: list[float]) -> None:
    """Also where it is not the middle of the box."""
    corner = Surface("corner", np.array([[0.0, 0, 0], [2, 0, 0], last]), np.array([[0, 1, 2]], np.uint32))
    view = view_of(corner, corner)
    across = np.cross(view.up, view.direction)
    for axis, size in ((view.up, view.height), (across, view.width)):
        seen = (view.placed(corner.positions) - view.middle) @ axis
        assert (seen.min(), seen.max()) == pytest.approx((-size / 2, size / 2))


def test_what_has_no_name_is_called_by_its_letter() -> None:
    assert titled("A", "A") == "A"
    assert titled("A", "part.stl") == "A: part.stl"


def test_a_missing_library_is_an_answer_before_any_work(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Before the files are looked for, which are not there."""
    monkeypatch.setattr(outputs, "find_spec", lambda name: None if name == "pyvista" else find_spec(name))
    with pytest.raises(ImportError, match=re.escape("python -m pip install 'laplacian-simplify[pictures]'")):
        ls.compare("missing.ply", "missing.ply", picture=tmp_path / "out.png")
    with pytest.raises(OSError, match=r"missing\.ply"):
        ls.compare("missing.ply", "missing.ply")


def test_so_is_a_missing_library_of_the_system(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def none(name: str) -> Any:
        raise OSError(name)

    monkeypatch.setattr(ctypes, "CDLL", none)
    with pytest.raises(ImportError, match="apt-get install libegl1"):
        ls.compare("missing.ply", "missing.ply", report=tmp_path / "out.html")


def test_osmesa_is_taken_where_there_is_no_egl(monkeypatch: pytest.MonkeyPatch) -> None:
    def only_osmesa(name: str) -> None:
        if "OSMesa" not in name:
            raise OSError(name)

    monkeypatch.setattr(ctypes, "CDLL", only_osmesa)
    assert outputs.off_screen_window() == "vtkOSOpenGLRenderWindow"


def test_names_are_checked_before_any_work(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"^picture .*out.jpg: a picture is PNG, so its name has to end with .png"):
        ls.compare("missing.ply", "missing.ply", picture=tmp_path / "out.jpg")
    with pytest.raises(ValueError, match=r"^report .*out.png: the page is HTML"):
        ls.compare("missing.ply", "missing.ply", report=tmp_path / "out.png")
    with pytest.raises(OSError, match="is not a folder"):
        ls.compare("missing.ply", "missing.ply", report=tmp_path / "nowhere" / "out.html")
