# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests say about a file: what it is read as, or how it is refused."""

from pathlib import Path

import numpy as np
import pytest

import laplacian_simplify as ls
from laplacian_simplify.files.reading import Reading, read

Content = bytes | str


def write(path: Path, content: Content) -> Path:
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


def names_in(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def reading_of(path: Path, content: Content) -> Reading:
    """Writes and reads a file."""
    return read(write(path, content))


def arrays(reading: Reading) -> tuple[np.ndarray, np.ndarray]:
    mesh = reading.mesh_set.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix()


def volume(reading: Reading) -> float:
    """Signed, so that a face that is turned round counts."""
    points, faces = arrays(reading)
    a, b, c = (points[faces[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def area(reading: Reading) -> float:
    points, faces = arrays(reading)
    a, b, c = (points[faces[:, k]] for k in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


def bounds(reading: Reading) -> list[list[float]]:
    points, _ = arrays(reading)
    return [points.min(axis=0).tolist(), points.max(axis=0).tolist()]


def refusal(path: Path) -> str:
    """How a file is refused; empty where it is read."""
    try:
        read(path)
    except OSError as error:
        return str(error)
    return ""


def assert_refused(path: Path, content: Content, *said: str) -> None:
    """Refused in one line that names the file and has all of these."""
    write(path, content)
    with pytest.raises(OSError) as raised:  # noqa: PT011
        ls.read_mesh(path)
    text = str(raised.value)
    assert text.startswith(f"{path} "), text
    assert "\n" not in text
    for words in said:
        assert words in text, text
