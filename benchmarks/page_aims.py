# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What this project aims at, and what was measured: the first tables of the benchmark's page."""

from dataclasses import dataclass

from page_geometry import benchmark_runs, bold
from page_speed import descriptor_ratios, growth_factor, input_name, pair_rounds
from peers import HOST, OWN, REFERENCE, SECOND_REFERENCE
from ratio_tables import DISTANCES, EQUAL_BELOW, cells, mean_of_distances
from timing import busy_cores, medians, ratios
from validity import compare

ARRAYS_ROW = "Laplacian, float arrays"  # of descriptor_benchmark
MESHOPTIMIZER = "meshoptimizer_debian"
COLLAPSING, REFINING = ("fast", "strict"), ("balanced", "best")


@dataclass(frozen=True)
class Aim:
    """One aim: a figure that should be at most its bound. Without a bound the figure is only shown."""

    text: str
    bound: float | None
    measured: float | None
    note: str = ""

    @property
    def met(self) -> bool:
        return self.bound is not None and self.measured is not None and self.measured <= self.bound

    def row(self) -> str:
        bound = "no aim" if self.bound is None else f"{self.bound:.3g}"
        return f"| {self.text} | {bound} | {self._shown()}{self.note and ', ' + self.note} |"

    def _shown(self) -> str:
        if self.measured is None:
            return "not measured"
        shown = f"{self.measured:.3g}"
        if self.bound is None or self.met:
            return shown
        return bold(shown if shown != f"{self.bound:.3g}" else f"{self.measured:.5g}")


def distance_aims(section: dict, peer_id: str) -> list[Aim]:
    """Ratios to Lindstrom-Turk by group, and single runs beside pymeshlab."""
    reference, second = (benchmark_runs(section, name) for name in (REFERENCE, SECOND_REFERENCE))
    found = cells(benchmark_runs(section, peer_id), reference, second)

    def largest(axis: str, least_percent: float = 0) -> float | None:
        return max((cell.ratio for cell in found if cell.axis == axis and cell.percent >= least_percent), default=None)

    refines = peer_id in REFINING
    behind = runs_behind(section, peer_id)
    aims = [
        Aim(f"{peer_id}: largest rms of a group, × Lindstrom–Turk", 1 if refines else 1.02, largest("rms")),
        Aim(f"{peer_id}: largest feature rms of a group at 50–10 %, × Lindstrom–Turk", 0.8, largest("feature_rms", 10)),
        Aim(f"{peer_id}: largest Hausdorff distance of a group, × Lindstrom–Turk", 0.8, largest("hausdorff")),
        Aim(
            f"{peer_id}: largest normal deviation of a group, × Lindstrom–Turk",
            1.07 if refines else None,
            largest("normal_deviation"),
        ),
        Aim(
            f"{peer_id}: single runs not ahead of pymeshlab's defaults in rms and feature rms",
            0,
            behind if behind is None else len(behind),
            "; ".join(behind or []),
        ),
    ]
    return aims + (mean_aims(peer_id, found) if refines else [])


def mean_aims(peer_id: str, found: list) -> list[Aim]:
    """The mean over all cells, and the worst of them."""
    lost = [cell for cell in found if cell.lost]
    worst = max((cell.to_the_better for cell in found if cell.axis in DISTANCES), default=None)
    return [
        Aim(
            f"{peer_id}: mean of rms, feature rms and Hausdorff over all groups, × Lindstrom–Turk",
            {"balanced": 0.62, "best": 0.57}[peer_id],
            mean_of_distances(found) if found else None,
        ),
        Aim(
            f"{peer_id}: largest of these cells, × the better of Lindstrom–Turk and Garland–Heckbert",
            1,
            worst,
            f"{len(lost)} of {sum(cell.axis in DISTANCES for cell in found)} cells behind" if lost else "",
        ),
    ]


def runs_behind(section: dict, peer_id: str) -> list[str] | None:
    """The runs in which pymeshlab's defaults are as good or better, however small the distances are; None: no runs."""
    runs, host = (benchmark_runs(section, name) for name in (peer_id, HOST))
    found = []
    for key in [key for key in runs if key in host]:
        lost = [axis for axis in ("rms", "feature_rms") if runs[key][axis] >= host[key][axis]]
        if lost:
            small = all(max(runs[key][axis], host[key][axis]) < EQUAL_BELOW for axis in lost)
            found.append(f"{key[0]} {key[1]:g} %" + (f" (all below {EQUAL_BELOW} % of the diagonal)" if small else ""))
    return found if runs.keys() & host.keys() else None


def validity_aims(sections: dict, peer_id: str) -> list[Aim]:
    """Counts that should be zero, over every mesh at every percentage."""
    section = sections.get("validity", {})
    measured = section.get("runs", {}).get(peer_id)
    found = compare(section, peer_id) if measured else None
    quality = sections.get("quality", {}).get(peer_id, {})
    failed = sum("failure" in run for run in quality.values())
    over = f"of {len(measured)} runs on {len(section['faces'])} meshes" if measured else ""
    edges = "new_non_manifold_edges"
    others = {key for name, keys in found.others.items() if name != edges for key in keys} if found else set()
    rows = [
        ("runs with new non-manifold edges", found and len(found.others[edges])),
        ("runs with new non-manifold vertices, duplicate or degenerate faces", found and len(others)),
        ("runs that miss the target", found and len(found.missed)),
        ("runs that fail", found and len(found.failed) + failed),
        ("runs with more folded faces than Lindstrom–Turk", found and len(found.more_folded)),
    ]
    return [Aim(f"{peer_id}: {text}", 0, count, over) for text, count in rows]


@dataclass(frozen=True)
class Pair:
    """A tool and its reference on one mesh of the section on speed."""

    mesh: str | None
    tool: str
    reference: str
    key: str = "cpu_seconds"

    def aim(self, speed: dict, text: str, bound: float) -> Aim:
        rounds = pair_rounds(speed, self.mesh, self.tool, self.reference)
        where = f" on {input_name(self.mesh)}" if self.mesh else ""
        if rounds is None:
            return Aim(text + where, bound, None)
        note = f"range {{1:.3g}}–{{2:.3g}}, others kept {busy_cores(*rounds):.1f} cores busy"
        values = ratios(*rounds, self.key)
        return Aim(text + where, bound, values[0], note.format(*values))


def engine_aims(sections: dict) -> list[Aim]:
    """Time and memory of the collapses alone."""
    speed = sections.get("speed", {})
    large, smooth = speed.get("large"), speed.get("smooth")
    against, threads = "engine fast, CPU, × meshoptimizer's simplify", "engine fast, wall, two threads × one"
    aims = [Pair(mesh, "engine_fast", MESHOPTIMIZER).aim(speed, against, 0.9) for mesh in (large, smooth)]
    aims += [
        Pair(mesh, "engine_fast_2", "engine_fast", "wall_seconds").aim(speed, threads, 0.65) for mesh in (large, smooth)
    ]
    aims.append(Pair(large, "fast", HOST).aim(speed, "fast in pymeshlab, CPU, × pymeshlab's own filter", 1 / 8))
    for tool, other, text in (("engine_fast", MESHOPTIMIZER, "engine fast"), ("fast", HOST, "fast in pymeshlab")):
        rounds = pair_rounds(speed, large, tool, other)
        peak = medians(rounds[0])["peak_bytes"] / speed["pairs"][large]["faces"] if rounds else None
        aims.append(Aim(f"{text}, peak bytes per face on top of the loaded mesh", 160, peak))
    growth = sections.get("growth", {})
    factor = growth_factor(growth, "engine_fast") if growth.get("rows") else None
    largest = f" to {growth['rows'][-1]['faces']:,}" if factor else " to 16 million"
    aims.append(Aim(f"engine fast, growth of the time per face from 100,000 faces{largest}", 1.3, factor))
    return aims


def array_descriptor_aims(descriptor: dict) -> list[Aim]:
    """The descriptor without a host: medians, with the least beside."""
    nanoseconds = least = times = least_times = None
    for line in descriptor.get("arrays", {}).get("report", "").splitlines():
        if line.startswith(ARRAYS_ROW):
            figures = line.removeprefix(ARRAYS_ROW).replace(" x", "").split()
            nanoseconds, least, times, least_times = map(float, figures)
    texts = ("descriptor on arrays, nanoseconds per face", "the same, × VCG's mean curvature")
    if nanoseconds is None:
        return [Aim(texts[0], 15, None), Aim(texts[1], 1 / 15, None)]
    busy = f"others kept {descriptor['arrays']['others']:.1f} cores busy"
    return [
        Aim(texts[0], 15, nanoseconds, f"least {least:.3g}; {busy}"),
        Aim(texts[1], 1 / 15, 1 / times, f"ratio of the least times {1 / least_times:.3g}"),
    ]


def refinement_time_aims(sections: dict) -> list[Aim]:
    """What refinement may cost."""
    speed = sections.get("speed", {})
    large, smooth = speed.get("large"), speed.get("smooth")
    against = "engine balanced, CPU, × meshoptimizer's simplify"
    aims = [Pair(mesh, "engine_balanced", MESHOPTIMIZER).aim(speed, against, 1.6) for mesh in (large, smooth)]
    aims.append(Pair(large, "balanced", HOST).aim(speed, "balanced in pymeshlab, CPU, × pymeshlab's own filter", 1 / 5))
    meshes = [mesh for mesh, run in speed.get("pairs", {}).items() if run["rows"][0]["tool"] == "engine_best"]
    text = "engine best, CPU, × Lindstrom–Turk"
    return aims + [Pair(mesh, "engine_best", REFERENCE).aim(speed, text, 1.5) for mesh in meshes or [None]]


def further_aims(sections: dict) -> list[Aim]:
    """The descriptor in the host, and the command."""
    host, command = sections.get("descriptor", {}).get("host"), sections.get("command")
    milliseconds = times = None
    note = ""
    if host:
        figures = descriptor_ratios(host)
        milliseconds = [1e9 * seconds / host["faces"] for seconds in figures["own"]]
        times, note = figures["times"], f"others kept {host['others']:.1f} cores busy"
    own = "descriptor in pymeshlab, ms per million faces"
    aims = [
        Aim(own, 100, milliseconds and milliseconds[0], milliseconds and f"least {milliseconds[1]:.3g}; {note}" or ""),
        Aim(
            "the same, × MeshLab's mean curvature",
            1 / 5,
            times and 1 / times[0],
            times and f"ratio of the least times {1 / times[1]:.3g}" or "",
        ),
    ]
    for axis, text, bound in (("rms", "rms", 0.5), ("feature_rms", "feature rms", 0.7)):
        value = command["project"][axis] / command["host"][axis] if command else None
        aims.append(Aim(f"command, {text}, × MeshLab's defaults", bound, value))
    return aims


def aims_by_subject(sections: dict) -> dict[str, list[Aim]]:
    """All aims: the collapses and their speed, refinement, and the rest."""
    quality = sections.get("quality", {})
    geometry = {peer.id: [*distance_aims(quality, peer.id), *validity_aims(sections, peer.id)] for peer in OWN}
    collapsing, refining = ([aim for peer_id in ids for aim in geometry[peer_id]] for ids in (COLLAPSING, REFINING))
    return {
        "Collapses alone": [
            *collapsing,
            *engine_aims(sections),
            *array_descriptor_aims(sections.get("descriptor", {})),
        ],
        "With refinement": [*refining, *refinement_time_aims(sections)],
        "Descriptor in the host, and the command": further_aims(sections),
    }


def aim_lines(sections: dict) -> list[str]:
    """The tables."""
    subjects = aims_by_subject(sections)
    aims = [aim for found in subjects.values() for aim in found if aim.bound is not None]
    missing = sum(aim.measured is None for aim in aims)
    unmeasured = f" {missing} were not measured in this run." if missing else ""
    lines = [
        "## Aims",
        "",
        f"{sum(aim.met for aim in aims)} of {len(aims)} aims are met; bold figures miss their bound.{unmeasured} "
        'Ratios of time are medians over pairs of runs. "strict" is effort fast with order strict.',
        "",
    ]
    for subject, found in subjects.items():
        lines += [f"### {subject}", "", "| aim | at most | measured |", "|---|---|---|"]
        lines += [*[aim.row() for aim in found], ""]
    return lines
