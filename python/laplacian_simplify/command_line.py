# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command laplacian-simplify: a mesh file in, a mesh file out, a report.

Exit codes: 0 done, also when a target could not be reached; 1 the input or the output could not be read or
written; 2 wrong arguments; 4 with --strict a target could not be reached. Those of batch are in its own module.
"""

import argparse
import json
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

from .answers import fraction_note, why_missed
from .error_bound import error_bounds
from .file_arguments import STANDARD_OUTPUT, Files, files_of, files_of_levels
from .files.errors import printable
from .files.output_formats import output_format
from .files.source import scratch_named
from .files.staging import check_target, staged_output, write_staged
from .following import in_a_process
from .options import SHORT_NAMES, WITHOUT_OPTION, Command, as_option, make_parser
from .pictures.outputs import DRAW, Outputs, drawing
from .report_file import report_of, report_text
from .running import checked
from .signals import signals_held
from .streams import say, show, write_out
from .summary import missed, summary, summary_lines

if TYPE_CHECKING:
    from .pictures.scene import Facts

STOPPED = 130
"""Exit code of a run that a signal ended, as shells have it."""
MISSED = 4
"""Exit code where a target that has to be reached is not."""
_KEPT = "what is done is kept, and the same command goes on"


class MissedTargetError(Exception):
    """The target was not reached, which is an error here."""


def main(arguments: list[str] | None = None) -> int:
    """Runs the command and returns its exit code."""
    code = STOPPED
    try:
        with signals_held():
            code = _main(make_parser().parse_args(arguments))
    except KeyboardInterrupt:
        pass  # it came when all was done
    return code


def _main(options: argparse.Namespace) -> int:
    command: Command = options.command
    try:
        if options.compare:
            from .comparison.command import run_compare

            return run_compare(options)
        values = _values(command, options)
        if note := fraction_note(values.get("target_percent", 0), as_option):
            say(f"laplacian-simplify: warning: {note}")
        if options.batch:
            from .batch.command import run_batch

            return run_batch(options, values)
        if options.huge:
            from .huge.command import run_huge

            return run_huge(options, values)
        if command.has_levels:
            return _levels(command, options, values)
        files = files_of(options)
        outputs = _outputs(options, files)
        answer = _run(command, files, outputs, values, options)
        _show(command, files, answer, quiet=options.quiet)
    except ValueError as error:
        return _fail(2, _with_option_name(str(error)))
    except KeyboardInterrupt:
        return _fail(STOPPED, "stopped; " + (_KEPT if options.batch or options.huge else "nothing was written"))
    except MissedTargetError as error:
        return _fail(MISSED, f"{error}; nothing was written")
    except (OSError, RuntimeError, ImportError) as error:
        return _fail(1, str(error))
    except MemoryError:
        return _fail(1, f"{printable(options.input)} cannot be worked on: there is not enough memory")
    return 0


def _values(command: Command, options: argparse.Namespace) -> dict[str, Any]:
    """The parameters that were given, all of them in their range."""
    names = [row.id for row in command.filter.parameters if row.id not in WITHOUT_OPTION]
    values = {name: getattr(options, name) for name in names if getattr(options, name, None) is not None}
    bound: dict[str, Any] = values.pop("max_error", {})  # a length is checked once the mesh is known
    may_lack_a_target = command.has_levels or not command.filter.has("max_error")
    if not may_lack_a_target and not bound and not SHORT_NAMES.keys() & values.keys():
        raise ValueError("one of the arguments --faces --percent --max-error is required")
    if bound.get("max_error") == 0:
        raise ValueError("max_error = 0 is outside (0, 100] (percent of the bounding box diagonal)")
    values |= {name: value for name, value in bound.items() if name == "max_error"}
    percent = values.get("target_percent", 100)
    if not 0 < percent <= 100:  # 0 would tell the filter to use target_faces
        raise ValueError(f"target_percent = {percent:g} is outside (0, 100] (percent of the faces)")
    if "max_errors" in values:
        bound["max_errors"] = error_bounds(values.pop("max_errors"))
    checked(command.filter, values)
    return values | bound


def _outputs(options: argparse.Namespace, files: Files) -> Outputs:
    """The picture and the page, which can be written; commands without the options have neither."""
    outputs = Outputs(getattr(options, "picture", None), getattr(options, "report", None))
    outputs.check({"OUTPUT": files.output, "INPUT": files.input, "--json": files.json or STANDARD_OUTPUT})
    return outputs


def _run(
    command: Command, files: Files, outputs: Outputs, values: Mapping[str, Any], options: argparse.Namespace
) -> dict[str, Any]:
    """Reads, filters and writes in a process of its own; the files appear when all of it went well. The answer has the
    report also as the text of a file."""
    if not files.to_standard_output:
        check_target(files.output)
    output_format(files.output_name)
    with ExitStack() as stack:
        staged_report = stack.enter_context(staged_output(files.json)) if files.json else None
        drawn = stack.enter_context(outputs.staged())
        staged = stack.enter_context(_staged(files))
        arguments = {
            "function": command.function.__name__,
            "source": files.input,
            "staged": str(staged),
            "shown_source": files.shown_input,
            "shown_target": files.shown_output,
            "values": dict(values),
        }
        with scratch_named(files.shown_input):
            scratch = stack.enter_context(TemporaryDirectory(prefix="laplacian-simplify-", ignore_cleanup_errors=True))
        scene = Path(scratch) / "scene.npz"
        for_drawing = {"scene": str(scene)} if outputs else {}
        answer = in_a_process({**arguments, **for_drawing}, scratch, quiet=options.quiet)
        report = answer["report"]
        if getattr(options, "strict", False) and missed(report):
            raise MissedTargetError(f"{files.shown_input}: target not reached: {why_missed(report, as_option)}")
        answer["text"] = report_text(command.filter, report, values, files.shown_input, files.shown_output)
        if outputs:
            facts = _facts(report, json.loads(answer["text"])["parameters"])
            outputs.check_apart(_textures(files, answer["textures"]))
            job = drawing(scene, facts, drawn, threads=values.get("threads", 0))
            in_a_process(job, scratch, DRAW, quiet=options.quiet, drawn=outputs.shown)
        if staged_report:
            write_staged(staged_report, answer["text"], printable(str(files.json)))
    return answer


def _textures(files: Files, names: list[str]) -> dict[str, str]:
    """Where the textures of the input are, and those of the output will be, by what messages call them."""
    folders = [Path(path).parent for path in (files.input, files.output)]
    return {f"the texture {folder / name}": str(folder / name) for folder in folders for name in names}


def _facts(report: Mapping[str, Any], parameters: Mapping[str, Any]) -> "Facts":
    """What is written beside the picture."""
    from .pictures.scene import Facts

    return Facts.of_run(summary_lines(report, as_option), report, parameters)


def _levels(command: Command, options: argparse.Namespace, values: Mapping[str, Any]) -> int:
    """The same with a file for every level: all are written before the first one appears."""
    field, text = ("percent", options.percents) if options.percents is not None else ("error", options.max_errors)
    files = files_of_levels(options, [word.strip() for word in text.split(",")], field)
    for level in files:
        check_target(level.output)
        output_format(level.output_name)
    first = files[0]
    with ExitStack() as stack:
        staged_report = stack.enter_context(staged_output(first.json)) if first.json else None
        staged = [stack.enter_context(_staged(level)) for level in files]
        arguments = {
            "function": command.function.__name__,
            "source": first.input,
            "staged": [str(path) for path in staged],
            "shown_source": first.shown_input,
            "shown_targets": [level.shown_output for level in files],
            "values": dict(values),
        }
        with scratch_named(first.shown_input):
            scratch = stack.enter_context(TemporaryDirectory(prefix="laplacian-simplify-", ignore_cleanup_errors=True))
        answer = in_a_process(arguments, scratch, "work:run_levels", quiet=options.quiet)
        reports = [
            report_of(command.filter, report, values, level.shown_input, level.shown_output)
            for level, report in zip(files, answer["report"], strict=True)
        ]
        text = json.dumps(reports, indent=2) + "\n"
        if staged_report:
            write_staged(staged_report, text, printable(str(first.json)))
    for note in answer["notes"]:
        say(f"laplacian-simplify: note: {note}")
    if not options.quiet:
        for level, report in zip(files, answer["report"], strict=True):
            lines = summary(level.shown_input, level.shown_output, report, as_option)
            (say if level.standard_output_is_taken else show)(lines)
    if first.json_to_standard_output:
        write_out(text.encode())
    return 0


@contextmanager
def _staged(files: Files) -> Iterator[Path]:
    """Where the mesh is written before it goes to its file or to standard output."""
    if not files.to_standard_output:
        with staged_output(files.output, source=files.input) as staged:
            yield staged
        return
    with TemporaryDirectory(prefix="laplacian-simplify-") as folder:
        staged = Path(folder) / files.output_name
        yield staged
        write_out(staged.read_bytes())


def _show(command: Command, files: Files, answer: Mapping[str, Any], *, quiet: bool) -> None:
    """Notes, the report for people, and as JSON where standard output was asked for."""
    stores_quality = command.stores_quality and Path(files.output_name).suffix.lower() != ".ply"
    if stores_quality:
        say("laplacian-simplify: note: the result is in the vertex quality, which only PLY keeps")
    for note in answer["notes"]:
        if not (stores_quality and note.endswith("does not keep vertex quality; PLY keeps all")):
            say(f"laplacian-simplify: note: {note}")
    if not quiet:
        text = summary(files.shown_input, files.shown_output, answer["report"], as_option)
        (say if files.standard_output_is_taken else show)(text)
    if files.json_to_standard_output:
        write_out(answer["text"].encode())


def _with_option_name(message: str) -> str:
    """A parameter's sentence with the option's name, as the user typed it."""
    name, equals, rest = message.partition(" = ")
    if not equals:
        return message
    return f"{as_option(name)} {rest}"


def _fail(code: int, message: str) -> int:
    say(f"laplacian-simplify: error: {printable(message.strip())}")
    return code
