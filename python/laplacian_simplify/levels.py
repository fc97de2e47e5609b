# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Levels of detail: their reports, and the files that a pattern names for them."""

import math
import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .report import DecimationReport
from .tables import filter_named

if TYPE_CHECKING:
    import pymeshlab

_FIELD = re.compile(r"\{(\w*)\}")


@dataclass(frozen=True, kw_only=True)
class LevelReport(DecimationReport):
    """What the decimation to one level reports."""

    @property
    def mesh_id(self) -> int:
        """Which mesh of the mesh set the level is."""
        return int(self.__dict__["_mesh_id"])


def reports_of_levels(returned: Mapping[str, Any], mesh_set: "pymeshlab.MeshSet") -> list[LevelReport]:
    """The reports of a run that returned a list under every name, NaN where a level has no number."""
    results = filter_named("meshing_decimation_laplacian_quadric_edge_collapse").results
    kinds = {"boolean": bool, "integer": int, "real": float}
    kind = {row.id: kinds[row.type] for row in results if row.type in kinds}  # levels return no lists of lists
    lists = {name: _as_list(numbers) for name, numbers in returned.items()}
    count = len(lists["faces"])
    last = mesh_set.current_mesh_id()  # that of the last level; those before it came in a row
    reports = []
    for i in range(count):
        numbers = {name: kind[name](row[i]) for name, row in lists.items() if not math.isnan(row[i])}
        report = LevelReport.of(numbers, mesh_set)
        report.__dict__["_mesh_id"] = last - count + 1 + i
        reports.append(report)
    return reports


def _as_list(numbers: Any) -> list[float]:
    """What the host may hand over as a vector or, where it has one number, as that."""
    plain = numbers.tolist() if hasattr(numbers, "tolist") else numbers
    return plain if isinstance(plain, list) else [plain]


def output_names(pattern: str, words: Sequence[str], field: str) -> list[str]:
    """The file of every level.

    Args:
        pattern: has {percent} or {error}, in whose place the word of the level goes, or {level}, its number from 1.
        words: what was typed for every level.
        field: percent or error: what the words are.

    Raises:
        ValueError: the pattern has another field, or gives two levels the same name.
    """
    unknown = [name for name in _FIELD.findall(pattern) if name not in (field, "level")]
    if unknown:
        raise ValueError(f"OUTPUT has {{{unknown[0]}}}; here it can have {{{field}}} and {{level}}")
    names = []
    for i, word in enumerate(words):
        fields = {field: word, "level": str(i + 1)}
        parts = _FIELD.split(pattern)  # text and fields in turn
        names.append("".join(fields[part] if k % 2 else part for k, part in enumerate(parts)))
    first: dict[str, int] = {}
    for i, name in enumerate(names):
        other = first.setdefault(os.path.realpath(name), i)
        if other != i:
            raise ValueError(
                f"levels {other + 1} and {i + 1} have the same file, {name}; OUTPUT needs {{{field}}} or {{level}}"
            )
    return names
