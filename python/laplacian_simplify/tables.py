# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin's own tables of filters, parameters and results, as it printed them when it was built."""

import json
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any, Literal


@dataclass(frozen=True)
class Option:
    """One value of a parameter that is a choice; its number is its place in the list."""

    id: str
    text: str


@dataclass(frozen=True)
class Parameter:
    """One parameter of one filter."""

    id: str
    type: Literal["boolean", "integer", "real", "choice", "numbers"]
    default: bool | float | str | None
    """None where the mesh decides it."""
    default_text: str
    range_text: str
    unit: str
    label: str
    help: str
    minimum: float = 0
    maximum: float = 1
    minimum_included: bool = True
    options: tuple[Option, ...] = ()
    advanced: bool = False
    """Of the dialogs: rarely used."""
    slider: bool = False
    """Of the dialogs: dragged over its range."""

    def number(self, value: object) -> float:
        """The number of a value: of a choice also by the id of the option. Numbers of NumPy are numbers, too.

        Raises:
            TypeError: it is no number, and no word where the parameter is a choice.
            ValueError: names the parameter, the value and the range.
        """
        if getattr(value, "shape", None) == () and hasattr(value, "item"):
            value = value.item()
        ids = [option.id for option in self.options]
        if isinstance(value, str) and value in ids:
            return ids.index(value)
        if not isinstance(value, bool | int | float | str) or (isinstance(value, str) and not self.options):
            raise TypeError(f"{self.id} must be {self._kind()}, not {type(value).__name__}")
        if isinstance(value, str) or not self._contains(value):
            relation = "not one of" if self.options else "outside"
            raise ValueError(f"{self.id} = {_shown(value)} is {relation} {self.range_text}")
        if self.type not in ("real", "numbers") and value != int(value):
            raise ValueError(f"{self.id} = {_shown(value)} is not a whole number in {self.range_text}")
        return value

    def numbers(self, value: object) -> str:
        """The text of several numbers: of a text such as "50,25", a number, or a sequence of numbers.

        Raises:
            TypeError: it is none of these.
            ValueError: names the parameter, the text and the word that is no number in the range.
        """
        if isinstance(value, str):
            text = value
        elif isinstance(value, Iterable):
            text = ",".join(repr(float(self.number(number))) for number in value)
        else:
            text = repr(float(self.number(value)))
        for word in text.split(",") if text.strip() else ():
            try:
                fits = self._contains(float(word))
            except ValueError:
                fits = False
            if not fits:
                raise ValueError(f'{self.id} = "{text}": "{word.strip()}" is not a number in {self.range_text}')
        return text

    def _kind(self) -> str:
        kinds = {"boolean": "True or False", "integer": "a whole number", "real": "a number", "numbers": "numbers"}
        return kinds.get(self.type, f"one of {self.range_text}")

    def _contains(self, value: float) -> bool:
        above = value >= self.minimum if self.minimum_included else value > self.minimum
        return above and value <= self.maximum  # written so that NaN is refused


def _shown(value: object) -> str:
    return str(value).removesuffix(".0")


@dataclass(frozen=True)
class Result:
    """One number that a filter returns."""

    id: str
    type: Literal["boolean", "integer", "real", "real_list"]
    unit: str
    help: str
    optional: bool


@dataclass(frozen=True)
class Filter:
    """One filter with its parameters and results."""

    name: str
    python_name: str
    summary: str
    help: str
    parameters: tuple[Parameter, ...]
    results: tuple[Result, ...]

    def parameter(self, name: str) -> Parameter:
        """The row of a parameter.

        Raises:
            TypeError: the filter has none of this name, as Python says of a function.
        """
        for row in self.parameters:
            if row.id == name:
                return row
        known = ", ".join(row.id for row in self.parameters)
        raise TypeError(f"{self.python_name} has no parameter '{name}'; it has {known}")

    def has(self, name: str) -> bool:
        """Whether the filter has a parameter of this name."""
        return any(row.id == name for row in self.parameters)


def _parameter(row: dict[str, Any]) -> Parameter:
    options = tuple(Option(**option) for option in row.pop("options", ()))
    return Parameter(**{"maximum": max(len(options) - 1, 1), **row}, options=options)


def _filter(row: dict[str, Any]) -> Filter:
    return Filter(
        name=row["name"],
        python_name=row["python_name"],
        summary=row["summary"],
        help=row["help"],
        parameters=tuple(_parameter(parameter) for parameter in row["parameters"]),
        results=tuple(Result(**result) for result in row["results"]),
    )


@cache
def filters() -> tuple[Filter, ...]:
    """All filters of the plugin in this package."""
    text = files(__package__).joinpath("tables.json").read_text(encoding="utf-8")
    return tuple(_filter(row) for row in json.loads(text)["filters"])


def filter_named(python_name: str) -> Filter:
    """The row of a filter.

    Raises:
        LookupError: the plugin in this package has no such filter.
    """
    for row in filters():
        if row.python_name == python_name:
            return row
    raise LookupError(f"this build of the plugin has no filter {python_name}")
