# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The header of a PLY file: encoding, elements and their properties."""

import re
from dataclasses import dataclass, field

from .errors import DamageError, shortened

# PLY has every type under two names.
_TYPES = {
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2", "ushort": "u2",
    "uint16": "u2", "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4", "float": "f4", "float32": "f4",
    "double": "f8", "float64": "f8",
}  # fmt: skip
_BYTE_ORDER = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
_LONGEST_HEADER = 1 << 20
_MOST_ELEMENTS = 2**31 - 1


@dataclass(frozen=True)
class Property:
    """A number, or a list of numbers, of every row of an element."""

    name: str
    type: str
    """As NumPy has it, without the byte order."""
    count_type: str = ""
    """Of a list; empty where the property is a single number."""


@dataclass
class Element:
    """A table: vertices, faces and whatever else a file holds."""

    name: str
    rows: int
    line: int
    properties: list[Property] = field(default_factory=list)

    def row_size(self) -> int:
        """Bytes that a row has in binary at least, with all its lists empty."""
        return sum(int((row.count_type or row.type)[1]) for row in self.properties)

    def has_lists(self) -> bool:
        return any(row.count_type for row in self.properties)


@dataclass
class Header:
    """What a PLY file says about itself."""

    byte_order: str
    """< or >, empty for text."""
    elements: list[Element]
    textures: list[str]
    size: int
    """Bytes up to the first one of the body."""

    def element(self, name: str) -> Element | None:
        return next((element for element in self.elements if element.name == name), None)


def parse_header(data: bytes) -> Header:
    """Reads the header.

    Raises:
        DamageError: names the line.
    """
    start = 3 if data.startswith(b"\xef\xbb\xbf") else 0  # some editors put a byte order mark before a text
    if not data.startswith(b"ply", start):
        first = re.split(rb"[\r\n]", data[start : start + 20])[0]
        raise DamageError("line 1", f"{shortened(first)} instead of 'ply'", "this is no PLY file")
    end = re.compile(rb"(?:^|[\r\n])end_header[ \t]*(\r\n|\n|\r|$)").search(data, start, start + _LONGEST_HEADER)
    if not end:
        raise DamageError("header", "it has no line 'end_header'", "the file is cut off, or no PLY file")
    byte_order, elements, textures = None, [], []
    lines = re.split(rb"\r\n|\n|\r", data[start : end.end(0)])
    for number, line in enumerate(lines, start=1):
        words = line.decode("latin-1").split()
        if number == 1 or not words or words[0] in ("end_header", "obj_info"):
            continue
        try:
            if words[0] == "comment":
                textures += _texture(line)
            elif words[0] == "format":
                byte_order = _byte_order(words)
            elif words[0] == "element":
                elements.append(_element(words, number))
            elif words[0] == "property":
                elements[-1].properties.append(_property(words))
            else:
                raise ValueError("unknown keyword")
        except (ValueError, IndexError) as error:
            reason = f" ({error})" if isinstance(error, ValueError) else ""
            raise DamageError(f"line {number}", f"{shortened(line)} is no line of a PLY header{reason}") from None
    if byte_order is None:
        raise DamageError("header", "it has no line 'format'", "the file is damaged")
    return Header(byte_order, elements, textures, end.end(0))


def _texture(line: bytes) -> list[str]:
    found = re.match(rb"\s*comment\s+TextureFile\s+(.*\S)", line)
    return [found[1].decode("utf-8", "surrogateescape")] if found else []


def _byte_order(words: list[str]) -> str:
    if words[1] not in _BYTE_ORDER:
        raise ValueError(f"the encodings are {', '.join(_BYTE_ORDER)}")
    return _BYTE_ORDER[words[1]]


def _element(words: list[str], line: int) -> Element:
    if len(words) != 3 or not re.fullmatch(r"\d{1,18}", words[2], re.ASCII):
        raise ValueError("a name and a count are wanted")
    if int(words[2]) > _MOST_ELEMENTS:
        raise ValueError("more than 2,147,483,647 rows")
    return Element(words[1], int(words[2]), line)


def _property(words: list[str]) -> Property:
    if words[1] == "list":
        if len(words) != 5:
            raise ValueError("two types and a name are wanted")
        count_type = _type(words[2])
        if count_type[0] == "f":
            raise ValueError("the length of a list is a whole number")
        return Property(words[4], _type(words[3]), count_type)
    if len(words) != 3:
        raise ValueError("a type and a name are wanted")
    return Property(words[2], _type(words[1]))


def _type(word: str) -> str:
    if word not in _TYPES:
        raise ValueError(f"unknown type '{word}'")
    return _TYPES[word]
