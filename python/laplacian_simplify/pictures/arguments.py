# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments for a picture and a page."""

import argparse


def add_picture_arguments(parser: argparse.ArgumentParser, what: str) -> None:
    """
    Args:
        parser: of a command.
        what: the pictures show.
    """
    needs = "needs laplacian-simplify[pictures]"
    parser.add_argument(
        "--picture", metavar="PNG", help=f"draw {what}, and the distance as colors, as this PNG file; {needs}"
    )
    parser.add_argument(
        "--report",
        metavar="HTML",
        help=f"write one page with the same, a viewer that turns, a histogram and all numbers to this file; {needs}",
    )
