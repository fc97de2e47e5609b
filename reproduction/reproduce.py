#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reproduces every figure and the table of the paper with the plugin's filters in pymeshlab.

    reproduce.py --project DIR [--meshes DIR] [--page FILE]

Writes docs/paper.md and docs/images/paper/ of the project. MESHES holds the public test models that the paper
shows. Without it the project's own sample meshes stand for them, and the page says so.
"""

import argparse
import platform
import sys
import time
from importlib.metadata import version
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "benchmarks")]  # the metric tool is the benchmark's

from tqdm import tqdm  # noqa: E402

import entries_classes  # noqa: E402
import entries_descriptor  # noqa: E402
import entries_operators  # noqa: E402
import entries_simplification  # noqa: E402
from models import find_models  # noqa: E402
from page import entry_lines, overview, table  # noqa: E402
from studio import Studio  # noqa: E402

ENTRIES = (
    entries_operators.operators,
    entries_descriptor.comparison_of_descriptors,
    entries_descriptor.segments_of_the_curve,
    entries_simplification.shortest_edge,
    entries_classes.borders,
    entries_classes.two_classes,
    entries_classes.refinement,
    entries_operators.other_meshes,
    entries_simplification.error_functions,
    entries_simplification.weights,
    entries_simplification.curvatures,
    entries_operators.times,
)


def head(studio: Studio, are_test_models: bool) -> list[str]:
    """What the page is, with what and on which meshes it was written."""
    meshes = (
        "the public test models"
        if are_test_models
        else "the project's sample meshes, since the test models were not given"
    )
    rows = [
        [model.path.name, len(model.mesh.vertices), len(model.mesh.faces), model.why]
        for model in studio.models.values()
    ]
    return [
        "<!-- SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors -->",
        "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->",
        "<!-- Written by scripts/reproduce; changes by hand are lost. -->",
        "# The paper, figure by figure",
        "",
        "Lin Zhang, Zhen Ma, Zhong Zhou and Wei Wu, *Laplacian-Based Feature Preserving Mesh Simplification* (2012): "
        "every figure and the table, reproduced with this plugin's filters, with the claim in one sentence and a check "
        "of the numbers. A claim *holds* if all of its checks agree, and *holds in part* if some of them agree. "
        "`scripts/reproduce [--meshes DIR]` writes this page.",
        "",
        f"Meshes: {meshes}, welded, in pymeshlab {version('pymeshlab')} on {platform.system()} ({platform.machine()}).",
        "",
        *table(["mesh", "vertices", "faces", "role"], rows),
        "",
    ]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--project", type=Path, required=True)
    parser.add_argument("--meshes", type=Path)
    parser.add_argument("--page", type=Path, help="docs/paper.md of the project; pictures go to images/paper beside it")
    arguments = parser.parse_args()
    page = arguments.page or arguments.project / "docs" / "paper.md"
    try:
        models, are_test_models = find_models(arguments.meshes, arguments.project / "sample_meshes")
    except FileNotFoundError as error:
        print(f"reproduce: {error}", file=sys.stderr)
        return 1
    studio = Studio(models, page.parent / "images" / "paper")
    start = time.monotonic()
    entries = [make(studio) for make in tqdm(ENTRIES, unit="entry", disable=None)]
    lines = [*head(studio, are_test_models), *overview(entries), ""]
    for entry in entries:
        lines += entry_lines(entry)
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text("\n".join(lines).rstrip() + "\n", encoding="utf-8")
    for entry in entries:
        print(f"{entry.verdict:14} {entry.title}")
    print(f"{page}: {len(entries)} entries in {(time.monotonic() - start) / 60:.1f} minutes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
