# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writers whose bytes depend on nothing but the mesh: binary PLY, OBJ with a texture, PNG."""

import struct
import zlib
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

# Coordinates are rounded to this many decimals before they are written, so that the last bit of
# a sine, which may differ from one processor to another, never reaches a file.
DECIMALS = 5


@dataclass
class Mesh:
    """Positions (n, 3) and faces (m, corners), all with as many corners; colors (n, 3) or (m, 3) of bytes."""

    positions: np.ndarray
    faces: np.ndarray
    vertex_colors: np.ndarray | None = field(default=None, kw_only=True)
    face_colors: np.ndarray | None = field(default=None, kw_only=True)


@dataclass
class TexturedMesh(Mesh):
    """Texture coordinates, normals and for every corner of a face the index of its own; the number of the material of
    every face, ascending."""

    texture_coordinates: np.ndarray = field(default_factory=lambda: np.zeros((0, 2)))
    texture_faces: np.ndarray = field(default_factory=lambda: np.zeros((0, 3), int))
    normals: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    materials: np.ndarray | None = None


def rounded(values: np.ndarray) -> np.ndarray:
    """Values with DECIMALS decimals; adding zero turns -0 into 0."""
    return np.round(values, DECIMALS) + 0.0


def write_ply(path: Path, mesh: Mesh, comment: str) -> None:
    """Binary little-endian PLY with float coordinates and colors."""
    colors = "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"comment {comment}\n"
        f"element vertex {len(mesh.positions)}\n"
        f"property float x\nproperty float y\nproperty float z\n{'' if mesh.vertex_colors is None else colors}"
        f"element face {len(mesh.faces)}\n"
        f"property list uchar int vertex_indices\n{'' if mesh.face_colors is None else colors}end_header\n"
    )
    corners = mesh.faces.shape[1]
    counts = np.full((len(mesh.faces), 1), corners, "u1")
    vertices = _rows(rounded(mesh.positions).astype("<f4"), mesh.vertex_colors)
    faces = _rows(counts, mesh.faces.astype("<i4"), mesh.face_colors)
    path.write_bytes(header.encode("ascii") + vertices + faces)


def _rows(*columns: np.ndarray | None) -> bytes:
    """Arrays beside each other, row by row; those that are no numbers of four bytes become bytes."""
    wide = [c if c.dtype.itemsize == 4 else c.astype("u1") for c in columns if c is not None]
    return np.concatenate([np.ascontiguousarray(c).view("u1").reshape(len(c), -1) for c in wide], axis=1).tobytes()


def write_obj(path: Path, mesh: TexturedMesh, materials: dict[str, tuple[Path, np.ndarray]]) -> None:
    """OBJ, its MTL and the PNG of every material, whose names are given with their textures."""
    material_path = path.with_suffix(".mtl")
    lines = [f"mtllib {material_path.name}"]
    lines += ["v {:.5f} {:.5f} {:.5f}".format(*p) for p in rounded(mesh.positions)]
    lines += ["vt {:.5f} {:.5f}".format(*t) for t in rounded(mesh.texture_coordinates)]
    lines += ["vn {:.5f} {:.5f} {:.5f}".format(*n) for n in rounded(mesh.normals)]
    names = list(materials)
    of_faces = np.zeros(len(mesh.faces), int) if mesh.materials is None else mesh.materials
    last = -1
    for corners, texture_corners, material in zip(mesh.faces + 1, mesh.texture_faces + 1, of_faces, strict=True):
        if material != last:
            lines.append(f"usemtl {names[material]}")
            last = material
        triples = zip(corners, texture_corners, corners, strict=True)
        lines.append("f " + " ".join(f"{v}/{t}/{n}" for v, t, n in triples))
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
    material_path.write_text(
        "".join(
            f"newmtl {name}\nKa 1 1 1\nKd 1 1 1\nillum 1\nmap_Kd {texture_path.name}\n"
            for name, (texture_path, _) in materials.items()
        ),
        encoding="ascii",
    )
    for texture_path, texture in materials.values():
        write_png(texture_path, texture)


def write_png(path: Path, pixels: np.ndarray) -> None:
    """8-bit RGB, rows from top to bottom; stored uncompressed, because compressors differ in their bytes."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    height, width, _ = pixels.shape
    rows = b"".join(b"\x00" + row.astype(np.uint8).tobytes() for row in pixels)
    path.write_bytes(
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
        + chunk(b"IDAT", zlib.compress(rows, 0))
        + chunk(b"IEND", b"")
    )
