# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Coordinates of seven digits before the point survive in every format, or the format is refused for them."""

from pathlib import Path

import numpy as np
import pytest
from mesh_files import BOX, QUADS, TRIANGLES, obj, ply
from reading_checks import arrays, reading_of

import laplacian_simplify as ls
from laplacian_simplify.files.output_formats import OUTPUT_FORMATS
from laplacian_simplify.files.reading import read

AT = np.array([452391.37, 5411932.81, 313.5])


@pytest.mark.parametrize("faces", [TRIANGLES, QUADS], ids=["triangles", "quads"])
@pytest.mark.parametrize("extension", [row.extension for row in OUTPUT_FORMATS])
def test_far_from_the_origin(extension: str, faces: list, tmp_path: Path) -> None:
    points = BOX / 100 + AT
    reading = reading_of(tmp_path / "far.ply", ply(points, faces))
    target = tmp_path / f"out.{extension}"
    if extension in ("ply", "obj", "off"):
        ls.write_mesh(reading.mesh_set, target)
        assert np.abs(arrays(read(target))[0] - points).max() <= 1e-9
        return
    with pytest.raises(OSError, match="too few digits") as raised:
        ls.write_mesh(reading.mesh_set, target)
    said = f".{extension} has too few digits for a mesh of size 0.0748 around (452391, 5.41193e+06, 313.53)"
    assert f"{said}; write PLY, or move the mesh to the origin first" in str(raised.value)
    assert not target.exists()


def test_text_is_read_with_all_its_digits(tmp_path: Path) -> None:
    content = obj().replace("v 2 ", "v 5411932.8125 ")
    points, _ = arrays(reading_of(tmp_path / "far.obj", content))
    assert points.max() == 5411932.8125


def test_a_tiny_mesh_is_no_reason_to_refuse(tmp_path: Path) -> None:
    reading = reading_of(tmp_path / "tiny.ply", ply(BOX * 1e-30))
    for extension in ("ply", "stl", "off"):
        ls.write_mesh(reading.mesh_set, tmp_path / f"out.{extension}")
    with pytest.raises(OSError, match=r"\.obj has too few digits"):  # it writes 16 digits behind the point
        ls.write_mesh(reading.mesh_set, tmp_path / "out.obj")
