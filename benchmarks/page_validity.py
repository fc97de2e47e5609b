# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page's section on folded faces, topology and targets, as lines of Markdown."""

from page_geometry import bold, title_of
from peers import OWN, REFERENCE
from validity import OTHER_FAULTS, Comparison, compare, failures_of

INTRODUCTION = (
    "Every mesh of `--meshes` and of [sample_meshes](../sample_meshes/README.md) at {percents} % of its faces, against "
    "CGAL's Lindstrom–Turk with bounded normal change. Folded faces are shown as sum/maximum over the percentages; "
    "bold: the percentages where this project has more of them than Lindstrom–Turk, with both counts. Other faults are "
    "new non-manifold edges and vertices, duplicate and degenerate faces, targets missed and failed runs. {runs} runs "
    "of each of this project's tools."
)


def validity_lines(section: dict) -> list[str]:
    """The whole section."""
    if not section.get("runs"):
        return []
    shown = [peer for peer in OWN if section["runs"].get(peer.id)]
    percents = ", ".join(f"{percent:g}" for percent in section["percents"])
    runs = len(section["faces"]) * len(section["percents"])
    titles = " | ".join(title_of(peer) for peer in shown)
    lines = [
        "## Folded faces, topology and targets on every mesh",
        "",
        INTRODUCTION.format(percents=percents, runs=runs),
        "",
        f"| mesh | faces | Lindstrom–Turk | {titles} | other faults |",
        "|---" * (len(shown) + 4) + "|",
    ]
    for name in sorted(section["faces"], key=lambda name: section["faces"][name]):
        comparisons = {peer: compare(section, peer.id, [name]) for peer in shown}
        cells = [folded_cell(found) for found in comparisons.values()]
        faults = "; ".join(filter(None, (fault_text(title_of(peer), found) for peer, found in comparisons.items())))
        lines.append(
            f"| {name} | {section['faces'][name]:,} | {reference_cell(section, name)} | {' | '.join(cells)} "
            f"| {faults or 'none'} |"
        )
    return [*lines, *total_lines(section, shown), ""]


def total_lines(section: dict, shown: list) -> list[str]:
    """Sums over all meshes, and why Lindstrom-Turk has no figures somewhere."""
    reference = compare(section, REFERENCE)
    cells = []
    for peer in shown:
        found = compare(section, peer.id)
        more = f"more in {len(found.more_folded)} runs"
        cells.append(f"{sum(found.folded.values())}, {bold(more) if found.more_folded else more}")
    total = f"| all | {sum(section['faces'].values()):,} | {sum(reference.folded.values())} | {' | '.join(cells)} | |"
    failed = failures_of(section, REFERENCE)
    reasons = sorted({f"{name}: {why}" for (name, _), why in failed.items()})
    notes = ["", "No result of Lindstrom–Turk, counted as no folded face: " + "; ".join(reasons) + "."]
    return [total, *(notes if reasons else [])]


def sum_and_maximum(counts: dict) -> str:
    return f"{sum(counts.values())}/{max(counts.values())}" if counts else "–"


def reference_cell(section: dict, name: str) -> str:
    """Lindstrom-Turk's folded faces, and the targets that it missed."""
    found = compare(section, REFERENCE, [name])
    return sum_and_maximum(found.folded) + (f", {missed_text(found)}" if found.missed else "")


def missed_text(found: Comparison) -> str:
    """The targets not reached, with the faces that are left."""
    missed = [f"{percent:g} % ({faces} faces, not {target})" for (_, percent), (faces, target) in found.missed.items()]
    return "target missed at " + ", ".join(missed)


def folded_cell(found: Comparison) -> str:
    """Sum and maximum, and the percentages with more folded faces than Lindstrom-Turk."""
    more = [f"{key[1]:g} %: {found.folded[key]} > {found.reference[key]}" for key in found.more_folded]
    return sum_and_maximum(found.folded) + (" " + bold(", ".join(more)) if more else "")


def fault_text(title: str, found: Comparison) -> str:
    """What else is wrong in one tool's runs on one mesh; empty where nothing is."""
    if found.clean:
        return ""
    runs_with = {"failed": found.failed} | {text: found.others[fault] for fault, text in OTHER_FAULTS.items()}
    parts = [missed_text(found)] if found.missed else []
    parts += [
        f"{text} at {', '.join(f'{percent:g}' for _, percent in keys)} %" for text, keys in runs_with.items() if keys
    ]
    return bold(f"{title}: " + ", ".join(parts))
