# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""OFF: polygons of any number of corners, colors, and damage that is named."""

from pathlib import Path

import numpy as np
import pytest
from mesh_files import BOX, QUADS, TRIANGLES, VOLUME, off
from reading_checks import area, arrays, assert_refused, reading_of, volume

PLAIN = off()
GOLDEN = (1 + 5**0.5) / 2


def dodecahedron() -> str:
    """Twelve pentagons around the cube of edge 2."""
    points = np.array(
        [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
        + [tuple(np.roll((0, a / GOLDEN, b * GOLDEN), k)) for k in range(3) for a in (-1, 1) for b in (-1, 1)]
    )
    faces = []
    for axis in (np.roll((0, a * GOLDEN, b), k) for k in range(3) for a in (-1, 1) for b in (-1, 1)):
        corners = np.argsort(points @ axis)[-5:]
        middle = points[corners].mean(axis=0)
        u = points[corners[0]] - middle
        v = np.cross(middle, u)
        angles = np.arctan2((points[corners] - middle) @ v / np.linalg.norm(middle), (points[corners] - middle) @ u)
        faces.append(corners[np.argsort(angles)].tolist())
    return off(points.tolist(), faces)


def test_pentagons(tmp_path: Path) -> None:
    edge = 2 / GOLDEN
    reading = reading_of(tmp_path / "dodecahedron.off", dodecahedron())
    assert len(arrays(reading)[1]) == 36
    assert volume(reading) == pytest.approx((15 + 7 * 5**0.5) / 4 * edge**3)


@pytest.mark.parametrize(
    "content",
    [
        pytest.param(PLAIN, id="quads"),
        pytest.param(off(faces=TRIANGLES), id="triangles"),
        pytest.param(off(faces=[*TRIANGLES[:3], *QUADS[3:], *[[q[0], q[2], q[3]] for q in QUADS[:3]]]), id="mixed"),
        pytest.param(PLAIN.replace("OFF\n8 6 0", "OFF 8 6 0"), id="counts on the first line"),
        pytest.param(PLAIN.replace("8 6 0", "8 6"), id="no number of edges"),
        pytest.param("# a box\n" + PLAIN.replace("\n", " # c\n"), id="comments"),
        pytest.param(PLAIN.replace("\n", "\r\n"), id="CRLF"),
        pytest.param(PLAIN.replace("\n", "\r"), id="CR"),
        pytest.param("\ufeff" + PLAIN, id="byte order mark"),
        pytest.param(PLAIN.replace("\n", "\n\n \n"), id="empty lines"),
        pytest.param(PLAIN.rstrip("\n"), id="no line end at the end"),
    ],
)
def test_spellings(content: str, tmp_path: Path) -> None:
    reading = reading_of(tmp_path / "box.off", content)
    assert np.array_equal(arrays(reading)[0], BOX)
    assert volume(reading) == pytest.approx(VOLUME)


def _with(header: str, at_vertices: str = "", at_faces: str = "") -> str:
    lines = PLAIN.splitlines()
    vertices = [line + at_vertices for line in lines[2:10]]
    return "\n".join([header, lines[1], *vertices, *[line + at_faces for line in lines[10:]], ""])


@pytest.mark.parametrize(
    ("content", "vertex", "face"),
    [
        (_with("COFF", " 255 0 128 255"), [1, 0, 0.5, 1], None),
        (_with("COFF", " 255 0 128"), [1, 0, 0.5, 1], None),
        (_with("COFF", " 1.0 0.0 0.5 1.0"), [1, 0, 0.5, 1], None),
        (_with("CNOFF", " 0 0 1 255 0 128 255"), [1, 0, 0.5, 1], None),
        (_with("NCOFF", " 255 0 128 255 0 0 1"), [1, 0, 0.5, 1], None),  # MeshLab's own
        (_with("OFF", "", " 255 0 128"), None, [1, 0, 0.5, 1]),
        (_with("OFF", "", " 1.0 0.0 0.5 1.0"), None, [1, 0, 0.5, 1]),
        (_with("OFF", "", " 17"), None, None),
        (_with("NOFF", " 0 0 1"), None, None),
        (_with("STOFF", " 0.5 0.5"), None, None),
    ],
)
def test_colors(content: str, vertex: list | None, face: list | None, tmp_path: Path) -> None:
    reading = reading_of(tmp_path / "box.off", content)
    mesh = reading.mesh_set.current_mesh()
    assert volume(reading) == pytest.approx(VOLUME)
    assert mesh.has_vertex_color() == (vertex is not None)
    assert mesh.has_face_color() == (face is not None)
    if vertex:
        assert mesh.vertex_color_matrix()[3] == pytest.approx(vertex, abs=0.01)
    if face:
        assert mesh.face_color_matrix()[3] == pytest.approx(face, abs=0.01)


def test_a_concave_polygon_keeps_its_area(tmp_path: Path) -> None:
    star = [(np.cos(k * np.pi / 5) * r, np.sin(k * np.pi / 5) * r, 0) for k in range(10) for r in [2 if k % 2 else 1]]
    expected = 0.5 * 10 * 1 * 2 * np.sin(np.pi / 5)
    for first in range(10):
        faces = [[(first + k) % 10 for k in range(10)]]
        assert area(reading_of(tmp_path / "star.off", off(star, faces))) == pytest.approx(expected)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("OFF", "OFG", "line 1: 'OFG' instead of 'OFF'"),
        ("OFF", "OFF BINARY", "binary OFF is not read"),
        ("OFF", "4OFF", "vertices in more than three dimensions"),
        ("8 6 0", "eight 6 0", "line 2: it has no numbers of vertices and faces"),
        ("8 6 0", "-8 6 0", "line 2"),
        ("8 6 0", "8 7 0", "the file ends after 6 of 7 faces"),
        ("8 6 0", "999999999 6 0", "the file ends after 14 of 999,999,999 vertices"),
        ("8 6 0", "8 5 0", "line 16: it goes on after"),
        ("8 6 0", "7 6 0", "line 16: it goes on after"),
        ("\n0 4 6\n", "\n0 4\n", "line 6, vertex 3: 2 numbers instead of 3"),
        ("\n0 4 6\n", "\n0 4 six\n", "line 6: 'six' is no number"),
        ("\n0 4 6\n", "\n0 4 6,5\n", "line 6: '6,5' has a decimal comma"),
        ("\n0 4 6\n", "\n0 nan 6\n", "vertex 3: 1 vertex with coordinates that are not finite"),
        ("4 4 6 7 5", "4 4 6 7 8", "face 1: vertex index 8 is outside 0..7"),
        ("4 4 6 7 5", "4 4 6 7 -5", "face 1: vertex index -5 is outside 0..7"),
        ("4 4 6 7 5", "4 4 6 7", "line 12, face 1: it announces 4 corners and has 3"),
        ("4 4 6 7 5", "1000000 4 6 7 5", "it announces 1e+06 corners and has 4"),
        ("4 4 6 7 5", "-4 4 6 7 5", "it announces -4 corners"),
        ("4 4 6 7 5", "4 4 6.5 7 5", "line 12, face 1: a vertex index is no whole number"),
    ],
)
def test_damage_is_named(old: str, new: str, said: str, tmp_path: Path) -> None:
    assert_refused(tmp_path / "box.off", PLAIN.replace(old, new, 1), said)
