# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes docs/benchmark.md from the stored figures. Every figure of the page comes from here."""

import os
from pathlib import Path

import page_geometry as geometry
import page_speed as speed
from build_peers import PROJECT
from meshes import GROUPS, MODELS
from metrics import SAMPLES
from page_aims import aim_lines
from page_optimum import optimum_lines
from page_validity import validity_lines
from peers import OWN, PEERS, Peer, peer_named
from ratio_tables import EQUAL_BELOW
from timing import busy_cores

HEAD = """<!-- Written by scripts/benchmark; changes by hand are lost. -->
# Benchmark

`scripts/benchmark` measured everything on this page and wrote the page; anyone can run it again ({command}).
Ratios below 1 mean that this project is ahead; **bold** figures mean that it is not.
"""

DEFINITIONS = """## What is measured

All tools get the same mesh, with float32 coordinates and with vertices at the same position merged. All results are
measured by [one tool](../benchmarks/metrics.py) with libigl's exact distances from points to meshes ({samples:,}
samples on either side, distributed by area, fixed seed), in percent of the diagonal of the original's bounding box:

- **rms** √((F + B)/2), F and B the mean squared distances original → simplified and back;
- **feature rms** original → simplified at the tenth of the original's vertices with the largest Laplacian descriptor;
- **Hausdorff** the largest distance in both directions, over the samples and all vertices;
- **normal deviation** the mean angle between the normals at a sample and at its closest point, in both directions;
- **folded faces** faces whose normal differs by more than 90° from the original's at the point closest to their
  centroid;
- **perceptual difference** how different both surfaces look, from 0 to 1: the curvatures at closest points, compared by
  mean, deviation and structure in small neighborhoods, [after Lavoué's MSDM2](../benchmarks/perceptual.py).

In ratios to CGAL's tools, two distances below 0.001 % count as equal. Groups: {groups}. {origin}
"""

MODELS_ORIGIN = (
    "These public test models are not part of the project;\n`--meshes FOLDER` names their folder. Folded faces and "
    "topology are also counted on the other meshes of that folder and on [sample_meshes](../sample_meshes/README.md)."
)

SAMPLES_ORIGIN = (
    "**These are not the public test models for which the aims\nwere set**: `--meshes FOLDER` names the folder "
    "of those ({models})."
)

QUICK = """
**This was a quick run: few meshes, four peers, and small meshes in place of those with a million faces.** It shows that
everything works; its figures say little about the aims.
"""

LOOKS = (
    "The perceptual difference as ratios to CGAL's Lindstrom–Turk, geometric means over the meshes of a group; bold "
    "where this project is behind."
)

TIMES = (
    "Every run is a separate process that is limited to as many cores as the tool uses threads: one, unless the table "
    "says two. Times are those of the simplification alone, without reading the mesh and handing it over. Peak memory "
    "is counted on top of the loaded mesh."
)

PAIRS = (
    "Two tools take turns; each is first in every other pair. The figures are ratios of the tool's time to the "
    "other's: the median and range over the pairs, and the ratio of the least times. Others' cores: the number of "
    "cores that other programs kept busy meanwhile, which slows two threads more than one."
)

TRAPS = """## Several names, one implementation

- MeshLab, meshlabserver and pymeshlab run the same VCG quadric decimation. PyVista's `decimate` and `decimate_pro` are
  VTK's; PyVista's and trimesh's fast simplification is the package fast-simplification, which wraps sp4cerat's code.
- The wrapper of meshoptimizer on PyPI stops at an error of 0.01 unless told otherwise, and contains an older version
  than the crate; here meshoptimizer is called directly, with any error allowed.
- CGAL's meshes cannot have non-manifold vertices: such vertices are split before the time is taken.
- vtkDecimatePro with topology kept, and meshoptimizer if nothing more may collapse, stop above the target: see the
  column of missed targets.
- bpy and pymeshlab cannot share a process, so every tool runs in its own.
"""


def environment_lines(machine: dict) -> list[str]:
    """Machine and versions."""
    versions = ", ".join(f"{name} {number}" for name, number in machine["versions"].items())
    return [
        "## Machine and versions",
        "",
        f"{machine['date']}: {machine['processor']}, {machine['cores']} cores, {machine['memory_gib']} GiB; "
        f"{machine['system']}; {machine['compiler']}.",
        "",
        versions + ".",
        "",
    ]


def definitions(measured: list[str]) -> str:
    """What the figures mean, and on which meshes they were taken."""
    shown = {group: [name for name in names if name in measured] for group, names in GROUPS.items()}
    groups = "; ".join(f"{group}: {', '.join(names)}" for group, names in shown.items() if names)
    models = [name for names in MODELS.values() for name in names]
    origin = MODELS_ORIGIN if set(models) & set(measured) else SAMPLES_ORIGIN.format(models=", ".join(models))
    return DEFINITIONS.format(samples=SAMPLES, groups=groups or "none", origin=origin)


def geometry_lines(section: dict) -> list[str]:
    """Everything about distances."""
    shown = [peer for peer in OWN if section.get(peer.id)]
    lines = [
        "## Geometry against the best open peers",
        "",
        "Geometric-mean ratios to CGAL's Lindstrom–Turk with bounded normal change: rms/feature rms/Hausdorff/normal "
        "deviation. Bold: worse than Lindstrom–Turk or Garland–Heckbert in one of the first three.",
        "",
        *geometry.group_table(section),
        "",
        "## All tools",
        "",
        "Over all meshes and percentages of both groups, ratios to CGAL's Lindstrom–Turk: geometric means, for rms "
        "also median and range over the runs; faults are sums. CPU times are added up before their ratio is taken.",
        "",
        *geometry.tool_table(section),
        "",
    ]
    lines += ["### Perceptual difference", "", LOOKS, "", *geometry.look_table(section), ""]
    for peer in shown:
        lines += [
            f"### {geometry.title_of(peer)} against MeshLab's defaults, mesh by mesh",
            "",
            "rms/feature rms as ratios to pymeshlab's quadric decimation with defaults; in brackets where both are "
            f"below {EQUAL_BELOW} % of the diagonal.",
            "",
            *geometry.host_table(section, peer),
            "",
        ]
    return lines + [
        "### The figures themselves",
        "",
        "rms/Hausdorff in percent of the diagonal.",
        "",
        *geometry.absolute_table(section, ["cgal_lt", "cgal_gh", "pymeshlab", *[peer.id for peer in shown]]),
        "",
    ]


def speed_lines(sections: dict) -> list[str]:
    """Everything about time and memory."""
    runs = sections.get("speed", {})
    lines = ["## Time and memory", "", TIMES, ""]
    if runs.get("pairs"):
        lines += ["### Pairs in turns", "", PAIRS, "", *speed.pair_table(runs["pairs"]), ""]
    if "tools" in runs:
        tools = runs["tools"]
        rounds = [figures for figures in tools["figures"].values() if figures]
        lines += [
            f"### All tools on {tools['faces']:,} faces ({speed.input_name(tools['mesh'])}), to {tools['percent']:g} %",
            "",
            "Medians over rounds in which the tools take turns; ratios are taken inside a round (median, range). "
            f"Other programs kept {busy_cores(*rounds):.1f} cores busy. For a tool that was stopped, the table shows "
            "after how many processor seconds, including its start and reading the mesh.",
            "",
            *speed.speed_table(tools, "meshoptimizer_debian"),
            "",
        ]
    return lines + growth_lines(sections.get("growth", {})) + descriptor_section(sections.get("descriptor", {}))


def growth_lines(growth: dict) -> list[str]:
    """Small to large meshes."""
    if not growth.get("rows"):
        return []
    lines = [f"### Growth, to {growth['percent']:g} %", "", *speed.growth_table(growth), ""]
    for peer_id in growth["rows"][0]["figures"]:
        factor = speed.growth_factor(growth, peer_id)
        if factor is not None:
            lines += [
                f"{speed.tool_name(peer_id)}: the time per face of the largest mesh is {factor:.2f} times that around "
                f"{speed.LARGE_FACES:,} faces (the cheaper of the meshes just below and above).",
                "",
            ]
    return lines


def descriptor_section(descriptor: dict) -> list[str]:
    """The descriptor alone."""
    return ["### Descriptor", "", *speed.descriptor_lines(descriptor), ""] if descriptor else []


def command_lines(command: dict) -> list[str]:
    """The command of the README against MeshLab's defaults."""
    if not command:
        return []
    own, host = command["project"], command["host"]
    lines = [
        f"## `scripts/simplify {command['mesh']} out.ply --faces {command['faces']}`",
        "",
        "| | this project | MeshLab's quadric decimation, defaults | ratio |",
        "|---|---|---|---|",
    ]
    for axis, text in (("rms", "rms, %"), ("feature_rms", "feature rms, %"), ("hausdorff", "Hausdorff, %")):
        ratio = own[axis] / host[axis]
        shown = geometry.bold(f"{ratio:.3f}") if ratio >= 1 else f"{ratio:.3f}"
        lines.append(f"| {text} | {own[axis]:.5f} | {host[axis]:.5f} | {shown} |")
    lines.append(f"| faces | {own['faces']} | {host['faces']} | |")
    lines.append(f"| folded faces | {own['folded_faces']} | {host['folded_faces']} | |")
    return [*lines, ""]


def picture_lines(pictures: dict) -> list[str]:
    """Error maps."""
    if not pictures:
        return []
    lines = ["## Where the error is", ""]
    lines += ["The originals, colored by their distance to each result; one color scale per picture.", ""]
    for name, picture in pictures.items():
        lines += [picture["text"], "", f"![Error maps of {name}](images/benchmark/{name}.png)", ""]
    return lines


def settings_lines(section: dict) -> list[str]:
    """Tools, their settings and who shares an implementation."""
    lines = ["## Tools and settings", "", "| tool | settings | implementation |", "|---|---|---|"]
    rows: list[Peer] = [peer for peer in [*OWN, *PEERS] if section.get(peer.id)]
    return lines + [f"| {peer.library} | {peer.settings} | {peer.implementation} |" for peer in rows] + [""]


def write_page(sections: dict, destination: Path, command: str) -> None:
    """The whole page."""
    quality = sections.get("quality", {})
    parts = [
        HEAD.format(command=command) + (QUICK if sections.get("run", {}).get("quick") else ""),
        *environment_lines(sections["machine"]),
        definitions(sections.get("run", {}).get("meshes", [])),
        *aim_lines(sections),
        *geometry_lines(quality),
        *optimum_lines(sections.get("optimum", {})),
        *validity_lines(sections.get("validity", {})),
        *command_lines(sections.get("command", {})),
        *picture_lines(sections.get("pictures", {})),
        *speed_lines(sections),
        *settings_lines(quality),
        TRAPS,
    ]
    top = os.path.relpath(PROJECT, destination.parent.resolve())
    destination.write_text("\n".join(parts).replace("](../", f"]({top}/"), encoding="utf-8")


def picture_captions(quality: dict, name: str, percent: float) -> dict:
    """'rms x %' of each tool, to stand in the pictures."""
    key = f"{name}_{percent:g}"
    found = {peer_id: runs[key] for peer_id, runs in quality.items() if "rms" in runs.get(key, {})}
    return {peer_id: f"rms {run['rms']:.4f} %" for peer_id, run in found.items() if peer_named(peer_id)}
