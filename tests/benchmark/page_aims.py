# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What this project aims at, and what was measured: the first table of the benchmark's page."""

from dataclasses import dataclass
from statistics import median

from page_geometry import benchmark_runs, bold
from page_speed import LARGE_FACES, growth_factor
from peers import HOST, OWN, REFERENCE, SECOND_REFERENCE
from quality import table_of
from ratio_tables import cells, mean_of_distances, ratio
from timing import medians, ratios, succeeded

ARRAYS_ROW = "Laplacian, float arrays"  # of descriptor_benchmark


@dataclass(frozen=True)
class Aim:
    """One aim: a figure that should be at most its bound."""

    text: str
    bound: float
    measured: float

    def row(self) -> str:
        shown = f"{self.measured:.3g}"
        return f"| {self.text} | {self.bound:.3g} | {shown if self.measured <= self.bound else bold(shown)} |"


def distance_aims(section: dict, peer_id: str, found: list) -> list[Aim]:
    """Ratios to Lindstrom-Turk by group."""
    rms = max(cell.ratio for cell in found if cell.axis == "rms")
    feature = max(cell.ratio for cell in found if cell.axis == "feature_rms" and cell.percent >= 10)
    hausdorff = max(cell.ratio for cell in found if cell.axis == "hausdorff")
    normals = max(cell.ratio for cell in found if cell.axis == "normal_deviation")
    aims = [
        Aim(f"{peer_id}: largest rms of a group, × Lindstrom–Turk", 1.02 if peer_id in ("fast", "strict") else 1, rms),
        Aim(f"{peer_id}: largest feature rms of a group at 50–10 %, × Lindstrom–Turk", 0.8, feature),
        Aim(f"{peer_id}: largest Hausdorff distance of a group, × Lindstrom–Turk", 0.8, hausdorff),
        Aim(f"{peer_id}: largest normal deviation of a group, × Lindstrom–Turk", 1.07, normals),
    ]
    bound = {"balanced": 0.62, "best": 0.57}.get(peer_id)
    if bound:
        text = f"{peer_id}: mean of rms, feature rms and Hausdorff over all groups, × Lindstrom–Turk"
        aims.append(Aim(text, bound, mean_of_distances(found)))
        lost = sum(cell.lost for cell in found)
        aims.append(Aim(f"{peer_id}: cells behind the better of Lindstrom–Turk and Garland–Heckbert", 0, lost))
    return aims


def fault_aims(section: dict, peer_id: str) -> list[Aim]:
    """Counts that should be zero, over all meshes measured."""
    runs, reference, host = (table_of(section, name) for name in (peer_id, REFERENCE, HOST))
    faults = sum(sum(value for key, value in run.items() if key.startswith("new_")) for run in runs.values())
    behind = sum(
        ratio(run[axis], host[key][axis], axis) > 1
        for key, run in runs.items()
        for axis in ("rms", "feature_rms")
        if key in host
    )
    folded = sum(run["folded_faces"] > reference[key]["folded_faces"] for key, run in runs.items() if key in reference)
    return [
        Aim(f"{peer_id}: rms or feature rms of a single run behind pymeshlab's defaults", 0, behind),
        Aim(f"{peer_id}: new non-manifold edges and vertices, duplicate and degenerate faces", 0, faults),
        Aim(f"{peer_id}: targets missed", 0, sum(run["faces"] > run["target"] for run in runs.values())),
        Aim(f"{peer_id}: runs with more folded faces than Lindstrom–Turk", 0, folded),
    ]


def geometry_aims(section: dict) -> list[Aim]:
    """Every effort."""
    reference, second = (benchmark_runs(section, peer_id) for peer_id in (REFERENCE, SECOND_REFERENCE))
    aims = []
    for peer in OWN:
        found = cells(benchmark_runs(section, peer.id), reference, second)
        if found:
            aims += [*distance_aims(section, peer.id, found), *fault_aims(section, peer.id)]
    return aims


def _ratio(speed: dict, tool: str, reference: str, key: str = "cpu_seconds") -> float | None:
    figures = speed.get("figures", {})
    if not all(succeeded(figures.get(name, [])) for name in (tool, reference)):
        return None
    return ratios(figures[tool], figures[reference], key)[0]


def speed_aims(sections: dict) -> list[Aim]:
    """Time and memory."""
    speed = sections.get("speed", {})
    arrays, host = speed.get("arrays", {}), speed.get("host", {})
    rows = [
        ("engine fast, CPU, × meshoptimizer's simplify (Debian)", 0.9,
         _ratio(arrays, "engine_fast", "meshoptimizer_debian")),
        ("engine balanced, CPU, × the same", 1.6, _ratio(arrays, "engine_balanced", "meshoptimizer_debian")),
        ("engine fast, wall time on two threads, × one thread", 0.65,
         _ratio(arrays, "engine_fast_2", "engine_fast", "wall_seconds")),
        ("pymeshlab host, fast, CPU, × pymeshlab's own filter", 1 / 8, _ratio(host, "fast", HOST)),
        ("pymeshlab host, balanced, CPU, × pymeshlab's own filter", 1 / 5, _ratio(host, "balanced", HOST)),
    ]  # fmt: skip
    rows += [
        (f"best on {run['mesh']}, CPU, × Lindstrom–Turk", 1.5, _ratio(run, "engine_best", REFERENCE))
        for name, run in speed.items()
        if name.startswith("best_")
    ]
    aims = [Aim(text, bound, value) for text, bound, value in rows if value is not None]
    if succeeded(arrays.get("figures", {}).get("engine_fast", [])):
        peak = medians(arrays["figures"]["engine_fast"])["peak_bytes"] / arrays["faces"]
        aims.append(Aim("engine fast, peak bytes a face above the loaded mesh", 160, peak))
    if sections.get("growth", {}).get("rows"):
        factor = growth_factor(sections["growth"], "engine_fast", LARGE_FACES)
        if factor is not None:
            aims.append(Aim("engine fast, growth of the time per face to the largest mesh", 1.3, factor))
    return aims


def further_aims(sections: dict) -> list[Aim]:
    """The descriptor in the host, and the command."""
    aims = []
    descriptor = sections.get("descriptor", {}).get("host")
    if descriptor:
        seconds = {name: median(values) for name, values in descriptor["seconds"].items()}
        own, other = (seconds[name] - seconds["nothing"] for name in ("descriptor", "curvature"))
        million = 1e6 / descriptor["faces"]
        aims.append(Aim("descriptor in pymeshlab, ms for a million faces", 100, 1e3 * own * million))
        aims.append(Aim("the same, × MeshLab's mean curvature", 1 / 5, own / other))
    for line in sections.get("descriptor", {}).get("arrays", "").splitlines():
        if line.startswith(ARRAYS_ROW):
            nanoseconds, _, factor, _ = line.removeprefix(ARRAYS_ROW).split()
            aims.append(Aim("descriptor on arrays, nanoseconds a face", 15, float(nanoseconds)))
            aims.append(Aim("the same, × VCG's mean curvature", 1 / 15, 1 / float(factor)))
    command = sections.get("command")
    if command:
        for axis, text, bound in (("rms", "rms", 0.5), ("feature_rms", "feature rms", 0.7)):
            value = command["project"][axis] / command["host"][axis]
            aims.append(Aim(f"command, {text} × MeshLab's defaults", bound, value))
    return aims


def aim_lines(sections: dict) -> list[str]:
    """The table."""
    aims = [*geometry_aims(sections.get("quality", {})), *speed_aims(sections), *further_aims(sections)]
    missed = sum(aim.measured > aim.bound for aim in aims)
    return [
        "## Aims",
        "",
        f"{len(aims) - missed} of {len(aims)} are met; bold figures miss their bound.",
        "",
        "| aim | at most | measured |",
        "|---|---|---|",
        *[aim.row() for aim in aims],
        "",
    ]
