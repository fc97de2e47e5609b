# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""glTF scenes, as .glb or as .gltf with its buffers: all meshes of the scene in one, where their nodes put them."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import DamageError, counted
from .gltf_document import Document
from .mesh_data import Floats, Integers, MeshData, Texture, check_finite, check_indices
from .scene import Part, Scene, joined
from .source import Source

_TRIANGLES, _STRIP, _FAN = 4, 5, 6


def read_gltf(source: Source) -> MeshData:
    """Reads a glTF scene.

    Raises:
        DamageError: names the part of the document.
    """
    document = Document(source.read(), source.folder)
    return _Scene(document).mesh()


class _Scene:
    """Walks through the nodes and collects their meshes."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._textures: list[Texture] = []
        self._texture_of_image: dict[int, int] = {}
        self._notes: list[str] = []
        self._left_out = 0

    def mesh(self) -> MeshData:
        document = self._document
        scenes = document.rows("scenes")
        if scenes:
            roots = document.at("scenes", document.root.get("scene", 0), "the document").get("nodes", [])
        else:
            children = {child for node in document.rows("nodes") for child in node.get("children", [])}
            roots = [node for node in range(len(document.rows("nodes"))) if node not in children]
        scene = Scene()
        waiting = [(node, np.eye(4), frozenset[int]()) for node in reversed(roots)]
        while waiting:
            number, above, path = waiting.pop()
            node = document.at("nodes", number, "the scene")
            if number in path:
                raise DamageError(f"node {number}", "it is a child of itself", "the file is damaged")
            here = above @ _transform(node, number)
            if "mesh" in node:
                for part in self._parts(node["mesh"], number, here):
                    scene.add(part)
            waiting += [(child, here, path | {number}) for child in reversed(node.get("children", []))]
            scene.check(len(waiting))
        data = joined(scene.parts, self._textures)
        data.notes += self._notes
        if self._left_out:
            data.notes.append(f"{counted(self._left_out, 'primitive')} of points or lines left out")
        return data

    def _parts(self, mesh: int, node: int, transform: Floats) -> list[Part]:
        parts = []
        for k, primitive in enumerate(self._document.at("meshes", mesh, f"node {node}").get("primitives", [])):
            where = f"mesh {mesh}, primitive {k}"
            mode = primitive.get("mode", _TRIANGLES)
            if mode not in (_TRIANGLES, _STRIP, _FAN):
                self._left_out += 1
                continue
            if "KHR_draco_mesh_compression" in primitive.get("extensions", {}):
                raise DamageError(
                    where, "it is compressed with Draco, which is not read", "export it without compression"
                )
            parts.append(self._part(primitive, mode, where, transform))
        return parts

    def _part(self, primitive: Any, mode: int, where: str, transform: Floats) -> Part:
        document, attributes = self._document, primitive.get("attributes", {})
        if "POSITION" not in attributes:
            raise DamageError(where, "it has no positions", "the file is damaged")
        points = _shaped(document.accessor(attributes["POSITION"], where), 3, where, "positions")
        check_finite(points)
        if "indices" in primitive:
            indices = document.accessor(primitive["indices"], where).reshape(-1).astype(np.int64)
        else:
            indices = np.arange(len(points))
        if mode == _TRIANGLES and len(indices) % 3:
            raise DamageError(where, f"{len(indices)} corners do not make triangles", "the file is damaged")
        check_indices(indices, len(points), 3)
        part = Part(points @ transform[:3, :3].T + transform[:3, 3], _triangles(indices, mode))
        if np.linalg.det(transform[:3, :3]) < 0:  # a mirror turns faces inside out
            part.triangles = part.triangles[:, ::-1]
        if "COLOR_0" in attributes:
            part.colors = _colors(document.accessor(attributes["COLOR_0"], where), len(points), where)
        self._add_material(part, primitive, attributes, where)
        return part

    def _add_material(self, part: Part, primitive: Any, attributes: Any, where: str) -> None:
        """The color and the texture of the surface; textures have their origin at the top."""
        if "material" not in primitive:
            return
        material = self._document.at("materials", primitive["material"], where).get("pbrMetallicRoughness", {})
        factor = material.get("baseColorFactor")
        if isinstance(factor, list) and len(factor) == 4:
            part.face_color = tuple(int(min(max(float(value), 0), 1) * 255 + 0.5) for value in factor)
        texture = material.get("baseColorTexture")
        if not isinstance(texture, dict):
            return
        name = f"TEXCOORD_{texture.get('texCoord', 0)}"
        if name in attributes:
            uv = _shaped(self._document.accessor(attributes[name], where), 2, where, "texture coordinates")
            if len(uv) == len(part.points):
                part.uv = np.stack([uv[:, 0], 1 - uv[:, 1]], axis=1)
                part.texture = self._texture(texture.get("index"), where)

    def _texture(self, number: Any, where: str) -> int:
        image_number = self._document.at("textures", number, where).get("source")
        if not isinstance(image_number, int):  # only an extension names an image
            self._notes.append("a texture in a format that is not read was left out")
            return -1
        if image_number not in self._texture_of_image:
            self._texture_of_image[image_number] = self._load_image(image_number, where)
        return self._texture_of_image[image_number]

    def _load_image(self, number: int, where: str) -> int:
        image = self._document.at("images", number, where)
        content = self._document.image(image, where)
        suffix = next((end for kind, end in (("\x89PNG", ".png"), ("\xff\xd8", ".jpg"))
                       if content is not None and content.startswith(kind.encode("latin-1"))), None)  # fmt: skip
        if content is None or suffix is None:
            self._notes.append(f"image {number} is missing or neither PNG nor JPEG; the result has none in its place")
            return -1
        name = Path(str(image.get("uri") if _is_name(image.get("uri")) else image.get("name") or f"texture_{number}"))
        self._textures.append(Texture(name.name if name.suffix else name.name + suffix, content))
        return len(self._textures) - 1


def _is_name(uri: Any) -> bool:
    return isinstance(uri, str) and not uri.startswith("data:")


def _shaped(values: NDArray[Any], columns: int, where: str, name: str) -> Floats:
    if values.ndim != 2 or values.shape[1] != columns:
        raise DamageError(where, f"its {name} have not {columns} numbers each", "the file is damaged")
    return np.asarray(values, dtype=np.float64)


def _transform(node: Any, number: int) -> Floats:
    """The matrix of a node, or what its translation, rotation and scale make."""
    try:
        if "matrix" in node:
            given: Floats = np.array(node["matrix"], dtype=np.float64).reshape(4, 4).T
            return given
        matrix = np.eye(4)
        x, y, z, w = np.array(node.get("rotation", (0, 0, 0, 1)), dtype=np.float64)
        turn = np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
            ]
        )
        matrix[:3, :3] = turn * np.array(node.get("scale", (1, 1, 1)), dtype=np.float64).reshape(3)
        matrix[:3, 3] = np.array(node.get("translation", (0, 0, 0)), dtype=np.float64).reshape(3)
    except (ValueError, TypeError):
        raise DamageError(
            f"node {number}", "its transformation is not made of numbers", "the file is damaged"
        ) from None
    return matrix


def _triangles(indices: Integers, mode: int) -> Integers:
    if mode == _TRIANGLES:
        return indices.reshape(-1, 3)
    if len(indices) < 3:
        return np.empty((0, 3), np.int64)
    if mode == _FAN:
        return np.stack([np.full(len(indices) - 2, indices[0]), indices[1:-1], indices[2:]], axis=1)
    strip = np.stack([indices[:-2], indices[1:-1], indices[2:]], axis=1)
    strip[1::2] = strip[1::2, [1, 0, 2]]
    return strip


def _colors(values: NDArray[Any], count: int, where: str) -> NDArray[np.uint8] | None:
    if values.ndim != 2 or values.shape[1] not in (3, 4) or len(values) != count:
        raise DamageError(where, "its colors do not fit its vertices", "the file is damaged")
    colors = np.full((count, 4), 255, dtype=np.uint8)
    colors[:, : values.shape[1]] = np.clip(np.nan_to_num(values) * 255 + 0.5, 0, 255)
    return colors
