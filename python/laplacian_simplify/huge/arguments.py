# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of the command huge, but for those of simplify that it has, too."""

import argparse
from typing import Any

from ..workers.arguments import add_worker_arguments, count

SUMMARY = "Simplifies one mesh that is larger than memory"
_DESCRIPTION = (
    SUMMARY + ": a binary PLY or STL file is divided into blocks on the disk, which several workers simplify. "
    "The same command goes on where it was stopped. The result is a binary PLY file."
)
PARAMETERS = (
    "target_faces",
    "target_percent",
    "feature_weight",
    "effort",
    "boundary",
    "keep_attributes",
    "attribute_weight",
    "preserve_topology",
    "avoid_self_intersections",
    "measure_error",
)
"""Of simplify."""


def add_huge_parser(subparsers: Any) -> argparse.ArgumentParser:
    """The parser of the command, which still lacks the options of simplify."""
    parser: argparse.ArgumentParser = subparsers.add_parser(
        "huge", help=SUMMARY + ".", description=_DESCRIPTION, allow_abbrev=False
    )
    parser.add_argument("input", metavar="INPUT", help="binary PLY or STL")
    parser.add_argument("output", metavar="OUTPUT", help="PLY file")
    add_worker_arguments(parser, "blocks", "for all processes")
    parser.add_argument(
        "--work-folder",
        metavar="DIR",
        help="where parts of the mesh are kept until the end. Default: a folder beside OUTPUT.",
    )
    parser.add_argument("--json", metavar="REPORT", help="write the report as JSON to this file, - for standard output")
    parser.add_argument("--block-faces", type=count, metavar="N", help=argparse.SUPPRESS)  # in place of the memory
    parser.add_argument("--chunk-faces", type=count, metavar="N", help=argparse.SUPPRESS)
    parser.set_defaults(huge=True)
    return parser
