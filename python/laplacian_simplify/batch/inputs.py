# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which meshes there are, where their results go, and about how much memory each needs."""

import glob
import os
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from ..files.errors import printable
from ..files.formats import READERS
from ..files.output_formats import OUTPUT_FORMATS

# In a folder these are mostly notes and tables, or points without faces; a pattern that names them takes them.
_SELDOM_MESHES = frozenset(("apts", "asc", "bre", "e57", "pdb", "pts", "ptx", "qobj", "tri", "txt", "vmi", "xyz"))
_READ = frozenset(extension for reader in READERS for extension in reader.extensions)
_WRITTEN = frozenset(row.extension for row in OUTPUT_FORMATS)

# Measured: 82 MiB of a process with MeshLab in it, 275 bytes a face. Readers of text hold the text, too.
_BYTES_OF_A_PROCESS, _BYTES_A_FACE, _COPIES_OF_A_FILE = 100 << 20, 300, 4
_TEXT_OF_A_FACE, _GROWTH_OF_GZ = 30, 8
_HEAD = 1 << 14


@dataclass(frozen=True)
class MeshToDo:
    """A mesh and its result."""

    name: str
    """Of the file, from the folder of all inputs; the manifest and messages call it so."""
    source: Path
    target: Path
    memory: int
    """Bytes that simplifying it takes, about."""


def find_meshes(given: str, output: Path, output_format: str | None) -> list[MeshToDo]:
    """The meshes of a folder and those below, or those that a pattern matches, by their names.

    Args:
        given: a folder, a file, or a pattern with ``*``, ``?`` or ``**``.
        output: the folder of the results, which lie there as the inputs lie in theirs.
        output_format: extension of the results; otherwise that of the input, or PLY where that cannot be written.

    Raises:
        ValueError: there is none, or two of them would have one result.
    """
    folder = Path(given)
    if folder.is_dir():
        base, paths = folder.absolute(), _below(folder.absolute(), output)
    else:
        base, paths = _fixed_part(given), iter(sorted(_matching(given)))
    if os.path.realpath(base) == os.path.realpath(output):
        raise ValueError(f"OUTPUT_DIR {printable(output)} is the folder of the inputs, which the results would replace")
    found: dict[Path, MeshToDo] = {}
    for path in paths:
        name = str(path.relative_to(base))
        target = output / Path(name).parent / _result_name(path.name, output_format)
        if target in found:
            raise ValueError(
                f"{printable(found[target].name)} and {printable(name)} would both become {printable(target)}; "
                "give a pattern that matches one of them"
            )
        found[target] = MeshToDo(name, path, target, _memory_for(path))
    if not found:
        raise ValueError(f"{printable(given)} holds no mesh that can be read")
    return list(found.values())


def _below(folder: Path, output: Path) -> Iterator[Path]:
    """Files of mesh formats in a folder and its folders, but for hidden ones and those of the output."""
    own = os.path.realpath(output)
    for place, folders, files in os.walk(folder):
        folders[:] = sorted(name for name in folders if name[0] != "." and os.path.realpath(Path(place) / name) != own)
        for name in sorted(files):
            if name[0] != "." and _format_of(name) in _READ - _SELDOM_MESHES:
                yield Path(place) / name


def _matching(pattern: str) -> Iterator[Path]:
    if Path(pattern).is_file():  # whatever brackets its name has
        pattern = glob.escape(pattern)
    for name in glob.iglob(pattern, recursive=True):  # noqa: PTH207, as that of Path takes no absolute ones
        path = Path.cwd() / name
        if not path.is_dir() and _format_of(path.name) in _READ:
            yield path


def _fixed_part(pattern: str) -> Path:
    """The folder before the first part with a wildcard."""
    parts = (Path.cwd() / pattern).parts
    if Path(pattern).is_file():
        return Path(*parts[:-1])
    fixed = next((k for k, part in enumerate(parts) if glob.has_magic(part)), len(parts) - 1)
    return Path(*parts[: min(fixed, len(parts) - 1)])


def _format_of(name: str) -> str:
    return Path(re.sub(r"\.gz$", "", name, flags=re.I)).suffix.lower().lstrip(".")


def _result_name(name: str, output_format: str | None) -> str:
    plain = Path(re.sub(r"\.gz$", "", name, flags=re.I))
    if output_format is None and _format_of(name) in _WRITTEN:
        return plain.name
    return f"{plain.stem}.{output_format or 'ply'}"


def _memory_for(path: Path) -> int:
    if not path.is_file():  # the worker will say it
        return _BYTES_OF_A_PROCESS
    try:
        size = path.stat().st_size
        with path.open("rb") as file:
            head = file.read(_HEAD)
    except OSError:
        return _BYTES_OF_A_PROCESS
    size *= _GROWTH_OF_GZ if path.name.lower().endswith(".gz") else 1
    return _BYTES_OF_A_PROCESS + _BYTES_A_FACE * _faces(_format_of(path.name), head, size) + _COPIES_OF_A_FILE * size


def _faces(extension: str, head: bytes, size: int) -> int:
    """By the header where it says so, and never more than the file has bytes; else a guess from the size."""
    if extension == "ply" and (found := re.search(rb"element\s+face\s+(\d{1,12})\s", head)):
        return min(int(found[1]), size)
    if extension == "stl" and not head.lstrip().startswith(b"solid"):
        return size // 50
    return size // _TEXT_OF_A_FACE
