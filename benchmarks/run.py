#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures this project against its peers and writes docs/benchmark.md; scripts/benchmark prepares what it needs.

Sections: quality, optimum, validity, command, speed, growth, descriptor, pictures. Figures are kept between runs in the
folder, so a single section can be measured again; peers' geometry is measured once, this project's every time.
"""

import argparse
from datetime import date
from pathlib import Path

import machine
from build_peers import PROJECT, build_all
from claims import measure_command, measure_descriptor
from meshes import all_meshes_in, meshes_in, subdivided
from optimum import measure_optimum
from page import picture_captions, write_page
from peers import ENGINE, HOST, OWN, PEERS, REFERENCE
from pictures import draw_error_maps
from quality import measure_quality
from runs import Store, Workshop
from timing import Plan, measure_growth, measure_pairs, measure_speed
from validity import measure_validity

SECTIONS = ("quality", "optimum", "validity", "command", "speed", "growth", "descriptor", "pictures")
QUICK_MESHES = ("fandisk", "cow")
QUICK_FACES = 16_000
QUICK_PEERS = ("cgal_lt", "cgal_gh", "pymeshlab", "meshoptimizer_debian")
SPEED_PERCENT = 10
TOOL_SECONDS = 300  # of a processor, with the process's start and the mesh's way into the library
SIMPLIFY = "meshoptimizer_debian"
ENGINE_PAIRS = [("engine_fast", SIMPLIFY), ("engine_balanced", SIMPLIFY), ("engine_fast_2", "engine_fast")]
MIDPOINT_PAIRS = [
    *ENGINE_PAIRS,
    ("engine_balanced_2", "engine_balanced"),
    ("engine_fast", "meshoptimizer"),
    ("fast", HOST),
    ("balanced", HOST),
]
BEST_FACES = 20_000  # from here effort best is timed against Lindstrom-Turk
PICTURES = {"fandisk": 10, "bunny": 2, "rocker_arm": 10}
GROWTH_CHAIN = ("bunny10k_textured", "bunny")  # then the last one, its faces cut into four again and again
LARGEST_GROWTH = {True: 400_000, False: 20_000_000}


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="scripts/benchmark", description=__doc__)
    parser.add_argument("--meshes", type=Path, default=PROJECT / "sample_meshes", help="folder of the test models")
    parser.add_argument("--folder", type=Path, default=PROJECT / "build" / "benchmark", help="where the work is done")
    parser.add_argument("--vcglib", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--section", choices=SECTIONS, action="append", help="measure only this; may be repeated")
    parser.add_argument("--rounds", type=int, default=5, help="rounds of the measurements of time")
    parser.add_argument(
        "--limit", type=int, default=TOOL_SECONDS, help="processor seconds of a tool among all in speed"
    )
    parser.add_argument("--quick", action="store_true", help="few meshes and peers, small sizes, in minutes")
    parser.add_argument("--page", type=Path, help="default: docs/benchmark.md; with --quick a page in the folder")
    return parser.parse_args()


class Benchmark:
    """One run of the sections."""

    def __init__(self, arguments: argparse.Namespace):
        self.arguments = arguments
        self.quick = arguments.quick
        self.rounds = min(2, arguments.rounds) if self.quick else arguments.rounds
        folder = arguments.folder / "quick" if self.quick else arguments.folder
        self.workshop = Workshop(folder)
        self.store = Store(folder / "results.json")
        self.page = arguments.page or (folder if self.quick else PROJECT / "docs") / "benchmark.md"
        build_all(self.workshop.peers, arguments.vcglib)
        self.store.sections["machine"] = machine.describe(self.workshop.peers)
        self.meshes = meshes_in(arguments.meshes, self.workshop.inputs, QUICK_MESHES if self.quick else None)
        if not self.meshes:
            self.meshes = meshes_in(arguments.meshes, self.workshop.inputs, ["flange", "creature"])
        self.by_name = {mesh.name: mesh for mesh in self.meshes}
        self.store.sections["run"] = {"quick": self.quick, "meshes": list(self.by_name)}

    def large_mesh(self, smooth: bool = False):
        """About a million faces: igea cut once, or whatever there is."""
        if self.quick or "igea" not in self.by_name:
            return subdivided(self.meshes[0], 1 if self.quick else 3, self.workshop.inputs, smooth)
        return subdivided(self.by_name["igea"], 1, self.workshop.inputs, smooth)

    def every_mesh(self):
        """All meshes of both folders; with --quick the two and what fits beside them."""
        found = all_meshes_in([self.arguments.meshes, PROJECT / "sample_meshes"], self.workshop.inputs)
        return [mesh for mesh in found if not self.quick or mesh.face_count < QUICK_FACES]

    def quality(self):
        peers = [peer for peer in PEERS if not self.quick or peer.id in QUICK_PEERS]
        measure_quality(self.workshop, self.store, self.meshes, peers=peers)

    def optimum(self):
        measure_optimum(self.workshop, self.store, date.today().isoformat())

    def validity(self):
        measure_validity(self.workshop, self.store, self.every_mesh())

    def command(self):
        mesh = self.by_name.get("fandisk", self.meshes[0])
        source = next(path for path in self.arguments.meshes.iterdir() if path.stem == mesh.name)
        measure_command(self.workshop, self.store, source, mesh)

    def speed(self):
        """The pairs that aims compare, then all tools beside each other on one core each."""
        plan, fewer = Plan(SPEED_PERCENT, self.rounds), Plan(SPEED_PERCENT, min(3, self.rounds))
        large, smooth = self.large_mesh(), self.large_mesh(smooth=True)
        self.store.sections["speed"] = {"large": large.name, "smooth": smooth.name}
        midpoint = [pair for pair in MIDPOINT_PAIRS if not self.quick or pair[1] != "meshoptimizer"]
        measure_pairs(self.workshop, self.store, large, midpoint, plan)
        measure_pairs(self.workshop, self.store, smooth, ENGINE_PAIRS, plan)
        for mesh in self.every_mesh():
            if mesh.face_count >= BEST_FACES:
                measure_pairs(self.workshop, self.store, mesh, [("engine_best", REFERENCE)], fewer)
        tools = [peer.id for peer in [*ENGINE, *OWN] if peer.threads == 1]
        tools += [peer.id for peer in PEERS if not self.quick or peer.id in QUICK_PEERS]
        limited = Plan(SPEED_PERCENT, min(3, self.rounds), self.arguments.limit)
        measure_speed(self.workshop, self.store, large, tools, limited)

    def growth(self):
        chain = [self.by_name[name] for name in GROWTH_CHAIN if name in self.by_name] or self.meshes[:1]
        meshes, last = list(chain), chain[-1]
        for times in range(1, 8):
            if last.face_count * 4**times <= LARGEST_GROWTH[self.quick]:
                meshes.append(subdivided(last, times, self.workshop.inputs))
        plan = Plan(SPEED_PERCENT, min(3, self.rounds))
        measure_growth(self.workshop, self.store, meshes, ["engine_fast", "engine_balanced"], plan)

    def descriptor(self):
        measure_descriptor(self.workshop, self.store, self.large_mesh(), self.arguments.vcglib, self.rounds)

    def pictures(self):
        shown = self.store.sections["pictures"] = {}
        for name, percent in PICTURES.items():
            if name in self.by_name:
                captions = picture_captions(self.store.section("quality"), name, percent)
                destination = self.page.parent / "images" / "benchmark" / f"{name}.png"
                draw_error_maps(self.workshop, self.by_name[name], percent, destination, captions)
                shown[name] = {"text": f"{name.replace('_', ' ')}, {percent} % of the faces:"}


def main() -> None:
    arguments = parse_arguments()
    benchmark = Benchmark(arguments)
    for section in SECTIONS:
        if not arguments.section or section in arguments.section:
            getattr(benchmark, section)()
            benchmark.store.save()
    page = benchmark.page.resolve()
    write_page(benchmark.store.sections, page, "`scripts/benchmark --meshes FOLDER`, or `--quick`")
    print(f"written: {page.relative_to(PROJECT) if page.is_relative_to(PROJECT) else page}")


if __name__ == "__main__":
    main()
