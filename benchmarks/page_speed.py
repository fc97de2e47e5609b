# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The time and memory tables of the benchmark's page, as lines of Markdown."""

import re
from statistics import median

from peers import OWN, peer_named
from timing import busy_cores, medians, ratio_of_least, ratios, succeeded

LARGE_FACES = 100_000  # growth is counted from here; far below, a mesh fits the processor's caches


def tool_name(peer_id: str) -> str:
    """Library and settings of a tool; this project's efforts through the host are named so."""
    peer = peer_named(peer_id)
    library = "this project in pymeshlab" if peer in OWN else peer.library
    return f"{library}, {peer.settings}"


def with_range(values: tuple[float, float, float]) -> str:
    """Median and range of a ratio."""
    middle, least, largest = values
    return f"{middle:.2f} ({least:.2f}–{largest:.2f})"


def input_name(mesh: str) -> str:
    """What was done to a mesh before it was simplified, in words."""
    found = re.fullmatch(r"(.+)_(subdivided|loop)_(\d+)", mesh)
    if not found:
        return mesh
    name, scheme, times = found.groups()
    rule = "by Loop's rule" if scheme == "loop" else "at midpoints"
    return f"{name}, subdivided {rule}" + (f" {times} times" if times != "1" else "")


def speed_table(speed: dict, reference: str) -> list[str]:
    """Tools on one mesh: medians, and ratios inside the rounds to the reference tool."""
    figures = speed["figures"]
    other = peer_named(reference).library
    lines = [f"| tool | CPU s | wall s | CPU, ratio to {other} | wall, ratio | peak B/face | rounds |"]
    lines.append("|---" * 7 + "|")
    working = {peer_id: rounds for peer_id, rounds in figures.items() if succeeded(rounds)}
    for peer_id, rounds in sorted(working.items(), key=lambda item: medians(item[1])["cpu_seconds"]):
        middle = medians(rounds)
        keys = ("cpu_seconds", "wall_seconds") if reference in working else ()
        comparison = [with_range(ratios(rounds, working[reference], key)) for key in keys] or ["–", "–"]
        lines.append(
            f"| {tool_name(peer_id)} | {middle['cpu_seconds']:.2f} | {middle['wall_seconds']:.2f} "
            f"| {comparison[0]} | {comparison[1]} | {middle['peak_bytes'] / speed['faces']:.0f} | {len(rounds)} |"
        )
    for peer_id, rounds in figures.items():
        if peer_id not in working:
            lines.append(f"| {tool_name(peer_id)} | {rounds[-1]['failure'] if rounds else 'not run'} | | | | | |")
    return lines


def pair_table(pairs: dict) -> list[str]:
    """Tool against tool in turns, on every mesh where that was measured."""
    lines = ["| input | faces | tool | against | CPU | CPU, least | wall | wall, least | others' cores | pairs |"]
    lines.append("|---" * 10 + "|")
    for mesh, measured in pairs.items():
        for row in measured["rows"]:
            tool, reference = row["tool"], row["reference"]
            head = f"| {input_name(mesh)} | {measured['faces']:,} | {tool_name(tool)} | {tool_name(reference)} | "
            lines.append(head + " | ".join(_pair_cells(row["figures"][tool], row["figures"][reference])) + " |")
    return lines


def _pair_cells(own: list[dict], other: list[dict]) -> list[str]:
    if not (succeeded(own) and succeeded(other)):
        failure = next(figures["failure"] for figures in own + other if "failure" in figures)
        return [f"failed: {failure}", "", "", "", "", ""]
    cells = []
    for key in ("cpu_seconds", "wall_seconds"):
        cells += [with_range(ratios(own, other, key)), f"{ratio_of_least(own, other, key):.2f}"]
    return [*cells, f"{busy_cores(own, other):.1f}", str(len(own))]


def pair_rounds(speed: dict, mesh: str, tool: str, reference: str) -> tuple[list[dict], list[dict]] | None:
    """The rounds of a pair; None where it was not measured or failed."""
    for row in speed.get("pairs", {}).get(mesh, {}).get("rows", []):
        if (row["tool"], row["reference"]) == (tool, reference):
            own, other = row["figures"][tool], row["figures"][reference]
            return (own, other) if succeeded(own) and succeeded(other) else None
    return None


def growth_table(growth: dict) -> list[str]:
    """Nanoseconds and peak bytes per face, from small to large meshes."""
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


def growth_factor(growth: dict, peer_id: str) -> float | None:
    """Time per face of the largest mesh over that of the cheaper of the two meshes around LARGE_FACES."""
    rows = [row for row in growth["rows"] if succeeded(row["figures"][peer_id])]
    per_face = [(row["faces"], medians(row["figures"][peer_id])["cpu_seconds"] / row["faces"]) for row in rows]
    before = [seconds for faces, seconds in per_face if faces < LARGE_FACES][-1:]
    after = [seconds for faces, seconds in per_face if faces >= LARGE_FACES]
    if len(after) < 2:
        return None
    return after[-1] / min(before + after[:1])


def descriptor_ratios(host: dict) -> dict:
    """Seconds of the descriptor and of mean curvature beyond an idle filter: medians, least, and their ratio."""
    idle = median(host["seconds"]["nothing"])
    own, other = ([seconds - idle for seconds in host["seconds"][name]] for name in ("descriptor", "curvature"))
    return {
        "own": (median(own), min(own)),
        "other": (median(other), min(other)),
        "times": (median(theirs / ours for ours, theirs in zip(own, other)), min(other) / min(own)),
    }


def descriptor_lines(descriptor: dict) -> list[str]:
    """The descriptor in the host beside MeshLab's mean curvature, and on arrays where that was measured."""
    lines = []
    if "host" in descriptor:
        host, figures = descriptor["host"], descriptor_ratios(descriptor["host"])
        own, other = ([1e3 * seconds for seconds in figures[name]] for name in ("own", "other"))
        lines.append(
            f"In pymeshlab, on {host['faces']:,} faces with one thread, and without the time of a filter that does "
            f"nothing, the descriptor takes {own[0]:.0f} ms (median of {len(host['seconds']['nothing'])} rounds; least "
            f"{own[1]:.0f}) and MeshLab's mean curvature {other[0]:.0f} ms (least {other[1]:.0f}): "
            f"{figures['times'][0]:.1f} times as long (median of the rounds; ratio of the least times "
            f"{figures['times'][1]:.1f}). Other programs kept {host['others']:.1f} cores busy."
        )
    if "arrays" in descriptor:
        arrays = descriptor["arrays"]
        lines += ["", f"Without a host; other programs kept {arrays['others']:.1f} cores busy:", ""]
        lines += ["```text", *arrays["report"].splitlines(), "```"]
    return lines
