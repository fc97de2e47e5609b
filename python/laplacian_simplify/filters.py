# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin's filters as functions; their keywords are the ids of the plugin's parameters.

A keyword that is None, as all are by default, has the filter's own default. A test compares these signatures,
and the choices, with the plugin's tables.
"""

from collections.abc import Sequence
from typing import Literal

from .levels import LevelReport, reports_of_levels
from .report import ClassificationReport, DecimationReport, DescriptorReport, SmoothingReport
from .running import MeshSource, returned, run, with_one_target
from .simplification import Boundary, Computed, Effort, Guidance, Order, Seams, simplify

__all__ = ["classify", "descriptor", "levels_of_detail", "simplify", "smooth", "weighted"]

WeightedGuidance = Literal[Guidance, "curvature_weighted_quadric"]


def levels_of_detail(
    mesh: MeshSource,
    *,
    percents: str | Sequence[float] | None = None,
    max_errors: str | Sequence[float] | None = None,
    max_error: float | None = None,
    feature_weight: float | None = None,
    effort: Effort | int | None = None,
    descriptor: Guidance | int | None = None,
    boundary: Boundary | int | None = None,
    preserve_topology: bool | None = None,
    selected_only: bool | None = None,
    lock_selected_vertices: bool | None = None,
    keep_attributes: bool | None = None,
    attribute_weight: float | None = None,
    seams: Seams | int | None = None,
    avoid_self_intersections: bool | None = None,
    clean_input: bool | None = None,
    weld_distance: float | None = None,
    measure_error: bool | None = None,
    error_as_quality: bool | None = None,
    order: Order | int | None = None,
    threads: int | None = None,
) -> list[LevelReport]:
    """Several simplifications of a mesh, each coarser than the one before, as new meshes of the mesh set.

    >>> levels = ls.levels_of_detail("bunny.off", percents=[50, 25, 10])
    >>> levels[0].mesh_set.set_current_mesh(levels[0].mesh_id)

    Args:
        mesh: a mesh set, whose current mesh stays as it is and which gets a mesh for each level, or a file, which is
            read into a new one.
        percents: percent of the faces to keep, from the finest level to the coarsest; 50, 25 and 10 by default.
        max_errors: in their place, from the finest level to the coarsest: each level is as small as it can be if no
            point of either surface is farther than this from the other, in percent of the diagonal of the bounding box.
        max_error: a bound for all levels by percents.
        feature_weight: as of simplify, and so are the rest.
        effort: geometry against time.
        descriptor: what tells features from the rest.
        boundary: how open borders are treated.
        preserve_topology: keep every handle, hole and component.
        selected_only: only the selected faces are decimated; percents are of those.
        lock_selected_vertices: selected vertices neither move nor disappear.
        keep_attributes: colors, texture coordinates and numbers guide and are interpolated (default).
        attribute_weight: of attributes against the geometry.
        seams: keep (default) or ignore.
        avoid_self_intersections: no more faces cross each other than before (default).
        clean_input: first join open borders where they meet, and leave out degenerate and duplicate faces (default).
        weld_distance: borders this close are joined, too, in percent of the bounding box's diagonal.
        measure_error: measure the distances of every level for its report (default).
        error_as_quality: the distance of each vertex to the original becomes its quality and color.
        order: sweeps (default) or strict.
        threads: 0 all; the result does not depend on it.

    Returns:
        A report for each level; it names the mesh of the set that the level is.

    Raises:
        ValueError, OSError, RuntimeError: as simplify.
    """
    values = {name: value for name, value in locals().items() if name != "mesh"}
    return reports_of_levels(*returned("generate_laplacian_levels_of_detail", mesh, values))


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
