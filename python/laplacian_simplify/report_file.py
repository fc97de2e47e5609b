# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The report as a JSON file: the numbers, and all that is needed to do the same again."""

import json
from collections.abc import Mapping
from typing import Any

from .options import WITHOUT_OPTION
from .tables import Filter, Parameter


def report_text(row: Filter, report: Mapping[str, Any], values: Mapping[str, Any], source: str, target: str) -> str:
    """The file, with arguments as report_of."""
    return json.dumps(report_of(row, report, values, source, target), indent=2) + "\n"


def report_of(
    row: Filter, report: Mapping[str, Any], values: Mapping[str, Any], source: str, target: str
) -> dict[str, Any]:
    """What the file holds of a result.

    Args:
        row: the filter.
        report: its numbers; their names are keys of the object.
        values: parameters that were given; the others have their defaults.
        source: how the input is named.
        target: how the output is named.
    """
    from importlib.metadata import version  # which takes its time

    units = {result.id: result.unit for result in row.results if result.unit and result.id in report}
    about = {
        "input": source,
        "output": target,
        "parameters": _parameters(row, values),
        "units": units,
        "version": version("laplacian-simplify"),
    }
    return {**report, **about}


def _parameters(row: Filter, values: Mapping[str, Any]) -> dict[str, Any]:
    """Every parameter that has a value: choices by their words. A target that the mesh decided has none,
    and so have percents of levels that errors decided."""
    known = {parameter.id: parameter for parameter in row.parameters if parameter.id not in WITHOUT_OPTION}
    given = {name: values.get(name, known[name].default) for name in known}
    if "target_percent" in given and given["target_percent"] == 0:
        del given["target_percent"]
    if values.get("max_errors"):
        given.pop("percents", None)
    further = {name: value for name, value in values.items() if name not in known}
    return {name: _word(known[name], value) for name, value in given.items() if value is not None} | further


def _word(parameter: Parameter, value: Any) -> Any:
    if not parameter.options or isinstance(value, str):
        return bool(value) if parameter.type == "boolean" else value
    return parameter.options[int(value)].id
