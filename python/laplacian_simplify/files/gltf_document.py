# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The document of a glTF file and the numbers in its buffers, none of which may lie outside of them."""

import base64
import binascii
import json
import stat
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np
from numpy.typing import NDArray

from .errors import DamageError, printable

_COMPONENT = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_COLUMNS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
_JSON, _BIN = b"JSON", b"BIN\0"
# Extensions without which a scene that requires them is not what it says, but whose lack does no harm here.
_HARMLESS = ("KHR_materials_", "KHR_texture_transform", "KHR_lights_punctual", "KHR_mesh_quantization", "KHR_xmp")


class Document:
    """A glTF document."""

    def __init__(self, content: bytes, folder: Path) -> None:
        self._folder = folder
        text, self._binary = _chunks(content) if content.startswith(b"glTF") else (content, None)
        self.root = _parsed(text)
        self._buffers: dict[int, bytes] = {}
        for name in self.root.get("extensionsRequired", []):
            if not str(name).startswith(_HARMLESS):
                raise DamageError(
                    "extensionsRequired", f"the extension {printable(name)} is not read", "export without it"
                )

    def rows(self, name: str) -> list[Any]:
        """All objects of a kind."""
        rows = self.root.get(name, [])
        if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
            raise DamageError(name, "it is no list of objects", "the file is damaged")
        return rows

    def at(self, name: str, number: Any, where: str) -> dict[str, Any]:
        """One object by its number."""
        rows = self.rows(name)
        if not isinstance(number, int) or isinstance(number, bool) or not 0 <= number < len(rows):
            raise DamageError(where, f"it refers to {name} {number!r} of {len(rows)}", "the file is damaged")
        return dict(rows[number])

    def accessor(self, number: Any, where: str) -> NDArray[Any]:
        """Numbers, a row for every element; those that stand for parts of one are divided to be so."""
        row = self.at("accessors", number, where)
        where = f"accessor {number}"
        kind, columns = _COMPONENT.get(row.get("componentType", 0)), _COLUMNS.get(row.get("type", ""))
        count = row.get("count")
        if kind is None or columns is None or not isinstance(count, int) or count < 0:
            raise DamageError(where, "its type or its count is none", "the file is damaged")
        if "sparse" in row or "bufferView" not in row:
            raise DamageError(where, "sparse numbers are not read", "export without them")
        view, stride = self._view(row["bufferView"], where)
        start, size = _number(row, "byteOffset", where), columns * int(kind[2])
        stride = stride or size
        if count and start + (count - 1) * stride + size > len(view):
            raise DamageError(
                where,
                f"its {count:,} elements take {start + (count - 1) * stride + size:,} bytes of a view of {len(view):,}",
                "the file is cut off or damaged",
            )
        if not count:
            return np.empty((0, columns))
        values: np.ndarray[Any, Any] = np.ndarray((count, columns), kind, view, start, (stride, int(kind[2])))
        if not row.get("normalized") or kind[1] == "f":
            return np.array(values)
        numbers: np.ndarray[Any, Any] = np.maximum(values.astype(np.float64) / np.iinfo(values.dtype).max, -1)
        return numbers

    def image(self, row: dict[str, Any], where: str) -> bytes | None:
        """The bytes of an image; nothing where its file is not there."""
        if "bufferView" in row:
            return bytes(self._view(row["bufferView"], where)[0])
        if not isinstance(row.get("uri"), str):
            return None
        try:
            return self._from_uri(row["uri"], where)
        except DamageError:
            return None

    def _view(self, number: Any, where: str) -> tuple[bytes, int]:
        row = self.at("bufferViews", number, where)
        where = f"bufferView {number}"
        if "EXT_meshopt_compression" in row.get("extensions", {}):
            raise DamageError(
                where, "it is compressed with meshopt, which is not read", "export it without compression"
            )
        buffer = self._buffer(row.get("buffer"), where)
        start, length = _number(row, "byteOffset", where), _number(row, "byteLength", where)
        if start + length > len(buffer):
            raise DamageError(
                where, f"it ends at byte {start + length:,} of a buffer of {len(buffer):,}", "the file is cut off"
            )
        return buffer[start : start + length], _number(row, "byteStride", where)

    def _buffer(self, number: Any, where: str) -> bytes:
        row = self.at("buffers", number, where)
        if number not in self._buffers:
            if "uri" in row:
                self._buffers[number] = self._from_uri(str(row["uri"]), f"buffer {number}")
            elif self._binary is not None:
                self._buffers[number] = self._binary
            else:
                raise DamageError(f"buffer {number}", "it has no bytes", "the file is damaged")
        return self._buffers[number]

    def _from_uri(self, uri: str, where: str) -> bytes:
        """Bytes in the document itself or in a file beside it."""
        if uri.startswith("data:"):
            try:
                return base64.b64decode(uri.partition(",")[2], validate=True)
            except (binascii.Error, ValueError):
                raise DamageError(where, "its bytes are no base64", "the file is damaged") from None
        path = self._folder / unquote(uri)
        try:
            if not stat.S_ISREG(path.stat().st_mode):
                raise DamageError(where, f"{printable(uri)} is not a file")
            return path.read_bytes()
        except (OSError, ValueError) as error:
            reason = getattr(error, "strerror", None) or error
            raise DamageError(
                where, f"{printable(uri)} cannot be read ({reason})", "it belongs beside the .gltf"
            ) from None


def _chunks(content: bytes) -> tuple[bytes, bytes | None]:
    """Document and buffer of a .glb."""
    words = np.frombuffer(content[:12].ljust(12, b"\0"), "<u4")
    version, length = int(words[1]), int(words[2])
    if version != 2:
        raise DamageError("header", f"it is glTF {version}", "only glTF 2 is read")
    if length != len(content):
        raise DamageError(
            "header", f"it announces {length:,} bytes, but the file has {len(content):,}", "it is cut off or damaged"
        )
    found: dict[bytes, bytes] = {}
    at = 12
    while at + 8 <= length:
        size = int.from_bytes(content[at : at + 4], "little")
        if at + 8 + size > length:
            raise DamageError(
                f"chunk at byte {at}", f"it announces {size:,} bytes, more than are left", "it is damaged"
            )
        found.setdefault(content[at + 4 : at + 8], content[at + 8 : at + 8 + size])
        at += 8 + size
    if _JSON not in found:
        raise DamageError("header", "it has no chunk 'JSON'", "the file is damaged")
    return found[_JSON], found.get(_BIN)


def _parsed(text: bytes) -> dict[str, Any]:
    try:
        root = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise DamageError("document", f"it is no JSON ({error})", "the file is damaged, or no glTF") from None
    if not isinstance(root, dict) or not isinstance(root.get("asset"), dict):
        raise DamageError("document", "it has no 'asset'", "the file is no glTF")
    if not str(root["asset"].get("version", "")).startswith("2"):
        raise DamageError("document", f"it is glTF {printable(root['asset'].get('version'))}", "only glTF 2 is read")
    return root


def _number(row: dict[str, Any], name: str, where: str) -> int:
    value = row.get(name, 0)
    if not isinstance(value, int) or isinstance(value, bool) or value < 0:
        raise DamageError(where, f"{name} is {value!r}", "the file is damaged")
    return value
