# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes that are large for a test, as arrays and as the files that huge reads."""

from pathlib import Path
from typing import Any

import numpy as np


def torus(around: int, across: int) -> tuple[np.ndarray, np.ndarray]:
    """A closed torus with relief, of 2 * around * across faces, in single precision."""
    u, v = np.meshgrid(np.arange(around) * 2 * np.pi / around, np.arange(across) * 2 * np.pi / across, indexing="ij")
    radius = 0.4 + sum(0.05 / k * np.sin(k * 3 * u + k) * np.sin(k * 2 * v + 2 * k) for k in range(1, 6))
    ring = 1 + radius * np.cos(v)
    points = np.stack([ring * np.cos(u), ring * np.sin(u), radius * np.sin(v)], axis=-1).reshape(-1, 3)
    index = np.arange(around * across).reshape(around, across)
    right, below = np.roll(index, -1, axis=0), np.roll(index, -1, axis=1)
    corner = np.roll(right, -1, axis=1)
    faces = np.concatenate([np.stack([index, right, corner], axis=-1), np.stack([index, corner, below], axis=-1)])
    # As scanners write them: neighbors in space are neighbors in the file.
    return points.astype(np.float32), faces.reshape(2, -1, 3).transpose(1, 0, 2).reshape(-1, 3).astype(np.int32)


COLORS = ("red", "green", "blue", "alpha")


def painted(vertices: np.ndarray) -> np.ndarray:
    """Colors that are smooth in one place and change quickly in another, (n, 3) of bytes."""
    x, y, z = vertices.astype(np.float64).T
    waves = [np.sin(3 * x + z), np.sin(9 * y - 2 * x), np.sign(np.sin(5 * x * y))]
    return np.rint(127 + 120 * np.stack(waves, axis=1)).astype(np.uint8)


def write_ply(
    path: Path, vertices: Any, faces: Any, *, order: str = "<", extras: bool = False, colors: Any = None
) -> None:
    """Binary PLY; extras are properties before, between and behind those of the mesh."""
    kind = "f8" if vertices.dtype == np.float64 else "f4"
    columns = [(axis, order + kind) for axis in "xyz"]
    if colors is not None:
        columns += [(name, order + colors.dtype.str[1:]) for name in COLORS[: colors.shape[1]]]
    face = [("count", "u1"), ("corners", order + "i4", 3)]
    if extras:
        columns = [("id", order + "i2"), *columns[:2], ("quality", order + "f8"), columns[2], ("red", "u1")]
        face = [("flags", order + "u4"), *face, ("count of uv", "u1"), ("uv", order + "f4", 6)]
    rows, corners = np.zeros(len(vertices), columns), np.zeros(len(faces), face)
    for k, axis in enumerate("xyz"):
        rows[axis] = vertices[:, k]
    for k in range(0 if colors is None else colors.shape[1]):
        rows[COLORS[k]] = colors[:, k]
    corners["count"], corners["corners"] = 3, faces
    names = {"f4": "float", "f8": "double", "i2": "short", "u1": "uchar", "u2": "ushort"}
    lines = ["ply", f"format binary_{'little' if order == '<' else 'big'}_endian 1.0"]
    lines += [f"element vertex {len(rows)}"]
    lines += [f"property {names[np.dtype(row[1]).str[1:]]} {row[0]}" for row in columns]
    lines += [f"element face {len(corners)}", *(["property uint flags"] if extras else [])]
    lines += ["property list uchar int vertex_indices"]
    if extras:
        corners["count of uv"] = 6
        lines += ["property list uchar float uv"]
    path.write_bytes("\n".join([*lines, "end_header\n"]).encode() + rows.tobytes() + corners.tobytes())


def write_stl(path: Path, vertices: Any, faces: Any) -> None:
    rows = np.zeros(len(faces), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    rows["corners"] = vertices[faces]
    path.write_bytes(bytes(80) + np.uint32(len(faces)).tobytes() + rows.tobytes())


def read_ply(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of what huge writes."""
    return read_painted(path)[:2]


def read_painted(path: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """And its colors, (n, 0) where there are none."""
    header, _, body = path.read_bytes().partition(b"end_header\n")
    counts = [int(line.split()[2]) for line in header.decode().splitlines() if line.startswith("element")]
    kind = "<f8" if b"double x" in header else "<f4"
    parts = sum(f"uchar {name}\n".encode() in header for name in COLORS)
    vertices = np.frombuffer(body, [("place", kind, 3), ("color", "u1", parts)], counts[0])
    rows = np.frombuffer(body, [("count", "u1"), ("corners", "<i4", 3)], counts[1], vertices.nbytes)
    assert vertices.nbytes + rows.nbytes == len(body)
    assert (rows["count"] == 3).all()
    return vertices["place"], rows["corners"], vertices["color"]
