# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The body of a PLY file as columns, for every type of numbers and lists, in text and both byte orders."""

from contextlib import suppress
from dataclasses import dataclass
from struct import Struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import DamageError, counted
from .mesh_data import Integers
from .numbers import parse_numbers, word_starts
from .ply_header import Element, Header

_STRUCT = {"i1": "b", "u1": "B", "i2": "h", "u2": "H", "i4": "i", "u4": "I"}


@dataclass
class Lists:
    """A list for every row: all values one after the other, and how many each row has."""

    values: NDArray[Any]
    counts: Integers


Column = NDArray[Any] | Lists
Columns = dict[str, Column]


def read_tables(data: bytes, header: Header) -> dict[str, Columns]:
    """The columns of every element by its name.

    Raises:
        DamageError: the body is shorter or longer than the header says, or holds what is no number.
    """
    body: _Binary | _Text
    body = _Binary(data, header.size, header.byte_order) if header.byte_order else _Text(data, header.size)
    tables: dict[str, Columns] = {}
    for element in header.elements:
        names = [row.name for row in element.properties]
        if len(set(names)) < len(names) or element.name in tables:
            raise DamageError(f"line {element.line}", f"element '{element.name}' or a property of it is there twice")
        _check_room(body.left(), element, "bytes" if header.byte_order else "numbers")
        tables[element.name] = body.even_rows(element) or body.uneven_rows(element)
    if body.left_over():
        raise DamageError(
            "end of file",
            f"it goes on for {body.left_over()} after the last row that the header announces",
            "a count in the header is too small, or the file is damaged",
        )
    return tables


def _check_room(left: int, element: Element, unit: str) -> None:
    needed = element.rows * (element.row_size() if unit == "bytes" else len(element.properties))
    if needed > left:
        raise DamageError(
            f"line {element.line}",
            f"the header announces {counted(element.rows, 'row')} of element '{element.name}', "
            f"which take at least {needed:,} {unit}, but {left:,} are left",
            "the file is cut off, or the count is wrong",
        )


def _cut(element: Element, row: int) -> DamageError:
    return DamageError(
        f"{element.name} {row}", f"the file ends after {row:,} of {counted(element.rows, 'row')}", "it is cut off"
    )


def _check_count(count: int, element: Element, row: int) -> None:
    if count < 0:
        raise DamageError(f"{element.name} {row}", f"a list of {count} numbers")


class _Binary:
    """Reads tables off bytes."""

    def __init__(self, data: bytes, start: int, byte_order: str) -> None:
        self._data, self._at, self._order = data, start, byte_order

    def left(self) -> int:
        return len(self._data) - self._at

    def left_over(self) -> str:
        """What is left that means anything, in words; writers may fill up with blanks."""
        rest = self._data[self._at :].strip(b"\0 \t\r\n")
        return counted(len(rest), "byte") if rest else ""

    def even_rows(self, element: Element) -> Columns | None:
        """All columns at once where every list is as long as that of the first row, otherwise nothing."""
        fields: list[Any] = []
        at = self._at
        for row in element.properties:
            if row.count_type:
                if element.rows == 0:
                    count = 0
                elif at + int(row.count_type[1]) > len(self._data):
                    return None
                else:
                    count = int(np.frombuffer(self._data, self._order + row.count_type, 1, at)[0])
                if not 0 <= count <= self.left():
                    return None
                fields.append(("count of " + row.name, self._order + row.count_type))
                fields.append((row.name, self._order + row.type, (count,)))
                at += int(row.count_type[1]) + count * int(row.type[1])
            else:
                fields.append((row.name, self._order + row.type))
                at += int(row.type[1])
        dtype = np.dtype(fields)
        if dtype.itemsize * element.rows > self.left():
            return None
        table = (
            np.frombuffer(self._data, dtype, element.rows, self._at)
            if dtype.itemsize
            else np.zeros(element.rows, dtype)
        )
        columns: Columns = {}
        for row in element.properties:
            columns[row.name] = table[row.name]
            if row.count_type:
                count = dtype[row.name].shape[0]
                if (table["count of " + row.name] != count).any():
                    return None
                columns[row.name] = Lists(table[row.name].reshape(-1), np.full(element.rows, count))
        self._at += dtype.itemsize * element.rows
        return columns

    def uneven_rows(self, element: Element) -> Columns:
        """Column by column, after the places of all lists were found row by row."""
        places, counts = self._walk(element)
        columns: Columns = {}
        raw = np.frombuffer(self._data, np.uint8)
        for k, row in enumerate(element.properties):
            number_of = np.array(counts[k], dtype=np.int64) if row.count_type else np.ones(element.rows, np.int64)
            values = self._gather(raw, np.array(places[k], dtype=np.int64), number_of, row.type)
            columns[row.name] = Lists(values, number_of) if row.count_type else values
        return columns

    def _walk(self, element: Element) -> tuple[list[list[int]], list[list[int]]]:
        """Where the numbers of every property are in every row, and how many."""
        steps = [
            (Struct(self._order + _STRUCT[row.count_type]) if row.count_type else None, int(row.type[1]))
            for row in element.properties
        ]
        places: list[list[int]] = [[] for _ in steps]
        counts: list[list[int]] = [[] for _ in steps]
        at, end = self._at, len(self._data)
        for index in range(element.rows):
            for k, (count_at, size) in enumerate(steps):
                count = 1
                if count_at is not None:
                    if at + count_at.size > end:
                        raise _cut(element, index)
                    (count,) = count_at.unpack_from(self._data, at)
                    _check_count(count, element, index)
                    counts[k].append(count)
                    at += count_at.size
                places[k].append(at)
                at += count * size
                if at > end:
                    raise _cut(element, index)
        self._at = at
        return places, counts

    def _gather(self, raw: NDArray[np.uint8], places: Integers, counts: Integers, type_name: str) -> NDArray[Any]:
        """The numbers at these places, one row after the other."""
        size = int(type_name[1])
        starts = np.cumsum(counts) - counts
        values = np.empty(int(counts.sum()), dtype=type_name)
        for count in np.unique(counts[counts > 0]):
            rows = np.flatnonzero(counts == count)
            picked = raw[places[rows, None] + np.arange(count * size)].view(self._order + type_name)
            values[starts[rows, None] + np.arange(count)] = picked
        return values


class _Text:
    """Reads tables off numbers in text."""

    def __init__(self, data: bytes, start: int) -> None:
        self._data = data
        self._words = word_starts(data, start)
        self._at = 0

    def left(self) -> int:
        return len(self._words) - self._at

    def left_over(self) -> str:
        return counted(self.left(), "number") if self.left() else ""

    def even_rows(self, element: Element) -> Columns | None:
        """As in _Binary."""
        at, sizes = self._at, []
        for row in element.properties:
            count = 1
            if row.count_type and element.rows:
                if at >= len(self._words):
                    return None
                count = _length(self._numbers(at, at + 1, element)[0], element, 0)
                if not 0 <= count <= self.left():
                    return None
                at += 1
            sizes.append(count)
            at += count
        width = at - self._at
        if width * element.rows > self.left():
            return None
        table = self._numbers(self._at, self._at + width * element.rows, element).reshape(element.rows, width)
        columns: Columns = {}
        at = 0
        for row, size in zip(element.properties, sizes, strict=True):
            if row.count_type and element.rows:
                if (table[:, at] != size).any():
                    return None
                at += 1
            picked = table[:, at : at + size]
            columns[row.name] = (
                Lists(picked.reshape(-1), np.full(element.rows, size)) if row.count_type else picked[:, 0]
            )
            at += size
        self._at += width * element.rows
        return columns

    def uneven_rows(self, element: Element) -> Columns:
        """As in _Binary."""
        numbers = self._numbers(self._at, len(self._words), element)
        places: list[list[int]] = [[] for _ in element.properties]
        counts: list[list[int]] = [[] for _ in element.properties]
        at, end = 0, len(numbers)
        for index in range(element.rows):
            for k, row in enumerate(element.properties):
                count = 1
                if row.count_type:
                    if at >= end:
                        raise _cut(element, index)
                    count = _length(numbers[at], element, index)
                    _check_count(count, element, index)
                    at += 1
                counts[k].append(count)
                places[k].append(at)
                at += count
                if at > end:
                    raise _cut(element, index)
        self._at += at
        columns: Columns = {}
        for k, row in enumerate(element.properties):
            number_of = np.array(counts[k], dtype=np.int64)
            within = np.arange(int(number_of.sum())) - np.repeat(np.cumsum(number_of) - number_of, number_of)
            values = numbers[np.repeat(np.array(places[k], dtype=np.int64), number_of) + within]
            columns[row.name] = Lists(values, number_of) if row.count_type else values
        return columns

    def _numbers(self, first: int, last: int, element: Element) -> NDArray[Any]:
        """The words first..last-1: as integers, which is five times as fast, where the element has no others."""
        if first >= last:
            return np.empty(0)
        start = int(self._words[first])
        end = int(self._words[last]) if last < len(self._words) else len(self._data)
        if all(row.type[0] in "iu" for row in element.properties):
            with suppress(DamageError):
                return parse_numbers(self._data, start, end, np.int64)
        return parse_numbers(self._data, start, end)


def _length(number: float, element: Element, row: int) -> int:
    if not float(number).is_integer():
        raise DamageError(f"{element.name} {row}", f"a list of {number:g} numbers")
    return int(number)
