# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of the command compare."""

import argparse
from typing import Any

from ..pictures.arguments import add_picture_arguments

SUMMARY = "Measures how far two meshes are apart, whatever made them"
_DESCRIPTION = (
    SUMMARY + ": the distances from each surface to the\n"
    "other, in percent of the diagonal of the bounding box of A and in the meshes' units.\n"
    "They are taken at points spread evenly by area and at all vertices, where they are\n"
    "exact; --samples says at how many points."
)
SAMPLES = 100_000
"""Points a side beside the vertices: the most that simplify takes."""


def add_compare_parser(subparsers: Any, **common: Any) -> argparse.ArgumentParser:
    """The parser of the command."""
    parser: argparse.ArgumentParser = subparsers.add_parser(
        "compare", help=SUMMARY + ".", description=_DESCRIPTION, allow_abbrev=False, **common
    )
    parser.add_argument("input", metavar="A", help="mesh file, also as .gz; - for standard input")
    parser.add_argument("other", metavar="B", help="the same; it may be of another format")
    parser.add_argument("--json", metavar="REPORT", help="write the report as JSON to this file, - for standard output")
    add_picture_arguments(parser, "both meshes")
    parser.add_argument(
        "-q", "--quiet", action="store_true", help="show neither report nor progress, only what is wrong"
    )
    parser.add_argument(
        "--samples",
        type=int,
        default=SAMPLES,
        metavar="N",
        help=f"points a side beside the vertices. Default: {SAMPLES}.",
    )
    parser.add_argument("--threads", type=int, default=0, metavar="N", help="0: all processors. Default: 0.")
    return parser
