# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh of the corpus with parameters as the bytes that mesh_bytes.cpp reads.

As a program: python mesh_bytes.py FOLDER writes the smaller ones there, as seeds for a fuzzer.
"""

import struct
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from hostile_meshes import HostileMesh, corpus

TOPOLOGY, CROSSINGS, CLEAN, MEASURE, FIXED, SELECTED = 1, 2, 4, 8, 16, 32
SINGLE, LONG_INDICES, ANY_INDEX, LABELS, EVERY_THREADS = 64, 128, 256, 512, 1024


@dataclass(frozen=True)
class CoreSetting:
    """What is asked of the core, by the fields of mesh_bytes.cpp."""

    name: str
    flags: int = CROSSINGS | CLEAN | MEASURE
    share: int = 20
    """Of the faces, in 255ths."""
    weights: int = 0x11
    """Of features, and 16 times that of attributes."""
    error: int = 0
    """As exponent: 2^(error - 16) percent."""
    weld: int = 0
    descriptor: int = 0
    effort: int = 1
    boundary: int = 1
    seams: int = 0
    levels: int = 0
    textures: int = 0
    scalars: int = 0

    def choices(self) -> int:
        low = self.descriptor | self.effort << 2 | self.boundary << 4 | self.seams << 6
        return low | self.levels << 8 | self.textures << 10 | self.scalars << 12


def core_settings() -> list[CoreSetting]:
    every = CROSSINGS | CLEAN  # measuring takes ten times as long as the rest, so that only two do it
    return [
        CoreSetting("default", every | MEASURE, scalars=1),
        CoreSetting("fast_floats", every | SINGLE | EVERY_THREADS, share=10, effort=0),
        CoreSetting("best_to_one_face", every | EVERY_THREADS, share=0, effort=2, boundary=0),
        CoreSetting("topology_kept", every | TOPOLOGY | LONG_INDICES, share=5, boundary=0),
        CoreSetting("borders_locked", every, share=5, boundary=2, descriptor=1),
        CoreSetting("input_as_it_is", SINGLE, share=10, descriptor=2),
        CoreSetting("bound_of_1_percent", every, share=0, error=16),
        CoreSetting("bound_of_nothing", CLEAN, share=0, error=1, effort=0),
        CoreSetting("best_within_4_percent", EVERY_THREADS, share=0, error=18, effort=2),
        CoreSetting("welded_widely", every, weld=19),
        CoreSetting("welded_to_a_point", every, weld=23),
        CoreSetting("locked", every | FIXED, share=0, effort=2),
        CoreSetting("selected", CROSSINGS | SELECTED, share=0),
        CoreSetting("selected_and_cleaned", every | SELECTED | FIXED, share=0),
        CoreSetting("random_attributes", every | LABELS | EVERY_THREADS, textures=1, scalars=4),
        CoreSetting("seams_ignored", every | LABELS | MEASURE, seams=1, weights=0xF1, textures=2, effort=2),
        CoreSetting("levels", every, share=150, levels=3),
        CoreSetting("levels_as_they_are", 0, share=200, levels=2, effort=0, boundary=0),
    ]


def bytes_of(mesh: HostileMesh, setting: CoreSetting) -> bytes:
    """Locks, selections and attributes are random, where the setting has any."""
    flags = setting.flags | ANY_INDEX
    counts = len(mesh.vertices), len(mesh.faces)
    numbers = setting.share, setting.weights, setting.error, setting.weld
    head = struct.pack("<HBbHHBBBBH", flags, 0, 0, *counts, *numbers, setting.choices())
    faces = np.where((mesh.faces < 0) | (mesh.faces > 65535), 65535, mesh.faces).astype("<u2")
    return head + mesh.vertices.astype("<f8").tobytes() + faces.tobytes() + _random_rest(setting, *counts)


def _random_rest(setting: CoreSetting, vertices: int, faces: int) -> bytes:
    chance = np.random.default_rng(vertices + faces)
    rest = b""
    if setting.flags & FIXED:
        rest += (chance.random(vertices) < 0.2).tobytes()
    if setting.flags & SELECTED:
        rest += (chance.random(faces) < 0.6).tobytes()
    if setting.flags & LABELS:
        rest += (chance.random(faces) < 0.1).tobytes()
    if setting.descriptor == 3:
        rest += chance.random(vertices).astype("<f4").tobytes()
    channels = 2 * setting.textures + setting.scalars
    return rest + chance.random((faces, 3, channels)).astype("<f4").tobytes()


def write_seeds(folder: Path) -> None:
    """Those that a fuzzer is quick with, each with one setting."""
    for number, mesh in enumerate(corpus()):
        setting = core_settings()[number % len(core_settings())]
        content = bytes_of(mesh, setting)
        if len(content) < 4096:
            (folder / f"{mesh.name}_{setting.name}").write_bytes(content)


if __name__ == "__main__":
    write_seeds(Path(sys.argv[1]))
