# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of all commands that have workers."""

import argparse
import re

_SIZE = re.compile(r"(\d+(?:\.\d+)?)\s*([KMGT]?)(?:iB|B)?", re.IGNORECASE)
_UNITS = {"": 0, "K": 10, "M": 20, "G": 30, "T": 40}


def add_worker_arguments(parser: argparse.ArgumentParser, jobs: str, memory: str) -> None:
    """Adds --workers, --scheduler and --memory.

    Args:
        parser: of the command.
        jobs: what workers do, for the help.
        memory: what the memory is for.
    """
    where = parser.add_mutually_exclusive_group()
    where.add_argument(
        "--workers", type=count, metavar="N", help=f"{jobs} at a time. Default: as many as there are processors."
    )
    where.add_argument(
        "--scheduler", metavar="ADDRESS", help="use the workers of this Dask scheduler, such as tcp://host:8786"
    )
    parser.add_argument("--memory", type=_bytes, metavar="SIZE", help=f"{memory}, such as 4GiB. Default: 3/4 of all.")


def check_workers(workers: int | None, scheduler: str | None, progress: object) -> None:
    """Refuses keywords of functions that have workers.

    Raises:
        TypeError, ValueError: one is wrong.
    """
    if scheduler is not None and workers is not None:
        raise ValueError("workers and scheduler exclude each other: a scheduler has its own workers")
    if workers is not None and workers < 1:
        raise ValueError(f"workers = {workers} is not 1 or more")
    if progress is not None and progress is not True and not callable(progress):
        raise TypeError(f"progress must be a callable or True, not {type(progress).__name__}")


def count(text: str) -> int:
    """A number of one or more."""
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{text} is not 1 or more")
    return number


def bytes_of(text: str) -> int:
    """The number of bytes that a size with a unit means.

    Raises:
        ValueError: it is none.
    """
    found = _SIZE.fullmatch(text.strip())
    if not found or float(found[1]) == 0:
        raise ValueError(f"{text} is not a size such as 500MiB or 4GiB")
    return int(float(found[1]) * (1 << _UNITS[found[2].upper()]))


def _bytes(text: str) -> int:
    try:
        return bytes_of(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
