# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The meshes of the benchmark: their groups, and the one welded input that every tool gets."""

from dataclasses import dataclass
from pathlib import Path

import igl
import numpy as np
import trimesh

from mesh_topology import Mesh, read_mesh, welded, without_unreferenced

PERCENTS = (50, 20, 10, 2)

# Public test models, five mechanical or man-made and five natural shapes, and those of sample_meshes, which stand in
# where the models are not at hand: only the names that a folder has are measured.
MODELS = {
    "CAD": ("block", "fandisk", "rocker_arm", "screwdriver", "airplane"),
    "natural": ("cow", "bunny", "bunny10k_textured", "elephant", "igea"),
}
SAMPLES = {
    "CAD": ("flange", "bracket_quads", "painted_box"),
    "natural": ("creature", "folded_sheet", "relief_scan"),
}
GROUPS = {group: names + SAMPLES[group] for group, names in MODELS.items()}
LARGEST_PLY = 2_000_000  # faces
FORMATS = (".ply", ".off", ".obj", ".stl")


@dataclass(frozen=True)
class BenchmarkMesh:
    """One mesh of the benchmark and where its welded copies lie."""

    name: str
    group: str
    arrays: Path  # .npz with vertices (float32) and faces (int32)
    ply: Path

    @property
    def face_count(self) -> int:
        return len(np.load(self.arrays)["faces"])

    def load(self) -> Mesh:
        stored = np.load(self.arrays)
        return Mesh(stored["vertices"].astype(np.float64), stored["faces"].astype(np.int64))


def group_of(name: str) -> str:
    """CAD or natural; everything that is not in the list above is 'other'."""
    return next((group for group, names in GROUPS.items() if name in names), "other")


def prepare_mesh(source: Path, folder: Path, name: str | None = None) -> BenchmarkMesh:
    """Welds a mesh (float32 coordinates) and stores it for all tools; done once per folder."""
    name = name or source.stem
    prepared = BenchmarkMesh(name, group_of(name), folder / f"{name}.npz", folder / f"{name}.ply")
    if not prepared.arrays.exists():
        mesh = read_mesh(source)
        store_mesh(prepared, welded(Mesh(mesh.vertices.astype(np.float32).astype(np.float64), mesh.faces)))
    return prepared


def store_mesh(prepared: BenchmarkMesh, mesh: Mesh) -> None:
    """Writes both copies of a mesh, the arrays last; of a very large one only the arrays."""
    prepared.arrays.parent.mkdir(parents=True, exist_ok=True)
    if len(mesh.faces) <= LARGEST_PLY:
        write_ply(prepared.ply, mesh.vertices, mesh.faces)
    np.savez(prepared.arrays, vertices=mesh.vertices.astype(np.float32), faces=mesh.faces.astype(np.int32))


def write_ply(path: Path, vertices: np.ndarray, faces: np.ndarray) -> None:
    """Binary PLY with float32 coordinates."""
    path.write_bytes(trimesh.Trimesh(vertices, faces, process=False).export(file_type="ply"))


def meshes_in(source: Path, folder: Path, wanted=None) -> list[BenchmarkMesh]:
    """The meshes of a folder that belong to a group (or are named in `wanted`), welded into `folder`."""
    chosen = wanted or [name for names in GROUPS.values() for name in names]
    paths = mesh_files(source)
    return [prepare_mesh(paths[name], folder) for name in chosen if name in paths]


def all_meshes_in(sources: list[Path], folder: Path) -> list[BenchmarkMesh]:
    """Every mesh of several folders, welded into `folder`; a name that was there before gets its folder's in front."""
    prepared = {}
    for source in dict.fromkeys(path.resolve() for path in sources):
        for stem, path in mesh_files(source).items():
            name = f"{source.name}_{stem}" if stem in prepared else stem
            prepared[name] = prepare_mesh(path, folder, name)
    return list(prepared.values())


def mesh_files(source: Path) -> dict[str, Path]:
    """The meshes of a folder by their names without suffix."""
    return {path.stem: path for path in sorted(source.iterdir()) if path.suffix.lower() in FORMATS}


def subdivided(mesh: BenchmarkMesh, times: int, folder: Path, smooth: bool = False) -> BenchmarkMesh:
    """Every face cut into four, `times` times: at the edges' midpoints, which keeps the surface, or by Loop's rule."""
    name = f"{mesh.name}_{'loop' if smooth else 'subdivided'}_{times}"
    prepared = BenchmarkMesh(name, mesh.group, folder / f"{name}.npz", folder / f"{name}.ply")
    if not prepared.arrays.exists():
        original = mesh.load()
        vertices, faces = (igl.loop if smooth else igl.upsample)(original.vertices, original.faces, times)
        store_mesh(prepared, without_unreferenced(np.asarray(vertices), np.asarray(faces)))
    return prepared


def target_faces(faces: int, percent: float) -> int:
    """Faces to reach at a percentage, rounded down as MeshLab's filters do."""
    return int(faces * percent / 100)
