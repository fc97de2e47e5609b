# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a comparison reports."""

from dataclasses import dataclass
from typing import Any

from ..report import Report
from .distances import Distances
from .surface import Surface

LENGTHS = (
    "hausdorff",
    "rms",
    "feature_rms",
    "forward_hausdorff",
    "forward_rms",
    "forward_mean",
    "backward_hausdorff",
    "backward_rms",
    "backward_mean",
    "spacing",
    "rms_error",
)
UNIT = "% of the bounding box's diagonal of the first mesh"


@dataclass(frozen=True, kw_only=True)
class CompareReport(Report):
    """Distances between two meshes, in percent of the diagonal of the bounding box of the first one's faces, as in the
    reports of simplify; ``in_units`` has them in the unit of the coordinates."""

    name_a: str
    name_b: str
    faces_a: int
    vertices_a: int
    faces_b: int
    vertices_b: int
    diagonal: float
    """In the unit of the coordinates."""
    hausdorff: float
    """Largest distance found, both ways."""
    rms: float
    """Square root of the mean, over both directions, of the mean squared distance."""
    feature_rms: float | None = None
    """From the first mesh, at the tenth of its vertices with the largest descriptor; None where it is flat."""
    forward_hausdorff: float
    """From the first mesh to the second, as the next two."""
    forward_rms: float
    forward_mean: float
    backward_hausdorff: float
    """From the second mesh to the first, as the next two."""
    backward_rms: float
    backward_mean: float
    samples: int
    """Points a side, beside all vertices."""
    spacing: float
    """How far these are apart: a distance between them differs by no more than the way to the next one."""
    rms_error: float
    """Standard error of the rms, if the points were random; they are spread more evenly."""

    @property
    def in_units(self) -> dict[str, float]:
        """The distances in the unit of the coordinates."""
        values = {name: getattr(self, name) for name in LENGTHS}
        return {name: value * self.diagonal / 100 for name, value in values.items() if value is not None}

    def to_dict(self) -> dict[str, Any]:
        return super().to_dict() | {"in_units": self.in_units}

    def __str__(self) -> str:
        return "\n".join([*self.lines(), f"time      {self.seconds:.2f} s"])

    def lines(self) -> list[str]:
        """The numbers as the summary of the command has them."""
        units = self.in_units
        features = units_features = ""
        if self.feature_rms is not None:
            features = f"at features {self.feature_rms:.3g} %, "
            units_features = f"at features {units['feature_rms']:.4g}, "
        return [
            f"faces     {self.faces_a:,} | {self.faces_b:,}; vertices {self.vertices_a:,} | {self.vertices_b:,}",
            f"distance  rms {self.rms:.3g} %, {features}largest {self.hausdorff:.3g} {UNIT}",
            f"length    rms {units['rms']:.4g}, {units_features}largest {units['hausdorff']:.4g}; "
            f"the diagonal is {self.diagonal:.6g}",
            _one_way("forward ", "first to the second", self.forward_rms, self.forward_mean, self.forward_hausdorff),
            _one_way("backward", "second to the first", self.backward_rms, self.backward_mean, self.backward_hausdorff),
            f"sampled   at {self.samples:,} points a side, {self.spacing:.2g} % apart, and all vertices; "
            f"rms to {self.rms_error:.1g} %",
        ]


def _one_way(name: str, way: str, rms: float, mean: float, largest: float) -> str:
    return f"{name}  rms {rms:.3g} %, mean {mean:.3g} %, largest {largest:.3g} %, from the {way}"


def report_of(a: Surface, b: Surface, found: Distances, samples: int, seconds: float) -> CompareReport:
    """The report of what was measured.

    Raises:
        ValueError: there is nothing that percent could be of.
    """
    if not a.diagonal > 0:
        raise ValueError(f"{a.name} has all its faces in one point, so distances in percent of its size mean nothing")
    percent = 100 / a.diagonal
    features = found.feature_rms
    return CompareReport(
        seconds=seconds,
        name_a=a.title,
        name_b=b.title,
        faces_a=len(a.faces),
        vertices_a=len(a.positions),
        faces_b=len(b.faces),
        vertices_b=len(b.positions),
        diagonal=a.diagonal,
        hausdorff=percent * found.largest,
        rms=percent * found.rms,
        feature_rms=None if features is None else percent * features,
        forward_hausdorff=percent * found.forward.largest,
        forward_rms=percent * found.forward.mean_square**0.5,
        forward_mean=percent * found.forward.mean,
        backward_hausdorff=percent * found.backward.largest,
        backward_rms=percent * found.backward.mean_square**0.5,
        backward_mean=percent * found.backward.mean,
        samples=samples,
        spacing=percent * found.spacing,
        rms_error=percent * found.rms_error,
    )
