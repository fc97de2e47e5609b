# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Options of the command, made from the plugin's tables of parameters."""

import argparse
from collections.abc import Callable, Collection
from dataclasses import dataclass
from typing import Any, NoReturn

from . import filters as functions
from .batch.arguments import add_batch_parser
from .error_bound import MAX_ERROR_HELP, error_bound
from .huge.arguments import PARAMETERS, add_huge_parser
from .report import Report
from .streams import show
from .tables import Filter, Parameter, filter_named, filters


@dataclass(frozen=True)
class Command:
    """A subcommand: the function behind it and where its options differ from the filter's parameters."""

    name: str
    filter_name: str
    function: Callable[..., Report]
    stores_quality: bool = False
    other_defaults: tuple[tuple[str, Any], ...] = ()

    @property
    def filter(self) -> Filter:
        return filter_named(self.filter_name)


_COMMANDS = (
    Command("simplify", "meshing_decimation_laplacian_quadric_edge_collapse", functions.simplify),
    Command("descriptor", "compute_scalar_by_laplacian_descriptor_per_vertex", functions.descriptor, True),
    Command(
        "classify",
        "compute_selection_by_laplacian_descriptor_per_vertex",
        functions.classify,
        True,
        (("class_as_quality", True),),  # no file holds a selection
    ),
    Command("smooth", "apply_coord_umbrella_smoothing", functions.smooth),
)

SHORT_NAMES = {"target_faces": "--faces", "target_percent": "--percent"}
_SHORT_HELP = {"target_faces": "number of faces to keep", "target_percent": "percent of the faces to keep"}
WITHOUT_OPTION = ("new_layer", "selected_only")  # one mesh in, one out; files hold no selection


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


def make_parser() -> argparse.ArgumentParser:
    """The parser of the whole command; the chosen subcommand is in ``command``."""
    parser = OneLineParser(
        prog="laplacian-simplify",
        description="Simplifies meshes so that creases, corners and details stay longest.",
        allow_abbrev=False,
    )
    parser.add_argument("--version", action=ShowVersion, nargs=0, help="show the version and exit")
    subparsers = parser.add_subparsers(required=True, metavar="COMMAND", parser_class=OneLineParser)
    for command in commands():
        row = command.filter
        subparser = subparsers.add_parser(command.name, help=row.summary, description=row.summary, allow_abbrev=False)
        _add_options(subparser, command, row)
        subparser.set_defaults(command=command, batch=False, huge=False)
        if command.name == "simplify":
            batch = add_batch_parser(subparsers)
            add_parameters(batch, command, row)
            batch.set_defaults(command=command, huge=False)
            huge = add_huge_parser(subparsers)
            add_parameters(huge, command, row, PARAMETERS)
            huge.set_defaults(command=command, batch=False)
    return parser


def _add_options(parser: argparse.ArgumentParser, command: Command, row: Filter) -> None:
    parser.add_argument("input", metavar="INPUT", help="mesh file, also as .gz; - for standard input")
    parser.add_argument("output", metavar="OUTPUT", nargs="?", help="mesh file; - for standard output")
    parser.add_argument("--in-place", action="store_true", help="write to INPUT, in place of OUTPUT")
    parser.add_argument(
        "--output-format", choices=("ply", "stl"), help="format of a mesh on standard output. Default: ply."
    )
    parser.add_argument("--json", metavar="REPORT", help="write the report as JSON to this file, - for standard output")
    add_parameters(parser, command, row)


def add_parameters(
    parser: argparse.ArgumentParser, command: Command, row: Filter, only: Collection[str] | None = None
) -> None:
    """The options that are parameters of the filter, all of them by default."""
    targets: argparse._ActionsContainer = parser
    if row.has("target_faces"):
        has_bound = row.has("max_error") and (only is None or "max_error" in only)
        targets = parser.add_mutually_exclusive_group(required=not has_bound)
    other_defaults = dict(command.other_defaults)
    for parameter in row.parameters:
        if parameter.id in WITHOUT_OPTION or (only is not None and parameter.id not in only):
            continue
        group = targets if parameter.id in SHORT_NAMES else parser
        _add_option(group, parameter, other_defaults.get(parameter.id))


def _add_option(group: argparse._ActionsContainer, parameter: Parameter, default: object) -> None:
    name = SHORT_NAMES.get(parameter.id, "--" + parameter.id.replace("_", "-"))
    common: dict[str, Any] = {"dest": parameter.id, "default": default, "help": _help(parameter, default)}
    if parameter.type == "boolean":
        group.add_argument(name, action=argparse.BooleanOptionalAction, **common)
    elif parameter.type == "choice":
        group.add_argument(name, choices=[option.id for option in parameter.options], **common)
    elif parameter.id == "max_error":
        group.add_argument(name, type=error_bound, metavar="X[%]", **common)
    else:
        kind = int if parameter.type == "integer" else float
        group.add_argument(name, type=kind, metavar="N" if kind is int else "X", **common)


def _help(parameter: Parameter, default: object) -> str:
    text = parameter.help
    if parameter.id in SHORT_NAMES:
        return _SHORT_HELP[parameter.id]
    if parameter.id == "max_error":
        return MAX_ERROR_HELP.replace("%", "%%")
    if isinstance(default, bool):
        shown = "on" if default else "off"
    elif parameter.options:
        shown = parameter.options[int(parameter.default or 0)].id
    else:
        shown = {"true": "on", "false": "off"}.get(parameter.default_text, parameter.default_text)
    return f"{text} Default: {shown}.".replace("%", "%%")
