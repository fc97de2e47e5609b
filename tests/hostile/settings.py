# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What every mesh of the corpus goes through in a host: each filter with several settings."""

from dataclasses import dataclass
from typing import Any

DESCRIPTOR = "compute_scalar_by_laplacian_descriptor_per_vertex"
SELECTION = "compute_selection_by_laplacian_descriptor_per_vertex"
GUIDED = "meshing_decimation_laplacian_quadric_edge_collapse"
WEIGHTED = "meshing_decimation_laplacian_weighted_edge_collapse"
LEVELS = "generate_laplacian_levels_of_detail"
SMOOTHING = "apply_coord_umbrella_smoothing"


@dataclass(frozen=True)
class Setting:
    """A filter, its parameters by id, and a name for both."""

    name: str
    filter: str
    values: dict[str, Any]


def settings() -> list[Setting]:
    return [*_descriptors(), *_guided(), *_weighted(), *_levels(), *_smoothing()]


def _descriptors() -> list[Setting]:
    found = [Setting(f"descriptor_{k}", DESCRIPTOR, {"descriptor": k, "rescale": k == 3}) for k in range(5)]
    found.append(Setting("descriptor_of_selection", DESCRIPTOR, {"selected_only": True, "colorize": False}))
    found += [Setting(f"classes_by_{k}", SELECTION, {"descriptor": k, "refine": True}) for k in (0, 3, 5)]
    found.append(
        Setting("sixteen_classes", SELECTION, {"classes": 16, "selected_classes": 15, "class_as_quality": True})
    )
    return found


def _guided() -> list[Setting]:
    unmeasured = {"measure_error": False}  # it takes ten times as long as the rest
    values: dict[str, dict[str, Any]] = {
        "default": {},
        "fast_to_10_percent": {"target_percent": 10, "effort": 0, "threads": 2, **unmeasured},
        "best_to_one_face": {"target_faces": 1, "effort": 2, **unmeasured},
        "borders_free_topology_kept": {"target_percent": 5, "boundary": 0, "preserve_topology": True, **unmeasured},
        "borders_locked_plain": {"target_percent": 20, "boundary": 2, "feature_weight": 0, **unmeasured},
        "bound_alone": {"target_faces": 1, "max_error": 1},
        "bound_of_nearly_nothing": {"target_faces": 1, "max_error": 1e-7, "boundary": 0, **unmeasured},
        "best_within_bound": {"target_percent": 30, "max_error": 5, "effort": 2, **unmeasured},
        "seams_ignored": {"target_percent": 10, "seams": 1, "attribute_weight": 100},
        "attributes_let_be": {"target_percent": 20, "keep_attributes": False, "feature_weight": 50, **unmeasured},
        "attributes_guide_nothing": {"target_percent": 20, "attribute_weight": 0, "boundary": 0, "effort": 2},
        "input_as_it_is": {"target_percent": 10, "clean_input": False, "avoid_self_intersections": False, **unmeasured},
        "input_as_it_is_within_bound": {"target_faces": 1, "max_error": 2, "clean_input": False, **unmeasured},
        "welded_widely": {"target_percent": 30, "weld_distance": 5, **unmeasured},
        "welded_to_a_point": {"target_percent": 30, "weld_distance": 100, **unmeasured},
        "selection": {"target_faces": 1, "selected_only": True},
        "locked_vertices": {"target_percent": 5, "lock_selected_vertices": True, **unmeasured},
        "errors_as_quality": {"target_percent": 25, "error_as_quality": True, "new_layer": True},
        "gaussian_curvature": {"target_percent": 25, "descriptor": 3, "effort": 0, **unmeasured},
        "mean_curvature": {"target_percent": 25, "descriptor": 2, "effort": 0, "measure_error": False},
        "curvature_estimation": {"target_percent": 25, "descriptor": 4, "effort": 0, **unmeasured},
        "stored_quality": {"target_percent": 25, "descriptor": 5, **unmeasured},
        "strict": {"target_percent": 10, "order": 1, "effort": 0},
        "strict_best_borders_free": {"target_faces": 1, "order": 1, "effort": 2, "boundary": 0, **unmeasured},
        "strict_topology_kept": {
            "target_percent": 5,
            "order": 1,
            "preserve_topology": True,
            "clean_input": False,
            **unmeasured,
        },
    }
    return [Setting(name, GUIDED, given) for name, given in values.items()]


def _weighted() -> list[Setting]:
    found = [Setting(f"weighted_by_{k}", WEIGHTED, {"error_function": k, "target_percent": 20}) for k in range(3)]
    found.append(Setting("weighted_to_one_face", WEIGHTED, {"target_faces": 1, "class_aware": True, "refine": True}))
    found.append(Setting("weighted_by_curvature", WEIGHTED, {"target_percent": 30, "descriptor": 6}))
    return found


def _levels() -> list[Setting]:
    return [
        Setting("levels", LEVELS, {"percents": "60,20,1", "effort": 0}),
        Setting("levels_refined", LEVELS, {"percents": "50,50,10", "seams": 1, "boundary": 0, "measure_error": False}),
        Setting("levels_by_error", LEVELS, {"max_errors": "0.1,1,10", "measure_error": False}),
    ]


def _smoothing() -> list[Setting]:
    found = [
        Setting(f"smooth_by_{k}", SMOOTHING, {"operator": k, "steps": 5, "step_size": 1, "boundary": k})
        for k in range(3)
    ]
    found.append(Setting("smooth_selection", SMOOTHING, {"selected_only": True}))
    return found
