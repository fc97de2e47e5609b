# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How near to the best possible rms: shapes of which that is known, and every tool on them.

A triangle over a surface with curvatures k1, k2 of one sign has the least squared distance to it if it is equilateral
in lengths stretched by √|k1| and √|k2|, with its corners shifted along the normal. Its rms is then c √K times its area,
with K the Gaussian curvature and c = 2/(√3 √240), and the best spread of n faces over the surface gives

    rms = c (∫ K^⅓ dS)^1.5 / (n √S).

It holds while every face has many of the input below it. A cylinder has K = 0: strips of two triangles along the axis
are best there, m = n/2 of them with an rms of k L²/√720, L = 2πr/m.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import pi, sqrt

import numpy as np
from tqdm import tqdm

from mesh_topology import Mesh, welded
from meshes import BenchmarkMesh, store_mesh
from metrics import Surface
from peers import OWN, PEERS
from runs import Store, Workshop, load_result, result_path, run_tool

TARGETS = (2000, 1000, 500, 250)  # faces
SAMPLES = 50_000
CONSTANT = 2 / (sqrt(3) * sqrt(240))
COMPARED = ("fast", "balanced", "best", "cgal_lt", "cgal_gh", "pymeshlab", "meshoptimizer_debian")


@dataclass(frozen=True)
class Shape:
    """A surface over a rectangle of parameters (u, v), and the least rms of n faces on it."""

    name: str
    title: str
    looked_at: bool  # while constants of the engine or the refinement were chosen
    mesh: Callable[[], Mesh]
    least_rms: Callable[[int], float]
    most_faces: int = TARGETS[0]  # with more, too few of the input's are below each


def sphere_mesh(levels: int, axes=(1.0, 1.0, 1.0)) -> Mesh:
    """An icosahedron, its faces cut into four, on an ellipsoid; turned, so that no axis is one of the coordinates'."""
    golden = (1 + sqrt(5)) / 2
    points = [[0, s, t * golden] for s in (-1, 1) for t in (-1, 1)]
    points = np.array([np.roll(p, k) for k in range(3) for p in points], dtype=float)
    squared = ((points[:, None] - points[None]) ** 2).sum(axis=2)
    near = squared < 4.5
    corners = [
        (i, j, k)
        for i in range(12)
        for j in range(i + 1, 12)
        for k in range(j + 1, 12)
        if near[i, j] and near[j, k] and near[i, k]
    ]
    faces = np.array([c if np.linalg.det(points[list(c)]) > 0 else c[::-1] for c in corners])
    for _ in range(levels):
        points, faces = _cut_into_four(points, faces)
    points = points / np.linalg.norm(points, axis=1)[:, None] * np.array(axes)
    return Mesh(points @ _turn().T, faces)


def _cut_into_four(points: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    a, b, c = (points[faces[:, k]] for k in range(3))
    ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
    soup = np.concatenate([np.stack(t, axis=1) for t in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])
    mesh = welded(Mesh(soup.reshape(-1, 3), np.arange(3 * len(soup)).reshape(-1, 3)))
    vertices = mesh.vertices / np.linalg.norm(mesh.vertices, axis=1)[:, None]
    return vertices, mesh.faces


def _turn() -> np.ndarray:
    """A rotation by no special angle."""
    matrix, _ = np.linalg.qr(np.array([[0.36, 0.48, -0.8], [-0.7, 0.71, 0.1], [0.6, 0.5, 0.62]]))
    return matrix * np.sign(np.linalg.det(matrix))


def grid_mesh(point: Callable, across: int, along: int, closed: bool) -> Mesh:
    """Triangles over a grid that is closed across, and along if asked for; point(u, v), u and v in [0, 1]."""
    rows = along if closed else along + 1
    u, v = np.meshgrid(np.arange(across) / across, np.arange(rows) / along)
    points = np.stack(point(u.ravel(), v.ravel()), axis=1)
    i, j = (index.ravel() for index in np.meshgrid(np.arange(across), np.arange(along)))
    right, up = (i + 1) % across, (j + 1) % rows
    a, b, c, d = j * across + i, j * across + right, up * across + right, up * across + i
    return Mesh(points @ _turn().T, np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]))


def torus_mesh(minor: float) -> Mesh:
    def point(u, v):
        distance = 1 + minor * np.cos(2 * pi * u)
        return distance * np.cos(2 * pi * v), distance * np.sin(2 * pi * v), minor * np.sin(2 * pi * u)

    return grid_mesh(point, 128, 320, closed=True)


def cylinder_mesh(height: float) -> Mesh:
    return grid_mesh(lambda u, v: (np.cos(2 * pi * u), np.sin(2 * pi * u), height * v), 2048, 20, closed=False)


def spread_over(integral: float, area: float) -> Callable[[int], float]:
    """The formula above: ∫ K^⅓ dS and S."""
    return lambda faces: CONSTANT * integral**1.5 / (faces * sqrt(area))


def ellipsoid_least_rms(a: float, b: float, c: float) -> Callable[[int], float]:
    """K = (p²/(abc))², p the distance of the tangent plane from the center; by Gauss's rule along z."""
    nodes, weights = np.polynomial.legendre.leggauss(400)
    angle = 2 * pi * (np.arange(800) + 0.5) / 800
    z, phi = np.meshgrid(nodes, angle, indexing="ij")
    weight = np.meshgrid(weights, np.full(800, 2 * pi / 800), indexing="ij")
    x, y = np.sqrt(1 - z**2) * np.cos(phi), np.sqrt(1 - z**2) * np.sin(phi)
    inverse = np.sqrt((x / a) ** 2 + (y / b) ** 2 + (z / c) ** 2)  # 1/p
    area = a * b * c * inverse * weight[0] * weight[1]
    curvature = (a * b * c * inverse**2) ** -2.0
    return spread_over(float((np.cbrt(curvature) * area).sum()), float(area.sum()))


def torus_unit_rms(minor: float) -> Callable[[int], float]:
    """The same with |K| = |cos θ|/(r (1 + r cos θ)). Where K < 0 it is a unit, not a bound."""
    theta = 2 * pi * (np.arange(100_000) + 0.5) / 100_000
    element = 2 * pi * minor * (1 + minor * np.cos(theta)) * (2 * pi / len(theta))
    curvature = np.abs(np.cos(theta)) / (minor * (1 + minor * np.cos(theta)))
    return spread_over(float((np.cbrt(curvature) * element).sum()), float(element.sum()))


def strip_rms(faces: int) -> float:
    length = 2 * pi / (faces / 2)
    return length**2 / sqrt(720)


LEVELS = 6  # 81,920 faces

SHAPES = (
    Shape("sphere", "sphere", True, lambda: sphere_mesh(LEVELS), ellipsoid_least_rms(1, 1, 1)),
    Shape(
        "ellipsoid",
        "ellipsoid 1 : .7 : .4",
        True,
        lambda: sphere_mesh(LEVELS, (1, 0.7, 0.4)),
        ellipsoid_least_rms(1, 0.7, 0.4),
    ),
    Shape("torus", "torus 1 : .4", True, lambda: torus_mesh(0.4), torus_unit_rms(0.4)),
    Shape(
        "flat_ellipsoid",
        "ellipsoid 1 : .9 : .3",
        False,
        lambda: sphere_mesh(LEVELS, (1, 0.9, 0.3)),
        ellipsoid_least_rms(1, 0.9, 0.3),
    ),
    Shape(
        "long_ellipsoid",
        "ellipsoid 1 : .35 : .35",
        False,
        lambda: sphere_mesh(LEVELS, (1, 0.35, 0.35)),
        ellipsoid_least_rms(1, 0.35, 0.35),
    ),
    Shape("thin_torus", "torus 1 : .15", False, lambda: torus_mesh(0.15), torus_unit_rms(0.15)),
    Shape("cylinder", "open cylinder, 1 high", False, lambda: cylinder_mesh(1), strip_rms, 1000),
)


def prepared(shape: Shape, workshop: Workshop) -> BenchmarkMesh:
    folder = workshop.inputs / "analytic"
    mesh = BenchmarkMesh(shape.name, "analytic", folder / f"{shape.name}.npz", folder / f"{shape.name}.ply")
    if not mesh.arrays.exists():
        store_mesh(mesh, shape.mesh())
    return mesh


def rms_between(original: Surface, simplified: Mesh) -> float:
    """Both ways, in the unit of the meshes."""
    surface = Surface(simplified)
    forward, _ = surface.closest(original.samples(SAMPLES)[0])
    backward, _ = original.closest(surface.samples(SAMPLES)[0])
    return float(np.sqrt((forward.mean() + backward.mean()) / 2))


def measure_optimum(workshop: Workshop, store: Store, when: str) -> None:
    """Fills the section 'optimum': date, sizes {shape: faces} and factors {tool: {shape: {faces: rms / least}}}."""
    section = store.sections["optimum"] = {"date": when, "sizes": {}, "factors": {}}
    tools = [peer for peer in [*OWN, *PEERS] if peer.id in COMPARED]
    for shape in tqdm(SHAPES, desc="optimum", unit="shape"):
        mesh = prepared(shape, workshop)
        section["sizes"][shape.name] = mesh.face_count
        targets = [target for target in TARGETS if target <= shape.most_faces]
        original = Surface(mesh.load())
        for peer in tools:
            paths = [result_path(workshop, peer.id, mesh, target) for target in targets]
            done = section["factors"].setdefault(peer.id, {}).setdefault(shape.name, {})
            for path, target, run in zip(paths, targets, run_tool(workshop, peer.id, mesh, list(zip(targets, paths)))):
                if "failure" not in run:
                    result = load_result(path)
                    done[str(target)] = rms_between(original, result) / shape.least_rms(len(result.faces))
        store.save()
