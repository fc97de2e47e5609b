# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The guided decimation as a function on arrays, meshes of other libraries, mesh sets and files.

Its keywords are the ids of the plugin's parameters and what only arrays have; one that is None, as all are by default,
has the filter's own default. A test compares the signature, and the choices, with the plugin's tables.
"""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, Literal, TypedDict, TypeVar, overload

from .report import DecimationReport
from .running import is_mesh_source, run, with_one_target
from .tables import filter_named

if TYPE_CHECKING:
    from os import PathLike

    import numpy as np
    from numpy.typing import NDArray
    from typing_extensions import Unpack  # in typing from Python 3.11 on

    from .arrays import Simplified

M = TypeVar("M")
Effort = Literal["fast", "balanced", "best"]
Boundary = Literal["free", "preserve", "lock"]
Seams = Literal["keep", "ignore"]
Order = Literal["sweeps", "strict"]
Computed = Literal["laplacian", "normalised_umbrella", "mean_curvature", "gaussian_curvature", "curvature_estimation"]
Guidance = Literal[Computed, "vertex_quality"]
Kind = Literal["texture", "color", "scalar", "origin"]


class FileOptions(TypedDict, total=False):
    """The keywords of simplify that files have."""

    target_faces: int | None
    target_percent: float | None
    max_error: float | None
    feature_weight: float | None
    effort: Effort | int | None
    descriptor: Guidance | int | None
    boundary: Boundary | int | None
    keep_attributes: bool | None
    attribute_weight: float | None
    seams: Seams | int | None
    preserve_topology: bool | None
    avoid_self_intersections: bool | None
    clean_input: bool | None
    weld_distance: float | None
    measure_error: bool | None
    error_as_quality: bool | None
    order: Order | int | None
    threads: int | None


class SimplifyOptions(FileOptions, total=False):
    """The keywords of simplify but for return_result."""

    selected_only: bool | None
    lock_selected_vertices: bool | None
    new_layer: bool | None
    selected: "NDArray[np.bool_] | None"
    locked: "NDArray[np.bool_] | None"
    quality: "NDArray[Any] | None"
    vertex_attributes: "Mapping[str, NDArray[Any]] | None"
    corner_attributes: "Mapping[str, NDArray[Any]] | None"
    face_labels: "NDArray[Any] | None"
    attribute_kinds: Mapping[str, Kind] | None
    progress: Callable[[int, str], object] | bool | None


@overload
def simplify(mesh: "NDArray[Any]", faces: "NDArray[Any]", **options: "Unpack[SimplifyOptions]") -> "Simplified": ...
@overload  # a mesh set has no type that is known to checkers: with it the result has none either
def simplify(mesh: "str | PathLike[str]", **options: "Unpack[SimplifyOptions]") -> DecimationReport: ...
@overload
def simplify(
    mesh: M, *, return_result: Literal[True], **options: "Unpack[SimplifyOptions]"
) -> "tuple[M, Simplified]": ...
@overload
def simplify(mesh: M, **options: "Unpack[SimplifyOptions]") -> M: ...
def simplify(
    mesh: Any,
    faces: Any = None,
    *,
    target_faces: int | None = None,
    target_percent: float | None = None,
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
    new_layer: bool | None = None,
    measure_error: bool | None = None,
    error_as_quality: bool | None = None,
    order: Order | int | None = None,
    threads: int | None = None,
    selected: "NDArray[np.bool_] | None" = None,
    locked: "NDArray[np.bool_] | None" = None,
    quality: "NDArray[Any] | None" = None,
    vertex_attributes: "Mapping[str, NDArray[Any]] | None" = None,
    corner_attributes: "Mapping[str, NDArray[Any]] | None" = None,
    face_labels: "NDArray[Any] | None" = None,
    attribute_kinds: Mapping[str, Kind] | None = None,
    progress: Callable[[int, str], object] | bool | None = None,
    return_result: bool = False,
) -> Any:
    """Reduces the number of faces and keeps creases, corners and details longest.

    >>> vertices, faces = ls.simplify(vertices, faces, target_percent=10)
    >>> small = ls.simplify(mesh, target_percent=10)

    One of target_faces and target_percent, or max_error, or it with one of them, has to be given.

    Args:
        mesh: vertices as a NumPy array, (n, 3), float32 or float64, with the next argument; or a mesh of trimesh,
            pyvista, Open3D, meshio, vedo or pymeshlab. Those stay as they are, and the result is of the same type.
            Or a mesh set of pymeshlab, whose current mesh is changed, or a file, which stays as it is.
        faces: vertex indices as a NumPy array of integers, (m, 3).
        target_faces: faces to keep, of the selected ones where faces are selected.
        target_percent: percent of the faces to keep, above 0 to 100.
        max_error: no point of either surface is farther than this from the other, in percent of the diagonal of the
            bounding box; with a target, whichever comes first, without one as few faces as it allows. 0: no bound.
        feature_weight: lambda, 0 to 50: 0 plain decimation, 2 (default) suits most meshes, 4 less error at features and
            more elsewhere.
        effort: quality/speed trade-off: fast, balanced (default) or best.
        descriptor: measure that decides what counts as a feature; curvatures for mesh sets and files only.
        boundary: open borders are free, preserved (default) or locked.
        keep_attributes: colors, texture coordinates and numbers guide the collapse and are interpolated, and their
            seams stay (default); otherwise values are those of the vertices and faces that remain. Of vertices at one
            place, as textures make them along seams, clean_input makes one, which is split again at the end.
        attribute_weight: of attributes against the geometry, 0 to 100; 1 by default. 0: they guide nothing.
        seams: keep (default), or ignore: where the target asks for it parts of the texture may go.
        preserve_topology: keep every handle, hole and component.
        selected_only: only the selected faces are decimated; default where faces are selected.
        lock_selected_vertices: selected vertices neither move nor disappear; for mesh sets, arrays have locked.
        avoid_self_intersections: no more faces cross each other than before (default); the report says so if that could
            not be kept.
        clean_input: first join open borders where they meet, and leave out degenerate and duplicate faces and vertices
            of no face (default).
        weld_distance: borders this close are joined, too, in percent of the bounding box's diagonal.
        new_layer: keep the original, the result becomes a new mesh of the set; for mesh sets and files only.
        measure_error: measure the distances for the report (default).
        error_as_quality: the distance of each vertex of the result to the original becomes its quality, in the unit of
            the coordinates, and its color; for mesh sets and files only.
        order: sweeps, the parallel engine (default), or strict, VCG's own order; for mesh sets and files only.
        threads: 0 all; the result does not depend on it.
        selected: the selected faces, an array of bool, (m,). As all that follow not for mesh sets and files.
        locked: vertices that stay as they are, an array of bool, (n,).
        quality: the vertex quality, (n,), for descriptor = vertex_quality.
        vertex_attributes: arrays at the vertices under their names, (n,) or (n, k): as the next three for arrays only;
            meshes of other libraries have their own.
        corner_attributes: the same at the corners of the faces, (m, 3) or (m, 3, k).
        face_labels: materials or parts, integers, (m,): seams run between different ones.
        attribute_kinds: what a named array holds, where type, shape and name do not tell it: "texture", "color" (floats
            in 0..1, uint8 or uint16), "scalar" (any number, interpolated), "normal" (computed from the result; edges
            where those at one place are more than 30 degrees apart stay hard) or "origin" (the value of what remains).
            By default bytes in three or four columns and floats called color are colors, two columns of floats called
            uv or texcoord texture coordinates, three called normals are such, other floats scalars, and whole numbers
            are not interpolated.
        progress: called with percent and stage, in this thread; returning False stops the run, which then gives
            the mesh as it came. True shows a bar.
        return_result: for a mesh of another library: return it with the result that it was built from.

    Returns:
        For arrays a Simplified, which unpacks as vertices, faces and has report, vertex_origin, face_origin,
        vertex_attributes, corner_attributes and face_labels. For a mesh of another library a mesh of that type, or it
        and a Simplified. For a mesh set or a file the report. A target that could not be reached is no error: the
        report says why.

    Raises:
        TypeError: something is of a type that cannot be used; the text says what can.
        ValueError: a value is outside its range, or the arrays are no mesh.
        OSError: the file cannot be read.
        RuntimeError: the mesh of a set or a file is unusable; it is unchanged.
    """
    name = "meshing_decimation_laplacian_quadric_edge_collapse"
    values = {
        "target_faces": target_faces,
        "target_percent": target_percent,
        "max_error": max_error,
        "feature_weight": feature_weight,
        "effort": effort,
        "descriptor": descriptor,
        "boundary": boundary,
        "preserve_topology": preserve_topology,
        "selected_only": selected_only,
        "lock_selected_vertices": lock_selected_vertices,
        "keep_attributes": keep_attributes,
        "attribute_weight": attribute_weight,
        "seams": seams,
        "avoid_self_intersections": avoid_self_intersections,
        "clean_input": clean_input,
        "weld_distance": weld_distance,
        "new_layer": new_layer,
        "measure_error": measure_error,
        "error_as_quality": error_as_quality,
        "order": order,
        "threads": threads,
    }
    of_arrays = {
        "selected": selected,
        "locked": locked,
        "quality": quality,
        "vertex_attributes": vertex_attributes,
        "corner_attributes": corner_attributes,
        "face_labels": face_labels,
        "attribute_kinds": attribute_kinds,
        "progress": progress or None,
    }
    numbers = with_one_target(name, values)
    if not is_mesh_source(mesh):
        from .conversions import simplify_object

        return simplify_object(filter_named(name), mesh, faces, numbers, of_arrays, return_result)
    for keyword, value in {"faces": faces, **of_arrays, "return_result": return_result or None}.items():
        if value is not None:
            raise TypeError(f"{keyword} is for arrays and meshes of other libraries, not for a mesh set or a file")
    return run(name, DecimationReport, mesh, **numbers)
