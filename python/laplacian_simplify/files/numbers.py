# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers in text, read all at once and exactly, whatever the locale; what is no number is named with its line."""

import re
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import DamageError, shortened

_LAST_BLANK = ord(" ")  # other control characters before it end the reading of numbers
_BLOCK = 1 << 20


def parse_numbers(data: bytes, start: int = 0, end: int | None = None, dtype: Any = np.float64) -> NDArray[Any]:
    """All numbers of a part of a text, which are divided by blanks.

    Raises:
        DamageError: there is something else; names the line and quotes it.
    """
    end = len(data) if end is None else end
    text = data if (start, end) == (0, len(data)) else data[start:end]
    numbers = _converted(text, dtype)
    if len(numbers) != count_words(text):
        raise no_number(data, start, end)
    return numbers


def _converted(text: bytes, dtype: Any) -> NDArray[Any]:
    """The numbers up to the first word that is none. NumPy warns of it or, in later versions, raises."""
    if not text.strip():
        return np.empty(0, dtype=dtype)
    try:
        return np.fromstring(text, dtype=dtype, sep=" ")
    except (ValueError, DeprecationWarning, OverflowError):
        return np.empty(0, dtype=dtype)


def count_words(text: bytes) -> int:
    """Words between blanks."""
    blank = np.frombuffer(text, np.uint8) <= _LAST_BLANK
    return int(np.count_nonzero(blank[:-1] > blank[1:])) + int(len(blank) > 0 and not blank[0])


def word_starts(text: bytes | bytearray | NDArray[np.uint8], start: int = 0) -> NDArray[np.int64]:
    """Where words start, from a place of a text on."""
    blank = np.frombuffer(text, np.uint8)[start:] <= _LAST_BLANK
    starts = np.flatnonzero(blank[:-1] > blank[1:]) + (start + 1)
    return np.concatenate([[start], starts]) if len(blank) and not blank[0] else starts


def no_number(data: bytes, start: int, end: int) -> DamageError:
    """Looks for the first word that is no number in a part of a file: block by block, then word by word."""
    while start < end:
        stop = min(data.find(b"\n", min(start + _BLOCK, end)) + 1 or end, end)
        block = data[start:stop]
        if len(_converted(block, np.float64)) != count_words(block):
            for word in re.finditer(rb"[^ \t\n\r\v\f]+", block):
                if not is_number(word[0]):
                    return DamageError(f"line {line_of(data, start + word.start())}", *not_a_number(word[0]))
        start = stop
    return DamageError("", "it holds a number that cannot be read")


def is_number(word: bytes) -> bool:
    """Whether a word is a number as meshes have it; NaN and infinity are, and are refused where they do harm."""
    return re.fullmatch(rb"[+-]?((\d+\.?\d*|\.\d+)(e[+-]?\d+)?|nan|inf(inity)?)", word, re.I) is not None


def not_a_number(word: bytes) -> tuple[str, str]:
    """What is wrong with a word, and what helps."""
    if re.fullmatch(rb"[+-]?\d*,\d+([eE][+-]?\d+)?", word):
        return f"{shortened(word)} has a decimal comma", "write numbers with a decimal point"
    return f"{shortened(word)} is no number", ""


def line_of(data: bytes, place: int) -> int:
    """The number of the line, counted from 1, for every kind of line ends."""
    before = data[:place]
    return before.count(b"\n") + before.count(b"\r") - before.count(b"\r\n") + 1
