# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""OBJ: every spelling of corners and lines, and damage that is named with its line."""

from pathlib import Path

import numpy as np
import pytest
from mesh_files import BOX, QUADS, VOLUME, obj
from reading_checks import area, arrays, assert_refused, reading_of, volume

PLAIN = obj()


def _texture_vertices() -> str:
    return "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"


def _faces(corner: str) -> str:
    """The faces with corners by a pattern: {v} is the vertex, {t} the texture vertex."""
    return "".join(
        "f " + " ".join(corner.format(v=vertex + 1, t=k + 1) for k, vertex in enumerate(face)) + "\n" for face in QUADS
    )


VERTICES = PLAIN[: PLAIN.index("f ")]
NORMALS = "".join("vn 0 0 1\n" for _ in BOX)


@pytest.mark.parametrize(
    "content",
    [
        pytest.param("\ufeff" + PLAIN, id="byte order mark"),
        pytest.param("# head\n" + PLAIN.replace("\n", " # c\n"), id="comment after every line"),
        pytest.param(PLAIN.replace("\n", "#c\n"), id="comment without a blank"),
        pytest.param(PLAIN.replace("\n", "\r\n"), id="CRLF"),
        pytest.param(PLAIN.replace("\n", "\r"), id="CR"),
        pytest.param(PLAIN.replace(" ", "\t"), id="tabs"),
        pytest.param(PLAIN.replace(" ", "   ").replace("\n", "  \n"), id="many blanks"),
        pytest.param("  " + PLAIN.replace("\n", "\n   "), id="indented"),
        pytest.param(PLAIN.replace("\n", "\n\n"), id="empty lines"),
        pytest.param(PLAIN.rstrip("\n"), id="no line end at the end"),
        pytest.param(PLAIN.replace("f 1 2", "f 1 \\\n2"), id="a line that goes on"),
        pytest.param("o box\ng side\ns off\n" + PLAIN + "vp 1 2\ncurv 0 1 2\n", id="other statements"),
        pytest.param(PLAIN.replace("v 0 0 0\n", "v 0 0 0 1\n"), id="a fourth coordinate"),
        pytest.param(VERTICES + _texture_vertices() + _faces("{v}/{t}"), id="v/vt"),
        pytest.param(VERTICES + NORMALS + _faces("{v}//{v}"), id="v//vn"),
        pytest.param(VERTICES + NORMALS + _texture_vertices() + _faces("{v}/{t}/{v}"), id="v/vt/vn"),
        pytest.param(VERTICES + _texture_vertices() + _faces("{v}/{t}/"), id="v/vt/"),
        pytest.param(VERTICES + _faces("{v}//"), id="v//"),
        pytest.param(
            VERTICES + _texture_vertices() + NORMALS + _faces("{v}/{t}/{v}").replace("f 1/1/1", "f 1"), id="mixed"
        ),
        pytest.param("".join(f"vn 0 0 1\nv {x} {y} {z}\n" for x, y, z in BOX) + _faces("{v}//{v}"), id="vn before v"),
    ],
)
def test_spellings(content: str, tmp_path: Path) -> None:
    reading = reading_of(tmp_path / "box.obj", content)
    assert np.array_equal(arrays(reading)[0], BOX)
    assert volume(reading) == pytest.approx(VOLUME)


def test_indices_below_zero_count_from_where_they_stand(tmp_path: Path) -> None:
    first, second = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n", "v 5 0 0\nv 6 0 0\nv 5 1 0\nf -3 -2 -1\n"
    points, faces = arrays(reading_of(tmp_path / "two.obj", first + second))
    assert faces.tolist() == [[0, 1, 2], [3, 4, 5]]
    assert len(points) == 6


def test_faces_may_come_before_their_vertices(tmp_path: Path) -> None:
    content = "".join(sorted(PLAIN.splitlines(keepends=True)))  # f before v
    vertices = [line for line in PLAIN.splitlines(keepends=True) if line.startswith("v")]
    content = "".join([*[line for line in content.splitlines(keepends=True) if line.startswith("f")], *vertices])
    assert volume(reading_of(tmp_path / "box.obj", content)) == pytest.approx(VOLUME)


def test_concave_polygons_keep_their_area(tmp_path: Path) -> None:
    arrow = "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\n"  # the fan from the first corner covers too much
    assert area(reading_of(tmp_path / "arrow.obj", arrow + "f 1 2 3 4\n")) == pytest.approx(1)
    comb = [(0, 0), (5, 0), (5, 3), (4, 3), (4, 1), (3, 1), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
    for turned in ((0, 1, 2), (2, 0, 1), (1, 2, 0), (1, 0, 2)):
        points = [[(*point, 7.0)[k] for k in turned] for point in comb]
        content = obj(points, [list(range(len(comb)))])
        reading = reading_of(tmp_path / "comb.obj", content)
        assert len(arrays(reading)[1]) == len(comb) - 2
        assert area(reading) == pytest.approx(11)


def test_colors_behind_coordinates(tmp_path: Path) -> None:
    content = "v 0 0 0 1 0.5 0\nv 1 0 0 1 0.5 0\nv 0 1 0 255 128 0\nf 1 2 3\n"
    reading = reading_of(tmp_path / "colors.obj", content)
    assert reading.mesh_set.current_mesh().vertex_color_matrix() == pytest.approx(
        np.tile([1, 0.5, 0, 1], (3, 1)), abs=0.01
    )


def test_lines_and_points_are_left_out_and_noted(tmp_path: Path) -> None:
    reading = reading_of(tmp_path / "box.obj", PLAIN + "l 1 2\nl 99 -7\np 1\nf 1 2\n")
    assert len(arrays(reading)[1]) == 12
    assert reading.notes == [
        "1 face with fewer than three corners left out",
        "3 line or point elements left out",
    ]


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("f 1 2 4 3", "f 0 1 3 2", "line 9, 'f 0 1 3 2': vertex index 0; OBJ counts from 1"),
        ("f 1 2 4 3", "f 1 2 4 9", "line 9, 'f 1 2 4 9': vertex index 9 is outside 1..8"),
        ("f 1 2 4 3", "f 1 2 4 -9", "line 9, 'f 1 2 4 -9': vertex index -9 is outside 1..8"),
        ("f 1 2 4 3", "f 1 2 4 99999999999999999999", "line 9: '99999999999999999999' is no corner"),
        ("f 1 2 4 3", "f 1 2 four 3", "line 9: 'four' is no corner of a face"),
        ("f 1 2 4 3", "f 1 2 4.5 3", "line 9: '4.5' is no corner of a face"),
        ("f 1 2 4 3", "f 1/1 2/1 4/1 3/1", "line 9, 'f 1/1 2/1 4/1 3/1': texture vertex index 1, but the file has no"),
        ("f 1 2 4 3", "f 1//1 2//1 4//1 3//1", "normal index 1, but the file has no 'vn' lines"),
        ("f 1 2 4 3", "f 1//0 2//0 4//0 3//0", "normal index 0; OBJ counts from 1"),
        ("f 1 2 4 3", "f", "line 9"),
        ("f 1 2 4 3", "x 1 2 4 3", "line 9: 'x 1 2 4 3' is no line of an OBJ file"),
        ("f 1 2 4 3", "\x01 1 2 4 3", "line 9"),
        ("v 0 4 6", "v 0 4", "line 4: 'v 0 4' has fewer than 3 numbers"),
        ("v 0 4 6", "v 0 4 x6", "line 4: 'x6' is no number"),
        ("v 0 4 6", "v 0 4 6-7", "line 4: '6-7' is no number"),
        ("v 0 4 6", "v 0 4 1.2.3", "line 4: '1.2.3' is no number"),
        ("v 0 4 6", "v 0,5 4,0 6,0", "line 4: '0,5' has a decimal comma; write numbers with a decimal point"),
        ("v 0 4 6", "v 0 4 nan", "line 4: 1 vertex with coordinates that are not finite"),
        ("v 0 4 6", "v 0 4 -inf", "line 4: 1 vertex with coordinates that are not finite"),
        ("v 0 4 6", "v 0 4 1e300", "line 4: 1 vertex with coordinates that are not finite numbers up to 1e18"),
        ("v 0 4 6", "v 0 4 6\0", "line 4: it holds a zero byte"),
    ],
)
def test_damage_is_named_with_its_line(old: str, new: str, said: str, tmp_path: Path) -> None:
    assert_refused(tmp_path / "box.obj", PLAIN.replace(old, new), said)
    assert_refused(tmp_path / "box.obj", PLAIN.replace(old, new).replace("\n", "\r\n"), said)


def test_two_bytes_a_character_are_refused(tmp_path: Path) -> None:
    assert_refused(tmp_path / "box.obj", PLAIN.encode("utf-16"), "the text is UTF-16; save it as ASCII or UTF-8")


def test_decimal_commas_in_every_line(tmp_path: Path) -> None:
    content = "".join(line.replace(".", ",") for line in obj(BOX + 0.5).splitlines(keepends=True))
    assert_refused(tmp_path / "box.obj", content, "line 1: '0,5' has a decimal comma")


def test_hard_edges_are_said_to_be_lost(tmp_path: Path) -> None:
    """MeshLab has one normal a vertex. Those that differ by little are no edge."""
    roof = "v 0 0 0\nv 0 1 0\nv -1 0 -1\nv 1 0 -1\n"
    for lean, notes in (
        (1.0, ["hard edges left out: MeshLab has one normal a vertex, and 2 vertices have several"]),
        (0.2, []),
    ):
        content = roof + f"vn {-lean} 0 1\nvn {lean} 0 1\nf 1//1 2//1 3//1\nf 2//2 1//2 4//2\n"
        assert reading_of(tmp_path / "roof.obj", content).notes == notes
