# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A text as the lines that say something, for every kind of line ends, and a way to name them."""

import re

import numpy as np
from numpy.typing import NDArray

from .errors import DamageError, shortened
from .numbers import line_of, word_starts


def cleaned(content: bytes) -> bytes:
    """The text with line ends of one kind and no byte order mark. Every byte keeps its place, so lines keep numbers.

    Raises:
        DamageError: the file is no text, or in an encoding of two bytes a character.
    """
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise DamageError("line 1", "the text is UTF-16", "save it as ASCII or UTF-8")
    zero = content.find(b"\0")
    if zero >= 0:
        raise DamageError(
            f"line {line_of(content, zero)}", "it holds a zero byte, which no text has", "the file is damaged"
        )
    if content.startswith(b"\xef\xbb\xbf"):
        content = b"   " + content[3:]
    if b"\r" in content:
        content = content.replace(b"\r\n", b" \n").replace(b"\r", b"\n")
    return content


def without_comments(text: bytes) -> bytes:
    """The text with blanks in place of everything from # to the end of the line."""
    if b"#" not in text:
        return text
    return re.sub(rb"#[^\n]*", lambda comment: b" " * len(comment[0]), text)


class Lines:
    """The lines of a text that have a word on them."""

    def __init__(self, content: bytes) -> None:
        self.data = without_comments(cleaned(content))
        text = np.frombuffer(self.data, np.uint8)
        ends = np.concatenate([np.flatnonzero(text == ord("\n")), [len(text)]])
        self._words = word_starts(self.data)
        first_word = np.searchsorted(self._words, np.concatenate([[0], ends[:-1] + 1]))
        counts = np.diff(np.concatenate([first_word, [len(self._words)]]))
        self._sizes = counts[counts > 0]
        self._first_word = first_word[counts > 0]
        self._ends = ends[counts > 0]

    def __len__(self) -> int:
        return len(self._sizes)

    def name(self, line: int) -> str:
        """How messages name a line: with its number in the file."""
        if line >= len(self):
            return "end of file"
        return f"line {line_of(self.data, int(self._words[self._first_word[line]]))}"

    def words(self, line: int) -> list[bytes]:
        """The words of one line."""
        start, end = self.span(line, line + 1)
        return self.data[start:end].split()

    def quoted(self, line: int) -> str:
        """The line for a message."""
        start, end = self.span(line, line + 1)
        return shortened(self.data[start:end].strip())

    def span(self, first: int, last: int) -> tuple[int, int]:
        """Where the lines first..last-1 start and end."""
        if first >= last:
            return 0, 0
        return int(self._words[self._first_word[first]]), int(self._ends[last - 1])

    def word_counts(self, first: int, last: int) -> NDArray[np.int64]:
        """Words on each of the lines first..last-1."""
        return self._sizes[first:last]

    def words_with(self, mark: bytes, first: int, last: int) -> NDArray[np.bool_]:
        """Which words on the lines first..last-1 have this character."""
        start, end = self.span(first, last)
        words = self._words[(self._words >= start) & (self._words < end)]
        places = np.flatnonzero(np.frombuffer(self.data, np.uint8)[start:end] == mark[0]) + start
        found = np.zeros(len(words), dtype=bool)
        found[np.searchsorted(words, places, side="right") - 1] = True
        return found
