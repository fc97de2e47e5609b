# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Material libraries of OBJ files: a color and a texture for every name."""

import re
import stat
from pathlib import Path

import numpy as np

from .errors import DamageError, printable
from .text_lines import cleaned

_WHITE, _LIGHT_GRAY = (255, 255, 255, 255), (192, 192, 192, 255)
_LARGEST = 64 << 20  # bytes; libraries of thousands of materials have one
# Options of texture maps, with the number of words that follow each.
_OPTIONS = {
    "-blendu": 1, "-blendv": 1, "-boost": 1, "-mm": 2, "-texres": 1, "-clamp": 1, "-bm": 1, "-imfchan": 1, "-type": 1,
}  # fmt: skip
_UP_TO_THREE_NUMBERS = ("-o", "-s", "-t")


class Materials:
    """The materials that an OBJ file may use; number 0 is the one for unknown names, and before the first."""

    def __init__(self, mesh: Path) -> None:
        self._mesh = mesh
        self._numbers: dict[str, int] = {}
        self._missing: set[str] = set()
        self.colors: list[tuple[int, int, int, int]] = [_LIGHT_GRAY]
        self.texture_of: list[int] = [0]
        self.textures: list[str] = []
        self.notes: list[str] = []

    def add_library(self, name: str, folder: Path) -> None:
        """Reads a library, or several, that the mesh names; what keeps one from being read is a note."""
        several = name.split()
        names = [name] if len(several) < 2 or (folder / name).is_file() else several
        for one in names:
            content, reason = _content(folder, one)
            if content is None:
                self.notes.append(f"material file '{printable(one)}' {reason}; the mesh was read without it")
            else:
                self._parse(content)

    def number_of(self, name: str) -> int:
        """The number of a material; an unknown one is looked for in the library named after the mesh, and noted."""
        if not self._numbers and not self.notes:
            content, _ = _content(self._mesh.parent, self._mesh.with_suffix(".mtl").name)
            self._parse(content or b"")
        if name not in self._numbers and name not in self._missing and self._numbers:
            self._missing.add(name)
            self.notes.append(f"material '{printable(name)}' is in no material file")
        return self._numbers.get(name, 0)

    def _parse(self, content: bytes) -> None:
        """Materials without a texture get the first one, as MeshLab has it."""
        first_new = len(self.colors)
        for line in content.decode("utf-8", "surrogateescape").splitlines():
            words = line.split()
            if not words:
                continue
            keyword, rest = words[0].lower(), line.strip()[len(words[0]) :].strip()
            if keyword == "newmtl":
                self._numbers.setdefault(rest, len(self.colors))
                self.colors.append(_WHITE)
                self.texture_of.append(0)
            elif len(self.colors) > first_new and keyword == "kd":
                self.colors[-1] = _color(words[1:4]) or self.colors[-1]
            elif len(self.colors) > first_new and keyword == "map_kd" and rest:
                self.texture_of[-1] = self._texture(_without_options(rest))

    def _texture(self, name: str) -> int:
        if name not in self.textures:
            self.textures.append(name)
        return self.textures.index(name)


def _content(folder: Path, name: str) -> tuple[bytes | None, str]:
    """The bytes of a library, or what keeps them from being read: it may be anything that a name can name."""
    path = folder / name.replace("\\", "/")
    try:
        found = path.stat()
        if not stat.S_ISREG(found.st_mode):
            return None, "is not a file"
        if found.st_size > _LARGEST:
            return None, "is too large for one"
        return cleaned(path.read_bytes()), ""
    except FileNotFoundError:
        return None, "does not exist"
    except DamageError as damage:
        return None, f"cannot be read: {damage}"
    except (OSError, ValueError) as error:
        return None, f"cannot be read: {getattr(error, 'strerror', None) or error}"


def _color(words: list[str]) -> tuple[int, int, int, int] | None:
    """Three numbers from 0 to 1 as bytes, as MeshLab rounds them."""
    if len(words) < 3 or not all(re.fullmatch(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", word) for word in words):
        return None
    red, green, blue = (int(min(max(float(np.float32(float(word))) * 255.0, 0), 255)) for word in words)
    return red, green, blue, 255


def _without_options(rest: str) -> str:
    """The name of a texture, which may have blanks in it, behind the options of the map."""
    words = rest.split()
    while len(words) > 1 and words[0].startswith("-"):
        option = words[0].lower()
        skip = 1 + _OPTIONS.get(option, 0)
        if option in _UP_TO_THREE_NUMBERS:
            while skip < min(4, len(words) - 1) and re.fullmatch(r"[+-]?[\d.]+([eE][+-]?\d+)?", words[skip]):
                skip += 1
        elif option not in _OPTIONS:
            break
        words = words[skip:]
        rest = rest.split(None, skip)[-1] if len(words) else rest
    return rest
