# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The time and memory tables of the benchmark's page, as lines of Markdown."""

from statistics import median

from peers import OWN, peer_named
from timing import medians, ratios, succeeded

LARGE_FACES = 100_000  # below, a mesh fits the processor's caches and says nothing about growth


def tool_name(peer_id: str) -> str:
    """Library and settings of a tool; this project's efforts through the host are named so."""
    peer = peer_named(peer_id)
    library = "this project in pymeshlab" if peer in OWN else peer.library
    return f"{library}, {peer.settings}"


def with_range(values: tuple[float, float, float]) -> str:
    """Median and range of a ratio."""
    middle, least, largest = values
    return f"{middle:.2f} ({least:.2f}–{largest:.2f})"


def speed_table(speed: dict, reference: str) -> list[str]:
    """Tools on one mesh: medians, and ratios inside the rounds to the reference tool."""
    figures = speed["figures"]
    other = peer_named(reference).library
    lines = [f"| tool | CPU s | wall s | CPU, ratio to {other} | wall, ratio | peak B/face | rounds |"]
    lines.append("|---" * 7 + "|")
    working = {peer_id: rounds for peer_id, rounds in figures.items() if succeeded(rounds)}
    for peer_id, rounds in sorted(working.items(), key=lambda item: medians(item[1])["cpu_seconds"]):
        middle = medians(rounds)
        comparison = [with_range(ratios(rounds, working[reference], key)) for key in ("cpu_seconds", "wall_seconds")]
        lines.append(
            f"| {tool_name(peer_id)} | {middle['cpu_seconds']:.2f} | {middle['wall_seconds']:.2f} "
            f"| {comparison[0]} | {comparison[1]} | {middle['peak_bytes'] / speed['faces']:.0f} | {len(rounds)} |"
        )
    for peer_id, rounds in figures.items():
        if peer_id not in working:
            lines.append(f"| {tool_name(peer_id)} | failed: {rounds[-1]['failure'] if rounds else 'not run'} |||||| ")
    return lines


def growth_table(growth: dict) -> list[str]:
    """Nanoseconds and peak bytes a face, from small to large meshes."""
    peer_ids = list(growth["rows"][0]["figures"])
    head = [f"{tool_name(peer_id)}: ns/face | B/face" for peer_id in peer_ids]
    lines = ["| faces | " + " | ".join(head) + " |", "|---" * (2 * len(peer_ids) + 1) + "|"]
    for row in growth["rows"]:
        cells = []
        for peer_id in peer_ids:
            rounds = row["figures"][peer_id]
            if succeeded(rounds):
                middle = medians(rounds)
                cells.append(f"{1e9 * middle['cpu_seconds'] / row['faces']:.0f}")
                cells.append(f"{middle['peak_bytes'] / row['faces']:.0f}")
            else:
                cells += ["failed", "–"]
        lines.append(f"| {row['faces']:,} | " + " | ".join(cells) + " |")
    return lines


def growth_factor(growth: dict, peer_id: str, least_faces: int) -> float | None:
    """Time per face of the largest mesh over that of the smallest with at least `least_faces`."""
    rows = [row for row in growth["rows"] if row["faces"] >= least_faces and succeeded(row["figures"][peer_id])]
    if len(rows) < 2:
        return None
    per_face = [medians(row["figures"][peer_id])["cpu_seconds"] / row["faces"] for row in (rows[0], rows[-1])]
    return per_face[1] / per_face[0]


def best_table(speed: dict) -> list[str]:
    """Effort best beside Lindstrom-Turk on each mesh from 20,000 faces."""
    lines = ["| mesh | faces | to | best, CPU s | CGAL Lindstrom–Turk, CPU s | ratio |", "|---" * 6 + "|"]
    for name, run in speed.items():
        if name.startswith("best_") and all(succeeded(rounds) for rounds in run["figures"].values()):
            own, other = (run["figures"][peer_id] for peer_id in ("engine_best", "cgal_lt"))
            lines.append(
                f"| {run['mesh']} | {run['faces']:,} | {run['percent']:g} % | {medians(own)['cpu_seconds']:.2f} "
                f"| {medians(other)['cpu_seconds']:.2f} | {with_range(ratios(own, other, 'cpu_seconds'))} |"
            )
    return lines


def descriptor_lines(descriptor: dict) -> list[str]:
    """The descriptor in the host beside MeshLab's mean curvature, and on arrays where that was measured."""
    lines = []
    if "host" in descriptor:
        seconds = {name: median(values) for name, values in descriptor["host"]["seconds"].items()}
        own, other = seconds["descriptor"] - seconds["nothing"], seconds["curvature"] - seconds["nothing"]
        lines.append(
            f"In pymeshlab, {descriptor['host']['faces']:,} faces, one thread, beyond a filter that does nothing: "
            f"the descriptor takes {1e3 * own:.0f} ms, MeshLab's mean curvature {1e3 * other:.0f} ms: "
            f"{other / own:.1f} times as long."
        )
    if "arrays" in descriptor:
        lines += ["", "Without a host:", "", "```", *descriptor["arrays"].splitlines(), "```"]
    return lines
