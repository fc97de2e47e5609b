# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command compare, and what it shows. Exit codes are those of simplify."""

import argparse
import json
from contextlib import ExitStack
from importlib.metadata import version
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from ..file_arguments import STANDARD_OUTPUT, check_apart
from ..files.errors import printable
from ..files.source import STANDARD_INPUT, scratch_named
from ..files.staging import staged_output, write_staged
from ..following import in_a_process
from ..pictures.outputs import DRAW, Outputs, drawing
from ..pictures.scene import Facts
from ..streams import say, show, write_out
from .api import checked
from .report import LENGTHS, UNIT


def run_compare(options: argparse.Namespace) -> int:
    """Runs it and returns the exit code.

    Raises:
        ValueError: the arguments do not fit together.
        OSError, RuntimeError, ImportError: as api.compare.
    """
    samples, threads = checked(options.samples, options.threads)
    inputs = {"A": options.input, "B": options.other}
    if options.input == options.other == STANDARD_INPUT:
        raise ValueError("A and B are both -, but there is one standard input")
    to_file = options.json not in (None, STANDARD_OUTPUT)
    if to_file:
        check_apart("--json", options.json, inputs)
    outputs = Outputs(options.picture, options.report)
    outputs.check({**inputs, "--json": options.json if to_file else STANDARD_OUTPUT})
    shown = [printable(path) if path != STANDARD_INPUT else "standard input" for path in inputs.values()]
    arguments = {"a": options.input, "b": options.other, "samples": samples, "threads": threads}
    with ExitStack() as stack:
        staged_report = stack.enter_context(staged_output(options.json)) if to_file else None
        staged = stack.enter_context(outputs.staged())
        with scratch_named(shown[0]):
            scratch = stack.enter_context(TemporaryDirectory(prefix="laplacian-simplify-", ignore_cleanup_errors=True))
        scene = Path(scratch) / "scene.npz"
        arguments |= {"scene": str(scene) if outputs else None, "shown_source": f"{shown[0]} or {shown[1]}"}
        answer = in_a_process(arguments, scratch, "comparison.work:compare", quiet=options.quiet)
        if outputs:
            job = drawing(scene, Facts(**answer["facts"]), staged, samples, threads)
            in_a_process(job, scratch, DRAW, quiet=options.quiet, drawn=outputs.shown)
        text = _json(answer["report"], shown, samples)
        if staged_report:
            write_staged(staged_report, text, printable(options.json))
    if not options.quiet:
        title = f"{shown[0]} | {shown[1]} in {answer['report']['seconds']:.2f} s"
        (say if options.json == STANDARD_OUTPUT else show)("\n".join([title, *answer["lines"]]))
    if options.json == STANDARD_OUTPUT:
        write_out(text.encode())
    return 0


def _json(report: dict[str, Any], shown: list[str], samples: int) -> str:
    about = {
        "input": shown,
        "parameters": {"samples": samples},
        "units": {name: UNIT for name in LENGTHS if name in report},
        "version": version("laplacian-simplify"),
    }
    return json.dumps({**report, **about}, indent=2) + "\n"
