# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""glTF and 3MF: scenes become one mesh, every part where its transformations put it."""

import base64
import json
import struct
from pathlib import Path

import numpy as np
import pytest
import trimesh
from mesh_files import BOX, MESH_3MF, PNG, TRIANGLES, VOLUME, glb, gltf_document, model_3mf, threemf
from reading_checks import arrays, assert_refused, bounds, reading_of, volume

HALF = 0.5**0.5
QUARTER_TURN = [0, 0, HALF, HALF]  # around z: (x, y) becomes (-y, x)


def _glb(*nodes: dict, **more: object) -> bytes:
    return glb(*gltf_document(list(nodes), **more))


@pytest.mark.parametrize(
    ("nodes", "low", "high"),
    [
        ([{"mesh": 0}], (0, 0, 0), (2, 4, 6)),
        ([{"mesh": 0, "translation": [10, 20, 30], "scale": [2, 2, 2]}], (10, 20, 30), (14, 28, 42)),
        ([{"mesh": 0, "rotation": QUARTER_TURN}], (-4, 0, 0), (0, 2, 6)),
        ([{"mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]}], (5, 6, 7), (7, 10, 13)),
        ([{"children": [1], "scale": [2, 1, 1]}, {"mesh": 0, "translation": [10, 0, 0]}], (20, 0, 0), (24, 4, 6)),
        (
            [{"children": [1], "rotation": QUARTER_TURN}, {"mesh": 0, "translation": [10, 0, 0]}],
            (-4, 10, 0),
            (0, 12, 6),
        ),
        ([{"mesh": 0, "scale": [-1, 1, 1]}], (-2, 0, 0), (0, 4, 6)),
    ],
)
def test_nodes_are_applied(nodes: list[dict], low: tuple, high: tuple, tmp_path: Path) -> None:
    reading = reading_of(tmp_path / "box.glb", _glb(*nodes))
    assert np.allclose(bounds(reading), [low, high], atol=1e-6)
    assert volume(reading) > 0  # a mirror does not turn it inside out
    scene = trimesh.load_scene(tmp_path / "box.glb")
    assert np.allclose(bounds(reading), scene.bounds, atol=1e-6)


def test_a_mesh_that_is_used_twice_is_there_twice(tmp_path: Path) -> None:
    content = _glb({"children": [1, 2]}, {"mesh": 0}, {"mesh": 0, "translation": [10, 0, 0]})
    reading = reading_of(tmp_path / "two.glb", content)
    assert volume(reading) == pytest.approx(2 * VOLUME)
    assert bounds(reading) == [[0, 0, 0], [12, 4, 6]]


@pytest.mark.parametrize("kind", [5121, 5123, 5125])
def test_types_of_indices(kind: int, tmp_path: Path) -> None:
    document, buffer = gltf_document([{"mesh": 0}])
    indices = np.array(TRIANGLES, {5121: "<u1", 5123: "<u2", 5125: "<u4"}[kind]).tobytes()
    buffer = buffer[:96] + indices
    document["accessors"][1]["componentType"] = kind
    document["bufferViews"][1]["byteLength"] = len(indices)
    document["buffers"][0]["byteLength"] = len(buffer)
    assert volume(reading_of(tmp_path / "box.glb", glb(document, buffer))) == pytest.approx(VOLUME)


def test_without_indices_with_strides_strips_and_fans(tmp_path: Path) -> None:
    corners = BOX[np.array(TRIANGLES)].reshape(-1, 3)
    rows = np.zeros(len(corners), [("p", "<f4", 3), ("other", "<f4", 2)])
    rows["p"] = corners
    document, _ = gltf_document([{"mesh": 0}])
    document["meshes"] = [{"primitives": [{"attributes": {"POSITION": 0}}]}]
    document["accessors"] = [{"bufferView": 0, "componentType": 5126, "count": len(rows), "type": "VEC3"}]
    document["bufferViews"] = [{"buffer": 0, "byteLength": rows.nbytes, "byteStride": 20}]
    document["buffers"] = [{"byteLength": rows.nbytes}]
    assert volume(reading_of(tmp_path / "box.glb", glb(document, rows.tobytes()))) == pytest.approx(VOLUME)
    for mode, expected in ((5, [[0, 1, 2], [2, 1, 3]]), (6, [[0, 1, 2], [0, 2, 3]])):
        document, buffer = gltf_document([{"mesh": 0}])
        document["meshes"] = [{"primitives": [{"attributes": {"POSITION": 0}, "mode": mode}]}]
        document["accessors"][0]["count"] = 4
        assert arrays(reading_of(tmp_path / "strip.glb", glb(document, buffer)))[1].tolist() == expected


def test_normalized_positions(tmp_path: Path) -> None:
    document, _ = gltf_document([{"mesh": 0, "scale": [2, 4, 6]}])
    corners = (BOX / (2, 4, 6) * 65535).astype("<u2").tobytes()
    indices = np.array(TRIANGLES, "<u2").tobytes()
    document["accessors"][0] |= {"componentType": 5123, "normalized": True}
    document["bufferViews"][0]["byteLength"] = 48
    document["bufferViews"][1]["byteOffset"] = 48
    document["buffers"][0]["byteLength"] = 48 + len(indices)
    assert volume(reading_of(tmp_path / "box.glb", glb(document, corners + indices))) == pytest.approx(VOLUME)


def test_a_gltf_with_its_buffer_beside_it_or_within(tmp_path: Path) -> None:
    document, buffer = gltf_document([{"mesh": 0}])
    (tmp_path / "my buffer.bin").write_bytes(buffer)
    for uri in ("my%20buffer.bin", "data:application/octet-stream;base64," + base64.b64encode(buffer).decode()):
        document["buffers"][0]["uri"] = uri
        assert volume(reading_of(tmp_path / "box.gltf", json.dumps(document))) == pytest.approx(VOLUME)
    document["buffers"][0]["uri"] = "missing.bin"
    assert_refused(tmp_path / "box.gltf", json.dumps(document), "buffer 0: missing.bin cannot be read")


def test_colors_and_texture(tmp_path: Path) -> None:
    document, buffer = gltf_document([{"mesh": 0}])
    uv = np.tile(np.array([0.25, 0.75], "<f4"), (len(BOX), 1)).tobytes()
    at = len(buffer)
    document["bufferViews"] += [
        {"buffer": 0, "byteOffset": at, "byteLength": len(uv)},
        {"buffer": 0, "byteOffset": at + len(uv), "byteLength": len(PNG)},
    ]
    document["accessors"].append({"bufferView": 2, "componentType": 5126, "count": len(BOX), "type": "VEC2"})
    document["buffers"][0]["byteLength"] = at + len(uv) + len(PNG)
    document["images"] = [{"bufferView": 3, "mimeType": "image/png", "name": "paint"}]
    document["textures"] = [{"source": 0}]
    document["materials"] = [
        {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "baseColorFactor": [1, 0.5, 0, 1]}}
    ]
    primitive = document["meshes"][0]["primitives"][0]
    primitive["attributes"]["TEXCOORD_0"] = 2
    primitive["material"] = 0
    reading = reading_of(tmp_path / "painted.glb", glb(document, buffer + uv + PNG))
    mesh = reading.mesh_set.current_mesh()
    assert list(mesh.textures()) == ["paint.png"]
    assert mesh.wedge_tex_coord_matrix()[0].tolist() == [0.25, 0.25]
    assert mesh.face_color_matrix()[0] == pytest.approx([1, 0.5, 0, 1], abs=0.01)


def _changed(**changes: object) -> bytes:
    """The box with something else in the first row of a kind."""
    document, buffer = gltf_document([{"mesh": 0}])
    for path, value in changes.items():
        kind, name = path.split("__")
        document[kind][0][name] = value
    return glb(document, buffer)


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (_glb({"mesh": 0})[:-4], "it is cut off or damaged"),
        (_glb({"mesh": 0})[:30], "it is cut off or damaged"),
        (b"glTF" + struct.pack("<II", 1, 12), "only glTF 2 is read"),
        (b"glTF" + struct.pack("<IIII", 2, 20, 99, 0), "chunk at byte 12"),
        (_changed(accessors__count=10**12), "accessor 0: its 1,000,000,000,000 elements take"),
        (_changed(accessors__count=-1), "accessor 0: its type or its count is none"),
        (_changed(accessors__byteOffset=1), "accessor 0: its 8 elements take 97 bytes of a view of 96"),
        (_changed(accessors__type="VEC9"), "accessor 0"),
        (_changed(accessors__bufferView=9), "accessor 0: it refers to bufferViews 9 of 2"),
        (_changed(accessors__sparse={}), "sparse numbers are not read"),
        (_changed(bufferViews__byteLength=10**9), "bufferView 0: it ends at byte 1,000,000,000 of a buffer"),
        (_changed(bufferViews__buffer=3), "bufferView 0: it refers to buffers 3 of 1"),
        (_changed(nodes__mesh=5), "node 0: it refers to meshes 5 of 1"),
        (_changed(nodes__mesh="a"), "node 0"),
        (_changed(nodes__children=[0]), "node 0: it is a child of itself"),
        (_changed(nodes__children=7), "it is damaged"),
        (_changed(nodes__matrix=[1, 2]), "node 0: its transformation"),
        (_changed(nodes__scale=["a", 1, 1]), "node 0: its transformation"),
        (_changed(nodes__scale=[1e300, 1, 1]), "coordinates that are not finite"),
        (_changed(meshes__primitives=[{"attributes": {}}]), "mesh 0, primitive 0: it has no positions"),
        (
            _glb({"mesh": 0}, extensionsRequired=["KHR_draco_mesh_compression"]),
            "KHR_draco_mesh_compression is not read",
        ),
        (_glb({"mesh": 0}, asset=[]), "it has no 'asset'"),
        (_glb({"mesh": 0}, meshes={}), "meshes: it is no list of objects"),
    ],
)
def test_damaged_gltf_names_the_part(content: bytes, said: str, tmp_path: Path) -> None:
    assert_refused(tmp_path / "box.glb", content, said)


def test_a_scene_that_multiplies_itself_ends(tmp_path: Path) -> None:
    nodes: list[dict] = [{"children": [k + 1, k + 1]} for k in range(60)]
    assert_refused(tmp_path / "deep.glb", _glb(*nodes, {"mesh": 0}), "it puts together more than")


MOVE = "1 0 0 0 1 0 0 0 1 10 20 30"


@pytest.mark.parametrize(
    ("content", "low", "high"),
    [
        (threemf(), (0, 0, 0), (2, 4, 6)),
        (threemf(items=f'<item objectid="1" transform="{MOVE}"/>'), (10, 20, 30), (12, 24, 36)),
        (threemf(items='<item objectid="1" transform="2 0 0 0 2 0 0 0 2 0 0 0"/>'), (0, 0, 0), (4, 8, 12)),
        (threemf(items='<item objectid="1" transform="0 1 0 -1 0 0 0 0 1 0 0 0"/>'), (-4, 0, 0), (0, 2, 6)),
        (threemf(items='<item objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/>'), (-2, 0, 0), (0, 4, 6)),
        (
            threemf(
                f'<object id="1">{MESH_3MF}</object><object id="2"><components>'
                f'<component objectid="1" transform="{MOVE}"/></components></object>',
                '<item objectid="2" transform="2 0 0 0 1 0 0 0 1 0 0 0"/>',
            ),
            (20, 20, 30),
            (24, 24, 36),
        ),
        (
            threemf(
                '<object id="2"><components><component objectid="7" p:path="/3D/parts/a.model"/></components></object>',
                '<item objectid="2"/>',
                **{"3D__parts__a.model": model_3mf(f'<object id="7">{MESH_3MF}</object>')},
            ),
            (0, 0, 0),
            (2, 4, 6),
        ),
    ],
)
def test_items_and_components_are_applied(content: bytes, low: tuple, high: tuple, tmp_path: Path) -> None:
    reading = reading_of(tmp_path / "box.3mf", content)
    assert np.allclose(bounds(reading), [low, high], atol=1e-9)
    assert volume(reading) > 0


def test_every_item_is_there(tmp_path: Path) -> None:
    content = threemf(items=f'<item objectid="1"/><item objectid="1" transform="{MOVE}"/>')
    assert volume(reading_of(tmp_path / "two.3mf", content)) == pytest.approx(2 * VOLUME)


def _box_3mf(old: str, new: str) -> bytes:
    return threemf(f'<object id="1">{MESH_3MF.replace(old, new, 1)}</object>')


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (threemf()[:-30], "it is no ZIP archive"),
        (threemf()[:100], "it is no ZIP archive"),
        (b"PK\3\4 and nothing else", "it is no ZIP archive"),
        (threemf(items=""), "build: it has no items"),
        (threemf(items='<item objectid="9"/>'), "object 9 of 3d/3dmodel.model: it is used, but not there"),
        (threemf(items='<item objectid="1" transform="1 0 0"/>'), "item: '1 0 0' is no transformation"),
        (threemf(items='<item objectid="1" transform="1 0 0 0 1 0 0 0 1 0 0 x"/>'), "is no transformation"),
        (
            threemf(
                '<object id="1"><components><component objectid="1"/></components></object>', '<item objectid="1"/>'
            ),
            "it is a component of itself",
        ),
        (_box_3mf('x="2"', 'x="two"'), "object 1: a vertex or triangle lacks a number"),
        (_box_3mf('x="2" ', ""), "object 1: a vertex or triangle lacks a number"),
        (_box_3mf('x="2"', 'x="nan"'), "object 1: vertex 4: 1 vertex with coordinates that are not finite"),
        (_box_3mf('v1="4"', 'v1="8"'), "object 1: face 1: vertex index 8 is outside 0..7"),
        (_box_3mf("</triangles>", ""), "it is no XML"),
        (_box_3mf('v1="4"', 'v1="99999999999999999999"'), "object 1"),
    ],
)
def test_damaged_3mf_names_the_object(content: bytes, said: str, tmp_path: Path) -> None:
    assert_refused(tmp_path / "box.3mf", content, said)
