# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One huge mesh from Python."""

import os
from pathlib import Path
from typing import TYPE_CHECKING, Literal, TypedDict

from ..running import with_one_target
from ..simplification import Boundary, Effort
from ..workers.arguments import bytes_of, check_workers
from .command import shown_progress
from .report import HugeReport, HugeRequest, Progress
from .runs import simplify_file

if TYPE_CHECKING:
    from typing_extensions import Unpack  # in typing from Python 3.11 on


class HugeOptions(TypedDict, total=False):
    """The keywords of simplify that huge meshes have."""

    target_faces: int | None
    target_percent: float | None
    feature_weight: float | None
    effort: Effort | int | None
    boundary: Boundary | int | None
    keep_attributes: bool | None
    attribute_weight: float | None
    preserve_topology: bool | None
    avoid_self_intersections: bool | None
    measure_error: bool | None


def simplify_huge(
    source: str | os.PathLike[str],
    output: str | os.PathLike[str],
    *,
    workers: int | None = None,
    scheduler: str | None = None,
    memory: int | str | None = None,
    work_folder: str | os.PathLike[str] | None = None,
    block_faces: int | None = None,
    progress: Progress | Literal[True] | None = None,
    **options: "Unpack[HugeOptions]",
) -> HugeReport:
    """Simplifies one mesh that is larger than memory; needs ``pip install laplacian-simplify[batch]``.

    >>> report = ls.simplify_huge("city.ply", "small.ply", target_percent=2, memory="8GiB")

    The same call goes on where it was stopped. Its bytes are the same for any number of workers.

    Args:
        source: binary PLY or STL.
        output: PLY.
        workers: blocks at a time; otherwise as many as there are processors.
        scheduler: address of a Dask scheduler whose workers do the blocks.
        memory: bytes for all processes, or a text such as ``"4GiB"``; 3/4 of all by default. With a scheduler those
            for each.
        work_folder: where parts of the mesh are kept until the end; otherwise a folder beside the output.
        block_faces: of a block, in place of what the memory allows; the last run has at most four times as many.
        progress: called with a stage, tasks that are done, and tasks in all; True shows a bar on a terminal.
        options: keywords of simplify; target_percent or target_faces has to be given.

    Raises:
        TypeError, ValueError: an argument is wrong.
        OSError: the mesh cannot be read or divided, nothing can be written, another run is at work in the folder, or
            the scheduler is missing or gone.
        ImportError: Dask is not installed.
    """
    unknown = sorted(set(options) - set(HugeOptions.__annotations__))
    if unknown:
        raise TypeError(f"simplify_huge has no keyword '{unknown[0]}'")
    check_workers(workers, scheduler, progress)
    if block_faces is not None and block_faces < 1:
        raise ValueError(f"block_faces = {block_faces} is not 1 or more")
    request = HugeRequest(
        source=os.fspath(source),
        output=Path(output),
        values=with_one_target("meshing_decimation_laplacian_quadric_edge_collapse", options),
        workers=workers,
        scheduler=scheduler,
        memory=bytes_of(memory) if isinstance(memory, str) else memory,
        work_folder=Path(work_folder) if work_folder is not None else None,
        block_faces=block_faces,
    )
    if progress is True:
        with shown_progress() as step:
            return simplify_file(request, step)
    return simplify_file(request, progress or (lambda *_: None))
