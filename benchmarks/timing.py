# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Time and memory: all tools on one large mesh, pairs of tools in turns, and the engine from 10k to 16M faces.

Tools run in rounds, one after the other, so that a busy stretch of the machine meets all of them. Where two are
compared they run in pairs, each of them first in every other pair; the ratio is taken inside a pair, and the page
shows the median and range of these ratios. What other programs did meanwhile is noted with every run.
"""

from dataclasses import dataclass
from statistics import median

from tqdm import tqdm

from meshes import BenchmarkMesh, target_faces
from runs import LONGEST_SECONDS, Store, Workshop, run_tool
from stopwatch import Neighbours


@dataclass(frozen=True)
class Plan:
    """How often a tool runs, to how many percent of the faces, and how many seconds of a processor it may use."""

    percent: float
    rounds: int
    limit: int = LONGEST_SECONDS


def run_once(workshop: Workshop, peer_id: str, mesh: BenchmarkMesh, plan: Plan) -> dict:
    """Figures of one run in a process of its own, and `others`: the cores that were busy with something else."""
    destination = workshop.results / "timing" / f"{peer_id}.npz"
    with Neighbours() as neighbours:
        faces = target_faces(mesh.face_count, plan.percent)
        figures = run_tool(workshop, peer_id, mesh, [(faces, destination)], plan.limit)
    return {**figures[0], "others": neighbours.cores}


def measure_rounds(workshop: Workshop, peer_ids: list[str], mesh: BenchmarkMesh, plan: Plan) -> dict:
    """{peer: list of figures, one a round}; a tool that fails is left out of the following rounds."""
    figures = {peer_id: [] for peer_id in peer_ids}
    for _ in tqdm(range(plan.rounds), desc=f"time, {mesh.name} to {plan.percent:g} %", unit="round"):
        for peer_id in peer_ids:
            if not any("failure" in earlier for earlier in figures[peer_id]):
                figures[peer_id].append(run_once(workshop, peer_id, mesh, plan))
    return figures


def measure_speed(workshop: Workshop, store: Store, mesh: BenchmarkMesh, peer_ids: list[str], plan: Plan) -> None:
    """Stores the rounds of all tools on one mesh under speed/tools."""
    store.section("speed")["tools"] = {
        "mesh": mesh.name,
        "faces": mesh.face_count,
        "percent": plan.percent,
        "figures": measure_rounds(workshop, peer_ids, mesh, plan),
    }
    store.save()


def measure_pairs(
    workshop: Workshop, store: Store, mesh: BenchmarkMesh, pairs: list[tuple[str, str]], plan: Plan
) -> None:
    """Stores under speed/pairs what pairs of a tool and its reference gave, running in turns on one mesh."""
    rows = []
    for tool, reference in pairs:
        figures = {tool: [], reference: []}
        for number in tqdm(range(plan.rounds), desc=f"{tool} and {reference}, {mesh.name}", unit="pair"):
            for peer_id in (tool, reference) if number % 2 == 0 else (reference, tool):
                figures[peer_id].append(run_once(workshop, peer_id, mesh, plan))
            if any("failure" in rounds_of[-1] for rounds_of in figures.values()):
                break
        rows.append({"tool": tool, "reference": reference, "figures": figures})
        measured = {"faces": mesh.face_count, "percent": plan.percent, "rows": rows}
        store.section("speed").setdefault("pairs", {})[mesh.name] = measured
        store.save()


def measure_growth(workshop: Workshop, store: Store, meshes: list[BenchmarkMesh], peer_ids, plan: Plan) -> None:
    """Stores growth: for each mesh its faces and the figures of each tool."""
    rows = []
    for mesh in meshes:
        figures = measure_rounds(workshop, peer_ids, mesh, plan)
        rows.append({"mesh": mesh.name, "faces": mesh.face_count, "figures": figures})
        store.section("growth")["rows"] = rows
        store.section("growth")["percent"] = plan.percent
        store.save()


def succeeded(rounds: list[dict]) -> bool:
    """True where a tool gave figures."""
    return bool(rounds) and not any("failure" in figures for figures in rounds)


def medians(rounds: list[dict]) -> dict:
    """Median of each figure over the rounds."""
    return {key: median(figures[key] for figures in rounds) for key in rounds[0]}


def ratios(rounds: list[dict], reference: list[dict], key: str) -> tuple[float, float, float]:
    """Median, least and largest of the ratios inside the rounds."""
    values = [one[key] / max(other[key], 1e-9) for one, other in zip(rounds, reference)]
    return median(values), min(values), max(values)


def ratio_of_least(rounds: list[dict], reference: list[dict], key: str) -> float:
    """The least of one over the least of the other: what the least disturbed runs say."""
    return min(figures[key] for figures in rounds) / max(min(figures[key] for figures in reference), 1e-9)


def busy_cores(*tools: list[dict]) -> float:
    """Median of the cores that were busy with something else during the runs."""
    return median(figures["others"] for rounds in tools for figures in rounds)
