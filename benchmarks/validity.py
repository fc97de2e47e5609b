# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Is what comes out still a clean surface? Folded faces, topology and targets on every mesh there is.

No distance is measured, so that all meshes of the folder and of sample_meshes can be run at all percentages in
minutes.
"""

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from tqdm import tqdm

from meshes import BenchmarkMesh, target_faces
from metrics import ValidOriginal, faults, plain_numbers
from peers import OWN, REFERENCE, peer_named
from quality import table_of
from runs import Store, Workshop, load_result, run_tool

PERCENTS = (50, 20, 10, 5, 2, 1)
OTHER_FAULTS = {  # beside folded faces and missed targets
    "new_non_manifold_edges": "non-manifold edges",
    "new_non_manifold_vertices": "non-manifold vertices",
    "new_duplicate_faces": "duplicate faces",
    "new_degenerate_faces": "degenerate faces",
}


def measure_validity(workshop: Workshop, store: Store, meshes: list[BenchmarkMesh], percents=PERCENTS) -> None:
    """Fills the section 'validity': its meshes with their faces, and {peer: {"cow_50": faults}}.

    Lindstrom-Turk's runs are kept from one benchmark to the next, this project's never.
    """
    section = store.section("validity")
    kept = section.get("runs", {}).get(REFERENCE, {})
    runs = {peer.id: {} for peer in OWN} | {REFERENCE: kept}
    section |= {"faces": {mesh.name: mesh.face_count for mesh in meshes}, "percents": list(percents), "runs": runs}
    chosen = [*OWN, peer_named(REFERENCE)]
    for mesh, peer in tqdm([(mesh, peer) for mesh in meshes for peer in chosen], desc="validity", unit="tool"):
        missing = [percent for percent in percents if f"{mesh.name}_{percent:g}" not in runs[peer.id]]
        if missing:
            runs[peer.id].update(run_and_count(workshop, peer.id, mesh, missing))
            store.save()


def run_and_count(workshop: Workshop, peer_id: str, mesh: BenchmarkMesh, percents) -> dict:
    """{"cow_50": faults of one run, or the reason why there is none}."""
    original = original_of(mesh)
    targets = [target_faces(len(original.mesh.faces), percent) for percent in percents]
    paths: list[Path] = [workshop.results / "validity" / f"{peer_id}_{percent:g}.npz" for percent in percents]
    counted = {}
    figures = run_tool(workshop, peer_id, mesh, list(zip(targets, paths)))
    for percent, target, path, run in zip(percents, targets, paths, figures):
        if "failure" not in run:
            run = plain_numbers(faults(original, load_result(path)))
        counted[f"{mesh.name}_{percent:g}"] = {**run, "target": target}
    return counted


@lru_cache(maxsize=1)
def original_of(mesh: BenchmarkMesh) -> ValidOriginal:
    """The original, prepared for counting; kept while the same mesh is asked for."""
    return ValidOriginal(mesh.load())


@dataclass(frozen=True)
class Comparison:
    """One tool of this project on some meshes, beside Lindstrom-Turk; where that gave nothing, it has no faults."""

    folded: dict  # (mesh, percent): faces
    reference: dict  # the same runs of Lindstrom-Turk
    more_folded: list  # the runs with more of them than Lindstrom-Turk
    missed: dict  # targets not reached: (mesh, percent): (faces, target)
    failed: list  # runs without a result
    others: dict  # fault: the runs that have it

    @property
    def clean(self) -> bool:
        """No fault but folded faces."""
        return not (self.missed or self.failed or any(self.others.values()))


def compare(section: dict, peer_id: str, names=None) -> Comparison:
    """Faults of a tool on the meshes of these names, or on all."""
    runs, reference = (
        {key: run for key, run in table_of(section["runs"], tool).items() if names is None or key[0] in names}
        for tool in (peer_id, REFERENCE)
    )
    folded = {key: run["folded_faces"] for key, run in runs.items()}
    beside = {key: reference[key]["folded_faces"] if key in reference else 0 for key in runs}
    return Comparison(
        folded=folded,
        reference=beside,
        more_folded=[key for key in runs if folded[key] > beside[key]],
        missed={key: (run["faces"], run["target"]) for key, run in runs.items() if run["faces"] > run["target"]},
        failed=[key for key in failures_of(section, peer_id) if names is None or key[0] in names],
        others={fault: [key for key, run in runs.items() if run[fault]] for fault in OTHER_FAULTS},
    )


def failures_of(section: dict, peer_id: str) -> dict:
    """{(mesh, percent): why a tool gave no result}."""
    found = {}
    for key, run in section["runs"].get(peer_id, {}).items():
        if "failure" in run:
            name, percent = key.rsplit("_", 1)
            found[name, float(percent)] = run["failure"]
    return found
