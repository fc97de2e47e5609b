# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which mesh stands for which model of the paper."""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from mesh_topology import Mesh, edges_of, read_mesh, sharp_vertices, welded
from metrics import Original

SAMPLES = 50_000  # on each surface; the figures of the page have two to three digits

TEST_MODELS = {
    "cow": ("cow.obj", "the paper's Cow"),
    "fandisk": ("fandisk.off", "the paper's Fandisk"),
    "bunny": ("bunny.off", "the paper's Bunny"),
    "mech_a": ("rocker_arm.obj", "in place of the paper's Mech A"),
    "mech_b": ("block.off", "in place of the paper's Mech B"),
    "girl": ("elephant.ply", "in place of the paper's Girl"),
    "non_manifold": ("non_manifold_hole.ply", "in place of the paper's cinghiale"),
    "quads": ("fandisk_quads.off", "in place of the paper's quad mesh"),
}
SAMPLE_MESHES = {
    "cow": ("creature.ply", "in place of the paper's Cow"),
    "fandisk": ("flange.ply", "in place of the paper's Fandisk"),
    "bunny": ("relief_scan.ply", "in place of the paper's Bunny"),
    "mech_a": ("painted_box.obj", "in place of the paper's Mech A"),
    "mech_b": ("folded_sheet.ply", "in place of the paper's Mech B"),
    "girl": ("creature.ply", "in place of the paper's Girl"),
    "non_manifold": ("leaves_and_cones.ply", "in place of the paper's cinghiale"),
    "quads": ("bracket_quads.ply", "in place of the paper's quad mesh"),
}


@dataclass(frozen=True)
class Model:
    """A mesh file and the model of the paper whose part it plays."""

    role: str
    path: Path
    why: str

    @property
    def name(self) -> str:
        """The file's name without its ending."""
        return self.path.stem

    @cached_property
    def mesh(self) -> Mesh:
        """Welded triangles; the order of the vertices is that of every result of a filter that keeps them."""
        return welded(read_mesh(self.path))

    @cached_property
    def original(self) -> Original:
        """What repeated measuring shares."""
        return Original(self.mesh, SAMPLES)

    @cached_property
    def is_sharp(self) -> np.ndarray:
        """True at the vertices on edges with a dihedral over 30 degrees: the features that geometry knows."""
        flags = np.zeros(len(self.mesh.vertices), dtype=bool)
        flags[sharp_vertices(self.mesh, edges_of(self.mesh))] = True
        return flags


def find_models(folder: Path | None, sample_meshes: Path) -> tuple[dict[str, Model], bool]:
    """The model of each role, and whether they are the public test models (otherwise the sample meshes).

    :raises FileNotFoundError: if a folder was asked for and lacks one of them.
    """
    for place, table in ((folder, TEST_MODELS), (sample_meshes, SAMPLE_MESHES)):
        if place is None:
            continue
        models = {role: Model(role, place / name, why) for role, (name, why) in table.items()}
        missing = [str(model.path) for model in models.values() if not model.path.exists()]
        if missing:
            raise FileNotFoundError(f"missing: {', '.join(missing)}")
        return models, table is TEST_MODELS
    raise AssertionError("the sample meshes are part of the project")
