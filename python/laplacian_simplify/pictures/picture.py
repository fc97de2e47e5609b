# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture: both surfaces, and the distance from the first to the second as colors with a scale."""

import io
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..huge.array_file import Array
from .error_map import COLORS, ErrorMap
from .scene import Facts, Scene, titled
from .view import View

_GREY, _EDGE = "#cdd6dd", "#3b444c"
_MOST_EDGES = 12_000
"""Faces up to which edges are drawn: more would hide the surface."""
_DPI = 150
_PANEL = 4.3
"""Width of one surface in inches; heights are as the surfaces have them, within bounds."""
_LEAST_HEIGHT, _MOST_HEIGHT = 0.5, 1.25
_MARGIN = 1.1
_FINER = 2  # points that are drawn for one of the picture, each way
_HEAD, _FOOT, _SCALE = 0.75, 0.9, 1.75
_LONGEST_NAME = 44


@dataclass(frozen=True, eq=False)
class Look:
    """How everything is shown."""

    view: View
    limit: float
    """Where the scale of colors ends, in the unit of the coordinates."""
    diagonal: float
    """Of the first surface's box, in that unit."""


def draw_picture(scene: Scene, error: ErrorMap, facts: Facts, look: Look) -> bytes:
    """The picture as PNG.

    Args:
        scene: both surfaces.
        error: of the first one.
        facts: what is written.
        look: how.
    """
    ratio = float(np.clip(look.view.height / look.view.width, _LEAST_HEIGHT, _MOST_HEIGHT))
    size = (round(_PANEL * _DPI * _FINER), round(_PANEL * ratio * _DPI * _FINER))
    surfaces = [
        _render(look, size, surface.positions, surface.faces, edges=len(surface.faces) <= _MOST_EDGES)
        for surface in (scene.before, scene.after)
    ]
    colored = _render(look, size, error.positions, error.divided, errors=error.errors)
    return _composed([*surfaces, colored], scene, facts, look, _PANEL * ratio)


def _render(
    look: Look,
    size: tuple[int, int],
    positions: Array,
    faces: Array,
    *,
    errors: Array | None = None,
    edges: bool = False,
) -> Array:
    import pyvista

    plotter = pyvista.Plotter(off_screen=True, window_size=list(size))
    try:
        plotter.set_background("white")
        mesh = pyvista.PolyData.from_regular_faces(look.view.placed(positions), faces.astype(np.int64))
        style: dict[str, Any] = {"specular": 0.0, "show_scalar_bar": False}
        if errors is None:
            style |= {"color": _GREY, "show_edges": edges, "edge_color": _EDGE, "line_width": 1.0}
            style |= {"ambient": 0.4, "diffuse": 0.66}
        else:
            mesh.point_data["error"] = errors
            style |= {"scalars": "error", "cmap": _color_map(), "clim": (0, look.limit), "interpolate_before_map": True}
            style |= {"ambient": 0.55, "diffuse": 0.5}  # shaded less, so that colors are those of the scale
        plotter.add_mesh(mesh, **style)
        camera = plotter.camera
        camera.focal_point = look.view.middle
        camera.position = look.view.middle + 3 * look.view.direction
        camera.up = look.view.up
        camera.parallel_projection = True
        camera.parallel_scale = _MARGIN / 2 * max(look.view.height, look.view.width * size[1] / size[0])
        plotter.renderer.ResetCameraClippingRange()
        image: Array = np.asarray(plotter.screenshot(None, return_img=True))
        return image
    finally:
        plotter.close()


def _color_map() -> Any:
    from matplotlib.colors import LinearSegmentedColormap

    return LinearSegmentedColormap.from_list("distance", COLORS, 256)


def _composed(images: list[Array], scene: Scene, facts: Facts, look: Look, height: float) -> bytes:
    """The three with their titles, the scale, and the lines of the summary."""
    from matplotlib import rcdefaults
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    rcdefaults()  # whatever a matplotlibrc of the user says
    whole = (3 * _PANEL + _SCALE, height + _HEAD + _FOOT)
    figure = Figure(figsize=whole, dpi=_DPI, facecolor="white")
    canvas = FigureCanvasAgg(figure)
    before, after = (_shortened(surface.name) for surface in (scene.before, scene.after))
    first, second = (_in_text(label) for label in facts.labels)
    titles = (
        (titled(facts.labels[0], before), f"{len(scene.before.faces):,} faces"),
        (titled(facts.labels[1], after), f"{len(scene.after.faces):,} faces"),
        (f"Distance from {first} to {second}", "of every point to the closest one"),
    )
    for k, (image, (title, subtitle)) in enumerate(zip(images, titles, strict=True)):
        box = (k * _PANEL / whole[0], _FOOT / whole[1], _PANEL / whole[0], height / whole[1])
        axes = figure.add_axes(box)
        axes.imshow(image, interpolation="antialiased", aspect="auto")
        axes.set_axis_off()
        middle = box[0] + box[2] / 2
        _write(figure, middle, 1 - 0.3 / whole[1], title, 11, "center", weight="bold")
        _write(figure, middle, 1 - 0.55 / whole[1], subtitle, 9.5, "center", color="#4a545c")
    _scale(figure, look, whole, height)
    lines = [f"{label}  {line}" for label, line in facts.summary if label in ("faces", "distance", "length")]
    for k, line in enumerate(lines[-2:]):
        _write(figure, 0.2 / whole[0], (0.52 - 0.26 * k) / whole[1], line, 9.5, "left", color="#2b3238")
    _write(
        figure, 1 - 0.2 / whole[0], 0.26 / whole[1], f"Laplacian Simplify {facts.version}", 8, "right", color="#7b858d"
    )
    written = io.BytesIO()
    canvas.print_png(written)
    return written.getvalue()


def _scale(figure: Any, look: Look, whole: tuple[float, float], height: float) -> None:
    """The bar of colors, in percent of the diagonal at its right and in the mesh's units at its left."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    tall = min(height * 0.86, 3.4)
    axes = figure.add_axes(
        ((3 * _PANEL + 0.78) / whole[0], (_FOOT + (height - tall) / 2) / whole[1], 0.18 / whole[0], tall / whole[1])
    )
    percent = 100 / look.diagonal if look.diagonal > 0 else 1.0
    colors = ScalarMappable(Normalize(0, look.limit * percent), _color_map())
    bar = figure.colorbar(colors, cax=axes, extend="max", extendfrac=0.04)
    bar.ax.tick_params(labelsize=8)
    bar.outline.set_linewidth(0.6)
    bar.set_label("% of the diagonal", fontsize=8.5)
    other = axes.secondary_yaxis("left", functions=(lambda value: value / percent, lambda value: value * percent))
    other.tick_params(labelsize=8)
    other.set_ylabel("units of the mesh", fontsize=8.5)


def _write(figure: Any, x: float, y: float, text: str, size: float, side: str, **style: Any) -> None:
    """Text as it stands: a dollar sign is no formula."""
    figure.text(x, y, text, fontsize=size, ha=side, va="center", parse_math=False, **style)


def _in_text(label: str) -> str:
    return label if len(label) == 1 else label.lower()


def _shortened(name: str) -> str:
    return name if len(name) <= _LONGEST_NAME else name[: _LONGEST_NAME - 15] + "..." + name[-12:]
