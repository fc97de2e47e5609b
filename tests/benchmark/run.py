#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures this project against its peers and writes docs/benchmark.md; scripts/benchmark prepares what it needs.

Sections: quality, command, speed, growth, descriptor, pictures. Figures are kept between runs in the folder, so a
single section can be measured again; peers' geometry is measured once, this project's every time.
"""

import argparse
from pathlib import Path

import machine
from build_peers import PROJECT, build_all, descriptor_report
from claims import measure_command, measure_host_descriptor
from meshes import meshes_in, subdivided
from page import picture_captions, write_page
from peers import ENGINE, PEERS
from pictures import draw_error_maps
from quality import measure_quality
from runs import Store, Workshop
from timing import measure_growth, measure_speed

SECTIONS = ("quality", "command", "speed", "growth", "descriptor", "pictures")
QUICK_MESHES = ("fandisk", "cow")
QUICK_PEERS = ("cgal_lt", "cgal_gh", "pymeshlab", "meshoptimizer_debian")
SPEED_PERCENT = 10
SAME_SPEED = (  # settings that cost as much as another row of the same tool
    "pymeshlab_weighted",
    "pymeshlab_preserve",
    "openmesh_flip",
    "vtk_quadric_volume",
    "vtk_pro",
)
FAST_PEERS = ("meshoptimizer_debian", "meshoptimizer", "meshoptimizer_update", "fast_simplification")
LARGE_MESHES = ("rocker_arm", "elephant", "bunny", "igea")
PICTURES = {"fandisk": 10, "bunny": 2, "rocker_arm": 10}
GROWTH_CHAIN = ("bunny10k_textured", "bunny")  # then the last one, its faces cut into four again and again
LARGEST_GROWTH = {True: 300_000, False: 20_000_000}


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="scripts/benchmark", description=__doc__)
    parser.add_argument("--meshes", type=Path, default=PROJECT / "sample_meshes", help="folder of the test models")
    parser.add_argument("--folder", type=Path, default=PROJECT / "build" / "benchmark", help="where the work is done")
    parser.add_argument("--vcglib", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--section", choices=SECTIONS, action="append", help="measure only this; may be repeated")
    parser.add_argument("--rounds", type=int, default=5, help="rounds of the measurements of time")
    parser.add_argument("--quick", action="store_true", help="two meshes and four peers, in minutes")
    parser.add_argument("--page", type=Path, help="default: docs/benchmark.md; with --quick a page in the folder")
    return parser.parse_args()


class Benchmark:
    """One run of the sections."""

    def __init__(self, arguments: argparse.Namespace):
        self.arguments = arguments
        self.quick = arguments.quick
        folder = arguments.folder / "quick" if self.quick else arguments.folder
        self.workshop = Workshop(folder)
        self.store = Store(folder / "results.json")
        build_all(self.workshop.peers, arguments.vcglib)
        self.store.sections["machine"] = machine.describe(self.workshop.peers)
        self.meshes = meshes_in(arguments.meshes, self.workshop.inputs, QUICK_MESHES if self.quick else None)
        if not self.meshes:
            self.meshes = meshes_in(arguments.meshes, self.workshop.inputs, ["flange", "creature"])
        self.by_name = {mesh.name: mesh for mesh in self.meshes}

    def large_mesh(self):
        """About a million faces: igea cut once, or whatever there is."""
        if self.quick or "igea" not in self.by_name:
            return subdivided(self.meshes[0], 2, self.workshop.inputs)
        return subdivided(self.by_name["igea"], 1, self.workshop.inputs)

    def quality(self):
        peers = [peer for peer in PEERS if not self.quick or peer.id in QUICK_PEERS]
        measure_quality(self.workshop, self.store, self.meshes, peers=peers)

    def command(self):
        mesh = self.by_name.get("fandisk", self.meshes[0])
        source = next(path for path in self.arguments.meshes.iterdir() if path.stem == mesh.name)
        measure_command(self.workshop, self.store, source, mesh)

    def speed(self):
        """All tools in a few rounds, then those that compete for speed in more of them, then the host's filters."""
        rounds, large = self.arguments.rounds, self.large_mesh()
        engine = [peer.id for peer in ENGINE if peer.id != "engine_best"]
        others = [peer.id for peer in PEERS if peer.id not in (*SAME_SPEED, *FAST_PEERS)]
        fast = engine + [peer_id for peer_id in FAST_PEERS if not self.quick or peer_id in QUICK_PEERS]
        measure_speed(self.workshop, self.store, "arrays", large, fast, SPEED_PERCENT, rounds)
        if not self.quick:
            tools = ["engine_fast", "engine_balanced", "meshoptimizer_debian", *others]
            measure_speed(self.workshop, self.store, "tools", large, tools, SPEED_PERCENT, min(3, rounds))
        host = ["fast", "balanced", "pymeshlab"]
        measure_speed(self.workshop, self.store, "host", large, host, SPEED_PERCENT, rounds)
        for name in LARGE_MESHES:
            if name in self.by_name and not self.quick:
                tools = ["engine_best", "cgal_lt"]
                measure_speed(
                    self.workshop, self.store, f"best_{name}", self.by_name[name], tools, SPEED_PERCENT, min(3, rounds)
                )

    def growth(self):
        chain = [self.by_name[name] for name in GROWTH_CHAIN if name in self.by_name] or self.meshes[:1]
        meshes, last = list(chain), chain[-1]
        for times in range(1, 8):
            if last.face_count * 4**times <= LARGEST_GROWTH[self.quick]:
                meshes.append(subdivided(last, times, self.workshop.inputs))
        tools, rounds = ["engine_fast", "engine_balanced"], min(3, self.arguments.rounds)
        measure_growth(self.workshop, self.store, meshes, tools, SPEED_PERCENT, rounds)

    def descriptor(self):
        measure_host_descriptor(self.workshop, self.store, self.large_mesh(), self.arguments.rounds)
        mesh = self.large_mesh().ply
        report = descriptor_report(self.workshop.peers, self.arguments.vcglib, mesh, self.arguments.rounds)
        self.store.section("descriptor")["arrays"] = report

    def pictures(self):
        shown = self.store.sections["pictures"] = {}
        for name, percent in PICTURES.items():
            if name in self.by_name:
                folder = self.workshop.folder if self.quick else PROJECT / "docs" / "images" / "benchmark"
                captions = picture_captions(self.store.section("quality"), name, percent)
                draw_error_maps(self.workshop, self.by_name[name], percent, folder / f"{name}.png", captions)
                shown[name] = {"text": f"{name.replace('_', ' ')}, {percent} % of the faces:"}


def main() -> None:
    arguments = parse_arguments()
    benchmark = Benchmark(arguments)
    for section in SECTIONS:
        if not arguments.section or section in arguments.section:
            getattr(benchmark, section)()
            benchmark.store.save()
    usual = benchmark.workshop.folder if arguments.quick else PROJECT / "docs"
    page = arguments.page or usual / "benchmark.md"
    write_page(benchmark.store.sections, page, "`scripts/benchmark --meshes FOLDER`, or `--quick`")
    print(f"written: {page.relative_to(PROJECT) if page.is_relative_to(PROJECT) else page}")


if __name__ == "__main__":
    main()
