# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin's filters as functions; their keywords are the ids of the plugin's parameters.

A keyword that is None, as all are by default, has the filter's own default. A test compares these signatures,
and the choices, with the plugin's tables.
"""

from typing import Literal

from .report import ClassificationReport, DecimationReport, DescriptorReport, SmoothingReport
from .running import MeshSource, run, with_one_target
from .simplification import Computed, Guidance, simplify

__all__ = ["classify", "descriptor", "simplify", "smooth", "weighted"]

WeightedGuidance = Literal[Guidance, "curvature_weighted_quadric"]


def weighted(
    mesh: MeshSource,
    *,
    error_function: Literal["quadric", "shortest_edge", "melax"] | int | None = None,
    feature_weight: float | None = None,
    descriptor: WeightedGuidance | int | None = None,
    class_aware: bool | None = None,
    classes: int | None = None,
    refine: bool | None = None,
    target_faces: int | None = None,
    target_percent: float | None = None,
    selected_only: bool | None = None,
) -> DecimationReport:
    """Decimation as Zhang et al. (2012) published it, for comparison and research.

    Args:
        mesh: a mesh set, whose current mesh is changed, or a file, which stays as it is.
        error_function: what a collapse costs before it is weighted.
        feature_weight: lambda of the paper, 10 by default; 0 plain.
        descriptor: what the cost is weighted by.
        class_aware: feature vertices collapse to feature vertices only (Section 4.4).
        classes: number of classes for class_aware.
        refine: refine the classes first.
        target_faces: faces to keep; this or the next has to be given.
        target_percent: percent of the faces to keep, above 0 to 100.
        selected_only: only the selected faces are decimated; default where faces are selected.

    Raises:
        ValueError, OSError, RuntimeError: as simplify.
    """
    name = "meshing_decimation_laplacian_weighted_edge_collapse"
    values = {
        "error_function": error_function,
        "feature_weight": feature_weight,
        "descriptor": descriptor,
        "class_aware": class_aware,
        "classes": classes,
        "refine": refine,
        "target_faces": target_faces,
        "target_percent": target_percent,
        "selected_only": selected_only,
    }
    with_one_target(name, values)
    return run(name, DecimationReport, mesh, **values)


def descriptor(
    mesh: MeshSource,
    *,
    descriptor: Computed | int | None = None,
    rescale: bool | None = None,
    colorize: bool | None = None,
    selected_only: bool | None = None,
) -> DescriptorReport:
    """Stores in the vertex quality how much every vertex stands out of its neighbourhood.

    Args:
        mesh: a mesh set, whose current mesh is changed, or a file, which stays as it is.
        descriptor: what is computed, the Laplacian by default.
        rescale: linearly, so that the 99.9 percentile becomes 1; what is above is cut.
        colorize: paint the vertices by their value (default).
        selected_only: only vertices of selected faces, or selected vertices, change.

    Raises:
        ValueError, OSError, RuntimeError: as simplify.
    """
    return run(
        "compute_scalar_by_laplacian_descriptor_per_vertex",
        DescriptorReport,
        mesh,
        descriptor=descriptor,
        rescale=rescale,
        colorize=colorize,
        selected_only=selected_only,
    )


def classify(
    mesh: MeshSource,
    *,
    descriptor: Guidance | int | None = None,
    classes: int | None = None,
    selected_classes: int | None = None,
    refine: bool | None = None,
    minimum_feature_neighbours: int | None = None,
    refinement_floor: float | None = None,
    class_as_quality: bool | None = None,
) -> ClassificationReport:
    """Selects the vertices on creases, corners and details, found by clustering a descriptor.

    Args:
        mesh: a mesh set, whose current mesh is changed, or a file, which stays as it is.
        descriptor: what is divided into classes, the Laplacian by default.
        classes: number of classes, 2 to 16; 2 by default.
        selected_classes: how many of the highest are selected; 1 by default.
        refine: close gaps by adding neighbours of feature vertices.
        minimum_feature_neighbours: for refine: how many are enough; 2 by default.
        refinement_floor: for refine: part of the threshold below which none is added; 0.5 by default.
        class_as_quality: store the number of the class in the vertex quality.

    Raises:
        ValueError, OSError, RuntimeError: as simplify.
    """
    return run(
        "compute_selection_by_laplacian_descriptor_per_vertex",
        ClassificationReport,
        mesh,
        descriptor=descriptor,
        classes=classes,
        selected_classes=selected_classes,
        refine=refine,
        minimum_feature_neighbours=minimum_feature_neighbours,
        refinement_floor=refinement_floor,
        class_as_quality=class_as_quality,
    )


def smooth(
    mesh: MeshSource,
    *,
    operator: Literal["umbrella", "scale_dependent", "normal_dependent"] | int | None = None,
    steps: int | None = None,
    step_size: float | None = None,
    boundary: Literal["free", "along", "fixed"] | int | None = None,
    selected_only: bool | None = None,
) -> SmoothingReport:
    """Moves every vertex towards the mean of its neighbours.

    Args:
        mesh: a mesh set, whose current mesh is changed, or a file, which stays as it is.
        operator: umbrella (uniform, default), scale_dependent or normal_dependent.
        steps: how often; 10 by default.
        step_size: part of the operator's vector that a vertex moves in a step, above 0 to 1; 0.5 by default.
        boundary: border vertices move as any other (default), along the border only, or not.
        selected_only: only vertices of selected faces, or selected vertices, move.

    Raises:
        ValueError, OSError, RuntimeError: as simplify.
    """
    return run(
        "apply_coord_umbrella_smoothing",
        SmoothingReport,
        mesh,
        operator=operator,
        steps=steps,
        step_size=step_size,
        boundary=boundary,
        selected_only=selected_only,
    )
