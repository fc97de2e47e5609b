# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command batch, and what it shows.

Exit codes: 0 every mesh has its result; 3 some were refused or crashed; 1, 2 and 130 as for the other commands.
"""

import argparse
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from ..files.errors import printable
from ..following import bar_of_steps, on_a_terminal
from ..streams import say, show
from ..summary import missed
from .manifest import MANIFEST
from .runs import BatchReport, BatchRequest, Finished, simplify_folder

SOME_FAILED = 3
_MOST_SHOWN = 20


def run_batch(options: argparse.Namespace, values: Mapping[str, Any]) -> int:
    """Runs it and returns the exit code; errors as simplify_folder."""
    request = BatchRequest(
        source=options.input,
        output=Path(options.output),
        values=values,
        output_format=options.format,
        workers=options.workers,
        scheduler=options.scheduler,
        memory=options.memory,
        seconds=options.timeout,
        retry_refused=options.retry_refused,
    )
    with progress() as (began, finished):
        report = simplify_folder(request, began, finished)
    show("\n".join(table(report, request.output)))
    return 0 if report.all_done else SOME_FAILED


@contextmanager
def progress() -> Iterator[tuple[Any, Finished]]:
    """Shows how far a run is where standard error is a terminal."""
    if not on_a_terminal():
        yield lambda *_: None, lambda *_: None
        return
    bars: list[Any] = []
    failed = 0

    def began(meshes: int, dashboard: str) -> None:
        if dashboard:
            say(f"laplacian-simplify: the work is shown at {dashboard}")
        bars.append(bar_of_steps(total=meshes, unit=" meshes", dynamic_ncols=True))

    def finished(row: Mapping[str, Any]) -> None:
        nonlocal failed
        if row["status"] != "done":
            failed += 1
            bars[0].set_postfix_str(f"{failed} failed", refresh=False)
        bars[0].update()

    try:
        yield began, finished
    finally:
        for bar in bars:
            bar.close()


def table(report: BatchReport, output: Path) -> list[str]:
    """The outcome for people: counts, and why meshes have no result."""
    counts = [(status, report.count(status)) for status in ("done", "refused", "crashed")]
    lines = [f"{status:<9} {count:>9,}" for status, count in (*counts, ("skipped", len(report.skipped)))]
    done = [row["report"] for row in report.meshes if row["status"] == "done"]
    if done:
        before, after = (sum(row[key] for row in done) for key in ("faces_before", "faces"))
        lines[0] += f"   {before:,} -> {after:,} faces in {sum(row['seconds'] for row in done):.1f} s of work"
        short = sum(missed(row) for row in done)
        lines[0] += f", target NOT reached by {short:,}" if short else ""
    failed = [row for row in (*report.meshes, *report.skipped) if row["status"] != "done"]
    lines += [f"{row['status']}: {_sentence(row)}" for row in failed[:_MOST_SHOWN]]
    if len(failed) > _MOST_SHOWN:
        lines.append(f"and {len(failed) - _MOST_SHOWN:,} more, see {printable(output / MANIFEST)}")
    return lines


def _sentence(row: Mapping[str, Any]) -> str:
    name, reason = printable(row["input"]), printable(row["reason"])
    return reason if reason.startswith(name) else f"{name}: {reason}"
