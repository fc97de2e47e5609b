# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines of an OBJ file, sorted by what they state."""

import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .errors import DamageError, shortened
from .mesh_data import Floats, Integers
from .numbers import line_of, parse_numbers, word_starts
from .text_lines import cleaned, without_comments

_KEYWORDS = ("v", "vt", "vn", "f", "l", "p", "usemtl", "mtllib")
_CODE = {word: number for number, word in enumerate(_KEYWORDS, start=1)}
# Everything else in the format, which says nothing about a mesh of polygons.
_SINGLE_LETTERS = (b"o", b"g", b"s")


@dataclass
class Rows:
    """The numbers of all lines with the same keyword."""

    all: Floats
    """One line after the other."""
    sizes: Integers
    """How many each line has."""

    def first(self, number: int) -> Floats:
        """The first numbers of every line, of which each has so many."""
        if not len(self.sizes):
            return np.empty((0, number))
        if self.sizes.min() == self.sizes.max():
            return np.ascontiguousarray(self.all.reshape(len(self.sizes), -1)[:, :number])
        starts = np.cumsum(self.sizes) - self.sizes
        picked: Floats = self.all[starts[:, None] + np.arange(number)]
        return picked

    def padded(self, number: int) -> Floats:
        """The first numbers of every line, zeros where it has fewer."""
        if not len(self.sizes) or self.sizes.min() >= number:
            return self.first(number)
        starts = np.cumsum(self.sizes) - self.sizes
        padded = np.zeros((len(self.sizes), number))
        for k in range(number):
            has = self.sizes > k
            padded[has, k] = self.all[starts[has] + k]
        return padded


class Statements:
    """An OBJ file line by line, without knowing what the lines mean."""

    def __init__(self, content: bytes) -> None:
        self._named = cleaned(content)
        if b"\\\n" in self._named:  # a line goes on
            self._named = self._named.replace(b"\\\n", b"  ")
        self.data = without_comments(self._named)
        text = np.frombuffer(self.data, np.uint8)
        ends = np.concatenate([np.flatnonzero(text == ord("\n")), [len(text)]])
        starts = np.concatenate([[0], ends[:-1] + 1])
        self._codes, self._starts = _classified(text, starts, ends)
        self._ends = ends
        self._original = content
        self._check_unknown()

    def count(self, keyword: str) -> int:
        """Lines with this keyword."""
        return len(self.lines(keyword))

    def lines(self, keyword: str) -> NDArray[np.int64]:
        """The lines with this keyword."""
        return np.flatnonzero(self._codes == _CODE[keyword])

    def before(self, keyword: str, lines: NDArray[np.int64]) -> NDArray[np.int64]:
        """How many lines with this keyword stand before each of some lines."""
        return np.searchsorted(self.lines(keyword), lines)

    def name(self, line: int) -> str:
        """How messages name a line: with its number in the file."""
        return f"line {line_of(self._original, int(self._starts[line]))}"

    def words(self, line: int) -> list[bytes]:
        """The words of one line."""
        return self.data[int(self._starts[line]) : int(self._ends[line])].split()

    def quoted(self, line: int) -> str:
        """The line for a message."""
        return shortened(self.data[int(self._starts[line]) : int(self._ends[line])].strip())

    def names(self, keyword: str) -> list[str]:
        """What stands behind a keyword that is followed by a name, which may have blanks and # in it."""
        found = []
        for line in self.lines(keyword):
            words = self._named[int(self._starts[line]) : int(self._ends[line])].strip().split(None, 1)
            name = re.sub(rb"\s#.*", b"", words[1]) if len(words) > 1 else b""
            found.append(name.strip().decode("utf-8", "surrogateescape"))
        return found

    def text_of(self, keyword: str) -> tuple[bytes, NDArray[np.int64]]:
        """What stands behind a keyword, line by line, and how many words each line has there."""
        lines = self.lines(keyword)
        if not len(lines):
            return b"", lines
        breaks = np.flatnonzero(np.diff(lines) != 1) + 1
        blocks = zip(
            self._starts[lines[np.concatenate([[0], breaks])]].tolist(),
            self._ends[lines[np.concatenate([breaks - 1, [len(lines) - 1]])]].tolist(),
            strict=True,
        )
        text = bytearray(b"\n").join([self.data[start:end] for start, end in blocks])
        raw = np.frombuffer(text, np.uint8)
        words = word_starts(text)
        line_ends = np.concatenate([np.flatnonzero(raw == ord("\n")), [len(text)]])
        first_of_line = np.searchsorted(words, np.concatenate([[0], line_ends[:-1] + 1]))
        for k in range(len(keyword)):  # what is left are the words behind it
            raw[words[first_of_line] + k] = ord(" ")
        return bytes(text), np.diff(first_of_line, append=len(words)) - 1

    def numbers(self, keyword: str, least: int) -> Rows:
        """The numbers of all lines with a keyword, of which each has to have some.

        Raises:
            DamageError: names the line.
        """
        text, sizes = self.text_of(keyword)
        if not len(sizes):
            return Rows(np.empty(0), np.empty(0, np.int64))
        try:
            numbers = parse_numbers(text)
        except DamageError:
            raise self._no_number(keyword) from None
        if sizes.min() < least:
            line = int(self.lines(keyword)[int(np.argmax(sizes < least))])
            raise DamageError(
                self.name(line), f"{self.quoted(line)} has fewer than {least} numbers", "the file is damaged"
            )
        return Rows(numbers, sizes)

    def with_line(self, keyword: str, damage: DamageError) -> DamageError:
        """Damage that a check of vertices found, with the line in place of the number of the vertex."""
        place, _, what = str(damage).partition(": ")
        return DamageError(self.name(int(self.lines(keyword)[int(place.removeprefix("vertex "))])), what)

    def _no_number(self, keyword: str) -> DamageError:
        """Looks for the line: this text is the file's, but without the other lines."""
        for line in self.lines(keyword):
            start, end = int(self._starts[line]) + len(keyword), int(self._ends[line])
            try:
                parse_numbers(self.data, start, end)
            except DamageError as damage:
                return DamageError(self.name(int(line)), str(damage).partition(": ")[2])
        return DamageError("", "it holds a number that cannot be read")

    def _check_unknown(self) -> None:
        """A line that begins with no word, or with a letter that means nothing, was something else once."""
        for line in np.flatnonzero(self._codes == 0):
            word = self.data[int(self._starts[line]) : int(self._ends[line])].split(None, 1)[0]
            if word in _SINGLE_LETTERS or (len(word) > 1 and re.match(rb"[A-Za-z_]", word)):
                continue
            raise DamageError(
                self.name(int(line)), f"{self.quoted(int(line))} is no line of an OBJ file", "it is damaged"
            )


def _classified(
    text: NDArray[np.uint8], starts: NDArray[np.int64], ends: NDArray[np.int64]
) -> tuple[NDArray[np.int8], NDArray[np.int64]]:
    """The code of every line's keyword, 0 for others and -1 for empty lines; and where its first word starts."""
    padded = np.concatenate([text, np.full(8, ord("\n"), np.uint8)])
    if np.isin(padded[starts], list(b" \t\v\f")).any():  # lines are indented
        words = np.concatenate([word_starts(text), [len(text)]])
        starts = np.minimum(words[np.searchsorted(words[:-1], starts)], ends)
    codes = np.zeros(len(starts), dtype=np.int8)
    codes[starts >= ends] = -1
    characters = [padded[starts + k] for k in range(7)]
    blank = [np.isin(column, list(b" \t\v\f\n")) for column in characters]
    for word, code in _CODE.items():
        matches = blank[len(word)] & (codes == 0)
        for k, letter in enumerate(word.encode()):
            matches &= characters[k] == letter
        codes[matches] = code
    return codes, starts
