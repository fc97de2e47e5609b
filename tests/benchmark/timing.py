# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Time and memory: all tools on one large mesh, and the engine from 10k to 16M faces.

Tools run in rounds, one after the other, so that a busy stretch of the machine meets all of them; ratios are taken
inside a round, and the page shows their median and range.
"""

import os
from statistics import median

from tqdm import tqdm

from meshes import BenchmarkMesh, target_faces
from runs import Store, Workshop, run_tool


def measure_rounds(workshop: Workshop, peer_ids: list[str], mesh: BenchmarkMesh, percent: float, rounds: int) -> dict:
    """{peer: list of figures, one a round}; a tool that fails is left out of the following rounds."""
    faces = target_faces(mesh.face_count, percent)
    figures = {peer_id: [] for peer_id in peer_ids}
    for _ in tqdm(range(rounds), desc=f"time, {mesh.name} to {percent:g} %", unit="round"):
        for peer_id in peer_ids:
            if any("failure" in earlier for earlier in figures[peer_id]):
                continue
            destination = workshop.results / "timing" / f"{peer_id}.npz"
            figures[peer_id] += run_tool(workshop, peer_id, mesh, [(faces, destination)])
    return figures


def measure_speed(workshop: Workshop, store: Store, name: str, mesh: BenchmarkMesh, peer_ids, percent, rounds) -> None:
    """Stores the rounds of several tools on one mesh under speed/name."""
    store.section("speed")[name] = {
        "mesh": mesh.name,
        "faces": mesh.face_count,
        "percent": percent,
        "load": os.getloadavg()[0],
        "figures": measure_rounds(workshop, peer_ids, mesh, percent, rounds),
    }
    store.save()


def measure_growth(workshop: Workshop, store: Store, meshes: list[BenchmarkMesh], peer_ids, percent, rounds) -> None:
    """Stores growth: for each mesh its faces and the median processor time and peak memory of each tool."""
    rows = []
    for mesh in meshes:
        figures = measure_rounds(workshop, peer_ids, mesh, percent, rounds)
        rows.append({"mesh": mesh.name, "faces": mesh.face_count, "figures": figures})
        store.section("growth")["rows"] = rows
        store.section("growth")["percent"] = percent
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
