# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the filters return, as values with names and types."""

import html
import json
from collections.abc import Mapping
from dataclasses import dataclass, fields
from enum import IntEnum
from typing import TYPE_CHECKING, Any

from .summary import summary_lines

if TYPE_CHECKING:
    import pymeshlab
    from typing_extensions import Self  # in typing from Python 3.11 on

STOP_REASONS = (
    "target reached",
    "error bound reached",
    "no further collapse possible without damage",
    "canceled",
    "seams hold the last faces of their charts",
)
"""What the numbers of ``stop_reason`` mean."""


class StopReason(IntEnum):
    """Why a decimation ended."""

    TARGET = 0
    ERROR_BOUND = 1
    NO_LEGAL_COLLAPSE = 2
    CANCELLED = 3
    SEAMS = 4


@dataclass(frozen=True, kw_only=True)
class Report:
    """What every filter reports. It prints as a few lines for people, and can be pickled."""

    seconds: float
    """Time that the filter took."""

    @classmethod
    def of(cls, returned: Mapping[str, Any], mesh_set: "pymeshlab.MeshSet | None" = None) -> "Self":
        """The report of a run that returned the map and left its result in the mesh set, if there is one."""
        report = cls(**{name: _plain(value) for name, value in returned.items()})
        if mesh_set is not None:
            report.__dict__["_mesh_set"] = mesh_set
        return report

    @property
    def mesh_set(self) -> "pymeshlab.MeshSet":
        """Holds the result as its current mesh. It is no field: not part of the dictionary, and not pickled.

        Raises:
            AttributeError: there is none, as the report is of arrays or was copied or pickled.
        """
        try:
            return self.__dict__["_mesh_set"]
        except KeyError:
            raise AttributeError("this report holds no mesh set: it is one of arrays, or a copy") from None

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in self.__dict__.items() if name != "_mesh_set"}

    def __str__(self) -> str:
        return "\n".join([*summary_lines(self.to_dict()), f"time      {self.seconds:.2f} s"])

    def _repr_html_(self) -> str:
        rows = (f"<tr><th>{name}</th><td>{html.escape(str(value))}</td></tr>" for name, value in self.to_dict().items())
        return f"<table>{''.join(rows)}</table>"

    def to_dict(self) -> dict[str, Any]:
        """The numbers under the names that the filter gives them; those that were not measured are absent."""
        values = {f.name: getattr(self, f.name) for f in fields(self)}
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
    class_sizes: tuple[int, ...]
    promoted: int
    selected: int

    def __post_init__(self) -> None:
        self.__dict__["class_sizes"] = tuple(int(size) for size in self.class_sizes)  # the host has no lists of those


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
    stop_reason: StopReason
    non_manifold_edges: int | None = None
    """None after a cancelled run, as the next."""
    boundary_edges: int | None = None
    hausdorff: float | None = None
    rms: float | None = None
    feature_rms: float | None = None
    folded: int | None = None
    self_intersections: int | None = None
    """Pairs of faces that cross; None where they were not to be avoided."""
    self_intersections_before: int | None = None
    """The same of the original; None where no faces crossed that could not be repaired: then
    they were not counted."""
    welded_vertices: int | None = None
    """Vertices that became one with another; None where the input was taken as it is, as the next."""
    dropped_faces: int | None = None
    """Degenerate and duplicate faces that were left out."""
    certified_error: float | None = None
    attribute_rms: dict[str, float] | tuple[float, ...] | None = None
    """Of each attribute by its name, in its own unit, colors in 0 to 255: the root mean square difference between
    points of either surface and the closest of the other; None where there were none, or they were not measured. Of
    mesh sets and files the same without names, in the order of the plugin's log."""
    texture_deviation: float | None = None
    """How far points are from where the original has their texture coordinates, root mean square."""
    largest_texture_deviation: float | None = None
    turned_texture_faces: int | None = None
    """Faces whose texture has turned over against what most of their chart has."""
    faces_held_by_seams: int | None = None
    """Faces that seams keep beyond the target."""

    def __post_init__(self) -> None:
        self.__dict__["stop_reason"] = StopReason(self.stop_reason)

    @property
    def stop_reason_text(self) -> str:
        """Why the collapse ended, in words."""
        return STOP_REASONS[self.stop_reason]

    def to_dict(self) -> dict[str, Any]:
        numbers = super().to_dict()
        return numbers | {"stop_reason": int(self.stop_reason), "stop_reason_text": self.stop_reason_text}


def _plain(value: Any) -> Any:
    """Vectors of the host as tuples of numbers, a single number for what the host may hand over as one."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    return tuple(value) if isinstance(value, list) else value
