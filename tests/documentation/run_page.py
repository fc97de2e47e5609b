# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the blocks of a page in their order, as a reader would: files are written, shell and Python are run.

    python run_page.py BLOCKS.json

in the folder where they shall run. All Python blocks of a page are one session.
"""

from __future__ import annotations

import contextlib
import doctest
import io
import json
import subprocess
import sys
from pathlib import Path


class Session:
    """What the blocks of a page have in common."""

    def __init__(self) -> None:
        self.names: dict[str, object] = {"__name__": "__page__"}
        self.said = ""

    def run(self, block: dict) -> None:
        if block["file"]:
            Path(block["file"]).parent.mkdir(exist_ok=True)
            Path(block["file"]).write_text(block["text"], encoding="utf-8")
        elif block["is_output"]:
            self._compare(block["text"])
        elif block["language"] == "sh":
            self._run_shell(block["text"])
        else:
            self._run_python(block)

    def _compare(self, expected: str) -> None:
        flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
        if not doctest.OutputChecker().check_output(expected, self.said, flags):
            raise AssertionError(f"expected:\n{expected}\ngot:\n{self.said}")

    def _run_shell(self, text: str) -> None:
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", text], capture_output=True, text=True)
        self.said = done.stdout
        if done.returncode:
            raise AssertionError(f"exit code {done.returncode}\n{done.stdout}\n{done.stderr}")

    def _run_python(self, block: dict) -> None:
        lines = "\n" * (block["line"] - 1)  # so that a traceback names the line of the page
        program = compile(lines + block["text"], block["page"], "exec")
        with contextlib.redirect_stdout(io.StringIO()) as output:
            exec(program, self.names)
        self.said = output.getvalue()


def main() -> int:
    session = Session()
    for block in json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")):
        try:
            session.run(block)
        except BaseException:
            print(f"{block['page']}, line {block['line']}:", file=sys.stderr)
            raise
    return 0


if __name__ == "__main__":
    sys.exit(main())
