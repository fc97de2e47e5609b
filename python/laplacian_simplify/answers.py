# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What people are told beyond the numbers: why a target was missed and what helps; what a small percentage means."""

from collections.abc import Callable, Mapping
from typing import Any, TypeAlias

Spelling: TypeAlias = Callable[..., str]
"""How a parameter, or a parameter with its value, is written where the answer is read."""

_NO_LEGAL_COLLAPSE, _SEAMS = 2, 4
_FEW = 4


def as_keyword(name: str, value: object = None) -> str:
    """As Python has it."""
    return name if value is None else f"{name}={value!r}"


def why_missed(report: Mapping[str, Any], spelled: Spelling = as_keyword) -> str:
    """Why a decimation ended above its target, and what helps.

    Args:
        report: its numbers, by their names.
        spelled: how parameters are written.
    """
    reason = str(report["stop_reason_text"])
    if report["stop_reason"] == _SEAMS:
        held = f"{report['faces_held_by_seams']:,} faces too many; " if "faces_held_by_seams" in report else ""
        return f"{reason} ({held}a texture of fewer parts helps, or {spelled('seams', 'ignore')})"
    if report["stop_reason"] != _NO_LEGAL_COLLAPSE or "boundary_edges" not in report:
        return reason
    faces, open_edges = report["faces"], report["boundary_edges"]
    edges = (3 * faces + open_edges) // 2
    if open_edges >= 2 * faces > _FEW:  # as of triangles and quads that share no vertices
        apart = "the faces share no vertices" if open_edges == 3 * faces else "most faces are not connected"
        found = f"{open_edges:,} of {edges:,} edges are open: {apart}"
        if "rounds" in report:  # of huge, which cannot weld first
            return found
        remedy = spelled("weld_distance", 0.01) if "welded_vertices" in report else spelled("clean_input", True)
        return f"{found}; weld first ({remedy})"
    if 2 * open_edges >= faces:
        return (
            f"{reason} ({open_edges:,} open edges hold most faces; {spelled('boundary', 'free')} lets borders shrink)"
        )
    return reason


def fraction_note(percent: float, spelled: Spelling = as_keyword) -> str | None:
    """Both readings of a percentage that may be meant as a fraction; None of one that is not below 1."""
    if not 0 < percent < 1:
        return None
    name = "target_percent"
    return (
        f"{spelled(name, percent)} keeps {percent:g} % of the faces, one of {100 / percent:,.0f}; "
        f"to keep the fraction {percent:g} of them, give {spelled(name, float(f'{100 * percent:g}'))}"
    )
