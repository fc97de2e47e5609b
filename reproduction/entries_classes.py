# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Vertex classes: Fig. 6 with 9, 7 and 8."""

import numpy as np
from matplotlib.figure import Figure

from drawing import Panel, draw, save_figure
from mesh_topology import Mesh
from metrics import Surface
from page import Check, Entry
from statistics_of import precision_and_recall
from studio import Studio

BORDER_SAMPLES = 8  # on every sharp edge


def border_points(mesh: Mesh, is_sharp: np.ndarray) -> np.ndarray:
    """Samples of the edges between two sharp vertices: the borders of a mechanical part."""
    ends = np.stack([mesh.faces, np.roll(mesh.faces, -1, axis=1)], axis=2).reshape(-1, 2)
    ends = np.unique(np.sort(ends[is_sharp[ends].all(axis=1)], axis=1), axis=0)
    part = (np.arange(BORDER_SAMPLES) + 0.5) / BORDER_SAMPLES
    first, second = mesh.vertices[ends[:, 0]], mesh.vertices[ends[:, 1]]
    return (first[:, None] * (1 - part[:, None]) + second[:, None] * part[:, None]).reshape(-1, 3)


def borders(studio: Studio) -> Entry:
    """Fig. 6 and 9."""
    rows, checks, pictures = [], [], []
    for role in ("mech_a", "mech_b", "fandisk"):
        model = studio.models[role]
        target = max(500, len(model.mesh.faces) // 6)
        points = border_points(model.mesh, model.is_sharp)
        plain = studio.decimate(role, target, error_function="shortest_edge", feature_weight=0.0)
        aware = studio.decimate(
            role, target, error_function="shortest_edge", feature_weight=0.0, class_aware=True, refine=True
        )
        distances = []
        for name, result in (("plain", plain), ("class-aware", aware)):
            squared, _ = Surface(result.mesh).closest(points)
            distance = 100 / model.mesh.diagonal * np.sqrt(squared)
            distances.append((float(distance.max()), float(np.sqrt((distance**2).mean()))))
            rows.append(
                [
                    model.name,
                    name,
                    len(result.mesh.faces),
                    *distances[-1],
                    result.numbers["rms"],
                    result.numbers["hausdorff"],
                    result.numbers["feature_rms"],
                    result.numbers["normal_deviation"],
                    result.numbers["seconds"],
                ]
            )
        checks += [
            Check(
                f"{model.name}: class-aware collapses have the smaller largest distance of a border point",
                distances[1][0] < distances[0][0],
            ),
            Check(
                f"{model.name}: … and the smaller rms distance of the border points", distances[1][1] < distances[0][1]
            ),
        ]
        name = f"figure_6_9_{role}.png"
        draw(
            [
                Panel("original", model.mesh),
                Panel(f"shortest edge first ({target} faces)", plain.mesh, edges=True),
                Panel("class-aware (Fig. 9)", aware.mesh, edges=True),
            ],
            model.name,
            studio.pictures / name,
        )
        pictures.append((name, f"{model.name}: original, shortest edge first, and with classes"))
    return Entry(
        title="Fig. 6 and 9: borders and classes",
        claim="Shortest edge first distorts the borders of mechanical parts; if feature vertices collapse into "
        "feature neighbors only, the borders are preserved.",
        pictures=pictures,
        columns=[
            "model",
            "shortest edge first",
            "faces",
            "largest border distance",
            "border rms",
            "rms",
            "Hausdorff",
            "feature rms",
            "normal deviation, °",
            "s",
        ],
        rows=rows,
        checks=checks,
        notes=[
            "Distances in percent of the bounding box diagonal. Borders are the edges between vertices with a dihedral "
            f"angle over 30°, sampled at {BORDER_SAMPLES} points each. A sixth of the faces is kept, as in the paper."
        ],
    )


def two_classes(studio: Studio) -> Entry:
    """Fig. 7."""
    model = studio.models["fandisk"]
    selected, report = studio.features("fandisk")
    values = studio.descriptor("fandisk")
    precision, recall = precision_and_recall(selected, model.is_sharp)
    order = np.argsort(values, kind="stable")
    figure = Figure(figsize=(5, 3))
    axes = figure.subplots()
    axes.scatter(np.arange(len(order)), values[order], s=3, c=np.where(selected[order], "#c0392b", "#2c5f8a"))
    axes.axhline(report.thresholds[0], color="black", linewidth=0.6)
    axes.set(xlabel="vertices, sorted", ylabel="Laplacian descriptor")
    save_figure(figure, studio.pictures / "figure_7_sorted.png")
    draw(
        [Panel("features", *only(model.mesh, selected)), Panel("model", model.mesh)],
        model.name,
        studio.pictures / "figure_7_points.png",
    )
    return Entry(
        title="Fig. 7: two classes",
        claim="K-means on the Laplacian descriptors divides the vertices of a mechanical part into features and "
        "the rest.",
        pictures=[
            ("figure_7_sorted.png", f"{model.name}: sorted descriptors, features in red, and the threshold"),
            ("figure_7_points.png", "The feature vertices in space, beside the model"),
        ],
        columns=["model", "vertices", "features", "threshold", "true features", "precision, %", "recall, %"],
        rows=[
            [
                model.name,
                len(values),
                int(selected.sum()),
                report.thresholds[0],
                int(model.is_sharp.sum()),
                precision,
                recall,
            ]
        ],
        checks=[
            Check("at least 95 % of the selected vertices are true features", precision >= 95),
            Check("at least 90 % of the true features are selected", recall >= 90),
        ],
        notes=["True features lie on an edge with a dihedral angle over 30°."],
    )


def only(mesh: Mesh, chosen: np.ndarray, values: np.ndarray | None = None):
    """Arguments of a panel that shows some of the vertices as points."""
    values = np.ones(int(chosen.sum())) if values is None else values[chosen]
    return Mesh(mesh.vertices[chosen], np.zeros((0, 3), dtype=np.int64)), values, True, (0.0, 1.0), "coolwarm"


def refinement(studio: Studio) -> Entry:
    """Fig. 8."""
    rows, checks, pictures = [], [], []
    for role in ("fandisk", "mech_b"):
        model = studio.models[role]
        before, _ = studio.features(role)
        after, report = studio.features(role, refine=True)
        old, new = precision_and_recall(before, model.is_sharp), precision_and_recall(after, model.is_sharp)
        rows += [
            [model.name, "k-means", int(before.sum()), 0, *old],
            [model.name, "refined", int(after.sum()), int(report.promoted), *new],
        ]
        checks += [
            Check(f"{model.name}: the refinement only adds vertices", bool((after | ~before).all())),
            Check(f"{model.name}: more true features are found", new[1] > old[1]),
            Check(f"{model.name}: precision falls by at most one percentage point", new[0] >= old[0] - 1),
        ]
        name = f"figure_8_{role}.png"
        draw(
            [
                Panel("features before", *only(model.mesh, before)),
                Panel("after (recaptured in blue)", *only(model.mesh, after, before.astype(float))),
            ],
            model.name,
            studio.pictures / name,
        )
        pictures.append((name, f"{model.name}: feature vertices before and after the refinement"))
    return Entry(
        title="Fig. 8: refined classes",
        claim="The refinement returns feature vertices that k-means missed to the feature class.",
        pictures=pictures,
        columns=["model", "classes", "features", "promoted", "precision, %", "recall, %"],
        rows=rows,
        checks=checks,
        notes=[
            "If a feature vertex has fewer than two feature neighbors, a neighbor is promoted whose descriptor is at "
            "least half the threshold. If k-means left no gap, there is nothing to recapture."
        ],
    )
