# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many meshes from Python."""

import os
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from ..files.output_formats import OUTPUT_FORMATS
from ..running import with_one_target
from ..simplification import FileOptions
from ..workers.arguments import bytes_of, check_workers
from .command import progress as shown_progress
from .runs import BatchReport, BatchRequest, Finished, simplify_folder

if TYPE_CHECKING:
    from typing_extensions import Unpack  # in typing from Python 3.11 on


def simplify_many(
    source: str | os.PathLike[str],
    output: str | os.PathLike[str],
    *,
    output_format: str | None = None,
    workers: int | None = None,
    scheduler: str | None = None,
    memory: int | str | None = None,
    timeout: float = 600,
    retry_refused: bool = False,
    progress: Finished | Literal[True] | None = None,
    **options: "Unpack[FileOptions]",
) -> BatchReport:
    """Simplifies all meshes of a folder, several at a time; needs ``pip install laplacian-simplify[batch]``.

    >>> report = ls.simplify_many("scans", "small", target_percent=10)
    >>> print(report)
    980 done, 20 refused, 0 crashed, 0 skipped

    A mesh that is damaged, crashes or takes too long costs only itself. The same call again skips what is done.

    Args:
        source: a folder, with those below it, or a pattern such as ``scans/**/*.ply``.
        output: folder for the results, which lie there as the meshes lie in theirs, and for the manifest
            ``laplacian-simplify.jsonl``.
        output_format: such as ``ply``; otherwise that of each input, or PLY where it cannot be written.
        workers: meshes at a time; otherwise as many as there are processors.
        scheduler: address of a Dask scheduler whose workers do the meshes.
        memory: bytes for all meshes at work, or a text such as ``"4GiB"``; 3/4 of all by default.
        timeout: seconds a mesh.
        retry_refused: try again what was refused before.
        progress: called with the line of the manifest of each mesh that has ended; True shows a bar on a terminal.
        options: keywords of simplify for files; target_percent, target_faces or max_error has to be given.

    Raises:
        TypeError, ValueError: an argument is wrong, or there are no meshes.
        OSError: nothing can be written, another run writes there, or the scheduler is missing or gone.
        ImportError: Dask is not installed.
    """
    unknown = sorted(set(options) - set(FileOptions.__annotations__))
    if unknown:
        raise TypeError(f"simplify_many has no keyword '{unknown[0]}'")
    values = with_one_target("meshing_decimation_laplacian_quadric_edge_collapse", options)
    check_workers(workers, scheduler, progress)
    if not timeout > 0:
        raise ValueError(f"timeout = {timeout} is not above 0")
    formats = [row.extension for row in OUTPUT_FORMATS]
    if output_format is not None and output_format not in formats:
        raise ValueError(f"output_format = {output_format} is not one of {', '.join(formats)}")
    request = BatchRequest(
        source=os.fspath(source),
        output=Path(output),
        values=values,
        output_format=output_format,
        workers=workers,
        scheduler=scheduler,
        memory=bytes_of(memory) if isinstance(memory, str) else memory,
        seconds=timeout,
        retry_refused=retry_refused,
    )
    if progress is True:
        with shown_progress() as (began, finished):
            return simplify_folder(request, began, finished)
    return simplify_folder(request, lambda *_: None, progress or (lambda _: None))
