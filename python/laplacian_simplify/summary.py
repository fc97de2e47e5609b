# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A report in a few lines for people."""

from collections.abc import Mapping, Sequence
from typing import Any

from .answers import Spelling, as_keyword, why_missed


def summary(source: str, target: str, report: Mapping[str, Any], spelled: Spelling) -> str:
    """What was done with which result; remedies spell parameters as the caller does."""
    return "\n".join([f"{source} -> {target} in {report['seconds']:.2f} s", *summary_lines(report, spelled)])


_ERROR_BOUND = 1
"""The stop reason of a run that went as far as it was allowed to: no target was missed."""


def missed(report: Mapping[str, Any]) -> bool:
    """Whether a decimation ended above its target although no error bound stopped it."""
    return "target_reached" in report and not report["target_reached"] and report["stop_reason"] != _ERROR_BOUND


def summary_lines(report: Mapping[str, Any], spelled: Spelling = as_keyword) -> list[str]:
    """The numbers of a report."""
    if "faces_before" in report:
        return _decimation(report, spelled)
    if "centers" in report:
        return _classification(report)
    if "percentile_99_9" in report:
        return _descriptor(report)
    moved = _count(report["moved"], "vertex", "vertices")
    return [f"moved     {moved}, at most {report['largest_movement']:.3g} % of the bounding box's diagonal"]


def _decimation(report: Mapping[str, Any], spelled: Spelling) -> list[str]:
    before, after = report["faces_before"], report["faces"]
    outcome = report["stop_reason_text"]
    if missed(report):
        outcome = f"target NOT reached: {why_missed(report, spelled)}"
    lines = [f"faces     {before:,} -> {after:,} ({100 * after / before:.3g} %), {outcome}"]
    if "rms" in report:
        lines.append(
            f"distance  rms {report['rms']:.3g} %, at features {report['feature_rms']:.3g} %, "
            f"largest {report['hausdorff']:.3g} % of the bounding box's diagonal"
        )
    if "attribute_rms" in report:
        lines.append("values    " + _attributes(report))
    if report.get("welded_vertices") or report.get("dropped_faces"):
        welded = _count(report["welded_vertices"], "vertex", "vertices")
        dropped = _count(report["dropped_faces"], "degenerate or duplicate face")
        lines.append(f"cleaned   {welded} welded, {dropped} left out")
    if "certified_error" in report:
        lines.append(f"proven    within {report['certified_error']:.4g} % of the bounding box's diagonal, both ways")
    checks = [_count(report["vertices"], "vertex", "vertices")]
    if "boundary_edges" in report:  # not after a run that was canceled
        checks.append(_count(report["non_manifold_edges"], "non-manifold edge"))
        checks.append(_count(report["boundary_edges"], "boundary edge"))
    if "self_intersections" in report:
        checks.append(_count(report["self_intersections"], "crossing"))
        if "self_intersections_before" in report:
            checks[-1] += f" (before: {report['self_intersections_before']:,})"
    if "folded" in report:
        checks.append(_count(report["folded"], "folded face"))
    return [*lines, "mesh      " + ", ".join(checks)]


def _attributes(report: Mapping[str, Any]) -> str:
    given = report["attribute_rms"]
    if isinstance(given, Mapping):
        parts = [f"{name} rms {rms:.3g}" for name, rms in given.items()]
    else:  # of the host, which names them in its log
        parts = [f"rms {_list(given, '.3g')}"]
    if "texture_deviation" in report:
        parts.append(
            f"texture off by rms {report['texture_deviation']:.3g} %, "
            f"largest {report['largest_texture_deviation']:.3g} % of the bounding box's diagonal"
        )
    if report.get("turned_texture_faces"):
        parts.append(_count(report["turned_texture_faces"], "face") + " with turned texture")
    return ", ".join(parts)


def _classification(report: Mapping[str, Any]) -> list[str]:
    return [
        f"selected  {_count(report['selected'], 'vertex', 'vertices')}, {report['promoted']:,} by refinement",
        f"classes   {_list(report['class_sizes'], ',.0f')} vertices",
        f"borders   {_list(report['thresholds'], '.3g')}",
    ]


def _descriptor(report: Mapping[str, Any]) -> list[str]:
    return [
        f"values    {report['minimum']:.3g} to {report['maximum']:.3g}, mean {report['mean']:.3g}, "
        f"99.9 percent up to {report['percentile_99_9']:.3g}"
    ]


def _count(number: int, one: str, many: str | None = None) -> str:
    return f"{number:,} {one if number == 1 else many or one + 's'}"


def _list(numbers: Sequence[float], form: str) -> str:
    return " / ".join(format(number, form) for number in numbers)
