# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""3MF packages: every item of the build where its transformation puts it, all in one mesh."""

import io
import posixpath
import re
import zipfile
import zlib
from dataclasses import dataclass, field
from xml.etree import ElementTree

import numpy as np

from .errors import DamageError, printable, shortened
from .mesh_data import Floats, Integers, MeshData, check_finite, check_indices
from .scene import Part, Scene, joined
from .source import Source

_MAIN_PART = "3d/3dmodel.model"
# XML of a mesh shrinks to a tenth in a package; what grows beyond this is there to fill memory.
_MOST_UNPACKED, _MOST_GROWTH = 1 << 28, 50


@dataclass
class _Object:
    """A mesh, or other objects, each with its transformation."""

    points: Floats = field(default_factory=lambda: np.empty((0, 3)))
    triangles: Integers = field(default_factory=lambda: np.empty((0, 3), np.int64))
    components: list[tuple[str, Floats]] = field(default_factory=list)


def read_3mf(source: Source) -> MeshData:
    """Reads a 3MF package.

    Raises:
        DamageError: names the part of the package and the object.
    """
    package = _Package(source.read())
    objects, items = package.objects_and_items()
    if not items:
        raise DamageError("build", "it has no items", "the package holds nothing to print")
    scene = Scene()
    waiting = [(name, transform, frozenset[str]()) for name, transform in reversed(items)]
    while waiting:
        name, transform, path = waiting.pop()
        if name in path:
            raise DamageError(f"object {printable(name)}", "it is a component of itself", "the package is damaged")
        if name not in objects:
            raise DamageError(f"object {printable(name)}", "it is used, but not there", "the package is damaged")
        found = objects[name]
        if len(found.triangles):
            part = Part(found.points @ transform[:3] + transform[3], found.triangles)
            if np.linalg.det(transform[:3]) < 0:
                part.triangles = part.triangles[:, ::-1]
            scene.add(part)
        waiting += [(child, _after(inner, transform), path | {name}) for child, inner in reversed(found.components)]
        scene.check(len(waiting))
    data = joined(scene.parts, [])
    if package.has_properties:
        data.notes.append("colors and materials of the package left out")
    return data


def _after(inner: Floats, outer: Floats) -> Floats:
    """A component's transformation within that of its object: rows of three, the last the translation."""
    result = inner @ outer[:3]
    result[3] += outer[3]
    return np.asarray(result)


class _Package:
    """The models in the package, which may refer to each other."""

    def __init__(self, content: bytes) -> None:
        try:
            self._zip = zipfile.ZipFile(io.BytesIO(content))
            sizes = sum(entry.file_size for entry in self._zip.infolist())
        except (zipfile.BadZipFile, ValueError, NotImplementedError, EOFError, OSError) as error:
            raise DamageError("package", f"it is no ZIP archive ({error})", "it is cut off or damaged") from None
        if sizes > max(_MOST_UNPACKED, _MOST_GROWTH * len(content)):
            raise DamageError("package", f"it unpacks to {sizes:,} bytes", "the package is damaged")
        self.has_properties = False

    def objects_and_items(self) -> tuple[dict[str, _Object], list[tuple[str, Floats]]]:
        """All objects, by model and number, and the items of the build."""
        names = {name.lower(): name for name in self._zip.namelist()}
        main = self._main(names)
        objects: dict[str, _Object] = {}
        items: list[tuple[str, Floats]] = []
        waiting, seen = [main], {main}
        while waiting:
            model = waiting.pop()
            for name in self._parse(model, objects, items if model == main else []):
                real = names.get(name.lower())
                if real is None:
                    raise DamageError(f"model {printable(name)}", "it is used, but not there", "the package is damaged")
                if real not in seen:
                    seen.add(real)
                    waiting.append(real)
        return objects, items

    def _main(self, names: dict[str, str]) -> str:
        """The model that the package starts with."""
        try:
            relations = self._zip.read(names["_rels/.rels"])
            found = re.search(rb'Target="/?([^"]+\.model)"', relations, re.I)
            if found and found[1].decode().lower() in names:
                return names[found[1].decode().lower()]
        except (KeyError, zipfile.BadZipFile, zlib.error, ValueError, NotImplementedError, EOFError, RuntimeError):
            pass
        if _MAIN_PART not in names:
            raise DamageError("package", f"it has no {_MAIN_PART}", "it is no 3MF package, or damaged")
        return names[_MAIN_PART]

    def _parse(self, model: str, objects: dict[str, _Object], items: list[tuple[str, Floats]]) -> list[str]:
        """Reads one model; returns the others that it refers to."""
        others: list[str] = []
        try:
            with self._zip.open(model) as file:
                for _, element in ElementTree.iterparse(file, events=("end",)):
                    tag = element.tag.rpartition("}")[2]
                    if tag == "object":
                        objects[_key(model, element)] = _object(model, element, others)
                        element.clear()
                    elif tag == "item":
                        items.append((_reference(model, element, others), _transformation(element, "item")))
                    elif tag in ("basematerials", "colorgroup", "texture2dgroup"):
                        self.has_properties = True
        except ElementTree.ParseError as error:
            raise DamageError(printable(model), f"it is no XML ({error})", "the package is damaged") from None
        except (zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, RuntimeError, ValueError) as error:
            raise DamageError(printable(model), f"it cannot be unpacked ({error})", "the package is damaged") from None
        return others


def _key(model: str, element: ElementTree.Element) -> str:
    return f"{element.get('id')} of {model.lower()}"


def _reference(model: str, element: ElementTree.Element, others: list[str]) -> str:
    """The object that a component or an item stands for, which may be in another model."""
    path = next((value for name, value in element.attrib.items() if name.rpartition("}")[2] == "path"), None)
    if path is None:
        return f"{element.get('objectid')} of {model.lower()}"
    name = posixpath.normpath(path).lstrip("/")
    others.append(name)
    return f"{element.get('objectid')} of {name.lower()}"


def _transformation(element: ElementTree.Element, where: str) -> Floats:
    """Twelve numbers in rows of three."""
    text = element.get("transform")
    if text is None:
        return np.concatenate([np.eye(3), np.zeros((1, 3))])
    try:
        return np.array([float(word) for word in text.split()]).reshape(4, 3)
    except ValueError:
        raise DamageError(where, f"{shortened(text.encode())} is no transformation", "the package is damaged") from None


def _object(model: str, element: ElementTree.Element, others: list[str]) -> _Object:
    where = f"object {printable(element.get('id'))}"
    found = _Object()
    vertices = [row for row in element.iter() if row.tag.rpartition("}")[2] == "vertex"]
    triangles = [row for row in element.iter() if row.tag.rpartition("}")[2] == "triangle"]
    try:
        found.points = np.array([[float(row.attrib[name]) for name in "xyz"] for row in vertices]).reshape(-1, 3)
        corners = [[int(row.attrib[name]) for name in ("v1", "v2", "v3")] for row in triangles]
        found.triangles = np.array(corners, dtype=np.int64).reshape(-1, 3)
    except (KeyError, ValueError, OverflowError) as error:
        raise DamageError(where, f"a vertex or triangle lacks a number ({error})", "the package is damaged") from None
    try:
        check_finite(found.points)
        check_indices(found.triangles.reshape(-1), len(found.points), 3)
    except DamageError as damage:
        raise DamageError(where, str(damage)) from None
    for row in element.iter():
        if row.tag.rpartition("}")[2] == "component":
            found.components.append((_reference(model, row, others), _transformation(row, where)))
    return found
