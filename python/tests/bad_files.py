# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are no usable mesh, each with what the message about it must say."""

import struct
from pathlib import Path

from conftest import SAMPLE_MESHES

_SQUARE_PLY = (
    "ply\nformat ascii 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 {y} 0\n0 1 0\n3 0 1 2\n{face}"
)
_SQUARE_OFF = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n{face}"
_POINTS_PLY = (
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n"
)


def _ascii_square(y: object = 1, face: str = "3 0 2 3\n", vertices: int = 4) -> bytes:
    return _SQUARE_PLY.format(y=y, face=face, vertices=vertices).encode()


def _binary_stl(triangles: int) -> bytes:
    return struct.pack("<80sI", b"", triangles) + struct.pack("<12fH", *range(12), 0) * triangles


def _flange() -> bytes:
    return (SAMPLE_MESHES / "flange.ply").read_bytes()


def _header_size() -> int:
    end = b"end_header\n"
    return _flange().index(end) + len(end)


def _with_nan_in_first_vertex(ply: bytes) -> bytes:
    start = ply.index(b"end_header\n") + len(b"end_header\n")
    return ply[:start] + struct.pack("<f", float("nan")) + ply[start + 4 :]


def bad_files() -> dict[str, tuple[bytes, str]]:
    """Content and what the message says, by file name."""
    return {
        "empty.ply": (b"", "the file is empty"),
        "empty.obj": (b"", "the file is empty"),
        "cut_in_faces.ply": (_flange()[:300_000], "face 12130: the file ends after 12,130 of 23,680 rows"),
        "cut_in_vertices.ply": (_flange()[:50_000], f"but {50_000 - _header_size():,} are left; the file is cut off"),
        "cut_in_header.ply": (_flange()[:60], "it has no line 'end_header'"),
        "one_byte_short.ply": (_flange()[:-1], "face 23679: the file ends after 23,679 of 23,680 rows"),
        "one_face_short.ply": (_ascii_square(face=""), "face 1: the file ends after 1 of 2 rows"),
        "nan.ply": (_ascii_square(y="nan"), "1 vertex with coordinates that are not finite"),
        "infinite.ply": (_ascii_square(y="inf"), "1 vertex with coordinates that are not finite"),
        "nan_binary.ply": (_with_nan_in_first_vertex(_flange()), "1 vertex with coordinates that are not finite"),
        "nan.obj": (b"v 0 0 0\nv nan 0 0\nv 1 1 0\nf 1 2 3\n", "line 2: 1 vertex with coordinates that are not finite"),
        "wrong_index.ply": (_ascii_square(face="3 0 2 99\n"), "face 1: vertex index 99 is outside 0..3"),
        "negative_index.ply": (_ascii_square(face="3 0 2 -5\n"), "face 1: vertex index -5 is outside 0..3"),
        "more_than_memory.ply": (_ascii_square(vertices=999_999_999_999), "'element vertex 999999999999' is no"),
        "points.ply": (_POINTS_PLY.encode(), "no faces (3 vertices)"),
        "text.ply": (b"hello\n", "'hello' instead of 'ply'"),
        "text.off": (b"hello\n", "'hello' instead of 'OFF'"),
        "cut.off": (_SQUARE_OFF.format(face="").encode(), "the file ends after 1 of 2 faces"),
        "cut_in_a_face.off": (_SQUARE_OFF.format(face="3 0").encode(), "face 1: it announces 3 corners and has 1"),
        "cut_in_vertices.off": (b"OFF\n4 2 0\n0 0 0\n1 0 0\n1 1", "the file ends after 3 of 4 vertices"),
        "wrong_index.off": (_SQUARE_OFF.format(face="3 0 2 77\n").encode(), "face 1: vertex index 77 is outside 0..3"),
        "wrong_index.obj": (b"v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 1 2 99\n", "line 5, 'f 1 2 99': vertex index"),
        "text.obj": (b"hello\n", "has no faces (0 vertices)"),
        "text.stl": (b"hello\n", "too short for an STL file"),
        "cut.stl": (_binary_stl(2)[:-30], "announces 2 facets, which take 184 bytes, but the file has 154"),
        "unknown.xyzzy": (b"hello\n", "the format '.xyzzy' is unknown"),
    }


def write_bad_file(name: str, folder: Path) -> Path:
    path = folder / name
    path.write_bytes(bad_files()[name][0])
    return path
