# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the filters return, as values with names and types."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any, Self

if TYPE_CHECKING:
    import pymeshlab

STOP_REASONS = ("target reached", "error bound reached", "no legal collapse left", "cancelled")
"""What the numbers of ``stop_reason`` mean."""


@dataclass(frozen=True, kw_only=True)
class Report:
    """What every filter reports."""

    mesh_set: "pymeshlab.MeshSet" = field(repr=False, compare=False)
    """Holds the result as its current mesh; not part of the dictionary."""
    seconds: float
    """Time that the filter took."""

    @classmethod
    def of(cls, mesh_set: "pymeshlab.MeshSet", returned: Mapping[str, Any]) -> Self:
        """The report of a run that left its result in the mesh set and returned the map."""
        return cls(mesh_set=mesh_set, **{name: _plain(value) for name, value in returned.items()})

    def to_dict(self) -> dict[str, Any]:
        """The numbers under the names that the filter gives them; those that were not measured are absent."""
        values = {f.name: getattr(self, f.name) for f in fields(self) if f.name != "mesh_set"}
        return {name: value for name, value in values.items() if value is not None}

    def to_json(self) -> str:
        """The same as a JSON object."""
        return json.dumps(self.to_dict(), indent=2)


@dataclass(frozen=True, kw_only=True)
class DescriptorReport(Report):
    """What the descriptor filter reports: its values over the vertices."""

    minimum: float
    maximum: float
    mean: float
    percentile_99_9: float


@dataclass(frozen=True, kw_only=True)
class ClassificationReport(Report):
    """What the feature selection reports, classes in ascending order."""

    thresholds: tuple[float, ...]
    centers: tuple[float, ...]
    class_sizes: tuple[float, ...]
    promoted: int
    selected: int


@dataclass(frozen=True, kw_only=True)
class SmoothingReport(Report):
    """What the umbrella smoothing reports."""

    moved: int
    largest_movement: float


@dataclass(frozen=True, kw_only=True)
class DecimationReport(Report):
    """What a decimation reports; distances are percent of the bounding box's diagonal."""

    faces_before: int
    faces: int
    vertices: int
    target_reached: bool
    stop_reason: int
    non_manifold_edges: int
    boundary_edges: int
    hausdorff: float | None = None
    rms: float | None = None
    feature_rms: float | None = None
    folded: int | None = None
    certified_error: float | None = None

    @property
    def stop_reason_text(self) -> str:
        """Why the collapse ended, in words."""
        return STOP_REASONS[self.stop_reason]

    def to_dict(self) -> dict[str, Any]:
        return super().to_dict() | {"stop_reason_text": self.stop_reason_text}


def _plain(value: Any) -> Any:
    """Vectors of the host as tuples of numbers, a single number for what the host may hand over as one."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    return tuple(value) if isinstance(value, list) else value
