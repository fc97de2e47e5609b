# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Geometry of every tool on every mesh at every percentage."""

from functools import lru_cache
from pathlib import Path

from tqdm import tqdm

from meshes import PERCENTS, BenchmarkMesh, target_faces
from metrics import Original, measure, plain_numbers
from peers import OWN, PEERS, Peer
from ratio_tables import LOOK
from runs import Store, Workshop, load_result, result_path, run_tool


def run_and_measure(workshop: Workshop, peer: Peer, mesh: BenchmarkMesh, percents, original: Original) -> dict:
    """{"cow_50": metrics, times and memory of one run, or the reason why there are none}."""
    targets = [target_faces(len(original.mesh.faces), percent) for percent in percents]
    paths: list[Path] = [result_path(workshop, peer.id, mesh, percent) for percent in percents]
    measured = {}
    for percent, target, path, figures in zip(
        percents, targets, paths, run_tool(workshop, peer.id, mesh, list(zip(targets, paths)))
    ):
        if "failure" not in figures:
            figures = {**plain_numbers(measure(original, load_result(path))), **figures}
        measured[f"{mesh.name}_{percent:g}"] = {**figures, "target": target}
    return measured


def measure_quality(workshop: Workshop, store: Store, meshes: list[BenchmarkMesh], percents=PERCENTS, peers=None):
    """Fills the section 'quality': {peer: {"cow_50": figures}}.

    Peers' results are kept from one benchmark to the next (remove the folder to renew them), this project's never.
    """
    section = store.section("quality")
    for peer in OWN:
        section.pop(peer.id, None)
    chosen = [*OWN, *(peers if peers is not None else PEERS)]
    for mesh, peer in tqdm([(mesh, peer) for mesh in meshes for peer in chosen], desc="geometry", unit="tool"):
        done = section.setdefault(peer.id, {})
        measure_again(workshop, peer, mesh, done)
        missing = [percent for percent in percents if f"{mesh.name}_{percent:g}" not in done]
        if missing:
            done.update(run_and_measure(workshop, peer, mesh, missing, original_of(mesh)))
            store.save()


def measure_again(workshop: Workshop, peer: Peer, mesh: BenchmarkMesh, done: dict) -> None:
    """Adds what metrics have come since to the figures of results that were kept; forgets those without a result."""
    for key in [key for key in done if key.rsplit("_", 1)[0] == mesh.name]:
        if "failure" in done[key] or LOOK in done[key]:
            continue
        path = result_path(workshop, peer.id, mesh, float(key.rsplit("_", 1)[1]))
        if path.exists():
            done[key] |= plain_numbers(measure(original_of(mesh), load_result(path)))
        else:
            del done[key]


@lru_cache(maxsize=1)
def original_of(mesh: BenchmarkMesh) -> Original:
    """The original, prepared for measuring; kept while the same mesh is asked for."""
    return Original(mesh.load())


def table_of(section: dict, peer_id: str) -> dict:
    """{(mesh, percent): figures} of the runs of one tool that gave a result."""
    runs = {}
    for key, figures in section.get(peer_id, {}).items():
        if "failure" not in figures:
            name, percent = key.rsplit("_", 1)
            runs[name, float(percent)] = figures
    return runs
