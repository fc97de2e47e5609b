# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of textures, made so that MeshLab keeps them, and made their own again.

MeshLab's PLY reader leaves blanks out of names and its OBJ reader drops such a texture. Between reading and writing
a texture therefore has its name in percent encoding, which is the name itself where that is plain.
"""

import re


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
