# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command huge, and what it shows. Exit codes are those of simplify."""

import argparse
import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from ..file_arguments import check_report_name
from ..files.errors import printable
from ..files.staging import check_target, staged_output, write_staged
from ..following import bar_of_steps, on_a_terminal
from ..options import as_option
from ..streams import say, show, write_out
from .report import HugeReport, HugeRequest
from .runs import simplify_file


def run_huge(options: argparse.Namespace, values: Mapping[str, Any]) -> int:
    """Runs it and returns the exit code; errors as simplify_file."""
    request = HugeRequest(
        source=options.input,
        output=Path(options.output),
        values=values,
        workers=options.workers,
        scheduler=options.scheduler,
        memory=options.memory,
        work_folder=Path(options.work_folder) if options.work_folder else None,
        block_faces=options.block_faces,
        chunk_faces=options.chunk_faces,
    )
    if options.json and options.json != "-":
        _check_report(options)
    with shown_progress() as progress:
        report = simplify_file(request, progress)
    _show(options, report)
    return 0


def _check_report(options: argparse.Namespace) -> None:
    """Finds out before all the work whether the report can be written."""
    check_target(options.json)
    check_report_name(options.json, options.output, options.input)


def _show(options: argparse.Namespace, report: HugeReport) -> None:
    text = json.dumps(report.to_dict(), indent=2) + "\n"
    for note in report.notes:
        say(f"laplacian-simplify: note: {printable(note)}")
    title = f"{printable(options.input)} -> {printable(options.output)} in {report.seconds:.1f} s"
    (say if options.json == "-" else show)(f"{title}\n{report.text(as_option)}")
    if options.json == "-":
        write_out(text.encode())
    elif options.json:
        with staged_output(options.json) as staged:
            write_staged(staged, text, printable(options.json))


@contextmanager
def shown_progress() -> Iterator[Any]:
    """Shows how far a run is where standard error is a terminal."""
    if not on_a_terminal():
        yield lambda *_: None
        return
    with bar_of_steps(bar_format="{desc:<12}{bar} {n_fmt}/{total_fmt}") as bar:

        def step(stage: str, done: int, total: int) -> None:
            bar.total = total
            bar.set_description_str(stage, refresh=False)
            bar.n = done
            bar.refresh()

        yield step
