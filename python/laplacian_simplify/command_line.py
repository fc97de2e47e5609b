# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command laplacian-simplify: a mesh file in, a mesh file out, a report.

Exit codes: 0 done, also when a target could not be reached; 1 the input or the output could not be read or
written; 2 wrong arguments.
"""

import argparse
import json
import sys
from collections.abc import Mapping
from contextlib import AbstractContextManager, nullcontext
from functools import partial
from importlib.metadata import version
from pathlib import Path
from typing import Any

from tqdm import tqdm

from .mesh_reading import read_mesh
from .mesh_writing import check_format, save_checked, staged_output
from .options import SHORT_NAMES, WITHOUT_OPTION, Command, make_parser
from .plugin import load
from .running import checked
from .summary import summary
from .worker import run_in_worker, signals_held

STOPPED = 130
"""Exit code of a run that a signal ended, as shells have it."""


def main(arguments: list[str] | None = None) -> int:
    """Runs the command and returns its exit code."""
    options = make_parser(version("laplacian-simplify")).parse_args(arguments)
    code = STOPPED
    try:
        with signals_held():
            code = _main(options)
    except KeyboardInterrupt:
        pass  # it came when all was done
    return code


def _main(options: argparse.Namespace) -> int:
    command: Command = options.command
    try:
        values = _values(command, options)
        report = _run(command, options, values)
        _show(options, report)
    except ValueError as error:
        return _fail(2, _with_option_name(str(error)))
    except KeyboardInterrupt:
        return _fail(STOPPED, "stopped; nothing was written")
    except (OSError, RuntimeError, ImportError) as error:
        return _fail(1, str(error))
    return 0


def _values(command: Command, options: argparse.Namespace) -> dict[str, Any]:
    """The parameters that were given, all of them in their range."""
    names = [row.id for row in command.filter.parameters if row.id not in WITHOUT_OPTION]
    values = {name: getattr(options, name) for name in names if getattr(options, name) is not None}
    percent = values.get("target_percent", 100)
    if not 0 < percent <= 100:  # 0 would tell the filter to use target_faces
        raise ValueError(f"target_percent = {percent:g} is outside (0, 100] (percent of the faces)")
    checked(command.filter, values)
    return values


def _run(command: Command, options: argparse.Namespace, values: Mapping[str, Any]) -> dict[str, Any]:
    """Reads, filters and writes in a worker process; the files appear when all of it went well."""
    with (
        _staged_report(options.json) as staged_report,
        staged_output(options.output, source=options.input) as staged,
        tqdm(total=100, disable=None, leave=False, bar_format="{desc:<20}{bar} {n:.0f} %") as bar,
    ):

        def show(percent: int, stage: str) -> None:
            if percent < 100:  # then only the filter's name follows
                bar.set_description_str(stage, refresh=False)
            bar.update(percent - bar.n)

        job = partial(_work, command, options.input, options.output, staged, values)
        report: dict[str, Any] = run_in_worker(job, show)
        if staged_report:
            staged_report.write_text(json.dumps(report, indent=2) + "\n", encoding="utf-8")
    return report


def _staged_report(path: str | None) -> AbstractContextManager[Path | None]:
    return nullcontext() if path in (None, "-") else staged_output(str(path))


def _work(command: Command, source: str, target: str, staged: Path, values: Mapping[str, Any]) -> dict[str, Any]:
    """What the worker process does."""
    check_format(staged, shown=target)
    mesh_set = read_mesh(source)
    load()
    mesh_set.set_verbosity(True)  # then progress is written, which the command follows
    report = command.function(mesh_set, **values)
    mesh_set.set_verbosity(False)
    save_checked(mesh_set, staged, shown=target)
    return report.to_dict()


def _show(options: argparse.Namespace, report: Mapping[str, Any]) -> None:
    """The report for people, and as JSON where standard output was asked for."""
    if options.command.stores_quality and Path(options.output).suffix.lower() != ".ply":
        print("laplacian-simplify: note: the result is in the vertex quality, which only PLY keeps", file=sys.stderr)
    text = summary(options.input, options.output, report)
    print(text, file=sys.stderr if options.json == "-" else sys.stdout)
    if options.json == "-":
        print(json.dumps(report, indent=2))


def _with_option_name(message: str) -> str:
    """A parameter's sentence with the option's name, as the user typed it."""
    name, equals, rest = message.partition(" = ")
    if not equals:
        return message
    return f"{SHORT_NAMES.get(name, '--' + name.replace('_', '-'))} {rest}"


def _fail(code: int, message: str) -> int:
    print(f"laplacian-simplify: error: {' '.join(message.split())}", file=sys.stderr)
    return code
