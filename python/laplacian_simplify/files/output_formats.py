# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which formats can be written, what each keeps of a mesh, and with how many digits."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from .errors import MeshFileError, printable

if TYPE_CHECKING:
    import pymeshlab

_COLORS = ("vertex colors", "face colors")
_UV = ("texture coordinates",)
_TEXTURED = ("texture coordinates", "textures")

_DOUBLE, _SINGLE, _SIX_DIGITS = 2.0**-53, 2.0**-24, 0.5e-5
"""Largest relative error of a coordinate that is written."""


@dataclass(frozen=True)
class OutputFormat:
    """A row of the table."""

    extension: str
    keeps: tuple[str, ...]
    """Attributes, besides positions and triangles."""
    relative_error: float
    absolute_error: float = 0
    in_own_process: bool = True
    """MeshLab's writer may end the process that calls it, or has to be watched."""


OUTPUT_FORMATS = (
    OutputFormat("ply", (*_COLORS, "vertex quality", "face quality", *_TEXTURED), _DOUBLE, in_own_process=False),
    OutputFormat("obj", (*_COLORS, *_TEXTURED, "polygons"), _DOUBLE, 0.5e-16, in_own_process=False),
    OutputFormat("off", (*_COLORS, "polygons"), 0.5e-15, in_own_process=False),
    OutputFormat("stl", ("face colors",), _SINGLE, in_own_process=False),
    OutputFormat("3ds", ("face colors", *_UV), _SINGLE),
    OutputFormat("3mf", (), _SINGLE),
    OutputFormat("ctm", ("vertex colors", "vertex quality"), _SINGLE),
    OutputFormat("dae", ("vertex colors", *_TEXTURED), _SIX_DIGITS),
    OutputFormat("dxf", (), _SIX_DIGITS),
    OutputFormat("idtf", _UV, _SIX_DIGITS),
    OutputFormat("json", ("vertex colors",), _SIX_DIGITS),
    OutputFormat("nxs", ("vertex colors", *_UV), _SINGLE),
    OutputFormat("nxz", ("vertex colors", *_UV), _SINGLE),
    OutputFormat("wrl", ("vertex colors", *_UV), _SIX_DIGITS),
    OutputFormat("x3d", _COLORS, _SIX_DIGITS),
)


def output_format(path: str | Path) -> OutputFormat:
    """The row for a file to be written.

    Raises:
        MeshFileError: no row has its extension.
    """
    suffix = Path(path).suffix.lower()
    for row in OUTPUT_FORMATS:
        if suffix == "." + row.extension:
            return row
    known = ", ".join(row.extension for row in OUTPUT_FORMATS)
    what = f"the format '{printable(suffix)}' is unknown" if suffix else "its name has no extension"
    raise MeshFileError(f"{printable(path)} cannot be written: {what}; known are {known}")


def lost(row: OutputFormat, mesh: "pymeshlab.Mesh") -> list[str]:
    """What a mesh has and the format does not keep."""
    has = {
        "vertex colors": mesh.has_vertex_color(),
        "face colors": mesh.has_face_color(),
        "vertex quality": mesh.has_vertex_scalar(),
        "texture coordinates": mesh.has_wedge_tex_coord() or mesh.has_vertex_tex_coord(),
        "textures": mesh.texture_number() > 0,
    }
    return [name for name, there in has.items() if there and name not in row.keeps]
