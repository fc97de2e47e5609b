# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The geometry tables of the benchmark's page, as lines of Markdown."""

from statistics import median

from meshes import GROUPS, PERCENTS
from peers import HOST, OWN, PEERS, REFERENCE, SECOND_REFERENCE, Peer
from quality import table_of
from ratio_tables import (
    AXES,
    EQUAL_BELOW,
    LOOK,
    cell_text,
    cells,
    geometric_mean,
    group_ratio,
    mean_of_distances,
    ratio,
)

BENCHMARK_MESHES = [name for names in GROUPS.values() for name in names]


def bold(text: str) -> str:
    return f"**{text}**"


def title_of(peer: Peer) -> str:
    """Column head: short for this project, library and settings otherwise."""
    return peer.settings.removeprefix("effort ") if peer in OWN else f"{peer.library} {peer.settings}"


def benchmark_runs(section: dict, peer_id: str) -> dict:
    """The runs on the meshes of the two groups."""
    return {key: run for key, run in table_of(section, peer_id).items() if key[0] in BENCHMARK_MESHES}


def group_table(section: dict) -> list[str]:
    """This project's efforts and Garland-Heckbert against Lindstrom-Turk, by group and percentage."""
    reference, second = (benchmark_runs(section, peer) for peer in (REFERENCE, SECOND_REFERENCE))
    columns = {"CGAL Garland–Heckbert": cells(second, reference, second)}
    runs = {peer: benchmark_runs(section, peer.id) for peer in OWN}
    columns |= {title_of(peer): cells(own, reference, second) for peer, own in runs.items() if own}
    lines = ["| | " + " | ".join(columns) + " |", "|---" * (len(columns) + 1) + "|"]
    for group in GROUPS:
        for percent in PERCENTS:
            row = [
                cell_text(found, group, percent, str if name.startswith("CGAL") else bold)
                for name, found in columns.items()
            ]
            lines.append(f"| {group} {percent} % | " + " | ".join(row) + " |")
    means = [f"{mean_of_distances(found):.3f}" if found else "–" for found in columns.values()]
    lines.append("| mean of rms, feature rms, Hausdorff | " + " | ".join(means) + " |")
    return lines


def tool_table(section: dict) -> list[str]:
    """Every tool on one line: mean ratios with the range over the runs, and its faults."""
    reference, missing = benchmark_runs(section, REFERENCE), []
    lines = [
        "| tool | rms | median (range) of rms | feature rms | Hausdorff | normal deviation | folded faces "
        "| new non-manifold edges | targets missed | failed runs | CPU time |",
        "|---" * 11 + "|",
    ]
    for peer in [*OWN, *PEERS]:
        runs = benchmark_runs(section, peer.id)
        common = [key for key in runs if key in reference]
        if common:
            lines.append(tool_row(peer, section, runs, reference, common))
        elif section.get(peer.id):
            why = next((run["failure"] for run in section[peer.id].values() if "failure" in run), "no common mesh")
            missing.append(f"{title_of(peer)} ({why})")
    return lines + (["", "Without a result: " + "; ".join(missing) + "."] if missing else [])


def look_table(section: dict) -> list[str]:
    """The perceptual difference of every tool by group, as ratios to Lindstrom-Turk's."""
    reference = benchmark_runs(section, REFERENCE)
    columns = [(group, percent) for group in GROUPS for percent in PERCENTS]
    lines = ["| tool | " + " | ".join(f"{group} {percent} %" for group, percent in columns) + " | all runs |"]
    lines.append("|---" * (len(columns) + 2) + "|")
    for peer in [*OWN, *PEERS]:
        runs = benchmark_runs(section, peer.id)
        ratios = [group_ratio(runs, reference, group, percent, LOOK) for group, percent in columns]
        found = [
            ratio(run[LOOK], reference[key][LOOK], LOOK)
            for key, run in runs.items()
            if LOOK in run and LOOK in reference.get(key, {})
        ]
        if found:
            shown = [_look_cell(value, peer in OWN) for value in [*ratios, geometric_mean(found)]]
            name = bold("this project, " + title_of(peer)) if peer in OWN else title_of(peer)
            lines.append(f"| {name} | " + " | ".join(shown) + " |")
    return lines


def _look_cell(value: float | None, own: bool) -> str:
    if value is None:
        return "–"
    return bold(f"{value:.2f}") if own and value > 1 else f"{value:.2f}"


def tool_row(peer: Peer, section: dict, runs: dict, reference: dict, common: list) -> str:
    """One line of tool_table."""
    by_axis = {axis: [ratio(runs[key][axis], reference[key][axis], axis) for key in common] for axis in AXES}
    rms = by_axis["rms"]
    means = {axis: f"{geometric_mean(values):.2f}" for axis, values in by_axis.items()}
    missed = sum(run["faces"] > run["target"] for run in runs.values())
    failed = sum("failure" in run for run in section.get(peer.id, {}).values())
    name = bold("this project, " + title_of(peer)) if peer in OWN else title_of(peer)
    figures = [
        name,
        means["rms"],
        f"{median(rms):.2f} ({min(rms):.2f}–{max(rms):.2f})",
        means["feature_rms"],
        means["hausdorff"],
        means["normal_deviation"],
        str(sum(run["folded_faces"] for run in runs.values())),
        str(sum(run["new_non_manifold_edges"] for run in runs.values())),
        str(missed),
        str(failed),
        f"{_total_seconds(runs, common) / max(_total_seconds(reference, common), 1e-9):.2f}",
    ]
    return "| " + " | ".join(figures) + " |"


def _total_seconds(runs: dict, keys: list) -> float:
    """A single short run may be shorter than the processor's clock ticks; the sum is not."""
    return sum(runs[key]["cpu_seconds"] for key in keys)


def host_table(section: dict, peer: Peer) -> list[str]:
    """One effort against MeshLab's defaults on every mesh: rms/feature rms as ratios, bold where it is behind."""
    runs, host = (benchmark_runs(section, peer_id) for peer_id in (peer.id, HOST))
    lines = ["| mesh | " + " | ".join(f"{percent} %" for percent in PERCENTS) + " |", "|---" * 5 + "|"]
    for name in BENCHMARK_MESHES:
        row = [_host_cell(runs.get((name, percent)), host.get((name, percent))) for percent in PERCENTS]
        if set(row) != {"–"}:
            lines.append(f"| {name} | " + " | ".join(row) + " |")
    return lines


def _host_cell(run, host) -> str:
    if run is None or host is None:
        return "–"
    return "/".join(_host_ratio(run[axis], host[axis]) for axis in ("rms", "feature_rms"))


def _host_ratio(value: float, host: float) -> str:
    """Bold where the host is as good or better; in brackets where both distances are too small to matter."""
    shown = f"{max(value, 1e-9) / max(host, 1e-9):.2f}"
    if max(value, host) < EQUAL_BELOW:
        shown = f"({shown})"
    return bold(shown) if value >= host else shown


def absolute_table(section: dict, peer_ids: list[str]) -> list[str]:
    """rms and Hausdorff in percent of the diagonal, for comparison with other papers and tools."""
    tables = {peer_id: benchmark_runs(section, peer_id) for peer_id in peer_ids}
    lines = ["| mesh | % | " + " | ".join(peer_ids) + " |", "|---" * (len(peer_ids) + 2) + "|"]
    for name in BENCHMARK_MESHES:
        for percent in PERCENTS:
            runs = [tables[peer_id].get((name, percent)) for peer_id in peer_ids]
            if any(runs):
                row = [f"{run['rms']:.4f}/{run['hausdorff']:.3f}" if run else "–" for run in runs]
                lines.append(f"| {name} | {percent} | " + " | ".join(row) + " |")
    return lines
