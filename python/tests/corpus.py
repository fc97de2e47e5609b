# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Damaged and rare files, made from sound ones by rules: the same ones for the same seed, as many as are wanted."""

import io
import random
import re
import zipfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from mesh_files import (
    BOX,
    ENCODINGS,
    MESH_3MF,
    PLY_TYPES,
    QUADS,
    TRIANGLES,
    binary_stl,
    glb,
    gltf_document,
    model_3mf,
    obj,
    off,
    ply,
    text_stl,
    threemf,
)


@dataclass(frozen=True)
class DamagedFile:
    """One file of the corpus."""

    name: str
    content: bytes


Damage = Callable[[bytes, random.Random], bytes]


def _sphere(rings: int = 7, sectors: int = 9) -> tuple[np.ndarray, list[list[int]]]:
    """A little more than a box, so that damage has places to be."""
    points = [(0.0, 0.0, 1.0), (0.0, 0.0, -1.0)]
    for ring in range(1, rings):
        for sector in range(sectors):
            polar, around = np.pi * ring / rings, 2 * np.pi * sector / sectors
            points.append((np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar)))
    faces = []
    for sector in range(sectors):
        after = (sector + 1) % sectors
        faces.append([0, 2 + sector, 2 + after])
        last = 2 + (rings - 2) * sectors
        faces.append([1, last + after, last + sector])
        for ring in range(rings - 2):
            a = 2 + ring * sectors
            faces.append([a + sector, a + sectors + sector, a + sectors + after, a + after])
    return np.array(points), faces


def sound_files() -> dict[str, bytes]:
    """What damage is done to, by name."""
    points, faces = _sphere()
    triangles = [[f[0], f[k], f[k + 1]] for f in faces for k in range(1, len(f) - 1)]
    files: dict[str, bytes] = {}
    for encoding in ENCODINGS:
        files[f"{encoding}.ply"] = ply(points, faces, encoding=encoding, coordinate_type="float")
    files["triangles.ply"] = ply(points, triangles, coordinate_type="float")
    textured = "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nusemtl red\n"
    files["plain.obj"] = obj(points, faces).encode()
    corners = "".join(f"f {' '.join(f'{v + 1}/{k + 1}/1' for k, v in enumerate(face))}\n" for face in TRIANGLES)
    files["full.obj"] = (obj(BOX, [], "mtllib m.mtl\n" + textured) + corners).encode()
    files["binary.stl"] = binary_stl(points, triangles)
    files["text.stl"] = text_stl(points, triangles).encode()
    files["plain.off"] = off(points, faces).encode()
    lines = off().splitlines()
    colored = [line + " 255 0 0 255" if 2 <= number < 2 + len(BOX) else line for number, line in enumerate(lines)]
    files["colors.off"] = ("C" + "\n".join(colored) + "\n").encode()
    files["scene.glb"] = glb(*gltf_document([{"mesh": 0, "translation": [1, 2, 3], "scale": [2, 2, 2]}]))
    files["package.3mf"] = threemf(items='<item objectid="1" transform="1 0 0 0 1 0 0 0 1 5 6 7"/>')
    return files


def _cut(content: bytes, chance: random.Random) -> bytes:
    return content[: chance.randrange(len(content))]


def _longer(content: bytes, chance: random.Random) -> bytes:
    return content + chance.choice([b"\0", b"\n\n", b"more", content, bytes(chance.randbytes(200))])


def _flipped(content: bytes, chance: random.Random) -> bytes:
    changed = bytearray(content)
    for _ in range(chance.choice([1, 1, 2, 8, 64])):
        changed[chance.randrange(len(changed))] = chance.randrange(256)
    return bytes(changed)


def _bit(content: bytes, chance: random.Random) -> bytes:
    changed = bytearray(content)
    changed[chance.randrange(len(changed))] ^= 1 << chance.randrange(8)
    return bytes(changed)


def _hole(content: bytes, chance: random.Random) -> bytes:
    start = chance.randrange(len(content))
    return content[:start] + content[start + chance.choice([1, 3, 50]) :]


def _twice(content: bytes, chance: random.Random) -> bytes:
    start = chance.randrange(len(content))
    return content[:start] + content[start : start + chance.choice([1, 7, 60])] + content[start:]


def _zeros(content: bytes, chance: random.Random) -> bytes:
    start, size = chance.randrange(len(content)), chance.choice([4, 100])
    return content[:start] + bytes(len(content[start : start + size])) + content[start + size :]


_NUMBERS = (
    b"-1", b"0", b"99", b"2147483647", b"2147483648", b"4294967295", b"99999999999999999999", b"1e9", b"nan", b"-inf",
    b"1e300", b"True", b"", b"3.5", b"0,5", b"1/2", b"1//", b"0x10", b"five", b"1_0", b"+", b"1-2", b"\xff",
)  # fmt: skip


def _number(content: bytes, chance: random.Random) -> bytes:
    """One number of a text is another one, or none."""
    found = list(re.finditer(rb"(?<![\w.])-?\d+(\.\d+)?(?![\w.])", content[:20_000]))
    if not found:
        return _flipped(content, chance)
    place = chance.choice(found)
    return content[: place.start()] + chance.choice(_NUMBERS) + content[place.end() :]


_LINES = (
    b"", b"f 1 2 3", b"v 1 2", b"\xef\xbb\xbf", b"mtllib .", b"mtllib /dev/zero", b"mtllib a b\\", b"l 99 -99",
    b"usemtl nothing", b"end_header", b"\\", b"#MRGB 00", b"solid", b"endsolid", b"4 0 1 2 3",
)  # fmt: skip


def _line(content: bytes, chance: random.Random) -> bytes:
    """A line is gone, twice there, moved, or another one."""
    lines = content.split(b"\n")
    at = chance.randrange(len(lines))
    other = chance.choice([*_LINES, b"# " + lines[at], lines[at] + b" # c"])
    change = chance.randrange(5)
    if change == 0:
        lines.pop(at)
    elif change == 1:
        lines.insert(at, lines[at])
    elif change == 2:
        lines.append(lines.pop(at))
    elif change == 3:
        lines[at] = other
    else:
        lines.insert(at, other)
    return b"\n".join(lines)


def _line_ends(content: bytes, chance: random.Random) -> bytes:
    return content.replace(b"\n", chance.choice([b"\r\n", b"\r", b"\n\r", b"\n\n", b" ", b"\x0b", b"\0"]))


def _encoding(content: bytes, chance: random.Random) -> bytes:
    text = content.decode("latin-1")
    return chance.choice([
        b"\xef\xbb\xbf" + content, text.encode("utf-16"), text.encode("utf-16-be"), content.replace(b" ", b"\xc2\xa0"),
        content.replace(b" ", b"\t"), content.upper(), content.replace(b".", b","), b" \n" + content,
    ])  # fmt: skip


def _type(content: bytes, chance: random.Random) -> bytes:
    """Another type, name or count in the header of a PLY, or another word in JSON or XML."""
    words = list(re.finditer(rb"[A-Za-z_]{2,}", content[:2000]))
    if not words:
        return _flipped(content, chance)
    place = chance.choice(words)
    new = chance.choice([*PLY_TYPES, "list", "vertex", "face", "binary_big_endian", "ascii", "null", "x", "end_header"])
    return content[: place.start()] + new.encode() + content[place.end() :]


_EVERYWHERE: tuple[Damage, ...] = (_cut, _longer, _flipped, _bit, _hole, _twice, _zeros)
_IN_TEXT: tuple[Damage, ...] = (_number, _number, _line, _line_ends, _encoding, _type)


def _in_package(damage: Damage) -> Damage:
    """Damage to the model within a 3MF package, which is packed again."""

    def applied(_content: bytes, chance: random.Random) -> bytes:
        text = model_3mf(f'<object id="1">{MESH_3MF}</object>', '<item objectid="1"/>').encode()
        package = io.BytesIO()
        with zipfile.ZipFile(package, "w") as archive:
            archive.writestr("3D/3dmodel.model", damage(text, chance))
        return package.getvalue()

    return applied


def _rules_for(name: str) -> tuple[Damage, ...]:
    if name.endswith(".3mf"):
        return (*_EVERYWHERE, *(_in_package(damage) for damage in (*_EVERYWHERE, *_IN_TEXT)))
    return (*_EVERYWHERE, *_IN_TEXT)


def rare_files(chance: random.Random) -> Iterator[DamagedFile]:
    """Sound PLY files with every kind of list, in random order; endless."""
    while True:
        whole = [name for name, kind in PLY_TYPES.items() if kind[0] != "f"]
        faces = [*TRIANGLES[:6], *QUADS] if chance.random() < 0.5 else QUADS
        content = ply(
            faces=faces,
            encoding=chance.choice(list(ENCODINGS)),
            count_type=chance.choice(whole),
            index_type=chance.choice(list(PLY_TYPES)),
            coordinate_type=chance.choice(list(PLY_TYPES)),
            comments=("c",) * chance.randrange(3),
        )
        yield DamagedFile("rare.ply", content)


def corpus(count: int, seed: int = 1) -> Iterator[DamagedFile]:
    """So many files: one in ten is rare, the others are damaged, each sound file and each rule in turn."""
    chance = random.Random(seed)
    rare = rare_files(chance)
    files = list(sound_files().items())
    for number in range(count):
        if number % 10 == 9:
            yield next(rare)
            continue
        name, content = files[number % len(files)]
        rules = _rules_for(name)
        damage = rules[(number // len(files)) % len(rules)]
        changed = damage(content, chance)
        if chance.random() < 0.2:
            changed = chance.choice(rules)(changed or content, chance)
        yield DamagedFile(f"{getattr(damage, '__name__', '').strip('_')}_{name}", changed)
