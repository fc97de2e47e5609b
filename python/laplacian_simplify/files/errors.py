# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The one kind of answer to a file that cannot be used."""

_UNPRINTABLE = {number: f"\\x{number:02x}" for number in (*range(32), 127)}


class MeshFileError(OSError):
    """A mesh file that cannot be read or written; the text is one line that names the file and the reason."""


class DamageError(Exception):
    """What a reader found: the place in the file, what is wrong there, and what helps.

    Readers raise it without the file's name; ``named`` makes the error for the user of it.
    """

    def __init__(self, where: str, what: str, remedy: str = "") -> None:
        super().__init__(": ".join(part for part in (where, what) if part) + (f"; {remedy}" if remedy else ""))

    def named(self, shown: str) -> MeshFileError:
        """The error about the file of this name."""
        return MeshFileError(f"{shown} cannot be read: {self}")


def printable(text: object) -> str:
    """The text on one line: control characters are written as escapes, everything else as it is."""
    return str(text).translate(_UNPRINTABLE)


def shortened(data: bytes, limit: int = 40) -> str:
    """A piece of a file, to be quoted in a message."""
    text = data[:limit].decode("utf-8", "replace") + ("..." if len(data) > limit else "")
    return "'" + "".join(character if character.isprintable() else "\ufffd" for character in text) + "'"


def counted(number: int, one: str, many: str = "") -> str:
    """1 face, 2 faces."""
    return f"{number:,} {one if number == 1 else many or one + 's'}"
