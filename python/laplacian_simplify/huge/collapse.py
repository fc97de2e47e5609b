# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Simplifies blocks. Vertices that other blocks have, too, stay as they are."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..library import MeshArrays, Outcome
from .array_file import Array, save_arrays
from .colors import run_with_colors, weight_in_part
from .edges import edges_of_block
from .gather import Block, Part, count_foreign, gather
from .grid import Grid, Layout, counted, paths_of
from .samples import sample

_LEAST_SHARE, _LEAST_FACES = 0.002, 4
"""Of its faces, what a block keeps even where all are cheap."""
_FACES_AT_FIXED = 1.2
"""A fixed vertex: fewer are hardly reached, and the last of them take longer than all others."""
FAST = 0


@dataclass(frozen=True)
class Engine:
    """What every collapse of a run is told; numbers as the C function takes them."""

    feature_weight: float
    boundary: int
    preserve_topology: int
    descriptor_scale: float = 0
    keep_attributes: int = 1
    attribute_weight: float = 0
    face_area: float = 0
    """Of a face of the result, where the mesh has colors and is simplified in parts."""

    def parameters(self, target: int, effort: int, *, cost_limit: float = 0, threads: int = 1) -> dict[str, float]:
        """Parameters of library.run."""
        return {
            "target_faces": max(target, 1),
            "feature_weight": self.feature_weight,
            "effort": effort,
            "boundary": self.boundary,
            "preserve_topology": self.preserve_topology,
            "descriptor_scale": self.descriptor_scale,
            "cost_limit": cost_limit,
            "threads": threads,
        }

    def run(self, mesh: MeshArrays, colors: Array | None, parameters: dict[str, float]) -> tuple[Outcome, Array | None]:
        """Simplifies a part of the mesh with the colors that it has, and returns those that it has then."""
        if colors is not None and self.keep_attributes:
            target = int(parameters["target_faces"])
            weight = weight_in_part(self.attribute_weight, self.face_area, mesh, target)
            parameters = parameters | {"attribute_weight": weight}
        return run_with_colors(mesh, colors, parameters, guide=bool(self.keep_attributes))


def pilot(
    folder: Path, block: int, parts: list[Part], toc: list[Part], engine: Engine, share: float, shown: str
) -> Any:
    """Collapses the cells around the middle of a block and returns how cost and vertices go together.

    Args:
        folder: of the work.
        block: its number.
        parts: of the pilot.
        toc: of the block itself, for its seam vertices.
        engine: what to do.
        share: of the faces, that remain.
        shown: name of the mesh.
    """
    mesh = gather(folder, parts, shown)
    border = _border_vertices(mesh.triangles, len(mesh.ids))
    free = len(mesh.ids) - int(np.count_nonzero(border))
    arrays = MeshArrays(mesh.positions, mesh.triangles, border)
    faces = len(mesh.triangles)
    outcome, _ = engine.run(arrays, mesh.colors, engine.parameters(_looked_at(share, faces, border), FAST))
    left = [(cost, max(1.0, free - (faces - now) / 2) / max(free, 1)) for cost, now in outcome.steps if cost > 0]
    return {
        "block": block,
        "curve": left,
        "scale": outcome.descriptor_scale,
        "seams": count_foreign(folder, toc),
    }


def survey(
    folder: Path, block: int, parts: list[Part], grid: Grid, layout: str, engine: Engine, share: float, shown: str
) -> dict[str, Any]:
    """Collapses a whole block until a share of its faces is left, and returns how cost and faces go together."""
    mesh = gather(folder, parts, shown)
    fixed = _fixed(folder, mesh, block, grid, layout)
    arrays = MeshArrays(mesh.positions, mesh.triangles, fixed, shared_seams=True)
    looked_at = _looked_at(share, len(mesh.triangles), fixed)
    outcome, _ = engine.run(arrays, mesh.colors, engine.parameters(looked_at, FAST))
    return {
        "block": block,
        "faces": len(mesh.triangles),
        "curve": [step for step in outcome.steps if step[0] > 0],
        "seams": count_foreign(folder, parts),
    }


@dataclass(frozen=True)
class Wanted:
    """How far a block is collapsed."""

    effort: int = FAST
    cost_limit: float = 0
    target: int = 0
    """Faces; 0: only the cost limits it."""
    sampled: str = ""
    """A file for what is measured of the block as it is before."""
    density: float = 0
    """Samples a face."""
    avoid_crossings: bool = False
    """No more faces of the block cross each other than before."""


def collapse(
    folder: Path, block: int, parts: list[Part], grid: Grid, layout: str, engine: Engine, wanted: Wanted,
    shown: str, file: str,
) -> dict[str, Any]:  # fmt: skip
    """Writes a file with the simplified block, and what the next round needs to know of it."""
    mesh = gather(folder, parts, shown)
    fixed = _fixed(folder, mesh, block, grid, layout)
    answer: dict[str, Any] = {"before": len(mesh.triangles)}
    if wanted.sampled:
        answer["original"] = sample(folder, mesh, fixed, wanted.density, wanted.sampled)
    target = wanted.target or _least(mesh)
    arrays = MeshArrays(mesh.positions, mesh.triangles, fixed, shared_seams=True)
    parameters = engine.parameters(target, wanted.effort, cost_limit=wanted.cost_limit)
    parameters["avoid_self_intersections"] = int(wanted.avoid_crossings)
    outcome, colors = engine.run(arrays, mesh.colors, parameters)
    answer["self_intersections"] = outcome.report.get("self_intersections")
    answer |= _saved(folder / file, mesh.ids, fixed, outcome, grid, colors)
    return answer


def _saved(path: Path, ids: Array, fixed: Array, outcome: Outcome, grid: Grid, colors: Array | None) -> dict[str, Any]:
    ids, shared = ids[outcome.vertex_origin], fixed[outcome.vertex_origin]
    positions, triangles = outcome.vertices, outcome.faces
    edges = edges_of_block(ids, positions, triangles, shared)
    cells = counted(paths_of(grid.centroid_places(positions, triangles), 0))
    seams = counted(paths_of(grid.places(positions[shared]), 0))
    arrays = {"ids": ids, "positions": positions, "triangles": triangles, "shared": shared, **cells}
    arrays |= {"seam_cells": seams["cells"], "seam_counts": seams["counts"], **edges.shared}
    if colors is not None:
        arrays["colors"] = colors
    return {
        **save_arrays(path, arrays),
        "faces": len(triangles),
        "vertices": len(ids),
        "seams": int(np.count_nonzero(shared)),
        "boundary_edges": edges.boundary,
        "non_manifold_edges": edges.non_manifold,
    }


def _fixed(folder: Path, mesh: Block, block: int, grid: Grid, layout: str) -> Array:
    """bool: the vertices that other blocks have, too; a few others may be among them."""
    home = Layout.read(folder / layout).blocks.at(grid.places(mesh.positions))
    fixed: Array = (home != block) | np.isin(mesh.ids, mesh.foreign, assume_unique=True)
    return fixed


def _looked_at(share: float, faces: int, fixed: Array) -> int:
    """Faces down to which it is worth to know what they cost."""
    return max(int(share * faces), int(_FACES_AT_FIXED * np.count_nonzero(fixed)), _LEAST_FACES)


def _least(mesh: Block) -> int:
    return max(int(_LEAST_SHARE * len(mesh.triangles)), _LEAST_FACES)


def _border_vertices(triangles: Array, vertices: int) -> Array:
    """bool: those on an edge with one face."""
    edges = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]).astype(np.int64)
    keys, counts = np.unique(edges.min(axis=1) * vertices + edges.max(axis=1), return_counts=True)
    single = keys[counts == 1]
    border = np.zeros(vertices, bool)
    border[single // vertices] = border[single % vertices] = True
    return border
