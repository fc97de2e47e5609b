# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Error maps: the original, coloured by its distance to the result of each tool."""

from pathlib import Path

import numpy as np
import pyvista

from meshes import BenchmarkMesh
from metrics import Surface
from peers import peer_named
from runs import Workshop, load_result, result_path

SHOWN = ("pymeshlab", "meshoptimizer_update", "cgal_lt", "cgal_gh", "fast", "balanced", "best")
PANEL = (300, 270)
COLUMNS = 4
CAMERAS = {  # direction from which the mesh is seen, what is up, zoom
    "fandisk": ((1.0, -0.9, 0.7), (0.0, 0.0, 1.0), 1.6),
    "bunny": ((0.25, 0.2, 1.0), (0.0, 1.0, 0.0), 1.3),
    "rocker_arm": ((0.3, 1.0, 0.5), (1.0, 0.0, 0.0), 1.2),
}
LARGEST_BYTES = 150_000


def distances_to_result(workshop: Workshop, peer_id: str, mesh: BenchmarkMesh, percent: float) -> np.ndarray:
    """Distance of each of the original's vertices to a result, in percent of the diagonal."""
    original = mesh.load()
    squared, _ = Surface(load_result(result_path(workshop, peer_id, mesh, percent))).closest(original.vertices)
    return 100 / original.diagonal * np.sqrt(squared)


def draw_error_maps(workshop: Workshop, mesh: BenchmarkMesh, percent: float, destination: Path, captions: dict) -> None:
    """One picture with a panel for each tool that has a result; all share one scale."""
    errors = {
        peer_id: distances_to_result(workshop, peer_id, mesh, percent)
        for peer_id in SHOWN
        if result_path(workshop, peer_id, mesh, percent).exists()
    }
    top = max(np.percentile(error, 99) for peer_id, error in errors.items() if peer_id.startswith("cgal"))
    rows = -(-len(errors) // COLUMNS)
    plotter = pyvista.Plotter(
        off_screen=True, shape=(rows, COLUMNS), window_size=(COLUMNS * PANEL[0], rows * PANEL[1]), border=False
    )
    original = mesh.load()
    surface = pyvista.PolyData.from_regular_faces(original.vertices, original.faces)
    for number, (peer_id, error) in enumerate(errors.items()):
        plotter.subplot(number // COLUMNS, number % COLUMNS)
        _draw_panel(plotter, surface.copy(), error, top, _caption(peer_id) + "\n" + captions.get(peer_id, ""))
        _look(plotter, mesh.name)
    _draw_scale(plotter, rows, len(errors), surface, top)
    _save_small(plotter, destination)


def _caption(peer_id: str) -> str:
    peer = peer_named(peer_id)
    settings = peer.settings.split(",")[0].replace("–", "-")
    return settings if peer.library == "this project" else f"{peer.library.split()[0]}: {settings}"


def _draw_panel(plotter, surface, error, top, caption) -> None:
    surface["error"] = error
    plotter.add_mesh(surface, scalars="error", clim=(0, top), cmap="viridis", show_scalar_bar=False)
    plotter.add_text(caption, font_size=7, color="black", position=(6, PANEL[1] - 32))
    plotter.set_background("white")


def _look(plotter, name) -> None:
    direction, up, zoom = CAMERAS.get(name, ((1.0, 1.0, 1.0), (0.0, 0.0, 1.0), 1.2))
    plotter.view_vector(direction, viewup=up)
    plotter.camera.zoom(zoom)


def _draw_scale(plotter, rows, panels, surface, top) -> None:
    """The colour bar, in the first empty panel or over the last one."""
    if panels < rows * COLUMNS:
        plotter.subplot(rows - 1, COLUMNS - 1)
        plotter.set_background("white")
        dot = surface.extract_points([0], include_cells=False)
        dot["distance, % of the diagonal"] = np.zeros(dot.n_points)
        bar = {"color": "black", "position_x": 0.1, "position_y": 0.4, "width": 0.8, "fmt": "%.2g", "n_labels": 3}
        scalars = "distance, % of the diagonal"
        plotter.add_mesh(dot, scalars=scalars, clim=(0, top), cmap="viridis", opacity=0, scalar_bar_args=bar)


def _save_small(plotter, destination: Path) -> None:
    """As PNG with a palette, which keeps the colours and stays small.

    :raises RuntimeError: if the picture is larger than pages should load.
    """
    from PIL import Image

    picture = Image.fromarray(plotter.screenshot(return_img=True))
    plotter.close()
    destination.parent.mkdir(parents=True, exist_ok=True)
    picture.quantize(192, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE).save(destination, optimize=True)
    if destination.stat().st_size > LARGEST_BYTES:
        raise RuntimeError(f"{destination.name} has {destination.stat().st_size} bytes, more than {LARGEST_BYTES}")
