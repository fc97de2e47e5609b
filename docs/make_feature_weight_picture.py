# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes docs/feature_weights.png: the same number of faces with feature weights 0, 2 and 8.

Needs pyvista beside this project's packages, as make_picture.py does.
"""

import subprocess

import pyvista
from make_picture import TOP, caption, show_result

import laplacian_simplify as ls

# name, percent of the faces to keep, direction from which it is seen, enlargement
EXAMPLES = (("flange.ply", 2, (1.0, -1.35, 1.05), 1.05), ("relief_scan.ply", 2, (0.55, -1.0, 0.8), 1.2))
FEATURE_WEIGHTS = (0, 2, 8)


def main() -> None:
    shape = (len(EXAMPLES), len(FEATURE_WEIGHTS))
    plotter = pyvista.Plotter(off_screen=True, shape=shape, window_size=(1800, 1000), border=False)
    plotter.set_background("white")
    for row, (name, percent, direction, enlargement) in enumerate(EXAMPLES):
        for column, weight in enumerate(FEATURE_WEIGHTS):
            report = ls.simplify(TOP / "sample_meshes" / name, target_percent=percent, feature_weight=weight)
            plotter.subplot(row, column)
            show_result(plotter, report.mesh_set.current_mesh())
            text = f"feature weight {weight}: {report.faces} faces\nrms {report.rms:.4f} %, at features "
            caption(plotter, f"{text}{report.feature_rms:.4f} %", direction, enlargement)
    file = TOP / "docs" / "feature_weights.png"
    plotter.screenshot(file)
    subprocess.run(["convert", file, "-strip", "-colors", "128", file], check=True)  # a third of the size


if __name__ == "__main__":
    main()
