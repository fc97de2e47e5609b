# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Geometric-mean ratios of one tool to another over groups of meshes.

A table of runs is a dictionary {(mesh, percent): metrics of metrics.py}.
"""

from dataclasses import dataclass
from math import exp, log

from meshes import GROUPS, PERCENTS

DISTANCES = ("rms", "feature_rms", "hausdorff")
AXES = DISTANCES + ("normal_deviation",)
LOOK = "perceptual"
EQUAL_BELOW = 1e-3  # percent of the diagonal: two distances below 1e-5 of it count as equal


@dataclass(frozen=True)
class Cell:
    """One axis of one group at one percentage."""

    group: str
    percent: float
    axis: str
    ratio: float  # to the reference
    second_ratio: float  # to the second reference

    @property
    def to_the_better(self) -> float:
        """To the better of both references."""
        return max(self.ratio, self.second_ratio)

    @property
    def lost(self) -> bool:
        """The reference or the second reference is ahead on a distance."""
        return self.axis in DISTANCES and self.to_the_better > 1


def ratio(value: float, reference: float, axis: str) -> float:
    """value / reference; 1 where both are too small to matter."""
    if axis in DISTANCES and value < EQUAL_BELOW and reference < EQUAL_BELOW:
        return 1.0
    return max(value, 1e-9) / max(reference, 1e-9)


def geometric_mean(values) -> float:
    """The geometric mean of positive numbers."""
    values = list(values)
    return exp(sum(map(log, values)) / len(values))


def group_ratio(runs: dict, reference: dict, group: str, percent: float, axis: str):
    """Geometric mean over the meshes of a group that both tables have; None where there is none."""
    pairs = [(runs.get((name, percent), {}), reference.get((name, percent), {})) for name in GROUPS[group]]
    found = [ratio(run[axis], other[axis], axis) for run, other in pairs if axis in run and axis in other]
    return geometric_mean(found) if found else None


def cells(runs: dict, reference: dict, second: dict) -> list[Cell]:
    """All cells that the runs fill."""
    found = []
    for group in GROUPS:
        for percent in PERCENTS:
            for axis in AXES:
                own = group_ratio(runs, reference, group, percent, axis)
                if own is not None:
                    beside = group_ratio(runs, second, group, percent, axis)
                    found.append(Cell(group, percent, axis, own, own if beside is None else beside))
    return found


def mean_of_distances(found: list[Cell]) -> float:
    """Geometric mean over the cells of rms, feature rms and Hausdorff."""
    return geometric_mean(cell.ratio for cell in found if cell.axis in DISTANCES)


def total(runs: dict, key: str) -> int:
    """A count summed over all runs."""
    return sum(run[key] for run in runs.values())


def cell_text(found: list[Cell], group: str, percent: float, mark) -> str:
    """'rms/feature rms/Hausdorff/normal deviation' of one row; `mark` dresses a figure that is lost."""
    row = [cell for cell in found if (cell.group, cell.percent) == (group, percent)]
    if not row:
        return "–"
    return "/".join(mark(f"{cell.ratio:.2f}") if cell.lost else f"{cell.ratio:.2f}" for cell in row)
