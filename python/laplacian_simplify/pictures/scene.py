# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a picture and a page show, as it is handed to the process that draws."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..comparison.report import CompareReport
from ..comparison.surface import Surface

_LABEL = 10
"""Characters at the start of a line of a summary that say what it is about."""
Rows = list[tuple[str, str]]


@dataclass(frozen=True, eq=False)
class Scene:
    """Two surfaces."""

    before: Surface
    after: Surface

    def save(self, path: Path) -> None:
        """Writes both to a file."""
        arrays: dict[str, Any] = {}
        for name, surface in (("before", self.before), ("after", self.after)):
            arrays |= {f"{name}_positions": surface.positions, f"{name}_faces": surface.faces}
        np.savez(path, **arrays, names=np.array([drawable(self.before.title), drawable(self.after.title)]))

    @staticmethod
    def load(path: Path) -> "Scene":
        """What save has written."""
        with np.load(path) as file:
            names = file["names"].tolist()
            return Scene(
                *(
                    Surface(name, file[f"{which}_positions"], file[f"{which}_faces"])
                    for which, name in zip(("before", "after"), names, strict=True)
                )
            )


@dataclass(frozen=True)
class Facts:
    """What is written beside the surfaces, in plain types; nothing of it is HTML yet."""

    labels: tuple[str, str]
    """Of the two surfaces."""
    summary: Rows
    """What each line of the summary is about, and the line."""
    numbers: Rows
    """Every number by its name."""
    parameters: Rows
    version: str

    @staticmethod
    def of_comparison(report: CompareReport, parameters: Mapping[str, Any]) -> "Facts":
        """Those of a comparison."""
        return _facts(("A", "B"), report.lines(), report.to_dict(), parameters)

    @staticmethod
    def of_run(lines: list[str], report: Mapping[str, Any], parameters: Mapping[str, Any]) -> "Facts":
        """Those of a run of a filter."""
        return _facts(("Before", "After"), lines, report, parameters)


def titled(label: str, name: str) -> str:
    """What a surface is called; one of arrays has no other name than its label."""
    return label if name == label else f"{label}: {name}"


def drawable(text: str) -> str:
    """The text without what no font has: bytes of a file name that are not UTF-8."""
    return text.encode("utf-8", "replace").decode()


def _facts(
    labels: tuple[str, str], lines: list[str], report: Mapping[str, Any], parameters: Mapping[str, Any]
) -> Facts:
    from importlib.metadata import version  # which takes its time

    summary = [(line[:_LABEL].strip(), line[_LABEL:]) for line in lines]
    numbers: Rows = []
    for name, value in report.items():
        if isinstance(value, Mapping):
            numbers += [(f"{name}: {key}", _shown(each)) for key, each in value.items()]
        else:
            numbers.append((name, _shown(value)))
    given = [(name, _shown(value)) for name, value in parameters.items()]
    return Facts(labels, summary, numbers, given, version("laplacian-simplify"))


def _shown(value: Any) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, int):
        return f"{value:,}"
    if isinstance(value, tuple | list):
        return ", ".join(_shown(each) for each in value)
    return drawable(str(value))
