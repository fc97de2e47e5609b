# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Images that meshes refer to: found, named so that MeshLab keeps the name, and given their own name again.

MeshLab's PLY reader leaves blanks out of names and its OBJ reader drops such a texture. Between reading and writing
a texture therefore has its name in percent encoding, which is the name itself where that is plain.
"""

import os
import re
import stat
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from .errors import printable
from .mesh_data import MeshData, Texture

_SIGNATURES = {
    ".bmp": (b"BM",),
    ".jpg": (b"\xff\xd8\xff",),
    ".jpeg": (b"\xff\xd8\xff",),
    ".png": (b"\x89PNG\r\n\x1a\n",),
    ".tif": (b"II*\0", b"MM\0*"),
    ".tiff": (b"II*\0", b"MM\0*"),
    ".tga": (b"",),
    ".xbm": (b"",),
    ".xpm": (b"",),
}
"""What MeshLab loads, and how such a file starts."""


def encoded(name: str) -> str:
    """The name that a texture has between reading and writing."""
    raw = name.encode("utf-8", "surrogateescape")
    return re.sub(rb"[^A-Za-z0-9_.\-]", lambda found: b"%%%02X" % found[0][0], raw).decode("ascii")


def decoded(name: str) -> str:
    """The name that a texture had before ``encoded``."""
    raw = re.sub(rb"%([0-9A-F]{2})", lambda found: bytes([int(found[1], 16)]), name.encode("utf-8", "surrogateescape"))
    return raw.decode("utf-8", "surrogateescape")


def is_inside(name: str) -> bool:
    """Whether a relative name stays in the folder that it is relative to."""
    return not name.startswith("/") and ".." not in name.split("/") and not re.match(r"[A-Za-z]:", name)


def use_textures(data: MeshData, names: Sequence[str], folder: Path) -> None:
    """Sets the textures of a mesh to those that are there, looked for beside its file; the others are noted.

    Faces with a texture that is not there keep their texture coordinates.
    """
    new_index = np.full(max(len(names), 1), -1, dtype=np.int64)
    for index, name in enumerate(names):
        image, reason = find_image(name, folder)
        if image is None:
            data.notes.append(f"texture '{printable(name)}' {reason}; the result has none in its place")
            continue
        new_index[index] = len(data.textures)
        data.textures.append(Texture(_kept_name(name, data.textures), image))
    if data.texture_of_face is not None:
        known = (data.texture_of_face >= 0) & (data.texture_of_face < len(names))
        data.texture_of_face = np.where(known, new_index[np.where(known, data.texture_of_face, 0)], -1)


def find_image(name: str, folder: Path) -> tuple[Path | None, str]:
    """The image, or what keeps it from being used."""
    wanted = name.replace("\\", "/")
    for path in (folder / wanted, folder / wanted.rsplit("/", 1)[-1]):
        try:
            if not stat.S_ISREG(path.stat().st_mode):
                continue
            with path.open("rb") as file:
                start = file.read(8)
        except (OSError, ValueError):
            continue
        if not any(start.startswith(signature) for signature in _SIGNATURES.get(path.suffix.lower(), ())):
            return None, "is no image that MeshLab reads (BMP, JPEG, PNG, TGA, TIFF, XBM or XPM)"
        return Path(os.path.realpath(path)), ""
    return None, "does not exist"


def _kept_name(name: str, others: Sequence[Texture]) -> str:
    """The name for the output: relative to it, and not that of another texture."""
    kept = name.replace("\\", "/")
    while kept.startswith("./"):
        kept = kept[2:]
    if not is_inside(kept):
        kept = kept.rsplit("/", 1)[-1]
    taken = {texture.name for texture in others}
    unique, number = kept, 1
    while unique in taken:
        number += 1
        unique = f"{number}_{kept}"
    return unique
