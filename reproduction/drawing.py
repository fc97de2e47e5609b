# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of surfaces and of vertices in space, rendered off-screen, and small files of them."""

import io
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pyvista
from matplotlib.figure import Figure
from PIL import Image

from mesh_topology import Mesh

PANEL = (340, 320)
LARGEST_BYTES = 150_000
FEW_FACES = 20_000  # up to there edges can be told apart in a panel
DIRECTIONS = {  # from where a model is seen, and what is up; others from the diagonal
    "cow": ((0.4, 0.35, 1), (0, 1, 0)),
    "bunny": ((0.25, 0.2, 1), (0, 1, 0)),
    "fandisk": ((1, -0.9, 0.7), (0, 0, 1)),
    "rocker_arm": ((0.3, 1, 0.5), (0, 0, 1)),
    "elephant": ((1, 0.3, 0.8), (0, 1, 0)),
}


@dataclass(frozen=True)
class Panel:
    """A mesh with a caption: shaded, or its vertices as points coloured by a value each."""

    caption: str
    mesh: Mesh
    values: np.ndarray | None = None  # one a vertex
    as_points: bool = False
    limits: tuple[float, float] | None = None
    colors: str = "viridis"
    edges: bool = False


def draw(panels: list[Panel], view: str, destination: Path, columns: int | None = None) -> None:
    """Panels side by side, all seen from where `view` says."""
    columns = columns or len(panels)
    rows = -(-len(panels) // columns)
    plotter = pyvista.Plotter(
        off_screen=True, shape=(rows, columns), window_size=(columns * PANEL[0], rows * PANEL[1]), border=False
    )
    for number, panel in enumerate(panels):
        plotter.subplot(number // columns, number % columns)
        plotter.set_background("white")
        _draw_panel(plotter, panel)
        direction, up = DIRECTIONS.get(view, ((1, -1, 0.8), (0, 0, 1)))
        plotter.view_vector(direction, viewup=up)
        plotter.camera.zoom(1.1)
    picture = plotter.screenshot(return_img=True)
    plotter.close()
    save_small(Image.fromarray(picture), destination)


def _draw_panel(plotter, panel: Panel) -> None:
    surface = pyvista.PolyData.from_regular_faces(panel.mesh.vertices, panel.mesh.faces)
    colored = {}
    if panel.values is not None:
        limits = panel.limits or (0.0, float(np.percentile(panel.values, 99.9)) or 1.0)
        colored = {"scalars": panel.values, "clim": limits, "cmap": panel.colors, "show_scalar_bar": False}
    if panel.as_points:
        points = pyvista.PolyData(panel.mesh.vertices)
        plotter.add_mesh(points, style="points", point_size=3 if len(panel.mesh.vertices) > 5000 else 4, **colored)
    else:
        edges = panel.edges and len(panel.mesh.faces) <= FEW_FACES
        plotter.add_mesh(
            surface,
            color=None if colored else "#d8dde6",
            show_edges=edges,
            edge_color="#5a6472",
            line_width=0.5,
            **colored,
        )
    caption = panel.caption.replace("λ", "lambda")  # the font has no Greek
    plotter.add_text(caption, font_size=7, color="black", position=(0.02, 0.93), viewport=True)


def save_figure(figure: Figure, destination: Path) -> None:
    """A plot of matplotlib."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=100, bbox_inches="tight")
    save_small(Image.open(buffer), destination)


def save_small(picture: Image.Image, destination: Path) -> None:
    """As PNG with a palette.

    :raises RuntimeError: if the file is larger than a page should load.
    """
    destination.parent.mkdir(parents=True, exist_ok=True)
    for colors in (128, 64, 32):
        picture.convert("RGB").quantize(colors, dither=Image.Dither.NONE).save(destination, optimize=True)
        if destination.stat().st_size <= LARGEST_BYTES:
            return
    raise RuntimeError(f"{destination.name} has {destination.stat().st_size} bytes, more than {LARGEST_BYTES}")
