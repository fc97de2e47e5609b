# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Images that meshes refer to."""

import os
import stat
from collections.abc import Collection, Sequence
from pathlib import Path

import numpy as np

from .errors import printable
from .mesh_data import MeshData, Texture
from .texture_names import encoded, is_inside

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


def use_textures(data: MeshData, names: Sequence[str], folder: Path) -> None:
    """Sets the textures of a mesh to those that are there, looked for beside its file; the others are noted.

    Faces with a texture that is not there keep their texture coordinates.
    """
    data.textures = []
    new_index = []
    for name in names:
        image, reason = find_image(name, folder)
        new_index.append(len(data.textures) if image else -1)
        if image:
            data.textures.append(Texture(_kept_name(name, data.textures), image))
        else:
            _note_missing(data, name, reason)
    _renumber(data, new_index)


def leave_out_damaged(data: MeshData, loaded: Collection[str]) -> bool:
    """Leaves out the textures that MeshLab could not load, by their names at that time; returns whether any was."""
    kept = [texture for texture in data.textures if encoded(texture.name) in loaded]
    if len(kept) == len(data.textures):
        return False
    for texture in data.textures:
        if texture not in kept:
            _note_missing(data, texture.name, "is damaged")
    _renumber(data, [kept.index(texture) if texture in kept else -1 for texture in data.textures])
    data.textures = kept
    return True


def _note_missing(data: MeshData, name: str, reason: str) -> None:
    data.notes.append(f"texture '{printable(name)}' {reason}; the result has none in its place")


def _renumber(data: MeshData, new_index: Sequence[int]) -> None:
    """Gives every face the new number of its texture, -1 for none."""
    if data.texture_of_face is None:
        return
    known = (data.texture_of_face >= 0) & (data.texture_of_face < len(new_index))
    table = np.array([*new_index, -1], dtype=np.int64)
    data.texture_of_face = table[np.where(known, data.texture_of_face, len(new_index))]


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
