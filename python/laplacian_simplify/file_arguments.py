# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which files a command line names."""

import argparse
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from .files.errors import printable
from .files.source import STANDARD_INPUT
from .levels import output_names

STANDARD_OUTPUT = "-"


@dataclass(frozen=True)
class Files:
    """The files of one run."""

    input: str
    output: str
    json: str | None
    """Empty where the report goes to standard output or nowhere."""
    json_to_standard_output: bool
    output_name: str
    """Tells the format of the output."""

    @property
    def to_standard_output(self) -> bool:
        return self.output == STANDARD_OUTPUT

    @property
    def standard_output_is_taken(self) -> bool:
        return self.to_standard_output or self.json_to_standard_output

    @property
    def shown_input(self) -> str:
        return "standard input" if self.input == STANDARD_INPUT else printable(self.input)

    @property
    def shown_output(self) -> str:
        return "standard output" if self.to_standard_output else printable(self.output)


def files_of(options: argparse.Namespace) -> Files:
    """The files, none of which takes the place of another.

    Raises:
        ValueError: the arguments do not fit together.
    """
    output = _output(options)
    to_standard_output = options.json == STANDARD_OUTPUT
    if to_standard_output and output == STANDARD_OUTPUT:
        raise ValueError("OUTPUT and --json are both -, but there is one standard output")
    if options.json and not to_standard_output:
        check_report_name(options.json, output, options.input)
    name = f"mesh.{options.output_format or 'ply'}" if output == STANDARD_OUTPUT else output
    if options.output_format and output != STANDARD_OUTPUT:
        raise ValueError("--output-format is for standard output; the name of OUTPUT tells the format")
    return Files(options.input, output, None if to_standard_output else options.json, to_standard_output, name)


def check_report_name(report: str, output: str, source: str) -> None:
    """Refuses a report that would take the place of another file of the run.

    Raises:
        ValueError: it would.
    """
    check_apart("--json", report, {"OUTPUT": output, "INPUT": source})


def check_apart(option: str, path: str, others: Mapping[str, str]) -> None:
    """Refuses a file that would take the place of another file of the run.

    Args:
        option: that names the file.
        path: the file.
        others: the other files, by the names of their arguments.

    Raises:
        ValueError: it would.
    """
    for name, other in others.items():
        if other != STANDARD_OUTPUT and _same(path, other):
            raise ValueError(f"{option} {printable(path)} is the file of {name}, which it would replace")


def files_of_levels(options: argparse.Namespace, words: Sequence[str], field: str) -> list[Files]:
    """The files of every level, each with the same input and report.

    Args:
        words: what was typed for every level.
        field: of the pattern: percent or error.

    Raises:
        ValueError: the arguments do not fit together.
    """
    files = []
    for name in output_names(options.output, words, field):
        level = {**vars(options), "output": name, "in_place": False, "output_format": None}
        files.append(files_of(argparse.Namespace(**level)))
    return files


def _output(options: argparse.Namespace) -> str:
    if options.in_place and options.output is not None:
        raise ValueError("--in-place writes to INPUT; leave OUTPUT out")
    if options.in_place and options.input == STANDARD_INPUT:
        raise ValueError("--in-place needs a file as INPUT")
    if not options.in_place and options.output is None:
        raise ValueError("OUTPUT is missing; --in-place writes to INPUT")
    return str(options.input if options.in_place else options.output)


def _same(one: str, other: str) -> bool:
    """Whether two names are of one file, which need not be there yet."""
    if os.path.realpath(one) == os.path.realpath(other):
        return True
    try:
        return Path(one).samefile(other)
    except (OSError, ValueError):
        return False
