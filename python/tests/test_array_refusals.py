# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays that are no mesh, and values that mean nothing for arrays, are refused by name."""

import numpy as np
import pytest
from array_meshes import wave

import laplacian_simplify as ls
from laplacian_simplify.arrays import _MESH_SETS_ONLY
from laplacian_simplify.library import MeshArrays, run
from laplacian_simplify.library_structures import ParametersStructure
from laplacian_simplify.tables import filter_named

ROW = filter_named("meshing_decimation_laplacian_quadric_edge_collapse")

V, F = wave(5)
HUGE = np.broadcast_to(np.zeros((1, 3)), (2**31, 3)), np.broadcast_to(np.zeros((1, 3), np.int32), (2**29, 3))


@pytest.mark.parametrize(
    ("arguments", "error", "said"),
    [
        ((V, F), ValueError, "there is no target: give target_faces=5000, "),
        ((V, F, {"target_faces": 5, "target_percent": 10}), ValueError, "are two targets: give one of them"),
        ((V, F, {"target_percent": 0}), ValueError, r"target_percent = 0 is outside \(0, 100\]"),
        ((V, F, {"target_percent": float("nan")}), ValueError, "target_percent = nan is outside"),
        ((V, F, {"target_percent": "10"}), TypeError, "target_percent must be a number, not str"),
        ((V, F, {"target_faces": [5]}), TypeError, "target_faces must be a whole number, not list"),
        ((V, None, {"target_faces": 5}), TypeError, "the faces are missing"),
        ((V[:, :2], F, {"target_faces": 5}), ValueError, r"vertices has the shape \(25, 2\), not \(n, 3\)"),
        ((V, F.ravel(), {"target_faces": 5}), ValueError, r"faces has the shape \(96,\), not \(m, 3\)"),
        ((V, F[:0], {"target_faces": 5}), ValueError, r"the mesh has no faces \(25 vertices\)"),
        ((V[:0], F[:0], {"target_faces": 5}), ValueError, r"the mesh has no faces \(0 vertices\)"),
        ((V[:0], F, {"target_faces": 5}), ValueError, r"of 32 of 32 faces are outside \[0, 0\)"),
        ((V, F + 1, {"target_faces": 5}), ValueError, r"of 2 of 32 faces are outside \[0, 25\); the first .* face 15"),
        ((V, F - 1, {"target_faces": 5}), ValueError, "of 2 of 32 faces are outside"),
        ((V, (F - 1).astype("i4"), {"target_faces": 5}), ValueError, "of 2 of 32 faces are outside"),
        ((V, F + 2**32, {"target_faces": 5}), ValueError, "of 32 of 32 faces are outside"),
        ((V, F.astype("u8") + 2**63, {"target_faces": 5}), ValueError, "of 32 of 32 faces are outside"),
        ((np.where(V[7] == V, np.nan, V), F, {"target_faces": 5}), ValueError, "25 vertices are not finite"),
        ((np.where(V == 0, np.inf, V), F, {"target_faces": 5}), ValueError, "of 9 of 25 vertices are not finite"),
        ((V * 1e19, F, {"target_faces": 5}), ValueError, "not finite or larger than 1e18"),
        (
            (V.astype(int), F, {"target_faces": 5}),
            TypeError,
            "vertices must be an array of float32 or float64, not of i",
        ),
        ((V.astype("f2"), F, {"target_faces": 5}), TypeError, "not of float16"),
        ((V.astype("g"), F, {"target_faces": 5}), TypeError, "not of float128"),
        ((V.astype(object), F, {"target_faces": 5}), TypeError, "not of object"),
        ((np.ma.array(V), F, {"target_faces": 5}), TypeError, "vertices must be a NumPy array"),
        ((V, F.tolist(), {"target_faces": 5}), TypeError, "faces must be a NumPy array of integers, not list"),
        ((V, F.astype(float), {"target_faces": 5}), TypeError, "faces must be an array of integers, not of float64"),
        ((V, F > 3, {"target_faces": 5}), TypeError, "faces must be an array of integers, not of bool"),
        ((V, F.astype("m8"), {"target_faces": 5}), TypeError, "not of timedelta64"),
        ((*HUGE, {"target_faces": 5}), ValueError, "536,870,912 faces and 2,147,483,648 vertices are too many"),
        ((V, F, {"target_faces": 5, "locked": [True]}), TypeError, "locked must be a NumPy array of bool"),
        ((V, F, {"target_faces": 5, "locked": np.ones(25, int)}), TypeError, "locked must be an array of bool"),
        ((V, F, {"target_faces": 5, "locked": np.ones(24, bool)}), ValueError, r"\(24,\), not \(25,\)"),
        ((V, F, {"target_faces": 5, "selected": np.ones(25, bool)}), ValueError, r"selected has the shape \(25,\)"),
        ((V, F, {"target_faces": 5, "selected": np.zeros(32, bool)}), ValueError, "no face is selected"),
        ((V, F, {"target_faces": 5, "selected_only": True}), ValueError, "no face is selected"),
        ((V, F, {"target_faces": 5, "quality": np.ones(25)}), ValueError, "given together or not at all"),
        ((V, F, {"target_faces": 5, "descriptor": "vertex_quality"}), ValueError, "given together or not at all"),
        (
            (V, F, {"target_faces": 5, "descriptor": "vertex_quality", "quality": np.full(25, np.nan)}),
            ValueError,
            "the quality is not finite at 25 of 25 vertices",
        ),
        ((V, F, {"target_faces": 5, "order": 1}), ValueError, "order = strict is for a pymeshlab.MeshSet or a"),
        ((V, F, {"target_faces": 5, "descriptor": "mean_curvature"}), ValueError, "descriptor = mean_curvature is for"),
        ((V, F, {"target_faces": 5, "new_layer": True}), ValueError, "new_layer = True is for a pymeshlab.MeshSet"),
        (
            (V, F, {"target_faces": 5, "error_as_quality": True}),
            ValueError,
            "error_as_quality = True is for a pymeshlab.MeshSet or a file, not for arrays",
        ),
        (
            (V, F, {"target_faces": 5, "lock_selected_vertices": True}),
            ValueError,
            "lock_selected_vertices = True is for a pymeshlab.MeshSet or a file, not for arrays",
        ),
        ((V, F, {"target_faces": 5, "progress": 3}), TypeError, "progress must be a callable or True, not int"),
        ((V, F, {"target_faces": 5, "return_result": True}), TypeError, "return_result is for meshes of other"),
        (([[0.0, 0, 0]], [[0, 0, 0]], {"target_faces": 5}), TypeError, "list cannot be simplified; accepted are two"),
        ((V, F, {"no_such": 5}), TypeError, "no_such"),
    ],
)
def test_refused_by_name(arguments, error: type[Exception], said: str) -> None:
    *arrays, options = arguments if isinstance(arguments[-1], dict) else (*arguments, {})
    with pytest.raises(error, match=said):
        ls.simplify(*arrays, **options)


@pytest.mark.parametrize("name", ["effort", "boundary", "seams"])
@pytest.mark.parametrize("value", [-1, 3])
def test_c_function_refuses_choices_that_there_are_not(name: str, value: int) -> None:
    with pytest.raises(ValueError, match=f"{name} = {value} is outside "):
        run(MeshArrays(V, F.astype(np.int32)), {"target_faces": 5, name: value}, None)


def test_every_parameter_of_the_filter_is_known_here() -> None:
    """A new one has to be handed on, or refused where it is given."""
    handed_on = {name for name, *_ in ParametersStructure._fields_} | {
        "target_percent",
        "selected_only",
        "keep_attributes",
    }
    assert {parameter.id for parameter in ROW.parameters} <= handed_on | set(_MESH_SETS_ONLY)
