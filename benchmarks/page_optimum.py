# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The section of the benchmark's page on the best possible rms, as lines of Markdown."""

from optimum import SHAPES, TARGETS, Shape
from page_geometry import title_of
from peers import OWN, PEERS

EXPLANATION = (
    "On a smooth surface with Gaussian curvature K > 0 no mesh of n triangles has less rms than "
    ".07454 (∫ K^⅓ dS)^1.5 / (n √S), while every triangle has many of the input below it; on a sphere that is "
    ".9366 R/n. The figures are × that, so 1 is the best possible: [optimum.py](../benchmarks/optimum.py) says why. On "
    "a torus K changes its sign, and the formula with |K| is a unit to compare tools in, not a bound. On the cylinder "
    "the optimum is strips from one end to the other, all vertices on borders. Every "
    "result is compared at the number of faces that it has; bold where another tool is ahead."
)


def optimum_lines(section: dict) -> list[str]:
    """Nothing where it was not measured."""
    if not section:
        return []
    sizes = " or ".join(f"{size:,}" for size in sorted(set(section["sizes"].values())))
    return [
        "## How near to the optimum",
        "",
        EXPLANATION,
        "",
        f"Measured on {section['date']}. Inputs have {sizes} faces.",
        "",
        "Shapes that were looked at while constants of the engine and of the refinement were chosen:",
        "",
        *_table(section["factors"], [shape for shape in SHAPES if shape.looked_at]),
        "",
        "Shapes on which nothing was chosen:",
        "",
        *_table(section["factors"], [shape for shape in SHAPES if not shape.looked_at]),
        "",
    ]


def _table(factors: dict, shapes: list[Shape]) -> list[str]:
    tools = [peer for peer in [*OWN, *PEERS] if factors.get(peer.id)]
    heads = [title_of(peer) if peer in OWN else peer.library + " " + peer.settings.split(",")[0] for peer in tools]
    lines = ["| | faces | " + " | ".join(heads) + " |", "|---" * (len(tools) + 2) + "|"]
    for shape in shapes:
        for target in (target for target in TARGETS if target <= shape.most_faces):
            found = [factors[peer.id].get(shape.name, {}).get(str(target)) for peer in tools]
            others = [value for peer, value in zip(tools, found) if peer not in OWN and value is not None]
            row = [
                _cell(value, peer in OWN and min(others, default=value or 0) < (value or 0))
                for peer, value in zip(tools, found)
            ]
            lines.append(f"| {shape.title} | {target:,} | " + " | ".join(row) + " |")
    return lines


def _cell(value: float | None, behind: bool) -> str:
    if value is None:
        return "–"
    return f"**{value:.2f}**" if behind else f"{value:.2f}"
