# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The fenced code blocks of the project's pages, and the cells of its notebooks."""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
_FENCE = re.compile(r"^(`{3,})(\{?)([\w-]*)")
_MARK = re.compile(r"^<!-- (file|output)(?:: (\S+))? -->$")


@dataclass(frozen=True)
class Block:
    """A block, and what the comment just above it says of it."""

    page: str  # from the top of the project
    line: int  # of its first line of code
    language: str
    text: str
    file: str | None = None
    """``<!-- file: NAME -->``: the block is the contents of that file, which later blocks use."""
    is_output: bool = False
    """``<!-- output -->``: the block before it prints this; ``...`` stands for anything."""

    @property
    def first_line(self) -> str:
        return self.text.partition("\n")[0]


def pages() -> list[str]:
    found = [*PROJECT.glob("*.md"), *(PROJECT / "docs").rglob("*.md"), *(PROJECT / "docs").rglob("*.ipynb")]
    found += [PROJECT / "python" / "README.md", PROJECT / "sample_meshes" / "README.md"]
    return sorted(str(path.relative_to(PROJECT)) for path in found)


def blocks_of(page: str) -> list[Block]:
    """The blocks of a page, but for Sphinx's directives, whose contents are no code of the page."""
    text = (PROJECT / page).read_text(encoding="utf-8")
    if page.endswith(".ipynb"):
        return [Block(page, 1, "python", code) for code in _cells(text)]
    lines = text.splitlines()
    found: list[Block] = []
    at = 0
    while at < len(lines):
        fence = _FENCE.match(lines[at])
        at += 1
        if not fence:
            continue
        start = at
        while lines[at].rstrip() != fence[1]:
            at += 1
        if not fence[2]:
            mark = _MARK.match(lines[start - 2]) if start > 1 else None
            kind, name = mark.groups() if mark else (None, None)
            text = "".join(f"{line}\n" for line in lines[start:at])
            found.append(Block(page, start + 1, fence[3], text, name, kind == "output"))
        at += 1
    return found


def _cells(notebook: str) -> list[str]:
    return ["".join(cell["source"]) for cell in json.loads(notebook)["cells"] if cell["cell_type"] == "code"]
