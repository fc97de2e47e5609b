# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Small meshes and the bytes of files that hold them, in every spelling that a format has."""

import io
import json
import struct
import zipfile
import zlib
from collections.abc import Sequence

import numpy as np

# A box of 2 x 4 x 6 around (1, 2, 3): eight vertices, six quads that look outwards.
BOX = np.array([[x, y, z] for x in (0, 2) for y in (0, 4) for z in (0, 6)], dtype=float)
QUADS = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
TRIANGLES = [[q[0], q[1], q[2]] for q in QUADS] + [[q[0], q[2], q[3]] for q in QUADS]
VOLUME = 48.0

PLY_TYPES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
    "float": "f4", "double": "f8",
}  # fmt: skip
ENCODINGS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}


def ply(
    points: Sequence[Sequence[float]] = tuple(map(tuple, BOX)),
    faces: Sequence[Sequence[int]] = QUADS,
    *,
    encoding: str = "binary_little_endian",
    count_type: str = "uchar",
    index_type: str = "int",
    coordinate_type: str = "double",
    end: str = "\n",
    comments: Sequence[str] = (),
) -> bytes:
    """A PLY file."""
    header = ["ply", f"format {encoding} 1.0", *(f"comment {text}" for text in comments)]
    header += [f"element vertex {len(points)}", *(f"property {coordinate_type} {axis}" for axis in "xyz")]
    header += [
        f"element face {len(faces)}",
        f"property list {count_type} {index_type} vertex_indices",
        "end_header",
        "",
    ]
    order = ENCODINGS[encoding]
    if not order:
        rows = [" ".join(f"{value:.17g}" for value in point) for point in points]
        rows += [" ".join(map(str, [len(face), *face])) for face in faces]
        return end.join([*header[:-1], *rows, ""]).encode()
    body = np.asarray(points, dtype=order + PLY_TYPES[coordinate_type]).tobytes()
    for face in faces:
        body += np.array([len(face)], order + PLY_TYPES[count_type]).tobytes()
        body += np.array(face, order + PLY_TYPES[index_type]).tobytes()
    return end.join(header).encode() + body


def obj(
    points: Sequence[Sequence[float]] = tuple(map(tuple, BOX)), faces: Sequence[Sequence[int]] = QUADS, before: str = ""
) -> str:
    """An OBJ file."""
    lines = [f"v {' '.join(f'{value:.9g}' for value in point)}" for point in points]
    lines += [f"f {' '.join(str(corner + 1) for corner in face)}" for face in faces]
    return before + "\n".join(lines) + "\n"


def off(points: Sequence[Sequence[float]] = tuple(map(tuple, BOX)), faces: Sequence[Sequence[int]] = QUADS) -> str:
    """An OFF file."""
    lines = [
        "OFF",
        f"{len(points)} {len(faces)} 0",
        *(" ".join(f"{value:.17g}" for value in point) for point in points),
    ]
    return "\n".join([*lines, *(" ".join(map(str, [len(face), *face])) for face in faces), ""])


def binary_stl(points: np.ndarray = BOX, faces: Sequence[Sequence[int]] = TRIANGLES) -> bytes:
    """A binary STL file."""
    corners = np.asarray(points)[np.asarray(faces)]
    facets = b"".join(struct.pack("<12fH", 0, 0, 0, *triangle.ravel(), 0) for triangle in corners)
    return struct.pack("<80sI", b"", len(corners)) + facets


def text_stl(points: np.ndarray = BOX, faces: Sequence[Sequence[int]] = TRIANGLES, end: str = "\n") -> str:
    """An STL file in text."""
    lines = ["solid box"]
    for triangle in np.asarray(points)[np.asarray(faces)]:
        lines += ["facet normal 0 0 0", " outer loop"]
        lines += [f"  vertex {' '.join(f'{value:.9g}' for value in corner)}" for corner in triangle]
        lines += [" endloop", "endfacet"]
    return end.join([*lines, "endsolid box", ""])


def gltf_document(nodes: list[dict], **more: object) -> tuple[dict, bytes]:
    """A glTF scene of the box, and its buffer."""
    positions = BOX.astype("<f4").tobytes()
    indices = np.array(TRIANGLES, "<u2").tobytes()
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": nodes,
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(BOX), "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 3 * len(TRIANGLES), "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": len(positions)},
            {"buffer": 0, "byteOffset": len(positions), "byteLength": len(indices)},
        ],
        "buffers": [{"byteLength": len(positions) + len(indices)}],
    }
    return document | more, positions + indices


def glb(document: dict, buffer: bytes) -> bytes:
    """A .glb file."""
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    buffer += b"\0" * (-len(buffer) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(buffer), b"BIN\0") + buffer
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


MESH_3MF = (
    "<mesh><vertices>"
    + "".join(f'<vertex x="{x:g}" y="{y:g}" z="{z:g}"/>' for x, y, z in BOX)
    + "</vertices><triangles>"
    + "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in TRIANGLES)
    + "</triangles></mesh>"
)
_3MF_NAMESPACES = (
    'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" '
    'xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06"'
)


def threemf(
    objects: str = f'<object id="1" type="model">{MESH_3MF}</object>', items: str = '<item objectid="1"/>', **parts: str
) -> bytes:
    """A 3MF package; parts: further models by their names, with / as __."""
    package = io.BytesIO()
    with zipfile.ZipFile(package, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("3D/3dmodel.model", model_3mf(objects, items))
        for name, text in parts.items():
            archive.writestr(name.replace("__", "/"), text)
    return package.getvalue()


def model_3mf(objects: str, items: str = "") -> str:
    return (
        f'<?xml version="1.0"?><model unit="millimeter" {_3MF_NAMESPACES}>'
        f"<resources>{objects}</resources><build>{items}</build></model>"
    )


def png() -> bytes:
    """One red pixel."""
    chunks = [
        (b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)),
        (b"IDAT", zlib.compress(b"\0\xff\0\0")),
        (b"IEND", b""),
    ]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)) for kind, data in chunks
    )


PNG = png()
