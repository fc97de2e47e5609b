# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Folders of meshes, the command batch as users run it, and what its results are."""

import json
import os
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from conftest import SAMPLE_MESHES

COMMAND = [sys.executable, "-P", "-m", "laplacian_simplify", "batch"]
HOOKS = Path(__file__).parent / "batch_hooks"
FAST = ("--percent", "25", "--effort", "fast", "--no-measure-error")


def write_sheet(path: Path, side: int) -> None:
    """A wavy sheet of 2 side^2 faces, as text."""
    x, y = np.meshgrid(np.arange(side + 1), np.arange(side + 1))
    points = np.stack([x, y, np.sin(0.7 * x) * np.cos(0.9 * y)], axis=-1).reshape(-1, 3)
    index = np.arange((side + 1) ** 2).reshape(side + 1, side + 1)
    a, b, c, d = (part.ravel() for part in (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]))
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w") as file:
        file.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        np.savetxt(file, points, "%.6f")
        np.savetxt(file, np.insert(faces, 0, 3, axis=1), "%d")


def fill(folder: Path) -> None:
    """Nine meshes and three that are broken, in three folders."""
    for k in range(7):
        write_sheet(folder / ("a", "b/c")[k % 2] / f"sheet_{k}.off", 8 + k)
    for name in ("painted_box.obj", "painted_box.mtl", "painted_box.png", "bracket_quads.ply"):
        shutil.copy(SAMPLE_MESHES / name, folder)
    (folder / "garbage.ply").write_text("garbage\n")
    (folder / "a" / "cut.stl").write_bytes(bytes(80) + b"\x09\0\0\0" + bytes(60))
    (folder / "wrong_index.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")
    (folder / "notes.txt").write_text("no mesh")


def manifest_rows(output: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in (output / "laplacian-simplify.jsonl").read_text().splitlines()]


def files_in(folder: Path) -> dict[str, bytes]:
    """Results and what lies beside them."""
    paths = [path for path in folder.rglob("*") if path.is_file() and path.suffix != ".jsonl"]
    return {str(path.relative_to(folder)): path.read_bytes() for path in paths}


def run_batch(*arguments: object, hooks: bool = False) -> "subprocess.CompletedProcess[str]":
    words = [*COMMAND, *map(str, arguments)]
    environment = with_hooks() if hooks else None
    return subprocess.run(words, env=environment, capture_output=True, text=True, timeout=300, check=False)


def with_hooks() -> dict[str, str]:
    paths = os.pathsep.join([str(HOOKS), *filter(None, [os.environ.get("PYTHONPATH")])])
    return {**os.environ, "PYTHONPATH": paths}


def wait_until(condition: Callable[[], object]) -> Any:
    deadline = time.monotonic() + 60
    while not (found := condition()):
        assert time.monotonic() < deadline, "it did not happen within a minute"
        time.sleep(0.01)
    return found


def is_alive(process: int) -> bool:
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False
