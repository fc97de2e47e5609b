# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the sample meshes, the same bytes each time: generate.py [FOLDER]."""

import random
import sys
from pathlib import Path

import numpy as np

from mesh_files import Mesh, TexturedMesh, write_obj, write_ply


def triangulated(quads: np.ndarray) -> np.ndarray:
    """Two triangles for every quad."""
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]], axis=1).reshape(-1, 3)


def grid_quads(rows: int, columns: int, *, close_rows: bool = False, close_columns: bool = False) -> np.ndarray:
    """Quads over vertices numbered row by row; a closed direction joins its end to its start."""
    i, j = np.meshgrid(
        np.arange(rows if close_rows else rows - 1),
        np.arange(columns if close_columns else columns - 1),
        indexing="ij",
    )
    below, right = (i + 1) % rows, (j + 1) % columns
    corners = [i * columns + j, below * columns + j, below * columns + right, i * columns + right]
    return np.stack([c.ravel() for c in corners], axis=1)


def without_unused_vertices(mesh: Mesh) -> Mesh:
    used, faces = np.unique(mesh.faces, return_inverse=True)
    return Mesh(mesh.positions[used], faces.reshape(mesh.faces.shape))


def square_outline(angles: np.ndarray, half_width: float, inset: float) -> np.ndarray:
    """Distance from the axis to a square, moved inwards; corners at x > 0 are sharp, the others rounded."""
    corner_radius = 0.9
    largest = np.maximum(abs(np.cos(angles)), abs(np.sin(angles)))
    smallest = np.minimum(abs(np.cos(angles)), abs(np.sin(angles)))
    sharp = (half_width - inset) / largest
    centre = half_width - corner_radius
    along = centre * (largest + smallest)
    arc = along + np.sqrt(np.maximum(along**2 - 2 * centre**2 + (corner_radius - inset) ** 2, 0))
    on_arc = (np.cos(angles) < 0) & (sharp * smallest > centre)
    return np.where(on_arc, arc, sharp)


def mechanical_part() -> Mesh:
    """A square flange with a boss: a closed profile of rings around the bore."""
    angles = np.arange(160) * (2 * np.pi / 160)
    half_width, height, top = 3.0, 1.2, 2.6  # of the flange, its height, that of the boss
    edge_radius, foot_radius, chamfer = 0.35, 0.4, 0.15
    boss, bore, counterbore, counterbore_depth = 1.7, 1.0, 1.35, 0.5
    rings: list[tuple[np.ndarray, float]] = []

    def circle(radius: float) -> np.ndarray:
        return np.full(angles.size, radius)

    def outline(inset: float) -> np.ndarray:
        return square_outline(angles, half_width, inset)

    def straight(start: np.ndarray, start_z: float, end: np.ndarray, end_z: float, steps: int) -> None:
        """From a ring up to, and without, the next one."""
        for t in np.arange(steps) / steps:
            rings.append(((1 - t) * start + t * end, (1 - t) * start_z + t * end_z))

    straight(circle(counterbore), 0, outline(0), 0, 10)
    straight(outline(0), 0, outline(0), height - edge_radius, 6)
    for turn in np.arange(6) / 6 * (np.pi / 2):
        inset = edge_radius * (1 - np.cos(turn))
        rings.append((outline(inset), height - edge_radius * (1 - np.sin(turn))))
    straight(outline(edge_radius), height, circle(boss + foot_radius), height, 8)
    for turn in np.arange(6) / 6 * (np.pi / 2):
        radius = boss + foot_radius * (1 - np.sin(turn))
        rings.append((circle(radius), height + foot_radius * (1 - np.cos(turn))))
    straight(circle(boss), height + foot_radius, circle(boss), top, 8)
    straight(circle(boss), top, circle(bore + chamfer), top, 5)
    straight(circle(bore + chamfer), top, circle(bore), top - chamfer, 2)
    straight(circle(bore), top - chamfer, circle(bore), counterbore_depth, 14)
    straight(circle(bore), counterbore_depth, circle(counterbore), counterbore_depth, 4)
    straight(circle(counterbore), counterbore_depth, circle(counterbore), 0, 5)

    positions = [
        np.stack([radii * np.cos(angles), radii * np.sin(angles), np.full(angles.size, z)], axis=1)
        for radii, z in rings
    ]
    quads = grid_quads(len(rings), angles.size, close_rows=True, close_columns=True)
    return Mesh(np.concatenate(positions), triangulated(quads[:, ::-1]))


def icosphere(level: int) -> Mesh:
    """A regular icosahedron, every triangle divided into four, level times."""
    golden = (1 + 5**0.5) / 2
    points = [(-1, golden, 0), (1, golden, 0), (-1, -golden, 0), (1, -golden, 0)]
    points = points + [(z, x, y) for x, y, z in points] + [(y, z, x) for x, y, z in points]
    positions = np.array(points, float)
    edge = 2.0
    distances = np.linalg.norm(positions[:, None] - positions[None], axis=2)
    near = abs(distances - edge) < 0.1
    faces = [
        (i, j, k)
        for i in range(12)
        for j in range(i + 1, 12)
        for k in range(j + 1, 12)
        if near[i, j] and near[j, k] and near[i, k]
    ]
    faces = [f if np.linalg.det(positions[list(f)]) > 0 else f[::-1] for f in faces]
    mesh = Mesh(positions, np.array(faces))
    for _ in range(level):
        mesh = divided_into_four(mesh)
    return Mesh(mesh.positions / np.linalg.norm(mesh.positions, axis=1, keepdims=True), mesh.faces)


def divided_into_four(mesh: Mesh) -> Mesh:
    a, b, c = mesh.faces.T
    edges = np.sort(np.concatenate([mesh.faces[:, [0, 1]], mesh.faces[:, [1, 2]], mesh.faces[:, [2, 0]]]), axis=1)
    unique_edges, middle = np.unique(edges, axis=0, return_inverse=True)
    ab, bc, ca = middle.reshape(3, -1) + len(mesh.positions)
    corners = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    faces = np.concatenate([np.stack(corner, axis=1) for corner in corners])
    return Mesh(np.concatenate([mesh.positions, mesh.positions[unique_edges].mean(axis=1)]), faces)


def organic_shape() -> Mesh:
    """A sphere with blunt limbs and a dent, smooth everywhere."""
    sphere = icosphere(5)
    limbs = [  # direction, height, sharpness
        ((1, 0.2, -0.5), 0.9, 9), ((-0.9, 0.5, -0.4), 0.8, 8), ((0.1, -1, -0.5), 0.85, 9),
        ((0.1, 0.9, 0.5), 0.7, 10), ((0.1, -0.2, 1), 1.1, 6), ((-0.6, -0.6, 0.6), -0.35, 12),
    ]  # fmt: skip
    radii = np.ones(len(sphere.positions))
    for direction, height, sharpness in limbs:
        axis = np.array(direction) / np.linalg.norm(direction)
        radii += height * np.exp(sharpness * (sphere.positions @ axis - 1))
    radii += 0.02 * np.prod(np.sin(5 * sphere.positions), axis=1)
    return Mesh(sphere.positions * radii[:, None], sphere.faces)


def open_surface() -> Mesh:
    """A folded sheet with a straight crease, straight borders, and a window."""
    steps = 91
    u, v = np.meshgrid(np.linspace(-1, 1, steps), np.linspace(-1, 1, steps), indexing="ij")
    z = 0.5 * abs(u) + 0.12 * np.sin(2.2 * v) * (1 + u) + 0.05 * np.cos(6 * u * v)
    quads = grid_quads(steps, steps)
    centres = np.stack([u.ravel(), v.ravel()], axis=1)[quads].mean(axis=1)
    window = np.linalg.norm(centres - np.array([0.45, -0.3]), axis=1) < 0.25
    positions = np.stack([u.ravel(), v.ravel(), z.ravel()], axis=1)
    return without_unused_vertices(Mesh(positions, triangulated(quads[~window])))


def non_manifold_surface() -> Mesh:
    """Three leaves that share one edge line, and beside them two cones that share one vertex."""
    rows, columns, leaves = 40, 24, 3
    along = np.linspace(-1, 1, rows)
    spine = np.stack([0.15 * np.sin(3 * along), 0.1 * np.cos(2 * along), along], axis=1)
    positions, faces = [spine], []
    for leaf in range(leaves):
        angle = 2 * np.pi * leaf / leaves + 0.3
        across = np.arange(1, columns) / (columns - 1)
        curl = angle + 0.9 * across
        offsets = across[:, None] * np.stack([np.cos(curl), np.sin(curl), 0 * curl], axis=1)
        positions.append((spine[:, None] + offsets[None]).reshape(-1, 3))
        local = grid_quads(rows, columns)
        row, column = local // columns, local % columns
        first = rows + leaf * rows * (columns - 1)
        faces.append(np.where(column == 0, row, first + row * (columns - 1) + column - 1))
    apex = rows + leaves * rows * (columns - 1)
    cone_positions, cone_faces = double_cone(apex)
    leaf_faces = triangulated(np.concatenate(faces))
    return Mesh(np.concatenate([*positions, cone_positions]), np.concatenate([leaf_faces, cone_faces]))


def double_cone(apex: int) -> tuple[np.ndarray, np.ndarray]:
    """Two open cones over one apex, whose index is given."""
    around, steps, centre = 48, 10, np.array([2.4, 0.0, 0.0])
    angles = np.arange(around) * (2 * np.pi / around)
    positions, faces = [centre[None]], []
    for side, direction in enumerate((1, -1)):
        first = apex + 1 + side * around * steps
        for step in range(1, steps + 1):
            r, z = 0.6 * step / steps, direction * 0.9 * step / steps
            ring = [r * np.cos(angles), r * np.sin(angles), np.full(around, z)]
            positions.append(centre + np.stack(ring, axis=1))
        ring_index, following = np.arange(around), (np.arange(around) + 1) % around
        tip = np.stack([np.full(around, apex), first + ring_index, first + following], axis=1)
        wall = triangulated(first + grid_quads(steps, around, close_columns=True))
        faces.append((np.concatenate([tip, wall]))[:, ::direction])
    return np.concatenate(positions), np.concatenate(faces)


def quad_mesh() -> Mesh:
    """The boundary of an angle bracket of small cubes, one arm twisted: sharp edges, quads only."""
    inside = np.zeros((44, 14, 32), bool)
    inside[1:43, 1:13, 1:9] = True
    inside[1:9, 1:13, 1:31] = True
    faces = []
    for axis in range(3):
        for direction in (1, -1):
            exposed = inside & ~np.roll(inside, -direction, axis)
            cells = np.argwhere(exposed)
            u, v = np.eye(3, dtype=int)[[(axis + 1) % 3, (axis + 2) % 3]]
            origin = cells + np.eye(3, dtype=int)[axis] * (1 if direction > 0 else 0)
            faces.append(np.stack([origin, origin + u, origin + u + v, origin + v], axis=1)[:, ::direction])
    points, quads = np.unique(np.concatenate(faces).reshape(-1, 3), axis=0, return_inverse=True)
    positions = (points - np.array([1.0, 7.0, 5.0])) / 10
    turn = 0.15 * np.maximum(positions[:, 0] - 1, 0) ** 2
    y, z = positions[:, 1].copy(), positions[:, 2].copy()
    positions[:, 1] = y * np.cos(turn) - z * np.sin(turn)
    positions[:, 2] = y * np.sin(turn) + z * np.cos(turn)
    return Mesh(positions, quads.reshape(-1, 4))


def noisy_scan() -> Mesh:
    """A relief as a range scanner sees it: 50,000 faces, depth noise, edges turned at random."""
    rows, columns = 251, 101
    generator = random.Random(2012)
    x, y = np.meshgrid(np.linspace(-2.5, 2.5, rows), np.linspace(-1, 1, columns), indexing="ij")
    dome = np.sqrt(np.maximum(0.75**2 - (x + 1.5) ** 2 - y**2, 0))
    pyramid = np.maximum(0.6 - np.maximum(abs(x), abs(y)), 0)
    step = np.clip((abs(x - 1.6) < 0.6) * (0.65 - abs(y)) * 6, 0, 0.4)
    depth = np.maximum(np.maximum(dome, pyramid), step) + 0.04 * np.cos(2 * x) * np.cos(3 * y)
    noise = [sum(generator.random() for _ in range(12)) - 6 for _ in range(rows * columns)]
    positions = np.stack([x.ravel(), y.ravel(), depth.ravel() + 0.004 * np.array(noise)], axis=1)
    quads = grid_quads(rows, columns)
    turned = np.array([generator.random() < 0.5 for _ in range(len(quads))])
    quads[turned] = np.roll(quads[turned], 1, axis=1)
    return Mesh(positions, triangulated(quads))


class Cube:
    """A cube from -1 to 1 whose sides are grids that meet along its edges."""

    def __init__(self, steps: int) -> None:
        t = np.linspace(-1, 1, steps)
        self.u, self.v = (values.ravel() for values in np.meshgrid(t, t, indexing="ij"))
        """Of the points of every side."""
        self.faces = triangulated(grid_quads(steps, steps))
        """Of a side."""
        corners = []
        for side in range(6):
            axis, sign = side // 2, 1 - 2 * (side % 2)
            point = np.empty((self.u.size, 3))
            point[:, axis], point[:, (axis + 1) % 3], point[:, (axis + 2) % 3] = sign, self.u, sign * self.v
            corners.append(point)
        whole = np.round(np.concatenate(corners) * (steps - 1)).astype(int)
        points, index = np.unique(whole, axis=0, return_inverse=True)
        self.positions = points / (steps - 1)
        self.index = index.reshape(-1)
        """The position of every point, one side after the other."""

    def all_faces(self) -> np.ndarray:
        """Of points, one side after the other."""
        return np.concatenate([self.faces + side * self.u.size for side in range(6)])


def textured_box() -> tuple[TexturedMesh, np.ndarray]:
    """A box with bulging sides: six charts, so that every edge of the box is a texture seam."""
    cube = Cube(17)
    texture_coordinates = []
    for side in range(6):
        cell = np.array([side % 3, side // 3])
        margin = 0.9
        in_cell = 0.5 + 0.5 * margin * np.stack([cube.u, cube.v], axis=1)
        texture_coordinates.append((cell + in_cell) / np.array([3, 2]))
    bulge = np.prod(1 - 0.85 * cube.positions**2, axis=1)[:, None]
    positions = cube.positions * (1 + 0.9 * bulge) * np.array([1.2, 1.0, 0.8])
    texture_faces = cube.all_faces()
    mesh_faces = cube.index[texture_faces]
    normals = vertex_normals(positions, mesh_faces)
    mesh = TexturedMesh(positions, mesh_faces, np.concatenate(texture_coordinates), texture_faces, normals)
    return mesh, checkered_texture()


MIRRORED_SCALE = np.array([3, 1])
"""Cells of the textures of mirrored_box: three beside each other, one for each side of its material."""


def mirrored_box() -> TexturedMesh:
    """The same shape, leaning, with two charts a side, the second of them mirrored onto the first in the texture. Each
    of two materials has three sides."""
    cube, margin = Cube(15), 0.9
    texture_coordinates, texture_faces = [], []
    for side in range(6):
        for half in range(2):
            u, v = (cube.u, cube.v) if half == 0 else (cube.u + 1, -cube.v)
            cell = np.array([side % 3, 0])
            in_cell = 0.5 + 0.5 * margin * np.stack([2 * u - 1, v], axis=1)
            texture_coordinates.append((cell + in_cell) / MIRRORED_SCALE)
            right = cube.u[cube.faces].mean(axis=1) > 0
            texture_faces.append(cube.faces[right == (half == 0)] + (2 * side + half) * cube.u.size)
    texture_faces = np.concatenate(texture_faces)
    per_chart = cube.u.size
    chart, point = texture_faces // per_chart, texture_faces % per_chart
    bulge = np.prod(1 - 0.85 * cube.positions**2, axis=1)[:, None]
    positions = cube.positions * (1 + 0.9 * bulge) * np.array([1.2, 1.0, 0.8])
    positions[:, 0] += 0.2 * positions[:, 2] ** 2
    mesh_faces = cube.index[chart // 2 * per_chart + point]
    used, texture_faces = np.unique(texture_faces, return_inverse=True)
    return TexturedMesh(
        positions,
        mesh_faces,
        np.concatenate(texture_coordinates)[used],
        texture_faces.reshape(-1, 3),
        vertex_normals(positions, mesh_faces),
        materials=chart[:, 0] // 6,
    )


def field_texture(colors: list[tuple[int, int, int]]) -> np.ndarray:
    """Fields of one color each beside each other, checkered."""
    row, column = np.meshgrid(np.arange(32), np.arange(32 * len(colors)), indexing="ij")
    dark = ((row // 4 + column // 4) % 2)[..., None]
    return (np.array(colors)[column // 32] * (1 - 0.35 * dark)).astype(np.uint8)


def egg(steps: int) -> tuple[np.ndarray, np.ndarray]:
    """Points in all directions, more of them than is needed anywhere, and faces."""
    cube = Cube(steps)
    sphere = cube.positions / np.linalg.norm(cube.positions, axis=1, keepdims=True)
    positions = sphere * np.array([1.0, 1.0, 1.3])
    positions[:, :2] *= (1 - 0.2 * sphere[:, 2])[:, None]
    return positions, cube.index[cube.all_faces()]


def painted_egg() -> Mesh:
    """An egg whose color changes little by little from bottom to top, with spots that have a hard border."""
    positions, faces = egg(29)
    part = (positions[:, 2] / 1.3 + 1) / 2
    colors = (1 - part)[:, None] * np.array([40, 90, 170]) + part[:, None] * np.array([240, 220, 150])
    spots = np.array([[0.9, 0.2, 0.5], [-0.6, 0.8, 0.1], [-0.3, -0.9, 0.6], [0.5, -0.7, -0.9]])
    near = np.linalg.norm(positions[:, None] - spots[None], axis=2).min(axis=1)
    colors[near < 0.42] = (200, 30, 60)
    return Mesh(positions, faces, vertex_colors=np.floor(colors + 0.5))


def parted_egg() -> Mesh:
    """An egg of five parts, each with a color of its own at its faces."""
    positions, faces = egg(25)
    centers = positions[faces].mean(axis=1)
    longitude = np.floor((np.arctan2(centers[:, 1], centers[:, 0]) / (2 * np.pi) + 0.5) * 3).astype(int)
    part = np.where(centers[:, 2] > 0.85, 3, np.where(centers[:, 2] < -0.7, 4, np.clip(longitude, 0, 2)))
    colors = np.array([(230, 90, 60), (70, 150, 220), (240, 190, 60), (90, 180, 100), (150, 100, 190)])
    return Mesh(positions, faces, face_colors=colors[part])


def vertex_normals(positions: np.ndarray, faces: np.ndarray) -> np.ndarray:
    a, b, c = (positions[faces[:, k]] for k in range(3))
    normals = np.zeros_like(positions)
    for k in range(3):
        np.add.at(normals, faces[:, k], np.cross(b - a, c - a))
    return normals / np.linalg.norm(normals, axis=1, keepdims=True)


def checkered_texture() -> np.ndarray:
    """Three by two fields of one colour each, checkered."""
    upper = [(230, 90, 60), (70, 150, 220), (240, 190, 60)]
    lower = [(90, 180, 100), (150, 100, 190), (230, 230, 230)]
    colours = np.array(upper + lower)
    row, column = np.meshgrid(np.arange(64), np.arange(96), indexing="ij")
    field = 3 * (1 - row // 32) + column // 32
    dark = ((row // 4 + column // 4) % 2)[..., None]
    return (colours[field] * (1 - 0.35 * dark)).astype(np.uint8)


PLY_MESHES = {
    "flange.ply": mechanical_part,
    "creature.ply": organic_shape,
    "folded_sheet.ply": open_surface,
    "leaves_and_cones.ply": non_manifold_surface,
    "bracket_quads.ply": quad_mesh,
    "relief_scan.ply": noisy_scan,
    "painted_egg.ply": painted_egg,
    "parted_egg.ply": parted_egg,
}


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for name, make in PLY_MESHES.items():
        write_ply(folder / name, make(), "Laplacian Simplify sample mesh, CC0-1.0")
    mesh, texture = textured_box()
    write_obj(folder / "painted_box.obj", mesh, {"painted": (folder / "painted_box.png", texture)})
    materials = {
        "warm": (folder / "mirrored_box_warm.png", field_texture([(230, 90, 60), (240, 190, 60), (190, 60, 120)])),
        "cold": (folder / "mirrored_box_cold.png", field_texture([(70, 150, 220), (90, 180, 100), (150, 100, 190)])),
    }
    write_obj(folder / "mirrored_box.obj", mirrored_box(), materials)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)
