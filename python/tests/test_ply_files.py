# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""PLY: every pair of list types in every encoding, rare headers, and damage that is named."""

from pathlib import Path

import numpy as np
import pytest
from mesh_files import BOX, ENCODINGS, PLY_TYPES, QUADS, TRIANGLES, VOLUME, ply
from reading_checks import area, arrays, assert_refused, reading_of, volume

WHOLE = [name for name, kind in PLY_TYPES.items() if kind[0] != "f"]


@pytest.mark.parametrize("encoding", ENCODINGS)
@pytest.mark.parametrize("index_type", PLY_TYPES)
@pytest.mark.parametrize("count_type", WHOLE)
def test_every_pair_of_list_types(count_type: str, index_type: str, encoding: str, tmp_path: Path) -> None:
    for faces in (TRIANGLES, QUADS, [*TRIANGLES[:4], *QUADS[4:]]):
        content = ply(faces=faces, encoding=encoding, count_type=count_type, index_type=index_type)
        points, found = arrays(reading_of(tmp_path / "box.ply", content))
        assert np.array_equal(points, BOX)
        expected = [
            list(triangle)
            for face in faces
            for triangle in ([face] if len(face) == 3 else [face[:3], [face[0], *face[2:]]])
        ]
        assert found.tolist() == expected


@pytest.mark.parametrize("encoding", ENCODINGS)
@pytest.mark.parametrize("coordinate_type", PLY_TYPES)
def test_every_type_of_coordinates(coordinate_type: str, encoding: str, tmp_path: Path) -> None:
    content = ply(encoding=encoding, coordinate_type=coordinate_type)
    points, _ = arrays(reading_of(tmp_path / "box.ply", content))
    assert np.array_equal(points, BOX)


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("encoding", ENCODINGS)
def test_every_kind_of_line_ends(encoding: str, end: str, tmp_path: Path) -> None:
    content = ply(encoding=encoding, end=end, comments=("made by hand", "element vertex 99"))
    assert volume(reading_of(tmp_path / "box.ply", content)) == pytest.approx(VOLUME)


def test_a_byte_order_mark_is_passed_over(tmp_path: Path) -> None:
    content = b"\xef\xbb\xbf" + ply(encoding="ascii")
    assert volume(reading_of(tmp_path / "box.ply", content)) == pytest.approx(VOLUME)


def test_vertex_index_without_the_plural(tmp_path: Path) -> None:
    content = ply().replace(b"vertex_indices", b"vertex_index")
    assert volume(reading_of(tmp_path / "box.ply", content)) == pytest.approx(VOLUME)


def test_a_polygon_of_300_corners(tmp_path: Path) -> None:
    """More than a byte counts, and more than MeshLab's reader holds."""
    angle = np.linspace(0, 2 * np.pi, 300, endpoint=False)
    circle = np.stack([np.cos(angle), np.sin(angle), np.zeros(300)], axis=1)
    content = ply(circle, [list(range(300))], count_type="ushort")
    reading = reading_of(tmp_path / "disk.ply", content)
    assert len(arrays(reading)[1]) == 298
    assert area(reading) == pytest.approx(150 * np.sin(2 * np.pi / 300))


def test_strips_of_triangles(tmp_path: Path) -> None:
    header = (
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
        "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
    )
    points = "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n"
    reading = reading_of(tmp_path / "strip.ply", header + points + "7 1 0 3 2 -1 4 5\n")
    assert arrays(reading)[1].tolist() == [[1, 0, 3], [3, 0, 2]]


@pytest.mark.parametrize(
    ("kind", "values"), [("uchar", (255, 128, 0)), ("ushort", (65535, 32896, 0)), ("float", (1.0, 0.5, 0.0))]
)
def test_colors_in_every_type(kind: str, values: tuple, tmp_path: Path) -> None:
    header = "ply\nformat ascii 1.0\nelement vertex 3\n" + "".join(f"property float {axis}\n" for axis in "xyz")
    header += "".join(f"property {kind} {name}\n" for name in ("red", "green", "blue"))
    header += "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    color = " ".join(map(str, values))
    body = f"0 0 0 {color}\n1 0 0 {color}\n0 1 0 {color}\n3 0 1 2\n"
    reading = reading_of(tmp_path / "colors.ply", header + body)
    assert reading.mesh_set.current_mesh().vertex_color_matrix()[0] == pytest.approx([1, 0.5, 0, 1], abs=0.01)


def test_other_elements_and_lists_are_passed_over(tmp_path: Path) -> None:
    for order, encoding in (("<", "binary_little_endian"), (">", "binary_big_endian")):
        header = (
            f"ply\nformat {encoding} 1.0\nelement odd 2\nproperty list ushort double numbers\nproperty char c\n"
            "element vertex 3\nproperty float x\nproperty list uchar short notes\nproperty float y\nproperty float z\n"
            "element face 1\nproperty int group\nproperty list uint ushort vertex_indices\nend_header\n"
        )
        body = b"".join(
            np.array([n], order + "u2").tobytes() + np.zeros(n, order + "f8").tobytes() + b"c" for n in (2, 0)
        )
        for n, point in enumerate(((0, 0, 5), (1, 0, 5), (0, 1, 5))):
            x, *rest = point
            body += np.array([x], order + "f4").tobytes() + bytes([n]) + np.zeros(n, order + "i2").tobytes()
            body += np.array(rest, order + "f4").tobytes()
        body += np.array([7, 3], order + "i4").tobytes() + np.array([0, 1, 2], order + "u2").tobytes()
        points, faces = arrays(reading_of(tmp_path / "odd.ply", header.encode() + body))
        assert points.tolist() == [[0, 0, 5], [1, 0, 5], [0, 1, 5]]
        assert faces.tolist() == [[0, 1, 2]]


def test_faces_with_a_vertex_twice_are_left_out_and_noted(tmp_path: Path) -> None:
    reading = reading_of(tmp_path / "box.ply", ply(faces=[*TRIANGLES, [0, 0, 1]]))
    assert len(arrays(reading)[1]) == len(TRIANGLES)
    assert reading.notes == ["1 face with the same vertex at two corners left out"]


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("element face 6", "element face", "line 7: 'element face' is no line of a PLY header"),
        ("element face 6", "element face -6", "line 7"),
        ("element face 6", "element face 6000", "line 7: the header announces 6,000 rows of element 'face'"),
        ("element face 6", "element face 99999999999999999999", "line 7"),
        ("element face 6", "element face 5", "it goes on for"),
        ("element vertex 8", "element vertex 2147483647", "line 3: the header announces 2,147,483,647 rows"),
        ("element vertex 8", "element vertex 8.5", "line 3"),
        ("property double z\n", "", "lacks one of the numbers x, y, z"),
        ("property double z", "property double z\nproperty double x", "is there twice"),
        ("property double z", "property list double z", "line 6"),
        ("property double z", "property real z", "unknown type 'real'"),
        ("list uchar int", "list float int", "the length of a list is a whole number"),
        ("vertex_indices", "corners", "has no list 'vertex_indices'"),
        ("element face 6", "element faces 6", "has no faces"),
        ("format binary_little_endian 1.0\n", "", "it has no line 'format'"),
        ("binary_little_endian", "binary_middle_endian", "line 2"),
        ("ply\n", "plx\n", "'plx'"),
        ("end_header\n", "", "it has no line 'end_header'"),
        ("property double x", "propperty double x", "line 4"),
    ],
)
def test_wrong_headers_are_refused_with_their_line(old: str, new: str, said: str, tmp_path: Path) -> None:
    content = ply().replace(old.encode(), new.encode(), 1)
    if said == "has no faces":
        assert len(arrays(reading_of(tmp_path / "box.ply", content))[1]) == 0
    else:
        assert_refused(tmp_path / "box.ply", content, said)


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_a_file_that_is_cut_anywhere_is_refused(encoding: str, tmp_path: Path) -> None:
    content = ply(faces=[*TRIANGLES[:3], *QUADS[2:]], encoding=encoding)
    for size in range(1, len(content) - 2, 7):
        assert_refused(tmp_path / "cut.ply", content[:size])


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_wrong_indices_name_their_face(encoding: str, tmp_path: Path) -> None:
    faces = [*QUADS[:5], [1, 5, 8, 3]]
    assert_refused(tmp_path / "box.ply", ply(faces=faces, encoding=encoding), "face 5: vertex index 8 is outside 0..7")
    assert_refused(tmp_path / "box.ply", ply(faces=[[0, 1, -1]], encoding=encoding), "face 0: vertex index -1")


def test_a_word_in_the_text_names_its_line(tmp_path: Path) -> None:
    content = ply(encoding="ascii").replace(b"\n0 4 6\n", b"\n0 four 6\n")
    assert_refused(tmp_path / "box.ply", content, "line 13: 'four' is no number")
    content = ply(encoding="ascii").replace(b"\n0 4 6\n", b"\n0 4,5 6\n")
    assert_refused(
        tmp_path / "box.ply", content, "line 13: '4,5' has a decimal comma; write numbers with a decimal point"
    )


def test_a_negative_list_is_refused(tmp_path: Path) -> None:
    content = bytearray(ply(count_type="char"))
    content[content.index(b"end_header\n") + 11 + 8 * 24] = 0xFC
    assert_refused(tmp_path / "box.ply", bytes(content), "face 0: a list of -4 numbers")


def test_more_bytes_than_announced_are_refused_but_padding_is_not(tmp_path: Path) -> None:
    assert_refused(tmp_path / "box.ply", ply() + b"more", "it goes on for 4 bytes after the last row")
    assert volume(reading_of(tmp_path / "box.ply", ply() + b"\0\0\n")) == pytest.approx(VOLUME)
