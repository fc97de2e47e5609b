# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The descriptor beside curvatures: Fig. 3 and 4."""

import numpy as np
from matplotlib.figure import Figure

from drawing import Panel, draw, save_figure
from mesh_topology import Mesh
from page import Check, Entry
from statistics_of import explained, grouping, largest_dihedral, segments, separation, to_unit
from studio import Studio

KINDS = ("laplacian", "mean_curvature", "gaussian_curvature", "curvature_estimation")
NAMES = {
    "laplacian": "Laplacian descriptor",
    "mean_curvature": "mean curvature",
    "gaussian_curvature": "Gaussian curvature",
    "curvature_estimation": "curvature estimation",
}
SEGMENTS = 6


def comparison_of_descriptors(studio: Studio) -> Entry:
    """Fig. 3."""
    roles, rows, areas = ("fandisk", "bunny"), [], {}
    figure = Figure(figsize=(9, 3.4))
    for axes, role in zip(figure.subplots(1, 2), roles, strict=True):
        model = studio.models[role]
        for kind in KINDS:
            values = to_unit(studio.descriptor(role, kind))
            axes.plot(np.sort(values), label=NAMES[kind], linewidth=1.2)
            areas[role, kind] = separation(values, model.is_sharp)
            rows.append([model.name, NAMES[kind], areas[role, kind], grouping(values)])
        axes.set(title=model.name, xlabel="vertices, sorted", ylabel="descriptor, scaled")
        axes.legend(fontsize=7)
    save_figure(figure, studio.pictures / "figure_3_sorted.png")
    for role in roles:
        model = studio.models[role]
        values = studio.descriptor(role)
        draw(
            [Panel("model", model.mesh), Panel("Laplacian descriptor", model.mesh, values, as_points=True)],
            model.name,
            studio.pictures / f"figure_3_{role}.png",
        )
    steps = {kind: grouping(to_unit(studio.descriptor("fandisk", kind))) for kind in KINDS}
    return Entry(
        title="Fig. 3: the descriptor compared with curvatures",
        claim="Laplacian descriptors are larger at features than in flat regions, and like mean curvature, but unlike "
        "Gaussian curvature and curvature estimation, they come in groups: a sorted plot is a staircase.",
        pictures=[
            (
                f"figure_3_{role}.png",
                f"{studio.models[role].name}: shaded, and its vertices colored by the Laplacian descriptor",
            )
            for role in roles
        ]
        + [("figure_3_sorted.png", "All descriptors, sorted and scaled to [0, 1]")],
        columns=["model", "descriptor", "separation of creases", "grouping"],
        rows=rows,
        checks=[
            Check(
                "the Laplacian descriptor separates crease vertices of the mechanical part (at least 0.95)",
                areas["fandisk", "laplacian"] >= 0.95,
            ),
            Check(
                "… better than Gaussian curvature",
                areas["fandisk", "laplacian"] > areas["fandisk", "gaussian_curvature"],
            ),
            Check(
                "… better than curvature estimation",
                areas["fandisk", "laplacian"] > areas["fandisk", "curvature_estimation"],
            ),
            Check(
                "Laplacian and mean curvature are grouped more than Gaussian curvature",
                min(steps["laplacian"], steps["mean_curvature"]) > steps["gaussian_curvature"],
            ),
            Check(
                "… and more than curvature estimation",
                min(steps["laplacian"], steps["mean_curvature"]) > steps["curvature_estimation"],
            ),
        ],
        notes=[
            "Separation: the probability that a vertex on an edge with a dihedral angle over 30° has a larger value "
            "than another vertex; 0.5 is chance. Grouping: the fraction of the variance that five classes (exact "
            "k-means) explain."
        ],
    )


def segments_of_the_curve(studio: Studio) -> Entry:
    """Fig. 4."""
    model = studio.models["fandisk"]
    angle = largest_dihedral(model.mesh)
    rows = []
    explained_by = {}
    for kind in KINDS:
        groups = segments(studio.descriptor("fandisk", kind), SEGMENTS)
        explained_by[kind] = explained(angle, groups)
        rows.append([NAMES[kind], explained_by[kind], *(int((groups == g).sum()) for g in range(SEGMENTS))])
    values = to_unit(studio.descriptor("fandisk"))
    groups = segments(values, SEGMENTS)
    order = np.argsort(values, kind="stable")
    shown = order[np.flatnonzero(groups[order] > 0)[0] - 200 :]
    figure = Figure(figsize=(6, 3.2))
    axes = figure.subplots()
    axes.scatter(
        np.arange(len(order) - len(shown), len(order)),
        values[shown],
        c=groups[shown],
        cmap="turbo",
        s=4,
        vmin=0,
        vmax=SEGMENTS - 1,
    )
    axes.set(xlabel="vertices, sorted", ylabel="Laplacian descriptor, scaled")
    save_figure(figure, studio.pictures / "figure_4_sorted.png")
    upper = groups > 0
    vertices = Mesh(model.mesh.vertices[upper], np.zeros((0, 3), dtype=np.int64))
    draw(
        [
            Panel("all vertices", model.mesh, groups.astype(float), True, (0, SEGMENTS - 1), "turbo"),
            Panel(
                "those above the lowest segment",
                vertices,
                groups[upper].astype(float),
                True,
                (0, SEGMENTS - 1),
                "turbo",
            ),
        ],
        model.name,
        studio.pictures / "figure_4_points.png",
    )
    return Entry(
        title="Fig. 4: segments of the sorted curve",
        claim="Each segment of the sorted Laplacian descriptors is a group of vertices of the same kind, more "
        "accurately than for Gaussian curvature and curvature estimation.",
        pictures=[
            ("figure_4_sorted.png", "Upper part of the sorted descriptors, colored by segment"),
            ("figure_4_points.png", "The same vertices in space"),
        ],
        columns=["descriptor", "dihedral explained", *(f"size {g + 1}" for g in range(SEGMENTS))],
        rows=rows,
        checks=[
            Check(
                f"its segments explain more of the edge angle at a vertex than those of {NAMES[kind]}",
                explained_by["laplacian"] > explained_by[kind],
            )
            for kind in ("gaussian_curvature", "curvature_estimation")
        ],
        notes=[
            "Explained: the fraction of the variance of the largest dihedral angle at a vertex that lies between the "
            f"{SEGMENTS} segments; 1 would mean that all vertices of a segment are alike."
        ],
    )
