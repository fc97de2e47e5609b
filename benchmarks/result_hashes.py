# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints a hash of every result of the default engine, so that two versions of the code can be compared.

    scripts/python benchmarks/result_hashes.py [MESH...] > before.txt
    scripts/python benchmarks/result_hashes.py [MESH...] --compare before.txt

Without meshes, the sample meshes. Positions are rounded to single precision, the precision of the engine's frame: a
formula that only rounds otherwise in double precision keeps its hash.
"""

import argparse
import hashlib
import sys
from pathlib import Path

import numpy as np
import pymeshlab

import laplacian_simplify as ls

SAMPLE_MESHES = Path(__file__).resolve().parents[1] / "sample_meshes"


def line(path: Path, percent: float, effort: str) -> str:
    mesh_set: pymeshlab.MeshSet = ls.read_mesh(path)
    ls.simplify(mesh_set, target_percent=percent, effort=effort, measure_error=False)
    mesh = mesh_set.current_mesh()
    content = mesh.vertex_matrix().astype(np.float32).tobytes() + mesh.face_matrix().astype(np.int32).tobytes()
    return f"{path.name} {percent:g} % {effort}: {mesh.face_number()} faces, {hashlib.sha256(content).hexdigest()[:16]}"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("meshes", nargs="*", type=Path)
    parser.add_argument("--compare", type=Path, metavar="FILE", help="print only what is not in this file")
    arguments = parser.parse_args()
    known = set(arguments.compare.read_text(encoding="utf-8").splitlines()) if arguments.compare else set()
    meshes = arguments.meshes or sorted(p for p in SAMPLE_MESHES.iterdir() if p.suffix in {".ply", ".obj", ".off"})
    changed = 0
    for path in meshes:
        for percent in (50, 10, 2):
            for effort in ("fast", "balanced"):
                text = line(path, percent, effort)
                if text not in known:
                    changed += 1
                    print(text, flush=True)
    if arguments.compare:
        print(f"{changed} results differ", file=sys.stderr)
    return int(bool(arguments.compare and changed))


if __name__ == "__main__":
    sys.exit(main())
