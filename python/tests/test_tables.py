# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The functions, their reports and the command say what the plugin's tables say."""

import dataclasses
import inspect
import typing
from collections.abc import Mapping
from os import PathLike

import numpy as np
import pymeshlab
import pytest
from numpy.typing import NDArray

import laplacian_simplify as ls
from laplacian_simplify.report import Report
from laplacian_simplify.simplification import SimplifyOptions
from laplacian_simplify.tables import Parameter, filter_named, filters

FUNCTIONS = {
    "compute_scalar_by_laplacian_descriptor_per_vertex": ls.descriptor,
    "compute_selection_by_laplacian_descriptor_per_vertex": ls.classify,
    "meshing_decimation_laplacian_quadric_edge_collapse": ls.simplify,
    "meshing_decimation_laplacian_weighted_edge_collapse": ls.weighted,
    "generate_laplacian_levels_of_detail": ls.levels_of_detail,
    "apply_coord_umbrella_smoothing": ls.smooth,
}
NOT_IN_THE_TABLES = {  # arrays' own
    "mesh",
    "faces",
    "selected",
    "locked",
    "quality",
    "vertex_attributes",
    "corner_attributes",
    "face_labels",
    "attribute_kinds",
    "progress",
    "return_result",
}
ROWS = [
    pytest.param(row, parameter, id=f"{row.name}: {parameter.id}") for row in filters() for parameter in row.parameters
]


def target_for(name: str) -> dict[str, float]:
    """What a decimation has to be given."""
    return {"target_percent": 50} if filter_named(name).has("target_percent") else {}


@pytest.mark.parametrize("row", filters(), ids=lambda row: row.name)
def test_every_filter_has_a_function_with_its_parameters(row) -> None:
    parameters = inspect.signature(FUNCTIONS[row.python_name]).parameters
    assert next(iter(parameters)) == "mesh"
    own = {name: p for name, p in parameters.items() if name not in NOT_IN_THE_TABLES}
    assert set(own) == {parameter.id for parameter in row.parameters}
    assert all(p.kind is p.KEYWORD_ONLY and p.default is None for p in own.values())


def test_the_keywords_of_simplify_are_written_twice_alike() -> None:
    """For type checkers in SimplifyOptions, which has all that the overloads do not name themselves."""
    parameters = set(inspect.signature(ls.simplify).parameters)
    assert set(SimplifyOptions.__annotations__) == parameters - {"mesh", "faces", "return_result"}


@pytest.mark.parametrize("row", filters(), ids=lambda row: row.name)
def test_every_parameter_is_documented(row) -> None:
    text = inspect.getdoc(FUNCTIONS[row.python_name])
    assert text is not None
    for parameter in row.parameters:
        assert f"    {parameter.id}: " in text


@pytest.mark.parametrize(("row", "parameter"), ROWS)
def test_hints_name_the_type_and_the_choices(row, parameter: Parameter) -> None:
    names = {
        "Mapping": Mapping,
        "pymeshlab": pymeshlab,
        "PathLike": PathLike,
        "np": np,
        "NDArray": NDArray,
        "Any": typing.Any,
    }
    hints = typing.get_type_hints(FUNCTIONS[row.python_name], names)
    hint = str(hints[parameter.id])
    expected = {"boolean": "bool", "integer": "int", "real": "float", "choice": "int", "numbers": "float"}[
        parameter.type
    ]
    assert expected in hint
    for option in parameter.options:
        assert f"'{option.id}'" in hint


@pytest.mark.parametrize("row", filters(), ids=lambda row: row.name)
def test_every_result_is_a_field_of_the_report(row) -> None:
    of_one_type = inspect.signature(FUNCTIONS[row.python_name]).return_annotation
    report_type = ls.DecimationReport if row.has("target_faces") or row.has("percents") else of_one_type
    assert issubclass(report_type, Report)
    fields = {field.name: field for field in dataclasses.fields(report_type) if field.name != "mesh_set"}
    ids = {result.id for result in row.results}
    assert ids <= set(fields)
    assert all(fields[name].default is None for name in set(fields) - ids)  # what only the other decimation returns
    for result in row.results:
        required = fields[result.id].default is dataclasses.MISSING
        assert required or result.optional, result.id


@pytest.mark.parametrize(("row", "parameter"), ROWS)
def test_the_range_is_checked_here_and_by_the_plugin_in_the_same_words(row, parameter: Parameter, load_sample) -> None:
    mesh_set = load_sample("painted_box.obj")
    before = mesh_set.current_mesh().vertex_matrix().copy()
    for value in _outside(parameter):
        with pytest.raises(ValueError, match=f"^{parameter.id} = ") as ours:
            FUNCTIONS[row.python_name](mesh_set, **{parameter.id: value})
        if parameter.type != "choice":  # pymeshlab itself refuses those
            with pytest.raises(Exception, match=f"{parameter.id} = ") as plugins:
                mesh_set.apply_filter(row.python_name, **{parameter.id: value})
            assert str(ours.value) in str(plugins.value)
    assert (mesh_set.current_mesh().vertex_matrix() == before).all()


def _outside(parameter: Parameter) -> list[float] | list[str]:
    if parameter.type == "boolean":
        return []
    if parameter.type == "numbers":
        return ["0", f"{parameter.maximum + 1:g}", "nan", "many", "1,,1"]
    values = [parameter.minimum - 1]
    if parameter.maximum < 2**31 - 1:
        values.append(parameter.maximum + 1)
    if not parameter.minimum_included:
        values.append(parameter.minimum)
    return [int(value) for value in values] if parameter.type != "real" else [*values, float("nan")]


def test_unknown_names_are_refused(load_sample) -> None:
    with pytest.raises(TypeError, match="no_such_parameter"):
        ls.simplify(load_sample("painted_box.obj"), no_such_parameter=1)  # type: ignore[call-arg]
    with pytest.raises(LookupError, match="no_such_filter"):
        filter_named("no_such_filter")


def test_a_choice_is_a_word_or_a_number(load_sample) -> None:
    for effort in ("fast", 0):
        assert ls.simplify(load_sample("painted_box.obj"), target_faces=500, effort=effort).faces <= 500
    with pytest.raises(ValueError, match=r"effort = fastest is not one of fast \(0\), balanced \(1\), best \(2\)"):
        ls.simplify(load_sample("painted_box.obj"), effort="fastest")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=r"classes = 2\.5 is not a whole number"):
        ls.classify(load_sample("painted_box.obj"), classes=2.5)  # type: ignore[arg-type]
