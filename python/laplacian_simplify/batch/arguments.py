# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of the command batch, but for those of simplify, which it has, too."""

import argparse
from typing import Any

from ..files.output_formats import OUTPUT_FORMATS
from ..workers.arguments import add_worker_arguments

SUMMARY = "Simplifies all meshes of a folder, or those that a pattern matches"
_DESCRIPTION = (
    SUMMARY + ", several at a time, and writes what became of each into the folder of the results. "
    "A mesh that is damaged, crashes or takes too long costs only itself. "
    "The same command again skips what is done."
)


def add_batch_parser(subparsers: Any, **options: Any) -> argparse.ArgumentParser:
    """The parser of the command, which still lacks the options of simplify. Options are those of argparse's parsers."""
    parser: argparse.ArgumentParser = subparsers.add_parser(
        "batch", help=SUMMARY + ".", description=_DESCRIPTION, allow_abbrev=False, **options
    )
    parser.add_argument("input", metavar="INPUT", help="folder, or pattern in quotes such as 'scans/**/*.ply'")
    parser.add_argument("output", metavar="OUTPUT_DIR", help="folder for the results and the manifest")
    parser.add_argument(
        "--format",
        choices=[row.extension for row in OUTPUT_FORMATS],
        help="format of the results. Default: that of each input, or ply where it cannot be written.",
    )
    add_worker_arguments(parser, "meshes", "for all meshes at work")
    parser.add_argument("--timeout", type=_seconds, default=600, metavar="X", help="seconds a mesh. Default: 600.")
    parser.add_argument("--retry-refused", action="store_true", help="try again what was refused before")
    parser.set_defaults(batch=True)
    return parser


def _seconds(text: str) -> float:
    number = float(text)
    if not 0 < number < 1e9:
        raise argparse.ArgumentTypeError(f"{text} is not a number of seconds above 0")
    return number
