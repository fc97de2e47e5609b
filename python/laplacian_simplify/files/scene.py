# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of a scene, joined to one mesh."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from .errors import DamageError
from .mesh_data import Colors, Floats, Integers, MeshData, Texture, check_finite

_MOST_PARTS, _MOST_TRIANGLES = 100_000, 50_000_000


@dataclass
class Part:
    """One mesh of a scene, in the coordinates of the scene."""

    points: Floats
    triangles: Integers
    colors: Colors | None = None
    uv: Floats | None = None
    texture: int = -1
    face_color: tuple[int, ...] | None = None


class Scene:
    """Collects parts; stops a scene that multiplies itself, as nodes may use others many times over."""

    def __init__(self) -> None:
        self.parts: list[Part] = []
        self._triangles = 0

    def add(self, part: Part) -> None:
        self.parts.append(part)
        self._triangles += len(part.triangles)
        if self._triangles > _MOST_TRIANGLES:
            raise DamageError(
                "scene", f"it puts together more than {_MOST_TRIANGLES:,} triangles", "the file is damaged"
            )

    def check(self, waiting: int) -> None:
        """Call it for every node, with the number of those that are still to be visited."""
        if len(self.parts) + waiting > _MOST_PARTS:
            raise DamageError("scene", f"it puts together more than {_MOST_PARTS:,} parts", "the file is damaged")


def joined(parts: list[Part], textures: list[Texture]) -> MeshData:
    """All parts, one after the other; what only some have is white, or zero, for the others."""
    offsets = np.cumsum([0, *(len(part.points) for part in parts)])
    data = MeshData(
        np.concatenate([np.empty((0, 3)), *(part.points for part in parts)]),
        np.concatenate(
            [np.empty((0, 3), np.int64), *(part.triangles + at for part, at in zip(parts, offsets, strict=False))]
        ),
    )
    check_finite(data.vertices)
    if any(part.colors is not None for part in parts):
        data.vertex_colors = np.concatenate([_or_white(part.colors, len(part.points)) for part in parts])
    if any(part.face_color is not None for part in parts):
        data.face_colors = np.concatenate(
            [np.tile(np.array(part.face_color or (255,) * 4, np.uint8), (len(part.triangles), 1)) for part in parts]
        )
    if any(part.uv is not None for part in parts):
        data.wedge_uv = np.concatenate([_wedges(part) for part in parts])
        data.texture_of_face = np.concatenate([np.full(len(part.triangles), part.texture) for part in parts])
        data.textures = textures
    return data


def _or_white(colors: Colors | None, count: int) -> Any:
    return np.full((count, 4), 255, np.uint8) if colors is None else colors


def _wedges(part: Part) -> Floats:
    return np.zeros((len(part.triangles), 3, 2)) if part.uv is None else part.uv[part.triangles]
