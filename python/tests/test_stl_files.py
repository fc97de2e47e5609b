# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""STL: binary of exactly its length, text with every kind of line ends, and damage that is named."""

from pathlib import Path

import numpy as np
import pymeshlab
import pytest
from conftest import SAMPLE_MESHES
from mesh_files import BOX, TRIANGLES, VOLUME, binary_stl, text_stl
from reading_checks import arrays, assert_refused, reading_of, volume, write

TEXT = text_stl()


@pytest.mark.parametrize(
    "content",
    [
        pytest.param(binary_stl(), id="binary"),
        pytest.param(b"solid box" + binary_stl()[9:], id="binary that begins with solid"),
        pytest.param(TEXT, id="text"),
        pytest.param(text_stl(end="\r\n"), id="CRLF"),
        pytest.param(text_stl(end="\r"), id="CR"),
        pytest.param(TEXT.upper(), id="capitals"),
        pytest.param("\ufeff" + TEXT, id="byte order mark"),
        pytest.param(TEXT.replace("solid box", "solid"), id="without a name"),
        pytest.param(TEXT.replace("solid box", "solid facet normal 1 2 vertex"), id="a name of keywords"),
        pytest.param(TEXT.replace("\n", "\n\n  "), id="empty lines and blanks"),
        pytest.param(TEXT.rstrip("\n"), id="no line end at the end"),
    ],
)
def test_spellings(content: bytes | str, tmp_path: Path) -> None:
    reading = reading_of(tmp_path / "box.stl", content)
    assert volume(reading) == pytest.approx(VOLUME)
    assert len(arrays(reading)[0]) == 8


def test_several_solids_in_one_text(tmp_path: Path) -> None:
    content = TEXT + text_stl(BOX + 10)
    assert volume(reading_of(tmp_path / "two.stl", content)) == pytest.approx(2 * VOLUME)


def test_vertices_are_those_of_meshlabs_reader(tmp_path: Path) -> None:
    """In their order, too: results depend on it."""
    meshlab = pymeshlab.MeshSet()
    meshlab.load_new_mesh(str(SAMPLE_MESHES / "leaves_and_cones.ply"))
    meshlab.save_current_mesh(str(tmp_path / "leaves.stl"))
    meshlab.load_new_mesh(str(tmp_path / "leaves.stl"))
    mesh = meshlab.current_mesh()
    points, faces = arrays(reading_of(tmp_path / "leaves.stl", (tmp_path / "leaves.stl").read_bytes()))
    assert np.array_equal(points, mesh.vertex_matrix())
    assert np.array_equal(faces, mesh.face_matrix())


def test_text_keeps_more_digits_than_single_precision_has(tmp_path: Path) -> None:
    far = np.add(BOX, (452391.125, 5411932.0625, 0))
    numbers = iter(f"vertex {x:.6f} {y:.6f} {z:.6f}" for triangle in far[np.array(TRIANGLES)] for x, y, z in triangle)
    lines = [next(numbers) if line.strip().startswith("vertex") else line for line in TEXT.splitlines()]
    content = "\n".join(lines)
    points, _ = arrays(reading_of(tmp_path / "far.stl", content))
    assert sorted(map(tuple, points)) == sorted(map(tuple, far))


def test_colors_of_facets(tmp_path: Path) -> None:
    content = bytearray(binary_stl())
    for facet in range(len(TRIANGLES)):
        content[84 + 50 * facet + 48 : 84 + 50 * facet + 50] = (0x8000 | 31 << 10).to_bytes(2, "little")
    reading = reading_of(tmp_path / "box.stl", bytes(content))
    assert reading.mesh_set.current_mesh().face_color_matrix()[0] == pytest.approx([248 / 255, 0, 0, 1])


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (
            binary_stl()[:-1],
            "the header announces 12 facets, which take 684 bytes, but the file has 683; it is cut off",
        ),
        (binary_stl() + b"\n", "684 bytes, but the file has 685; the count is wrong, or two files were joined"),
        (binary_stl()[:83], "too short"),
        (binary_stl()[:80] + b"\xff\xff\xff\xff" + binary_stl()[84:], "announces 4,294,967,295 facets"),
        (TEXT[: len(TEXT) // 10], "it is cut off"),
        (TEXT[:-14], "no line 'endsolid' after 12 facets; it is cut off"),
        (TEXT.replace("vertex 2 4 6", "vertex 2 4", 1), "where a number has to stand"),
        (TEXT.replace("endloop", "endlop", 1), "'endlop' where 'endloop' has to stand"),
        (TEXT.replace("vertex 2 4 6", "vertex 2 4,5 6", 1), "'4,5' has a decimal comma"),
        (TEXT.replace("vertex 2 4 6", "vertex 2 nan 6", 1), "coordinates that are not finite"),
        (TEXT.replace("vertex 2 4 6", "vertex 2 4 6 8", 1), "'8' where"),
    ],
)
def test_damage_is_named(content: bytes | str, said: str, tmp_path: Path) -> None:
    assert_refused(tmp_path / "box.stl", content, said)


def test_a_solid_without_facets_has_no_faces(tmp_path: Path) -> None:
    assert len(arrays(reading_of(tmp_path / "empty.stl", "solid a\nendsolid a\n"))[1]) == 0


def test_a_line_without_end_of_the_word_solid_takes_no_time(tmp_path: Path) -> None:
    write(tmp_path / "solid.stl", "x " + "solid " * 100_000)
    assert_refused(tmp_path / "solid.stl", "solid\nx " + "solid " * 100_000, "'x' where 'facet' has to stand")
