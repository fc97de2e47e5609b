# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of NumPy are numbers."""

import numpy as np
import pytest
from conftest import SAMPLE_MESHES

import laplacian_simplify as ls
from laplacian_simplify.tables import filter_named

BOX = SAMPLE_MESHES / "painted_box.obj"
SIMPLIFY = filter_named("meshing_decimation_laplacian_quadric_edge_collapse")


@pytest.mark.parametrize(
    ("name", "value", "number"),
    [
        ("target_faces", np.int64(300), 300),
        ("target_faces", np.uint8(200), 200),
        ("target_faces", np.array(300), 300),
        ("target_faces", np.float32(300), 300),
        ("target_percent", np.float32(12.5), 12.5),
        ("feature_weight", np.float64(2.5), 2.5),
        ("measure_error", np.bool_(False), False),
        ("measure_error", np.True_, True),
        ("effort", np.int32(0), 0),
        ("effort", np.str_("fast"), 0),
    ],
)
def test_a_number_of_numpy_is_one(name: str, value: object, number: float) -> None:
    assert SIMPLIFY.parameter(name).number(value) == number


def test_a_run_with_numbers_of_numpy() -> None:
    report = ls.simplify(BOX, target_faces=np.int64(300), feature_weight=np.float32(2), measure_error=np.bool_(False))
    assert report.faces <= 300
    assert report.rms is None


@pytest.mark.parametrize(
    ("name", "value", "said"),
    [
        ("target_faces", np.int64(0), "target_faces = 0 is outside"),
        ("target_faces", np.float64(2.5), "target_faces = 2.5 is not a whole number"),
        ("target_percent", np.float32("nan"), "target_percent = nan is outside"),
    ],
)
def test_one_out_of_range_is_refused(name: str, value: object, said: str) -> None:
    with pytest.raises(ValueError, match=said.replace("(", r"\(")):
        SIMPLIFY.parameter(name).number(value)


@pytest.mark.parametrize(
    ("name", "value", "said"),
    [
        ("feature_weight", np.array([1.0, 2.0]), "feature_weight must be a number, not ndarray"),
        ("feature_weight", 1j, "feature_weight must be a number, not complex"),
        ("feature_weight", None, "feature_weight must be a number, not NoneType"),
        ("target_faces", "five", "target_faces must be a whole number, not str"),
        ("measure_error", "no", "measure_error must be True or False, not str"),
        ("effort", [0], r"effort must be one of fast \(0\), balanced \(1\), best \(2\), not list"),
    ],
)
def test_what_is_no_number_is_a_type_error(name: str, value: object, said: str) -> None:
    with pytest.raises(TypeError, match=said):
        SIMPLIFY.parameter(name).number(value)
