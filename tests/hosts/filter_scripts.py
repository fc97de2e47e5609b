# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Scripts of filters (.mlx) as MeshLab writes them: every parameter is listed, which 2020.09 insists on."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TypeAlias
from xml.etree import ElementTree

TYPES = {
    "boolean": "RichBool",
    "integer": "RichInt",
    "real": "RichFloat",
    "choice": "RichEnum",
    "numbers": "RichString",
}
ON_EVERY_MESH = {"target_faces": 1000, "selected_only": False}
"""Values of the parameters whose default depends on the mesh."""


@dataclass(frozen=True)
class ForeignStep:
    """A filter of another plugin: its name, and of each parameter name, type and value."""

    name: str
    parameters: tuple[tuple[str, str, str], ...]


Step: TypeAlias = tuple[dict, dict[str, object]] | ForeignStep
"""A filter of ours with the values of its parameters, or one of another plugin."""


def values_of(filter_row: dict, **changes: object) -> dict[str, object]:
    """The default of every parameter of the filter, except for the changes."""
    values = {row["id"]: row["default"] for row in filter_row["parameters"]}
    for name, value in values.items():
        if value is None:
            values[name] = ON_EVERY_MESH[name]
    unknown = changes.keys() - values.keys()
    if unknown:
        raise KeyError(f"{filter_row['name']} has no parameter {sorted(unknown)}")
    return values | changes


def write_script(file: Path, *steps: Step) -> Path:
    """Writes filters in the order in which they shall run."""
    root = ElementTree.Element("FilterScript")
    for step in steps:
        if isinstance(step, ForeignStep):
            element = ElementTree.SubElement(root, "filter", name=step.name)
            for name, kind, value in step.parameters:
                words = {"type": kind, "name": name, "value": value, "description": name, "tooltip": ""}
                ElementTree.SubElement(element, "Param", words)
            continue
        filter_row, values = step
        element = ElementTree.SubElement(root, "filter", name=filter_row["name"])
        for row in filter_row["parameters"]:
            ElementTree.SubElement(element, "Param", _attributes(row, values[row["id"]]))
    ElementTree.indent(root)
    body = ElementTree.tostring(root, encoding="unicode")
    file.write_text(f"<!DOCTYPE FilterScript>\n{body}\n", encoding="utf-8")
    return file


def _attributes(row: dict, value: object) -> dict[str, str]:
    text = str(value) if row["type"] == "numbers" else f"{value:.9g}"
    if isinstance(value, bool):
        text = str(value).lower()
    attributes = {"type": TYPES[row["type"]], "name": row["id"], "value": text, "description": row["label"]}
    attributes["tooltip"] = row["help"]
    if row["type"] == "choice":
        attributes["enum_cardinality"] = str(len(row["options"]))
        attributes |= {f"enum_val{place}": option["text"] for place, option in enumerate(row["options"])}
    return attributes
