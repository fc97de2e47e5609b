# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes docs/picture.png, the picture of the README, from a run on two of the sample meshes.

Needs pyvista beside this project's packages:
    scripts/python -m venv --system-site-packages ENV; ENV/bin/pip install pyvista; see CONTRIBUTING.md
"""

from pathlib import Path

import numpy as np
import pyvista

import laplacian_simplify as ls

TOP = Path(__file__).parents[1]
# name, percent of the faces to keep, direction from which it is seen
EXAMPLES = (("flange.ply", 3, (1.0, -1.35, 1.05)), ("relief_scan.ply", 3, (0.55, -1.0, 0.8)))
WINDOW = (1500, 1000)


def main() -> None:
    plotter = pyvista.Plotter(off_screen=True, shape=(len(EXAMPLES), 2), window_size=WINDOW, border=False)
    plotter.set_background("white")
    for row, (name, percent, direction) in enumerate(EXAMPLES):
        original = ls.descriptor(TOP / "sample_meshes" / name, rescale=True).mesh_set
        report = ls.simplify(TOP / "sample_meshes" / name, target_percent=percent)
        ls.descriptor(report.mesh_set, rescale=True)
        plotter.subplot(row, 0)
        show(plotter, original.current_mesh(), f"{name}: {report.faces_before:,} faces", direction, edges=False)
        plotter.subplot(row, 1)
        text = f"{percent} %: {report.faces:,} faces, rms {report.rms:.3f} % of the diagonal"
        show(plotter, report.mesh_set.current_mesh(), text, direction, edges=True)
    plotter.screenshot(TOP / "docs" / "picture.png")


def show(plotter: pyvista.Plotter, mesh, text: str, direction: tuple[float, float, float], *, edges: bool) -> None:
    """Shaded flat and coloured by the descriptor: grey where flat, red on features."""
    faces = np.column_stack([np.full(mesh.face_number(), 3), mesh.face_matrix()]).ravel()
    surface = pyvista.PolyData(mesh.vertex_matrix(), faces)
    surface["descriptor"] = mesh.vertex_scalar_array()
    plotter.add_mesh(
        surface,
        scalars="descriptor",
        cmap=["#c9d3dc", "#d8bdb0", "#dd8f70", "#cf4a34", "#a3142a"],
        clim=(0, 1),
        show_scalar_bar=False,
        show_edges=edges,
        edge_color="#3a3f45",
        line_width=1,
        ambient=0.25,
        interpolate_before_map=True,
    )
    plotter.add_text(text, font_size=13, color="black", position="lower_edge")
    plotter.view_vector(direction, viewup=(0, 0, 1))
    plotter.camera.zoom(1.35)


if __name__ == "__main__":
    main()
