# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of the command batch, but for those of simplify, which it has, too."""

import argparse
import re
from typing import Any

from ..files.output_formats import OUTPUT_FORMATS

SUMMARY = "Simplifies all meshes of a folder, or those that a pattern matches"
_DESCRIPTION = (
    SUMMARY + ", several at a time, and writes what became of each into the folder of the results. "
    "A mesh that is damaged, crashes or takes too long costs only itself. "
    "The same command again skips what is done."
)
_SIZE = re.compile(r"(\d+(?:\.\d+)?)\s*([KMGT]?)(?:iB|B)?", re.IGNORECASE)
_UNITS = {"": 0, "K": 10, "M": 20, "G": 30, "T": 40}


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
    where = parser.add_mutually_exclusive_group()
    where.add_argument(
        "--workers", type=_count, metavar="N", help="meshes at a time. Default: as many as there are processors."
    )
    where.add_argument(
        "--scheduler", metavar="ADDRESS", help="use the workers of this Dask scheduler, such as tcp://host:8786"
    )
    parser.add_argument(
        "--memory", type=_bytes, metavar="SIZE", help="for all meshes at work, such as 4GiB. Default: 3/4 of all."
    )
    parser.add_argument("--timeout", type=_seconds, default=600, metavar="X", help="seconds a mesh. Default: 600.")
    parser.add_argument("--retry-refused", action="store_true", help="try again what was refused before")
    parser.set_defaults(batch=True)
    return parser


def _count(text: str) -> int:
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{text} is not 1 or more")
    return number


def _bytes(text: str) -> int:
    try:
        return bytes_of(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def bytes_of(text: str) -> int:
    """The number of bytes that a size with a unit means.

    Raises:
        ValueError: it is none.
    """
    found = _SIZE.fullmatch(text.strip())
    if not found or float(found[1]) == 0:
        raise ValueError(f"{text} is not a size such as 500MiB or 4GiB")
    return int(float(found[1]) * (1 << _UNITS[found[2].upper()]))


def _seconds(text: str) -> float:
    number = float(text)
    if not 0 < number < 1e9:
        raise argparse.ArgumentTypeError(f"{text} is not a number of seconds above 0")
    return number
