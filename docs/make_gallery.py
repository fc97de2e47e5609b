# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes docs/gallery.md and its pictures: eight meshes, simplified by three programs, with their errors.

Needs pyvista, libigl, scipy and trimesh beside this project's packages, as the benchmark does: they are in the
environment of scripts/benchmark.
"""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pymeshlab
import pyvista

import laplacian_simplify as ls

TOP = Path(__file__).parents[1]
sys.path.insert(0, str(TOP / "benchmarks"))

from mesh_topology import Mesh, read_mesh, welded  # noqa: E402
from metrics import Original, Surface, measure  # noqa: E402

PICTURES = TOP / "docs" / "images" / "gallery"
PERCENT = 5  # of the faces are kept
SAMPLES = 100_000
GREY, LINES, BACKGROUND = "#d3dae0", "#59626b", "white"
ERRORS = ("rms", "feature_rms", "hausdorff")
# name, direction from which it is seen, enlargement
VIEWS = {
    "flange": ((1.0, -1.35, 1.05), 1.0),
    "bracket_quads": ((1.0, -1.35, 1.05), 1.0),
    "painted_box": ((1.0, -1.35, 0.9), 1.1),
    "creature": ((0.6, -1.0, 0.5), 1.3),
    "folded_sheet": ((0.5, -1.0, 0.9), 1.1),
    "leaves_and_cones": ((0.6, -1.0, 0.7), 1.2),
    "relief_scan": ((0.55, -1.0, 0.8), 1.1),
    "knot": ((0.2, -0.5, 1.0), 1.3),
}
HEADER = """<!-- SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors -->
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by docs/make_gallery.py; changes by hand are lost. -->
# Gallery

Eight meshes, each simplified to {percent} % of its faces by MeshLab's quadric edge collapse with its defaults, by VTK's
`vtkQuadricDecimation`, and by this project with its defaults. VTK has the smallest rms of the programs in the
[benchmark](benchmark.md#all-tools) that can be installed from PyPI. CGAL's Lindstrom–Turk, which cannot, has a smaller
one still, and Blender is ahead of VTK at features.

The lower row shows the original, colored by the distance from each of its vertices to the simplified surface. The
scale, in percent of the diagonal of the bounding box, is the same for all programs.

The errors are measured by the [benchmark's tool](../benchmarks/metrics.py), in percent of the diagonal: rms in both
directions, rms at the tenth of the vertices with the largest descriptor, and the largest distance; the smallest of a
column is bold. Seven of the meshes are [sample meshes](../sample_meshes/README.md), the knot is made by the script.
"""


def main() -> None:
    PICTURES.mkdir(parents=True, exist_ok=True)
    page = [HEADER.format(percent=PERCENT)]
    for name in VIEWS:
        original = Original(original_mesh(name), SAMPLES)
        results = simplified(original.mesh, max(1, len(original.mesh.faces) * PERCENT // 100))
        draw(name, original.mesh, results)
        page.append(section(name, original, results))
        print(name, flush=True)
    (TOP / "docs" / "gallery.md").write_text("\n".join(page), encoding="utf-8")


def original_mesh(name: str) -> Mesh:
    """As every program gets it: triangles, float32, vertices at the same place are one."""
    if name == "knot":
        return knot()
    path = next(path for path in (TOP / "sample_meshes").glob(f"{name}.*") if path.suffix in (".ply", ".obj"))
    mesh = read_mesh(path)
    return welded(Mesh(mesh.vertices.astype(np.float32).astype(float), mesh.faces))


def knot(along: int = 600, around: int = 40) -> Mesh:
    """A square tube with rounded edges along a trefoil knot, twisted."""
    t = np.linspace(0, 2 * np.pi, along, endpoint=False)[:, None]
    center = np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)], axis=-1)
    forward = np.roll(center, -1, axis=0) - np.roll(center, 1, axis=0)
    side = np.cross(forward, [0, 0, 1])
    side /= np.linalg.norm(side, axis=-1, keepdims=True)
    up = np.cross(side, forward / np.linalg.norm(forward, axis=-1, keepdims=True))
    angle = np.linspace(0, 2 * np.pi, around, endpoint=False)[None, :] + 0 * t
    radius = 0.5 / (np.abs(np.cos(angle)) ** 12 + np.abs(np.sin(angle)) ** 12) ** (1 / 12)
    turned = (angle + t)[..., None]
    points = center + radius[..., None] * (np.cos(turned) * side + np.sin(turned) * up)
    i, j = (index.ravel() for index in np.meshgrid(np.arange(along), np.arange(around), indexing="ij"))
    corner = i * around + j
    right, above = (i + 1) % along * around + j, i * around + (j + 1) % around
    across = (i + 1) % along * around + (j + 1) % around
    faces = np.vstack([np.column_stack([corner, right, across]), np.column_stack([corner, across, above])])
    return Mesh(points.reshape(-1, 3).astype(np.float32).astype(float), faces)


def simplified(mesh: Mesh, target: int) -> dict[str, Mesh]:
    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(pymeshlab.Mesh(mesh.vertices, mesh.faces))
    mesh_set.meshing_decimation_quadric_edge_collapse(targetfacenum=target)
    result = mesh_set.current_mesh()
    poly = pyvista.PolyData.from_regular_faces(mesh.vertices.astype(np.float32), mesh.faces)
    vtk = poly.decimate(1 - target / len(mesh.faces), volume_preservation=False)
    ours = ls.simplify(mesh.vertices, mesh.faces, target_faces=target)
    return {
        "MeshLab, defaults": Mesh(result.vertex_matrix(), result.face_matrix().astype(np.int64)),
        "VTK, quadric": Mesh(np.asarray(vtk.points, float), np.asarray(vtk.regular_faces, np.int64)),
        "this project, defaults": Mesh(ours.vertices, ours.faces.astype(np.int64)),
    }


def draw(name: str, original: Mesh, results: dict[str, Mesh]) -> None:
    distances = {
        title: 100 * np.sqrt(Surface(mesh).closest(original.vertices)[0]) / original.diagonal
        for title, mesh in results.items()
    }
    largest = max(float(np.percentile(values, 99)) for values in distances.values())
    plotter = pyvista.Plotter(off_screen=True, shape=(2, 4), window_size=(1600, 800), border=False)
    plotter.set_background(BACKGROUND)
    plotter.subplot(0, 0)
    plotter.add_mesh(poly_of(original), color=GREY, ambient=0.25)
    look(plotter, name, f"{name}: {len(original.faces):,} faces")
    for column, (title, mesh) in enumerate(results.items(), 1):
        plotter.subplot(0, column)
        plotter.add_mesh(poly_of(mesh), color=GREY, show_edges=True, edge_color=LINES, ambient=0.25)
        look(plotter, name, f"{title}: {len(mesh.faces):,} faces")
        plotter.subplot(1, column)
        surface = poly_of(original)
        surface["distance"] = distances[title]
        plotter.add_mesh(surface, cmap="viridis", clim=(0, largest), ambient=0.3, show_scalar_bar=False)
        look(plotter, name, title)
    plotter.subplot(1, 0)
    text = f"distance to the original:\nblue 0, yellow {largest:.3f} %\nof the diagonal, or more"
    plotter.add_text(text, font_size=11, color="black", position=(0.2, 0.45), viewport=True, font="arial")
    file = PICTURES / f"{name}.png"
    plotter.screenshot(file)
    plotter.close()
    subprocess.run(["convert", file, "-strip", "-colors", "96", file], check=True)  # a third of the size


def poly_of(mesh: Mesh) -> pyvista.PolyData:
    return pyvista.PolyData.from_regular_faces(mesh.vertices, mesh.faces)


def look(plotter: pyvista.Plotter, name: str, text: str) -> None:
    direction, enlargement = VIEWS[name]
    plotter.add_text(text, font_size=9, color="black", position="upper_edge", font="arial")
    plotter.view_vector(direction, viewup=(0, 0, 1))
    plotter.camera.zoom(enlargement)


def cell(value: float, column: list[float]) -> str:
    return f"**{value:.4f}**" if value == min(column) else f"{value:.4f}"


def section(name: str, original: Original, results: dict[str, Mesh]) -> str:
    lines = [f"## {name}", "", f"![{name}, simplified by three programs](images/gallery/{name}.png)", ""]
    lines += ["| | faces | rms | rms at features | largest | folded faces | new non-manifold edges |"]
    lines += ["|---|---|---|---|---|---|---|"]
    measured = {title: measure(original, mesh) for title, mesh in results.items()}
    for title, values in measured.items():
        errors = " | ".join(cell(values[key], [row[key] for row in measured.values()]) for key in ERRORS)
        faults = f"{values['folded_faces']} | {max(0, values['new_non_manifold_edges'])}"
        lines.append(f"| {title} | {len(results[title].faces):,} | {errors} | {faults} |")
    return "\n".join([*lines, ""])


if __name__ == "__main__":
    main()
