# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page: one HTML file with the picture, a viewer, a histogram and the numbers, which asks for nothing else.

Meshes are stored as base64 of 32-bit floats and whole numbers. A mesh of more than ``MOST_FACES`` is shown by as many
of them, made by the fast effort of simplify, or chosen evenly where that cannot make so few; its colors are the
distances of the vertices that these were. With that, a page has at most about 15 MB.
"""

import base64
import html
import json
from importlib.resources import files
from string import Template
from typing import Any

import numpy as np

from ..comparison.distances import Distances
from ..comparison.surface import Surface
from ..huge.array_file import Array
from ..huge.surface_library import distances
from .error_map import COLORS, ErrorMap, error_map
from .histogram import histogram, shares
from .picture import Look
from .scene import Facts, Rows, Scene, titled

MOST_FACES = 100_000
"""Of either mesh in the viewer, divided faces included."""


def page_text(scene: Scene, found: Distances, facts: Facts, look: Look, picture: bytes, threads: int = 0) -> str:
    """The page.

    Args:
        scene: both surfaces.
        found: their distances.
        facts: what is written; it is escaped here.
        look: how they are shown.
        picture: PNG.
        threads: 0 all.
    """
    maps = [_shown_by(scene.before, scene.after, threads), _shown_by(scene.after, scene.before, threads)]
    percent = 100 / look.diagonal if look.diagonal > 0 else 1.0
    before, after = scene.before, scene.after
    first, second = facts.labels
    beyond = [shares(way, look.limit)[1] for way in (found.forward, found.backward)]
    texts = {
        "title": f"{before.name} | {after.name}" if first == "A" else f"{before.name} -> {after.name}",
        "before": titled(first, before.name),
        "after": titled(second, after.name),
        "first": first,
        "second": second,
        "beyond": f"Beyond the scale: {beyond[0]:.2g} % of {first}, {beyond[1]:.2g} % of {second}.",
        "version": facts.version,
        "limit": f"{look.limit * percent:.3g}",
        "half": f"{look.limit * percent / 2:.3g}",
        "limit_units": f"{look.limit:.3g}",
        "half_units": f"{look.limit / 2:.3g}",
        "shown": _what_is_shown(scene, maps),
    }
    parts = {
        "colors": ", ".join(COLORS),
        "picture": base64.b64encode(picture).decode(),
        "histogram": histogram(found.forward, found.backward, look.limit, percent),
        "summary": _rows(facts.summary),
        "numbers": _rows(facts.numbers),
        "parameters": _rows(facts.parameters),
        "data": _script_safe(json.dumps(_data(maps, look))),
        "three": _part("three.min.js"),
        "viewer": _part("viewer.js"),
    }
    escaped = {name: html.escape(text) for name, text in texts.items()}
    return Template(_part("page.html")).substitute(**escaped, **parts)


def _part(name: str) -> str:
    return files(__package__).joinpath(name).read_text(encoding="utf-8")


def _script_safe(text: str) -> str:
    """JSON that cannot end the element that it is in."""
    return text.replace("<", "\\u003c")


def _rows(rows: Rows) -> str:
    return "".join(f"<tr><th>{html.escape(name)}</th><td>{html.escape(value)}</td></tr>" for name, value in rows)


def _what_is_shown(scene: Scene, maps: list[ErrorMap]) -> str:
    reduced = [
        f"{surface.name} has {len(surface.faces):,} faces; the viewer shows it with {len(shown.faces):,}."
        for surface, shown in zip((scene.before, scene.after), maps, strict=True)
        if len(surface.faces) > MOST_FACES
    ]
    return " ".join(reduced)


def _data(maps: list[ErrorMap], look: Look) -> dict[str, Any]:
    """What the viewer gets."""
    view = look.view
    return {
        "meshes": [_mesh(shown, look) for shown in maps],
        "colors": COLORS,
        "view": {
            "direction": view.direction.tolist(),
            "up": view.up.tolist(),
            "middle": view.middle.tolist(),
            "width": view.width,
            "height": view.height,
        },
    }


def _shown_by(of: Surface, to: Surface, threads: int) -> ErrorMap:
    """What the viewer shows of a surface."""
    return (error_map if len(of.faces) <= MOST_FACES else _reduced)(of, to, MOST_FACES, threads)


def _mesh(shown: ErrorMap, look: Look) -> dict[str, str]:
    return {
        "positions": _base64(look.view.placed(shown.positions), np.float32),
        "faces": _base64(shown.faces, np.uint32),
        "divided": "" if shown.divided is shown.faces else _base64(shown.divided, np.uint32),
        "errors": _base64(np.minimum(shown.errors / look.limit, 2), np.float32),
    }


def _reduced(of: Surface, to: Surface, most: int, threads: int) -> ErrorMap:
    """A surface of too many faces with fewer."""
    from ..simplification import simplify

    small = simplify(
        of.positions,
        of.faces,
        target_faces=most,
        effort="fast",
        measure_error=False,
        avoid_self_intersections=False,
        threads=threads,
    )
    every = -(-len(small.faces) // most)  # 1, unless its parts are too many to be simplified
    used, corners = np.unique(small.faces[::every], return_inverse=True)
    faces = corners.reshape(-1, 3).astype(np.uint32)
    errors = distances(to.positions, to.faces, of.positions[small.vertex_origin[used]], threads)
    return ErrorMap(small.vertices[used], faces, faces, errors)


def _base64(values: Array, dtype: Any) -> str:
    little: Array = np.ascontiguousarray(values, np.dtype(dtype).newbyteorder("<"))
    return base64.b64encode(little.tobytes()).decode()
