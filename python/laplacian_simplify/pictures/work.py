# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the process that draws does."""

import os
import warnings
from pathlib import Path
from typing import Any

from ..child import Stage
from ..comparison.distances import measure
from ..files.staging import write_staged
from .error_map import color_limit, error_map
from .outputs import VTK_WINDOW, off_screen_window
from .page import page_text
from .picture import Look, draw_picture
from .scene import Facts, Scene
from .view import view_of

_FACES_OF_PICTURE = 200_000
"""Up to which large faces are divided, so that colors show what is within them."""


def draw(
    stage: Stage,
    *,
    scene: str,
    facts: dict[str, Any],
    picture: str | None,
    page: str | None,
    samples: int,
    threads: int,
) -> None:
    """Draws.

    Args:
        stage: is told what is done.
        scene: the file with both surfaces.
        facts: what is written beside them.
        picture: the file to write, if there is to be one.
        page: the same.
        samples: points a side at which distances are taken.
        threads: 0 all.
    """
    stage("drawing")
    if VTK_WINDOW not in os.environ:
        os.environ[VTK_WINDOW] = off_screen_window()
        os.environ.pop("DISPLAY", None)  # not even a display that is there is used
    shown, about = Scene.load(Path(scene)), Facts(**facts)
    before, after = shown.before, shown.after
    found = measure(before, after, samples, threads)
    look = Look(view_of(before, after), color_limit(found, before.diagonal), before.diagonal)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of a letter that a font lacks
        png = draw_picture(shown, error_map(before, after, _FACES_OF_PICTURE, threads), about, look)
    if picture:
        write_staged(Path(picture), png, "the picture")
    if page:
        write_staged(Path(page), page_text(shown, found, about, look, png, threads), "the page")
