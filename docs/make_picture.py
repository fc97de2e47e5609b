# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes docs/picture.png, the picture of the README, from a run on two of the sample meshes.

Needs pyvista beside this project's packages, as the benchmark does.
"""

from pathlib import Path

import numpy as np
import pyvista

import laplacian_simplify as ls

TOP = Path(__file__).parents[1]
# name, percent of the faces to keep, direction from which it is seen, enlargement
EXAMPLES = (("flange.ply", 3, (1.0, -1.35, 1.05), 1.05), ("relief_scan.ply", 3, (0.55, -1.0, 0.8), 1.45))
WINDOW = (1500, 960)
GREY, RED = "#d3dae0", "#b5182e"
FROM_FLAT_TO_FEATURE = [GREY, "#dcc3b8", "#dd8f70", "#cf4a34", RED]
FEATURE_ANGLE = 35  # degrees between the faces at an edge that is drawn red


def main() -> None:
    plotter = pyvista.Plotter(off_screen=True, shape=(len(EXAMPLES), 2), window_size=WINDOW, border=False)
    plotter.set_background("white")
    for row, (name, percent, direction, enlargement) in enumerate(EXAMPLES):
        source = TOP / "sample_meshes" / name
        original = ls.descriptor(source, rescale=True)
        report = ls.simplify(source, target_percent=percent)
        plotter.subplot(row, 0)
        show_original(plotter, original.mesh_set.current_mesh())
        caption(plotter, f"{name}: {report.faces_before:,} faces, descriptor in red", direction, enlargement)
        plotter.subplot(row, 1)
        show_result(plotter, report.mesh_set.current_mesh())
        caption(
            plotter,
            f"{percent} %: {report.faces:,} faces, edges over {FEATURE_ANGLE} degrees in red",
            direction,
            enlargement,
        )
    plotter.screenshot(TOP / "docs" / "picture.png")


def surface_of(mesh) -> pyvista.PolyData:
    faces = np.column_stack([np.full(mesh.face_number(), 3), mesh.face_matrix()]).ravel()
    return pyvista.PolyData(mesh.vertex_matrix(), faces)


def show_original(plotter: pyvista.Plotter, mesh) -> None:
    """Coloured by its descriptor, grey where it is flat."""
    surface = surface_of(mesh)
    surface["descriptor"] = mesh.vertex_scalar_array()
    plotter.add_mesh(surface, cmap=FROM_FLAT_TO_FEATURE, clim=(0, 1), show_scalar_bar=False, ambient=0.25)


def show_result(plotter: pyvista.Plotter, mesh) -> None:
    """With its edges, sharp ones in red."""
    surface = surface_of(mesh)
    plotter.add_mesh(surface, color=GREY, show_edges=True, edge_color="#59626b", line_width=1, ambient=0.25)
    sharp = surface.extract_feature_edges(
        FEATURE_ANGLE, boundary_edges=False, non_manifold_edges=False, manifold_edges=False
    )
    plotter.add_mesh(sharp, color=RED, line_width=4)


def caption(plotter: pyvista.Plotter, text: str, direction: tuple[float, float, float], enlargement: float) -> None:
    plotter.add_text(text, font_size=11, color="black", position="upper_edge", font="arial")
    plotter.view_vector(direction, viewup=(0, 0, 1))
    plotter.camera.zoom(enlargement)


if __name__ == "__main__":
    main()
