# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators, other kinds of meshes, and times: Fig. 1, 10 and Table 1."""

import numpy as np

from drawing import Panel, draw
from entries_descriptor import KINDS
from mesh_topology import Mesh
from page import Check, Entry
from statistics_of import largest_dihedral, separation
from studio import Studio, polygon_descriptor


def operators(studio: Studio) -> Entry:
    """Fig. 1."""
    model = studio.models["fandisk"]
    flat = studio.descriptor("fandisk") < 1e-5
    panels, rows, movement = [Panel("(a) original", model.mesh)], [], {}
    for letter, operator in zip("bcd", ("umbrella", "scale_dependent", "normal_dependent"), strict=True):
        name = operator.replace("_", "-")
        one = np.linalg.norm(studio.smoothed("fandisk", operator=operator, steps=1) - model.mesh.vertices, axis=1)
        vertices = studio.smoothed("fandisk", operator=operator, steps=10)
        ten = 100 / model.mesh.diagonal * np.linalg.norm(vertices - model.mesh.vertices, axis=1)
        movement[operator] = (ten[model.is_sharp].mean(), 100 / model.mesh.diagonal * one[flat].mean())
        rows.append([name, float(ten[model.is_sharp].mean()), float(ten.mean()), float(movement[operator][1])])
        panels.append(Panel(f"({letter}) {name}", Mesh(vertices, model.mesh.faces)))
    draw(panels, model.name, studio.pictures / "figure_1.png", columns=2)
    creases, planes = zip(
        *(movement[name] for name in ("umbrella", "scale_dependent", "normal_dependent")), strict=True
    )
    return Entry(
        title="Fig. 1: the three umbrella operators",
        claim="Smoothing with the umbrella and the scale-dependent operator distorts lines and corners; "
        "the normal-dependent operator does not.",
        pictures=[("figure_1.png", f"{model.name}, ten steps of size 0.5 with each operator")],
        columns=["operator", "movement of crease vertices, %", "of all vertices, %", "of flat vertices in one step, %"],
        rows=rows,
        checks=[
            Check(
                "crease vertices move less with the normal-dependent operator than with the umbrella",
                creases[2] < creases[0],
            ),
            Check("… and less than with the scale-dependent operator", creases[2] < creases[1]),
            Check("flat vertices move least with the normal-dependent operator", planes[2] < min(planes[:2])),
            Check("crease vertices stay (less than 0.01 %)", creases[2] < 0.01),
        ],
        notes=[
            "Percent of the bounding box diagonal. Crease vertices lie on an edge with a dihedral angle over 30°. The "
            "last check takes the claim literally: the normal-dependent operator moves creases too, inward, but not "
            "along themselves."
        ],
    )


def other_meshes(studio: Studio) -> Entry:
    """Fig. 10."""
    rows, checks, pictures = [], [], []
    for role, kind in (("non_manifold", "non-manifold"), ("quads", "quads")):
        model = studio.models[role]
        vertices, faces, values = polygon_descriptor(model.path)
        mesh = Mesh(vertices, faces)
        angle = largest_dihedral(mesh)
        flat, crease = values[angle < 1e-3], values[angle > 30]
        area = separation(values, angle > 30)
        rows.append(
            [
                model.name,
                kind,
                len(values),
                area,
                float(np.median(crease)) if len(crease) else None,
                float(flat.max()) if len(flat) else None,
            ]
        )
        name = f"figure_10_{role}.png"
        draw(
            [Panel(f"{kind} mesh", mesh, edges=True), Panel("Laplacian descriptor", mesh, values, as_points=True)],
            model.name,
            studio.pictures / name,
        )
        pictures.append((name, f"{model.name}: the mesh as triangles, and its vertices colored by the descriptor"))
        checks.append(
            Check(
                f"{kind}: every value is finite and in [0, 1]",
                bool(np.isfinite(values).all() and values.min() >= 0 and values.max() <= 1),
            )
        )
        checks.append(Check(f"{kind}: creases are separated (at least 0.9)", area >= 0.9))
        if len(flat):
            checks.append(Check(f"{kind}: flat vertices have at most 0.001", float(flat.max()) <= 1e-3))
    return Entry(
        title="Fig. 10: non-manifold and quad meshes",
        claim="The descriptor extends to non-manifold and quad meshes.",
        pictures=pictures,
        columns=["model", "kind", "vertices", "separation of creases", "median at creases", "largest in flat regions"],
        rows=rows,
        checks=checks,
        notes=[
            "Creases: vertices with a dihedral angle over 30°; flat: with none over 0.001°. A dash: there is no such "
            "vertex."
        ],
    )


PAPER_SECONDS = {  # of Table 1: Laplacian, mean curvature, curvature estimation
    "cow": (0.004, 0.009, 0.006),
    "fandisk": (0.009, 0.021, 0.012),
    "mech_a": (0.027, 0.081, 0.038),
    "mech_b": (0.026, 0.08, 0.03),
    "girl": (0.028, 0.122, 0.043),
    "bunny": (0.065, 0.469, 0.118),
}


def times(studio: Studio) -> Entry:
    """Table 1."""
    rows, ratios, estimation = [], [], []
    for role, (laplacian, mean, estimate) in PAPER_SECONDS.items():
        model = studio.models[role]
        milliseconds = studio.descriptor_milliseconds(role, KINDS)
        ratios.append(milliseconds["mean_curvature"] / milliseconds["laplacian"])
        estimation.append(milliseconds["curvature_estimation"] / milliseconds["laplacian"])
        rows.append(
            [
                model.name,
                len(model.mesh.faces),
                *(milliseconds[kind] for kind in KINDS),
                ratios[-1],
                mean / laplacian,
                estimation[-1],
                estimate / laplacian,
            ]
        )
    return Entry(
        title="Table 1: computing time of the descriptors",
        claim="The Laplacian descriptor is much faster than mean curvature (2.2 to 7.2 times in the paper); curvature "
        "estimation takes a similar time (1.2 to 1.8 times).",
        pictures=[],
        columns=[
            "model",
            "faces",
            "Laplacian, ms",
            "mean curvature, ms",
            "Gaussian curvature, ms",
            "curvature estimation, ms",
            "mean / Laplacian",
            "the paper's",
            "estimation / Laplacian",
            "the paper's",
        ],
        rows=rows,
        checks=[
            Check("faster than mean curvature on every model", min(ratios) > 1),
            Check("at least 5 times faster on every model", min(ratios) >= 5),
            Check(
                "curvature estimation takes less time than mean curvature on every model",
                all(e < r for e, r in zip(estimation, ratios, strict=True)),
            ),
        ],
        notes=[
            "Shortest of fifteen runs of each filter, taken in turns on the machine that wrote this page; compare the "
            "ratios, not the milliseconds. The curvatures are VCG's and include the adjacency that they need. The "
            "table at the top of the page says which models stand for the paper's."
        ],
    )
