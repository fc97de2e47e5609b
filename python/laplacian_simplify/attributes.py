# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What arrays carry beside vertices and faces, as the numbers at the corners of faces that the C function takes.

A value of a vertex is at all corners that the vertex has. Vertices at the same place, as a texture that is stored at
vertices makes them along its seams, are welded for the run; afterwards one that has several values is split again.
Normals are not interpolated: where those at one place are apart, an edge is hard and a seam, and those of the result
are computed from its faces, on each side of such edges.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal, TypeAlias

import numpy as np

from .small import Small

Array: TypeAlias = np.ndarray[Any, Any]
Kind: TypeAlias = Literal["texture", "color", "scalar", "normal", "origin"]

KINDS = ("texture", "color", "scalar", "normal", "origin")
"""Texture coordinates, colors and numbers are interpolated, normals computed anew; of others the value of what remains
is taken."""
_NUMBERS: dict[Kind, int] = {"texture": 0, "color": 1, "scalar": 2}
_TEXTURE_NAMES = ("uv", "texcoord", "tex_coord", "texture", "tcoord", "vt")
_COLOR_NAMES = ("color", "colour", "rgb")
_NORMAL_NAMES = {"normals", "normal", "pointnormals", "cellnormals", "vertexnormals", "cornernormals"}


@dataclass(frozen=True, eq=False)
class Attributes:
    """Named arrays at the vertices and corners of a mesh, and a number at each face."""

    vertex: Mapping[str, Array] = field(default_factory=dict)
    """(n,) or (n, k)."""
    corner: Mapping[str, Array] = field(default_factory=dict)
    """(m, 3) or (m, 3, k): at the first, second and third corner of every face."""
    labels: Array | None = None
    """(m,), integers: materials, parts."""
    kinds: Mapping[str, Kind] = field(default_factory=dict)
    """Of names whose arrays do not tell."""

    def kind(self, name: str, values: Array) -> Kind:
        """What an array holds: said by the caller, or told by name, type and shape."""
        return self.kinds.get(name) or kind_of(name, values, values.shape[-1] if self._has_columns(name, values) else 1)

    def _has_columns(self, name: str, values: Array) -> bool:
        return values.ndim > (2 if name in self.corner else 1)


def kind_of(name: str, values: Array, columns: int) -> Kind:
    """What an array of so many columns holds: colors are bytes, or have a name that says so; numbers that are whole
    name something, and are no quantities."""
    plain = name.lower()
    is_float = values.dtype.kind == "f"
    if columns in (3, 4) and (values.dtype == np.uint8 or (is_float and _sounds(plain, _COLOR_NAMES))):
        return "color"
    if not is_float:
        return "origin"
    if columns == 3 and is_normal(name):
        return "normal"
    return "texture" if columns == 2 and _sounds(plain, _TEXTURE_NAMES) else "scalar"


def is_normal(name: str) -> bool:
    """Whether it names normals."""
    return name.lower().replace("_", "") in _NORMAL_NAMES


def _sounds(name: str, words: tuple[str, ...]) -> bool:
    return any(word in name for word in words)


@dataclass(frozen=True, eq=False)
class _Column:
    """One array, and where its numbers are among the channels: value = channel * scale + shift."""

    name: str
    values: Array
    at_corners: bool
    first: int
    count: int
    kind: Kind
    scale: float
    shift: Array

    def numbers(self, values: Array) -> Array:
        """The channels of values, (..., count)."""
        columns = values.reshape(*values.shape[: 2 if self.at_corners else 1], self.count)
        return ((columns.astype(np.float64) - self.shift) / self.scale).astype(np.float32)

    def restored(self, channels: Array, stayed: Array) -> Array:
        """The values of channels, of the type that the input has. Those that did not change keep their bits.

        Args:
            channels: (..., count).
            stayed: the input's values of what has become the vertices or corners.
        """
        numbers = channels * np.float64(self.scale) + self.shift
        dtype = self.values.dtype
        if dtype.kind != "f":
            numbers = np.clip(np.rint(numbers), np.iinfo(dtype).min, np.iinfo(dtype).max)
        changed = (channels != self.numbers(stayed)).reshape(stayed.shape)
        restored: Array = np.where(changed, numbers.reshape(stayed.shape).astype(dtype), stayed)
        return restored.astype(dtype, copy=False)  # of the byte order that the input has


class Channels:
    """The arrays of a mesh that are interpolated, as channels at corners."""

    def __init__(self, attributes: Attributes, vertices: int, faces: int) -> None:
        """Checks the arrays.

        Raises:
            TypeError: something is of another type.
            ValueError: something has another shape or is not finite; the text names it.
        """
        self.attributes = attributes
        self._counts = vertices, faces
        self.kinds: list[int] = []
        self._columns: list[_Column] = []
        self._normals: dict[str, bool] = {}  # whether they are at corners
        _check_kinds(attributes)
        for name, values in attributes.vertex.items():
            self._add(f"vertex_attributes[{name!r}]", name, values, False)
        for name, values in attributes.corner.items():
            self._add(f"corner_attributes[{name!r}]", name, values, True)
        self.labels = None if attributes.labels is None else _checked_labels(attributes.labels, faces)

    @property
    def are_there(self) -> bool:
        """Whether there is anything that can guide."""
        return bool(self._columns) or bool(self._normals) or self.labels is not None

    @property
    def has_texture(self) -> bool:
        """Whether there are texture coordinates."""
        return _NUMBERS["texture"] in self.kinds

    def _add(self, shown: str, name: str, values: Any, at_corners: bool) -> None:
        vertices, faces = self._counts
        shape = (faces, 3) if at_corners else (vertices,)
        if isinstance(values, np.ma.MaskedArray) or not isinstance(values, np.ndarray):
            raise TypeError(f"{shown} must be a NumPy array, not {type(values).__name__}")
        expected = ", ".join(map(str, shape))
        if values.shape[: len(shape)] != shape:
            raise ValueError(f"{shown} has the shape {values.shape}, not ({expected}) or ({expected}, k)")
        kind = self.attributes.kind(name, values)
        if kind == "origin" or values.size == 0:
            return
        if values.ndim > len(shape) + 1:
            raise ValueError(f"{shown} has the shape {values.shape}, not ({expected}) or ({expected}, k)")
        count = int(values.shape[-1]) if values.ndim > len(shape) else 1
        _check_kind(shown, values, kind, count)
        if kind == "normal":
            self._normals[name] = at_corners
            return
        scale, shift = _scaled(values, kind, count)
        column = _Column(name, values, at_corners, len(self.kinds), count, kind, scale, shift)
        with np.errstate(over="ignore", invalid="ignore"):
            finite = np.isfinite(column.numbers(values)).reshape(*shape, count).all(axis=-1)
        if not finite.all():
            raise ValueError(f"{shown} is not finite, or too large, at {(~finite).sum():,} of {finite.size:,} places")
        self._columns.append(column)
        self.kinds += count * [_NUMBERS[kind]]

    def at_corners(self, faces: Array) -> Array | None:
        """The channels, (m, 3, k) of float32; None where there are none."""
        if not self._columns:
            return None
        channels = np.empty((len(faces), 3, len(self.kinds)), np.float32)
        for column in self._columns:
            part = channels[:, :, column.first : column.first + column.count]
            numbers = column.numbers(column.values)
            part[...] = numbers if column.at_corners else numbers[faces]
        return channels

    def normals(self) -> tuple[Array | None, Array | None]:
        """Normals of vertices, (n, 3), and of corners, (m, 3, 3), of float32: the first that there are."""
        found: dict[bool, Array] = {}
        for name, at_corners in self._normals.items():
            values = (self.attributes.corner if at_corners else self.attributes.vertex)[name]
            found.setdefault(at_corners, np.ascontiguousarray(values, np.float32))
        return found.get(False), found.get(True)

    def split(
        self, faces: Array, channels: Array | None, count: int, sides: Array | None = None
    ) -> tuple[Array, Array]:
        """One vertex for each tuple of values that the arrays at vertices have at a vertex, and for each side of a hard
        edge where normals of vertices made it.

        Args:
            faces: (m, 3).
            channels: (m, 3, k), what became of at_corners; None where there are none.
            count: of vertices.
            sides: (m, 3), where there are hard edges.

        Returns:
            The old vertex of each new one, ascending, and the faces with the new ones.
        """
        places = [k for c in self._columns if not c.at_corners for k in range(c.first, c.first + c.count)]
        corners = faces.ravel()
        parts = []
        if channels is not None:
            values = channels[:, :, places] + np.float32(0)  # which makes a plain zero of a negative one
            parts.append(values.reshape(len(corners), len(places)).view(np.uint32))
        if sides is not None and False in self._normals.values():
            parts.append(sides.reshape(-1, 1))
        if not parts:
            return np.arange(count), faces
        bits = np.concatenate(parts, axis=1)
        representative = np.zeros(count, np.intp)
        representative[corners[::-1]] = np.arange(len(corners))[::-1]  # the first corner of each
        other = (bits != bits[representative[corners]]).any(axis=1)
        if not other.any():
            return np.arange(count), faces
        keys = np.column_stack([corners[other], bits[other]])
        rows, inverse = np.unique(keys, axis=0, return_inverse=True)
        origin = np.concatenate([np.arange(count), rows[:, 0].astype(np.intp)])
        order = np.argsort(origin, kind="stable")
        place = np.empty_like(order)
        place[order] = np.arange(len(order))
        split = corners.astype(np.intp)
        split[other] = count + inverse.ravel()
        return origin[order], place[split].reshape(faces.shape).astype(faces.dtype)

    def results(
        self, channels: Array | None, vertex_origin: Array, face_origin: Array, small: Small | None = None
    ) -> dict[str, Any]:
        """What the arrays at vertices and at corners and the labels have become, under the names of Simplified.

        Args:
            channels: (m, 3, k) of the result; None where all have kept their values.
            vertex_origin: the input's vertex of each.
            face_origin: the input's face of each.
            small: the result after its split; None where it is the input.
        """
        given = self.attributes
        vertex = {name: values[vertex_origin] for name, values in given.vertex.items()}
        corner = {name: values[face_origin] for name, values in given.corner.items()}
        for column in self._columns:
            if channels is None or small is None:
                break
            part = channels[:, :, column.first : column.first + column.count]
            if column.at_corners:
                corner[column.name] = column.restored(part, corner[column.name])
                continue
            numbers = column.numbers(vertex[column.name])  # vertices without faces keep theirs
            numbers[small.faces.ravel()] = part.reshape(-1, column.count)
            vertex[column.name] = column.restored(numbers, vertex[column.name])
        if small is not None and self._normals:
            self._compute_normals(small.corner_normals(vertex_origin), small.faces, vertex, corner)
        labels = None if given.labels is None else given.labels[face_origin]
        return {"vertex_attributes": vertex, "corner_attributes": corner, "face_labels": labels}

    def _compute_normals(
        self, normals: Array, faces: Array, vertex: dict[str, Array], corner: dict[str, Array]
    ) -> None:
        found = (normals != 0).any(-1)  # what has no area keeps its own, and so do vertices without faces
        for name, at_corners in self._normals.items():
            if at_corners:
                corner[name] = np.where(found[..., None], normals.astype(corner[name].dtype), corner[name])
            else:
                vertex[name] = np.array(vertex[name])
                vertex[name][faces[found]] = normals[found]

    def unused(self) -> "Channels":
        """The same arrays, whose values are those of what remains; only normals are computed anew."""
        names = [*self.attributes.vertex, *self.attributes.corner]
        vertices, faces = self._counts
        kinds: dict[str, Kind] = {name: "normal" if name in self._normals else "origin" for name in names}
        unused = Channels(replace(self.attributes, kinds=kinds), vertices, faces)
        unused.labels = None
        return unused

    def rms(self, of_channels: list[float]) -> dict[str, float]:
        """The root mean square difference of each array, in its own unit: the length of a vector, and
        of colors the mean over their parts, in 0 to 255."""
        found = {}
        for column in self._columns:
            squares = np.array(of_channels[column.first : column.first + column.count]) ** 2
            is_color = column.kind == "color"
            found[column.name] = float(255 * np.sqrt(squares.mean()) if is_color else np.sqrt(squares.sum()))
        return found


def _check_kinds(attributes: Attributes) -> None:
    if both := attributes.vertex.keys() & attributes.corner.keys():
        raise ValueError(f"{min(both)!r} is a name both of vertex_attributes and of corner_attributes")
    for name, kind in attributes.kinds.items():
        if kind not in KINDS:
            raise ValueError(f"attribute_kinds[{name!r}] = {kind!r} is not one of {', '.join(KINDS)}")
        if name not in attributes.vertex and name not in attributes.corner:
            raise ValueError(f"attribute_kinds names {name!r}, which is no attribute")


def _check_kind(shown: str, values: Array, kind: Kind, count: int) -> None:
    fits = values.dtype.kind == "f" if kind in ("texture", "normal") else values.dtype.kind in "fiu"
    if kind == "color" and values.dtype.kind != "f":
        fits = values.dtype in (np.uint8, np.uint16)
    if not fits:
        wanted = {"texture": "floats", "color": "floats, uint8 or uint16", "scalar": "numbers", "normal": "floats"}[
            kind
        ]
        raise TypeError(f"{shown} must be an array of {wanted}, not of {values.dtype}")
    if kind == "texture" and count != 2:
        raise ValueError(f"{shown} must have two columns, u and v, not {count}")
    if kind == "normal" and count != 3:
        raise ValueError(f"{shown} must have three columns, not {count}")


def _scaled(values: Array, kind: Kind, count: int) -> tuple[float, Array]:
    """What makes channels of values. Numbers that are far from 0 would lose digits: their middle becomes 0."""
    shift = np.zeros(count)
    if kind == "color" and values.dtype.kind != "f":
        return float(np.iinfo(values.dtype).max), shift
    if kind == "color":
        return 1.0 if values.size == 0 or np.nanmax(values) <= 1 else 255.0, shift
    if kind == "scalar" and values.size:
        columns = values.reshape(-1, count)
        low, high = columns.min(axis=0).astype(np.float64), columns.max(axis=0).astype(np.float64)
        with np.errstate(over="ignore", invalid="ignore"):
            middle = low / 2 + high / 2
        shift = np.where(np.isfinite(middle), middle, 0)
    return 1.0, shift


def _checked_labels(labels: Any, faces: int) -> Array:
    if isinstance(labels, np.ma.MaskedArray) or not isinstance(labels, np.ndarray):
        raise TypeError(f"face_labels must be a NumPy array of integers, not {type(labels).__name__}")
    if labels.dtype.kind not in "iub":
        raise TypeError(f"face_labels must be an array of integers, not of {labels.dtype}")
    if labels.shape != (faces,):
        raise ValueError(f"face_labels has the shape {labels.shape}, not ({faces},)")
    return np.unique(labels, return_inverse=True)[1].reshape(-1).astype(np.int32)
