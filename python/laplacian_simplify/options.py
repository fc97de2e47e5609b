# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Options of the command, made from the plugin's tables of parameters."""

import argparse
import os
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from typing import Any, NoReturn

from . import filters as functions
from .batch.arguments import add_batch_parser
from .comparison.arguments import add_compare_parser
from .error_bound import MAX_ERROR_HELP, MAX_ERRORS_HELP, error_bound
from .huge.arguments import PARAMETERS, add_huge_parser
from .pictures.arguments import add_picture_arguments
from .report import Report
from .streams import show
from .tables import Filter, Parameter, filter_named, filters


@dataclass(frozen=True)
class Command:
    """A subcommand: the function behind it and where its options differ from the filter's parameters."""

    name: str
    filter_name: str
    function: Callable[..., Report | Sequence[Report]]
    stores_quality: bool = False
    other_defaults: tuple[tuple[str, Any], ...] = ()
    draws: bool = False
    """Whether it can draw what it did."""

    @property
    def has_levels(self) -> bool:
        """Whether it writes several meshes."""
        return self.filter.has("percents")

    @property
    def filter(self) -> Filter:
        return filter_named(self.filter_name)


_COMMANDS = (
    Command("simplify", "meshing_decimation_laplacian_quadric_edge_collapse", functions.simplify, draws=True),
    Command("descriptor", "compute_scalar_by_laplacian_descriptor_per_vertex", functions.descriptor, True),
    Command(
        "classify",
        "compute_selection_by_laplacian_descriptor_per_vertex",
        functions.classify,
        True,
        (("class_as_quality", True),),  # no file holds a selection
    ),
    Command("lod", "generate_laplacian_levels_of_detail", functions.levels_of_detail),
    Command("smooth", "apply_coord_umbrella_smoothing", functions.smooth),
)

_EXAMPLES = {
    "simplify": (
        "%(prog)s bunny.ply small.ply --percent 10",
        "%(prog)s scan.obj scan_small.obj --faces 20000 --effort best",
        "%(prog)s part.stl part_small.ply --max-error 0.1%% --json report.json",
        "%(prog)s bunny.ply small.ply --percent 10 --picture small.png --report small.html",
        "%(prog)s bunny.ply --in-place --percent 10 --strict --quiet",
    ),
    "descriptor": ("%(prog)s bunny.ply descriptor.ply --rescale",),
    "classify": ("%(prog)s bracket.ply features.ply --classes 3",),
    "smooth": ("%(prog)s scan.ply smooth.ply --steps 5 --boundary fixed",),
    "lod": (
        "%(prog)s part.ply 'part_{percent}.ply' --percents 50,25,10",
        "%(prog)s part.ply 'part_{level}.ply' --max-errors 0.01%%,0.05%%",
    ),
    "compare": (
        "%(prog)s part.stl part_by_another_tool.ply",
        "%(prog)s bunny.ply small.ply --report difference.html --json difference.json",
    ),
    "batch": ("%(prog)s scans small --percent 10", "%(prog)s 'scans/**/*.ply' small --faces 5000 --workers 4"),
}

SHORT_NAMES = {"target_faces": "--faces", "target_percent": "--percent"}
_SHORT_HELP = {"target_faces": "number of faces to keep", "target_percent": "percent of the faces to keep"}
PROGRAM_NAME = "LAPLACIAN_SIMPLIFY_PROGRAM"
"""Environment variable: how help and errors of simplify name the command, where a script runs it."""
WITHOUT_OPTION = ("new_layer", "selected_only", "lock_selected_vertices")  # one mesh in, one out, without a selection


def commands() -> tuple[Command, ...]:
    """The subcommands whose filters this build of the plugin has."""
    present = {row.python_name for row in filters()}
    return tuple(command for command in _COMMANDS if command.filter_name in present)


class OneLineParser(argparse.ArgumentParser):
    """Says what is wrong in one line and exits with 2."""

    def error(self, message: str) -> NoReturn:
        self.exit(2, f"{self.prog}: error: {message} (see {self.prog} --help)\n")


class ShowVersion(argparse.Action):
    """Looks the version up only where it is asked for: that takes longer than everything else here."""

    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> NoReturn:
        from importlib.metadata import version

        show(f"{parser.prog} {version('laplacian-simplify')}")
        parser.exit(0)


def examples(name: str) -> dict[str, Any]:
    """Of a subcommand, for its help, which keeps their lines."""
    lines = "".join(f"\n  {line}" for line in _EXAMPLES[name])
    return {"epilog": "examples:" + lines, "formatter_class": argparse.RawDescriptionHelpFormatter}


def as_option(name: str, value: object = None) -> str:
    """A parameter, or it with its value, as the command has it."""
    option = SHORT_NAMES.get(name, "--" + name.replace("_", "-"))
    if isinstance(value, bool):
        return option if value else option.replace("--", "--no-", 1)
    if isinstance(value, float):
        value = f"{value:g}"
    return option if value is None else f"{option} {value}"


class PrintCompletion(argparse.Action):
    """Prints the completion for a shell, which the package shtab makes."""

    def __call__(self, parser: argparse.ArgumentParser, _: object, shell: object, __: str | None = None) -> NoReturn:
        try:
            from shtab import complete
        except ImportError:
            parser.error("completion needs the package shtab: python -m pip install laplacian-simplify[completion]")
        show(complete(parser, shell=str(shell)))
        parser.exit(0)


def make_parser() -> argparse.ArgumentParser:
    """The parser of the whole command; the chosen subcommand is in ``command``."""
    parser = OneLineParser(
        prog="laplacian-simplify",
        description="Simplifies meshes so that creases, corners and details stay longest.",
        allow_abbrev=False,
    )
    parser.add_argument("--version", action=ShowVersion, nargs=0, help="show the version and exit")
    parser.add_argument(
        "--print-completion", action=PrintCompletion, choices=("bash", "zsh", "tcsh"), help="completion for a shell"
    )
    subparsers = parser.add_subparsers(required=True, metavar="COMMAND", parser_class=OneLineParser)
    for command in commands():
        row = command.filter
        subparser = subparsers.add_parser(
            command.name, help=row.summary, description=row.summary, allow_abbrev=False, **examples(command.name)
        )
        if command.name == "simplify":
            subparser.prog = os.environ.get(PROGRAM_NAME, subparser.prog)
        _add_options(subparser, command, row)
        subparser.set_defaults(command=command, batch=False, huge=False, compare=False)
        if command.name == "simplify":
            batch = add_batch_parser(subparsers, **examples("batch"))
            add_parameters(batch, command, row)
            batch.set_defaults(command=command, huge=False, compare=False)
            huge = add_huge_parser(subparsers)
            add_parameters(huge, command, row, PARAMETERS)
            huge.set_defaults(command=command, batch=False, compare=False)
    compare = add_compare_parser(subparsers, **examples("compare"))
    compare.set_defaults(command=None, batch=False, huge=False, compare=True)
    return parser


def _add_options(parser: argparse.ArgumentParser, command: Command, row: Filter) -> None:
    parser.add_argument("input", metavar="INPUT", help="mesh file, also as .gz; - for standard input")
    if command.has_levels:
        fields = "{percent} or {error}, as it is given, or {level}, its number"
        parser.add_argument("output", metavar="OUTPUT", help=f"mesh file of each level, with {fields}")
    else:
        parser.add_argument("output", metavar="OUTPUT", nargs="?", help="mesh file; - for standard output")
        parser.add_argument("--in-place", action="store_true", help="write to INPUT, in place of OUTPUT")
        parser.add_argument(
            "--output-format", choices=("ply", "stl"), help="format of a mesh on standard output. Default: ply."
        )
    parser.add_argument("--json", metavar="REPORT", help="write the report as JSON to this file, - for standard output")
    if command.draws:
        add_picture_arguments(parser, "the mesh before and after")
    parser.add_argument(
        "-q", "--quiet", action="store_true", help="show neither report nor progress, only what is wrong"
    )
    if row.has("target_faces"):
        parser.add_argument(
            "--strict",
            action="store_true",
            help="a target that is not reached is an error: exit code 4, nothing written",
        )
    add_parameters(parser, command, row)


def add_parameters(
    parser: argparse.ArgumentParser, command: Command, row: Filter, only: Collection[str] | None = None
) -> None:
    """The options that are parameters of the filter, all of them by default."""
    targets: argparse._ActionsContainer = parser
    if row.has("target_faces"):
        has_bound = row.has("max_error") and (only is None or "max_error" in only)
        targets = parser.add_mutually_exclusive_group(required=not has_bound)
    elif command.has_levels:
        targets = parser.add_mutually_exclusive_group(required=True)
    other_defaults = dict(command.other_defaults)
    for parameter in row.parameters:
        if parameter.id in WITHOUT_OPTION or (only is not None and parameter.id not in only):
            continue
        group = targets if parameter.id in SHORT_NAMES or parameter.type == "numbers" else parser
        _add_option(group, parameter, other_defaults.get(parameter.id))


def _add_option(group: argparse._ActionsContainer, parameter: Parameter, default: object) -> None:
    name = as_option(parameter.id)
    common: dict[str, Any] = {"dest": parameter.id, "default": default, "help": _help(parameter, default)}
    if parameter.type == "boolean":
        group.add_argument(name, action=argparse.BooleanOptionalAction, **common)
    elif parameter.type == "choice":
        group.add_argument(name, choices=[option.id for option in parameter.options], **common)
    elif parameter.id == "max_error":
        group.add_argument(name, type=error_bound, metavar="X[%]", **common)
    elif parameter.type == "numbers":
        group.add_argument(name, metavar="X[%],..." if parameter.id == "max_errors" else "X,...", **common)
    else:
        kind = int if parameter.type == "integer" else float
        group.add_argument(name, type=kind, metavar="N" if kind is int else "X", **common)


def _help(parameter: Parameter, default: object) -> str:
    text = parameter.help
    if parameter.id in SHORT_NAMES:
        return _SHORT_HELP[parameter.id]
    if parameter.id == "max_error":
        return MAX_ERROR_HELP.replace("%", "%%")
    if parameter.id == "max_errors":
        return MAX_ERRORS_HELP.replace("%", "%%")
    if parameter.type == "numbers":
        return "percent of the faces of each level, from the finest to the coarsest"
    if isinstance(default, bool):
        shown = "on" if default else "off"
    elif parameter.options:
        shown = parameter.options[int(parameter.default or 0)].id
    else:
        shown = {"true": "on", "false": "off"}.get(parameter.default_text, parameter.default_text)
    return f"{text} Default: {shown}.".replace("%", "%%")
