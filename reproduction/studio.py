# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the plugin's filters in pymeshlab on the models, and measures what comes out."""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pymeshlab

import laplacian_simplify
from mesh_topology import Mesh, without_unreferenced
from metrics import measure, plain_numbers
from models import Model

TIMED_RUNS = 15


@dataclass(frozen=True)
class Result:
    """A simplified mesh and its figures: those of the metric tool, and the filter's seconds."""

    mesh: Mesh
    numbers: dict


@dataclass
class Studio:
    """Everything that the entries share; a run that two of them need happens once."""

    models: dict[str, Model]
    pictures: Path
    _runs: dict = field(default_factory=dict)

    def __post_init__(self):
        laplacian_simplify.load()

    def decimate(self, role: str, target_faces: int, **parameters) -> Result:
        """The paper's filter; parameters by their ids."""
        key = (self.models[role].path, target_faces, tuple(sorted(parameters.items())))
        if key not in self._runs:
            model = self.models[role]
            meshes = mesh_set(model.mesh)
            report = laplacian_simplify.weighted(meshes, target_faces=target_faces, **parameters)
            mesh = current_mesh(meshes)
            numbers = plain_numbers(measure(model.original, mesh))
            numbers["seconds"] = report.seconds
            self._runs[key] = Result(mesh, numbers)
        return self._runs[key]

    def descriptor(self, role: str, kind: str = "laplacian") -> np.ndarray:
        """One value for each vertex of the model."""
        key = (self.models[role].path, kind)
        if key not in self._runs:
            meshes = mesh_set(self.models[role].mesh)
            laplacian_simplify.descriptor(meshes, descriptor=kind, colorize=False)
            self._runs[key] = meshes.current_mesh().vertex_scalar_array()
        return self._runs[key]

    def descriptor_milliseconds(self, role: str, kinds: tuple[str, ...]) -> dict[str, float]:
        """Shortest time of the filter for each descriptor, taken in turns: a busy machine can only add to it."""
        meshes = mesh_set(self.models[role].mesh)
        seconds = {kind: [] for kind in kinds}
        for _ in range(TIMED_RUNS):
            for kind in kinds:
                report = laplacian_simplify.descriptor(meshes, descriptor=kind, colorize=False)
                seconds[kind].append(report.seconds)
        return {kind: 1000 * min(values) for kind, values in seconds.items()}

    def smoothed(self, role: str, **parameters) -> np.ndarray:
        """The vertices after umbrella smoothing."""
        meshes = mesh_set(self.models[role].mesh)
        laplacian_simplify.smooth(meshes, **parameters)
        return meshes.current_mesh().vertex_matrix()

    def features(self, role: str, **parameters) -> tuple[np.ndarray, "laplacian_simplify.ClassificationReport"]:
        """True at the vertices that the selection filter selects, and its report."""
        meshes = mesh_set(self.models[role].mesh)
        report = laplacian_simplify.classify(meshes, **parameters)
        return meshes.current_mesh().vertex_selection_array().astype(bool), report


def mesh_set(mesh: Mesh) -> pymeshlab.MeshSet:
    """A new mesh set that holds the mesh."""
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(mesh.vertices, mesh.faces.astype(np.int32)))
    return meshes


def current_mesh(meshes: pymeshlab.MeshSet) -> Mesh:
    """The current mesh as arrays."""
    mesh = meshes.current_mesh()
    return without_unreferenced(mesh.vertex_matrix(), mesh.face_matrix())


def polygon_descriptor(path: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Vertices, triangles and Laplacian descriptor of a file as the host reads it: polygons stay polygons."""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    laplacian_simplify.descriptor(meshes, colorize=False)
    mesh = meshes.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix(), mesh.vertex_scalar_array()
