# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The other tools: one function and one row of PEERS for each.

A function gets vertices (float32), faces (int32), the faces to reach and a stopwatch, prepares the library's
own mesh, simplifies under the stopwatch, and returns vertices and faces. Each runs in a process of its own.
"""

import ctypes
import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np


@dataclass(frozen=True)
class Peer:
    """One library with one choice of its settings."""

    id: str
    library: str  # as shown in the page
    settings: str
    implementation: str  # peers with the same one share their code, whatever they are called
    simplify: Callable
    threads: int = 1


class _PeerMesh(ctypes.Structure):
    """peers/peer_interface.h's PeerMesh."""

    _fields_ = [
        ("points", ctypes.c_void_p),
        ("corners", ctypes.c_void_p),
        ("point_count", ctypes.c_size_t),
        ("face_count", ctypes.c_size_t),
        ("target_faces", ctypes.c_size_t),
        ("cpu_seconds", ctypes.c_double),
        ("wall_seconds", ctypes.c_double),
    ]


def _shared_object(library: str, function: str) -> Callable:
    """A peer in C++: a function of one of the shared objects that `build_peers.py` builds."""

    def simplify(vertices, faces, target, stopwatch):
        points = np.array(vertices, dtype=np.float32, order="C")
        corners = np.array(faces, dtype=np.uint32, order="C")
        mesh = _PeerMesh(points.ctypes.data, corners.ctypes.data, len(points), len(corners), target)
        loaded = ctypes.CDLL(str(Path(os.environ["BENCHMARK_PEERS"]) / f"{library}.so"))
        with stopwatch:
            failed = getattr(loaded, function)(ctypes.byref(mesh))
        if failed:
            raise RuntimeError(f"{library}: {function} failed")
        stopwatch.cpu_seconds, stopwatch.wall_seconds = mesh.cpu_seconds, mesh.wall_seconds
        return points[: mesh.point_count], corners[: mesh.face_count]

    return simplify


def _pymeshlab(quality_weight: bool = False, **settings) -> Callable:
    def simplify(vertices, faces, target, stopwatch):
        import pymeshlab

        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(np.asarray(vertices, dtype=np.float64), np.asarray(faces, dtype=np.int32)))
        with stopwatch:
            if quality_weight:
                meshes.compute_scalar_by_discrete_curvature_per_vertex(curvaturetype="RMS Curvature")
            meshes.meshing_decimation_quadric_edge_collapse(
                targetfacenum=target, qualityweight=quality_weight, **settings
            )
        result = meshes.current_mesh()
        return result.vertex_matrix(), result.face_matrix()

    return simplify


def _meshlib(**settings) -> Callable:
    def simplify(vertices, faces, target, stopwatch):
        from meshlib import mrmeshnumpy, mrmeshpy

        mesh = mrmeshnumpy.meshFromFacesVerts(np.asarray(faces, dtype=np.int32), np.asarray(vertices, np.float32))
        chosen = mrmeshpy.DecimateSettings()
        chosen.maxDeletedFaces = len(faces) - target
        chosen.packMesh = True
        for name, value in settings.items():
            setattr(chosen, name, value)
        with stopwatch:
            mrmeshpy.decimateMesh(mesh, chosen)
        return mrmeshnumpy.getNumpyVerts(mesh), mrmeshnumpy.getNumpyFaces(mesh.topology)

    return simplify


def _vtk(algorithm: str, **settings) -> Callable:
    def simplify(vertices, faces, target, stopwatch):
        import pyvista
        import vtk

        mesh = pyvista.PolyData.from_regular_faces(np.asarray(vertices, np.float32), faces)
        decimation = getattr(vtk, algorithm)()
        decimation.SetInputData(mesh)
        decimation.SetTargetReduction(1 - target / len(faces))
        for name, value in settings.items():
            getattr(decimation, "Set" + name)(value)
        with stopwatch:
            decimation.Update()
        result = pyvista.wrap(decimation.GetOutput())
        return np.asarray(result.points), result.regular_faces

    return simplify


def _open3d(vertices, faces, target, stopwatch):
    import open3d

    mesh = open3d.geometry.TriangleMesh(
        open3d.utility.Vector3dVector(vertices.astype(np.float64)), open3d.utility.Vector3iVector(faces)
    )
    with stopwatch:
        result = mesh.simplify_quadric_decimation(target)
    return np.asarray(result.vertices), np.asarray(result.triangles)


def _blender(vertices, faces, target, stopwatch):
    import bpy

    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata(vertices.tolist(), [], faces.tolist())
    thing = bpy.data.objects.new("thing", mesh)
    bpy.context.scene.collection.objects.link(thing)
    modifier = thing.modifiers.new("decimate", "DECIMATE")
    modifier.ratio = target / len(faces)
    with stopwatch:
        result = thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    points = np.empty(3 * len(result.vertices), dtype=np.float32)
    result.vertices.foreach_get("co", points)
    result.calc_loop_triangles()
    corners = np.empty(3 * len(result.loop_triangles), dtype=np.int32)
    result.loop_triangles.foreach_get("vertices", corners)
    return points.reshape(-1, 3), corners.reshape(-1, 3)


def _openmesh(normal_flipping: bool) -> Callable:
    def simplify(vertices, faces, target, stopwatch):
        import openmesh

        mesh = openmesh.TriMesh(points=vertices.astype(np.float64), face_vertex_indices=faces)
        mesh.request_face_normals()
        mesh.update_face_normals()
        decimater = openmesh.TriMeshDecimater(mesh)
        quadric = openmesh.TriMeshModQuadricHandle()
        decimater.add(quadric)
        decimater.module(quadric).unset_max_err()
        if normal_flipping:
            decimater.add(openmesh.TriMeshModNormalFlippingHandle())
        with stopwatch:
            decimater.initialize()
            decimater.decimate_to_faces(n_faces=target)
            mesh.garbage_collection()
        return mesh.points(), mesh.face_vertex_indices()

    return simplify


def _fast_simplification(vertices, faces, target, stopwatch):
    import fast_simplification

    with stopwatch:
        points, triangles = fast_simplification.simplify(vertices, faces, target_count=target)
    return points, triangles


def _this_project(**settings) -> Callable:
    """The plugin's guided filter in pymeshlab, without the report's distances, on one thread."""

    def simplify(vertices, faces, target, stopwatch):
        import pymeshlab

        import laplacian_simplify

        laplacian_simplify.load()
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(np.asarray(vertices, dtype=np.float64), np.asarray(faces, dtype=np.int32)))
        with stopwatch:
            meshes.apply_filter(
                "meshing_decimation_laplacian_quadric_edge_collapse",
                target_faces=target,
                measure_error=False,
                threads=1,
                **settings,
            )
        result = meshes.current_mesh()
        return result.vertex_matrix(), result.face_matrix()

    return simplify


_BEST_MESHLAB = {"preservenormal": True, "preserveboundary": True}
_VCG, _MESHOPT, _MESHLIB, _VTK = "VCG", "meshoptimizer", "MeshLib", "VTK"

PEERS = [
    Peer(
        "cgal_lt", "CGAL", "Lindstrom–Turk, bounded normal change", "CGAL LT", _shared_object("cgal", "LindstromTurk")
    ),
    Peer(
        "cgal_gh",
        "CGAL",
        "Garland–Heckbert, bounded normal change",
        "CGAL GH",
        _shared_object("cgal", "GarlandHeckbert"),
    ),
    Peer("pymeshlab", "pymeshlab", "defaults", _VCG, _pymeshlab()),
    Peer("pymeshlab_preserve", "pymeshlab", "preserve normal and boundary", _VCG, _pymeshlab(**_BEST_MESHLAB)),
    Peer(
        "pymeshlab_weighted",
        "pymeshlab",
        "the same + quality weight by RMS curvature",
        _VCG,
        _pymeshlab(quality_weight=True, **_BEST_MESHLAB),
    ),
    Peer(
        "meshoptimizer_debian",
        "meshoptimizer (Debian)",
        "simplify, any error",
        _MESHOPT,
        _shared_object("meshoptimizer_debian", "MeshoptimizerSimplify"),
    ),
    Peer(
        "meshoptimizer",
        "meshoptimizer (newest)",
        "simplify, any error",
        _MESHOPT,
        _shared_object("meshoptimizer_newest", "MeshoptimizerSimplify"),
    ),
    Peer(
        "meshoptimizer_update",
        "meshoptimizer (newest)",
        "simplifyWithUpdate, any error",
        _MESHOPT,
        _shared_object("meshoptimizer_newest", "MeshoptimizerSimplifyWithUpdate"),
    ),
    Peer("meshlib", "MeshLib", "defaults", _MESHLIB, _meshlib()),
    Peer(
        "meshlib_best",
        "MeshLib",
        "stabilizer 0, aspect ratio 100",
        _MESHLIB,
        _meshlib(stabilizer=0.0, maxTriangleAspectRatio=100.0),
    ),
    Peer(
        "meshlib_parts",
        "MeshLib",
        "the same, 2 parts",
        _MESHLIB,
        _meshlib(stabilizer=0.0, maxTriangleAspectRatio=100.0, subdivideParts=2),
    ),
    Peer("vtk_quadric", "VTK", "vtkQuadricDecimation, defaults", _VTK, _vtk("vtkQuadricDecimation")),
    Peer(
        "vtk_quadric_volume",
        "VTK",
        "vtkQuadricDecimation, volume preserving",
        _VTK,
        _vtk("vtkQuadricDecimation", VolumePreservation=True),
    ),
    Peer("vtk_pro_defaults", "VTK", "vtkDecimatePro, defaults", "VTK DecimatePro", _vtk("vtkDecimatePro")),
    Peer(
        "vtk_pro",
        "VTK",
        "vtkDecimatePro, topology kept",
        "VTK DecimatePro",
        _vtk("vtkDecimatePro", PreserveTopology=True),
    ),
    Peer("open3d", "Open3D", "quadric, defaults", "Open3D", _open3d),
    Peer("blender", "Blender bpy", "Decimate modifier, collapse", "Blender", _blender),
    Peer("openmesh", "OpenMesh", "quadric", "OpenMesh", _openmesh(normal_flipping=False)),
    Peer("openmesh_flip", "OpenMesh", "quadric, no normal flips", "OpenMesh", _openmesh(normal_flipping=True)),
    Peer(
        "fast_simplification",
        "fast-simplification",
        "defaults (also behind PyVista and trimesh)",
        "sp4cerat's Fast-Quadric-Mesh-Simplification",
        _fast_simplification,
    ),
]

_FAST, _BALANCED, _BEST = 0, 1, 2
_SWEEPS, _STRICT = 0, 1
_OWN = "this project"

OWN = [
    Peer("fast", _OWN, "effort fast", _OWN, _this_project(effort=_FAST, order=_SWEEPS)),
    Peer("balanced", _OWN, "effort balanced", _OWN, _this_project(effort=_BALANCED, order=_SWEEPS)),
    Peer("best", _OWN, "effort best", _OWN, _this_project(effort=_BEST, order=_SWEEPS)),
    Peer("strict", _OWN, "effort fast, order strict", _OWN, _this_project(effort=_FAST, order=_STRICT)),
]

# The engine without a host; geometry is that of the plugin, so it only appears where time is measured.
ENGINE = [
    Peer("engine_fast", "engine on arrays", "effort fast, 1 thread", _OWN, _shared_object("engine", "EngineFast")),
    Peer(
        "engine_fast_2",
        "engine on arrays",
        "effort fast, 2 threads",
        _OWN,
        _shared_object("engine", "EngineFastTwoThreads"),
        threads=2,
    ),
    Peer(
        "engine_balanced",
        "engine on arrays",
        "effort balanced, 1 thread",
        _OWN,
        _shared_object("engine", "EngineBalanced"),
    ),
    Peer(
        "engine_balanced_2",
        "engine on arrays",
        "effort balanced, 2 threads",
        _OWN,
        _shared_object("engine", "EngineBalancedTwoThreads"),
        threads=2,
    ),
    Peer("engine_best", "engine on arrays", "effort best, 1 thread", _OWN, _shared_object("engine", "EngineBest")),
]

REFERENCE, SECOND_REFERENCE, HOST = "cgal_lt", "cgal_gh", "pymeshlab"


def peer_named(identifier: str) -> Peer:
    """The row of the tables above with this id."""
    return next(peer for peer in PEERS + OWN + ENGINE if peer.id == identifier)
