# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sample meshes are what their README says and what their generator writes."""

import subprocess
import sys
from pathlib import Path

import pytest
from conftest import SAMPLE_MESHES, SAMPLE_NAMES

import laplacian_simplify as ls

# name: (boundary edges, edges of three faces or more, genus or -1 where it has none, components)
TOPOLOGY = {
    "flange.ply": (0, 0, 1, 1),
    "creature.ply": (0, 0, 0, 1),
    "folded_sheet.ply": (450, 0, 0, 1),
    "bracket_quads.ply": (0, 0, 0, 1),
    "relief_scan.ply": (700, 0, 0, 1),
    "painted_box.obj": (0, 0, 0, 1),
}


@pytest.mark.parametrize("name", TOPOLOGY)
def test_topology(name: str) -> None:
    found = ls.read_mesh(SAMPLE_MESHES / name).get_topological_measures()
    measured = (
        found["boundary_edges"],
        found["non_two_manifold_edges"],
        found["genus"],
        found["connected_components_number"],
    )
    assert measured == TOPOLOGY[name]


def test_non_manifold_sample() -> None:
    found = ls.read_mesh(SAMPLE_MESHES / "leaves_and_cones.ply").get_topological_measures()
    assert found["non_two_manifold_edges"] > 0
    assert found["non_two_manifold_vertices"] == 1


def test_quads_and_texture_coordinates() -> None:
    bracket = ls.read_mesh(SAMPLE_MESHES / "bracket_quads.ply")
    assert {len(face) for face in bracket.current_mesh().polygonal_face_list()} == {4}
    box = ls.read_mesh(SAMPLE_MESHES / "painted_box.obj")
    assert box.current_mesh().has_wedge_tex_coord()


def test_the_generator_writes_the_same_bytes(tmp_path: Path) -> None:
    subprocess.run([sys.executable, SAMPLE_MESHES / "generate.py", tmp_path], check=True)
    written = sorted(path.name for path in tmp_path.iterdir())
    assert set(written) >= set(SAMPLE_NAMES)
    for name in written:
        assert (tmp_path / name).read_bytes() == (SAMPLE_MESHES / name).read_bytes(), name
    assert sum((SAMPLE_MESHES / name).stat().st_size for name in written) < 5 * 2**20
