# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of meshio: blocks of triangles with named arrays and sets of points and cells."""

import sys
from collections.abc import Callable
from typing import Any

import numpy as np

from ..arrays import Simplified
from ..attributes import Array, Attributes
from .library import Arrays, Library, attributes_of, columns, require_triangles


def _read(mesh: Any) -> Arrays:
    kinds = {block.type for block in mesh.cells}
    require_triangles(kinds <= {"triangle"}, f"the mesh has cells of the types {', '.join(sorted(kinds))}")
    blocks = [np.asarray(block.data) for block in mesh.cells]
    return np.asarray(mesh.points), np.concatenate(blocks) if blocks else np.empty((0, 3), np.int64)


def _attributes(mesh: Any) -> Attributes:
    return attributes_of(columns(mesh.point_data))


def _build(mesh: Any, result: Simplified) -> Any:
    first = np.cumsum([0, *(len(block.data) for block in mesh.cells)])
    bounds = np.searchsorted(result.face_origin, first)
    parts = [slice(bounds[k], bounds[k + 1]) for k in range(len(mesh.cells))]
    origins = [result.face_origin[part] - first[k] for k, part in enumerate(parts)]

    def of_blocks(blocks: Any, remaining: Callable[[Array, Array], Array]) -> list[Array]:
        return [remaining(np.asarray(values), origin) for values, origin in zip(blocks, origins, strict=True)]

    def members(old: Array, origin: Array) -> Array:
        return np.flatnonzero(np.isin(origin, old))

    return sys.modules["meshio"].Mesh(
        result.vertices,
        [("triangle", result.faces[part]) for part in parts],
        point_data=result.vertex_attributes,
        cell_data={name: of_blocks(blocks, lambda old, at: old[at]) for name, blocks in mesh.cell_data.items()},
        field_data=dict(mesh.field_data),
        point_sets={name: members(old, result.vertex_origin) for name, old in mesh.point_sets.items()},
        cell_sets={name: of_blocks(blocks, members) for name, blocks in mesh.cell_sets.items()},
        info=mesh.info,
    )


LIBRARY = Library("meshio", "Mesh", _read, _attributes, _build)
