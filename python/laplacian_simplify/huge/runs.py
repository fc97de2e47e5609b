# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""From a file to its simplification: what the command huge and simplify_huge do."""

import os
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from importlib.metadata import version
from pathlib import Path
from tempfile import TemporaryDirectory, TemporaryFile
from typing import TYPE_CHECKING, Any

from ..arrays import rounded
from ..files.errors import MeshFileError, printable
from ..files.staging import check_target, staged_output, unwritable
from ..report import StopReason
from ..running import checked
from ..tables import filter_named
from .arguments import PARAMETERS
from .array_file import ArrayFile
from .collapse import Engine
from .plan import Sizes, sizes_for
from .report import HugeReport, HugeRequest, Progress
from .source import Source, open_source
from .work_folder import SchedulerGoneError, WorkFolder

if TYPE_CHECKING:
    from .rounds import Aim, Simplified
    from .stages import Stages

_FILTER = "meshing_decimation_laplacian_quadric_edge_collapse"
_SAMPLES = 100_000
_BYTES_A_FACE = {True: 25, False: 31}
"""On the disk, by whether coordinates have single precision: chunks, which stay for the comparison, with pilots."""
_BYTES_A_FACE_LEFT = 2 * 34
"""Blocks of two rounds."""
_BYTES_OF_COLORS, _BYTES_OF_COLORS_LEFT = 3, 2 * 9
"""More of both where vertices have colors."""
_TABLES = 64 << 20
"""Bytes of tables of cells, of one round at a time."""


def simplify_file(request: HugeRequest, progress: Progress) -> HugeReport:
    """Simplifies a mesh that may be larger than memory.

    Raises:
        ValueError: arguments do not fit together.
        OSError: the mesh cannot be read or divided, nothing can be written, another run is at work in the folder, or
            the scheduler is missing or gone.
        KeyboardInterrupt: a signal came; what is done is kept.
    """
    started = time.monotonic(), time.process_time()
    source = open_source(request.source)
    if request.output.suffix.lower() != ".ply":
        raise ValueError(f"{printable(request.output)} is no PLY file, the one format that huge writes")
    _check_output(request.output)
    target = _target(request, source)
    with ExitStack() as stack:
        workers = stack.enter_context(_workers(request, stack))
        memory = request.memory or workers.memory_of_one
        sizes = sizes_for(memory, request.block_faces, colored=source.colors > 0)
        work = stack.enter_context(_work_folder(request, target, sizes))
        stack.enter_context(_without_leftovers(work))
        _check_room(work, source, sizes, target)
        from .stages import Stages

        stages = stack.enter_context(Stages(workers, work, memory, request.scheduler is None, progress))
        report = _Run(request, source, stages, _aim(request, target, sizes)).run(started)
        work.remove()
    return report


class _Run:
    def __init__(self, request: HugeRequest, source: Source, stages: "Stages", aim: "Aim") -> None:
        self._request, self._source, self._stages, self._aim = request, source, stages, aim
        self._chunk = request.chunk_faces or aim.sizes.block

    def run(self, started: tuple[float, float]) -> HugeReport:
        """Does it and returns the report. Started are the clock, and the processor's of this process."""
        from .comparison import Comparison, edges_after
        from .prepare import prepare
        from .rounds import Rounds

        mesh = prepare(self._stages, os.path.abspath(self._request.source), self._source, self._chunk)  # noqa: PTH100
        if mesh.faces == 0:
            raise MeshFileError(
                f"{printable(self._request.source)} cannot be used: each face has the same vertex at two corners"
            )
        rounds = Rounds(self._stages, mesh, self._aim)
        done = rounds.run()
        if done.rounds and self._aim.samples:
            comparison = Comparison(self._stages, mesh, self._aim, done, rounds.original_parts())
            measured: dict[str, Any] = {**comparison.edges(), **comparison.distances()}
        else:
            measured = edges_after(self._stages, done)
            names = ("hausdorff", "rms", "feature_rms", "boundary_edges_before", "non_manifold_edges_before")
            measured |= {name: done.report[name] for name in names if done.report and name in done.report}
        measured |= _crossings(done)
        written = self._write(done)
        seconds, peak = self._stages.took()
        return HugeReport(
            faces_before=self._source.faces,
            **written,
            target_reached=written["faces"] <= self._aim.target,
            stop_reason=self._stop_reason(done, written["faces"]),
            **measured,
            dropped_faces=mesh.dropped,
            rounds=[{name: value for name, value in row.items() if name != "files"} for row in done.rounds],
            processor_seconds=seconds | {"driver": time.process_time() - started[1]},
            peak_memory=peak,
            seconds=time.monotonic() - started[0],
            notes=[*self._source.notes, *self._doubts(done)],
        )

    def _doubts(self, done: "Simplified") -> list[str]:
        """Says which crossings nobody has counted."""
        if not self._aim.avoid_crossings or not done.rounds:
            return []
        if done.report is None:
            return ["the result was refined in blocks; faces of different blocks may cross, and were not counted"]
        crossing = done.report.get("self_intersections")
        if crossing is None:
            return ["the faces of the result that cross were not counted"]
        if crossing:
            return [f"{crossing:,} pairs of faces cross; how many did in the input was not counted"]
        return []

    def _stop_reason(self, done: "Simplified", faces: int) -> StopReason:
        if done.report is not None:
            return StopReason(done.report["stop_reason"])
        return StopReason.TARGET if faces <= self._aim.target else StopReason.NO_LEGAL_COLLAPSE

    def _write(self, done: "Simplified") -> dict[str, int]:
        """The result as a file; it appears whole or not at all."""
        from .plan import block_memory
        from .stages import Task

        files = [block["file"] for block in done.blocks]
        most = max(ArrayFile(self._stages.work.path / file).rows("triangles") for file in files)
        with staged_output(self._request.output, source=self._request.source) as staged:
            arguments = {
                "files": files,
                "output": str(staged),
                "shown": str(self._request.output),
                "single": self._source.single,
            }
            self._stages.work.forget("write.0")  # what a stopped run has written is gone
            (answer,) = self._stages.do("write", "write", [Task("write_mesh", arguments, block_memory(most))])
        return {name: answer[name] for name in ("vertices", "faces")}


def _crossings(done: "Simplified") -> dict[str, int]:
    """Of a last run that had what was left of rounds, those before are not the input's."""
    names = ("self_intersections",) if done.rounds else ("self_intersections", "self_intersections_before")
    return {name: done.report[name] for name in names if done.report and name in done.report}


def _check_output(output: Path) -> None:
    """Finds out before all the work whether the result can be written."""
    check_target(output)
    folder = Path(os.path.realpath(output)).parent
    try:
        with TemporaryFile(dir=folder):
            pass
    except OSError as error:
        raise unwritable(printable(output), error, folder) from None


def _target(request: HugeRequest, source: Source) -> int:
    values = request.values
    target = int(values.get("target_faces") or rounded(values["target_percent"] / 100 * source.faces))
    if target >= source.faces:
        raise ValueError(
            f"{printable(request.source)} has {source.faces:,} faces, which are not more than the {target:,} to keep"
        )
    return max(target, 1)


def _numbers(request: HugeRequest) -> dict[str, Any]:
    """The filter's parameters as numbers, with their defaults."""
    row = filter_named(_FILTER)
    given = checked(row, request.values)
    return {parameter.id: given.get(parameter.id, parameter.default) for parameter in row.parameters}


def _aim(request: HugeRequest, target: int, sizes: Sizes) -> "Aim":
    from .rounds import Aim

    numbers = _numbers(request)
    engine = Engine(
        numbers["feature_weight"],
        int(numbers["boundary"]),
        int(numbers["preserve_topology"]),
        keep_attributes=int(numbers["keep_attributes"]),
        attribute_weight=numbers["attribute_weight"],
    )
    return Aim(
        target,
        engine,
        int(numbers["effort"]),
        sizes,
        bool(numbers["avoid_self_intersections"]),
        _SAMPLES if numbers["measure_error"] else 0,
    )


def _workers(request: HugeRequest, stack: ExitStack) -> Any:
    try:
        from ..workers.cluster import local_workers, workers_of
    except ModuleNotFoundError as missing:
        raise ImportError(
            f"huge needs Dask, of which {missing.name} is not installed: "
            "python -m pip install 'laplacian-simplify[batch]'"
        ) from None
    scratch = stack.enter_context(TemporaryDirectory(prefix="laplacian-simplify-", ignore_cleanup_errors=True))
    return workers_of(request.scheduler) if request.scheduler else local_workers(request.workers, scratch)


def _work_folder(request: HugeRequest, target: int, sizes: Sizes) -> WorkFolder:
    output = Path(os.path.realpath(request.output))
    folder = request.work_folder or output.with_name(f".{output.name}.laplacian-simplify")
    numbers = _numbers(request)
    options = (name for name in PARAMETERS if not name.startswith("target"))
    state = {
        "version": version("laplacian-simplify"),
        "input": os.path.abspath(request.source),  # noqa: PTH100
        "size of the input": Path(request.source).stat().st_size,
        "target": target,
        **{name: numbers[name] for name in options},
        "faces of a block": sizes.block,
        "faces of the last run": sizes.last,
        "faces of a chunk": request.chunk_faces or sizes.block,
    }
    return WorkFolder(folder.absolute(), state)


@contextmanager
def _without_leftovers(work: WorkFolder) -> Iterator[None]:
    """Removes the folder of a run that is refused before there is anything to keep. Later a run with more memory is
    another one, for which the folder is in the way."""
    try:
        yield
    except SchedulerGoneError:
        raise
    except (ValueError, MeshFileError) as error:
        if work.get("checksums") is None:
            with suppress(OSError):
                work.remove()
        elif str(error).endswith("by --memory"):
            folder = printable(work.path)
            raise MeshFileError(f"{error}, and another --work-folder, or remove {folder}") from None
        raise


def _check_room(work: WorkFolder, source: Source, sizes: Sizes, target: int) -> None:
    """For what will be written before files can go."""
    if source.faces <= sizes.last:
        return
    left = max(target * 3, min(sizes.last, source.faces // 2))
    of_colors = (_BYTES_OF_COLORS, _BYTES_OF_COLORS_LEFT) if source.colors else (0, 0)
    a_face, a_face_left = _BYTES_A_FACE[source.single] + of_colors[0], _BYTES_A_FACE_LEFT + of_colors[1]
    work.check_room(source.faces * a_face + left * a_face_left + _TABLES)
