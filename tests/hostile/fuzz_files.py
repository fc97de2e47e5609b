# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""libFuzzer, by atheris, on what reads mesh files: those of the package, and the readers in chunks of huge meshes.

Whatever the bytes are, a reader returns a mesh whose faces have vertices, or raises one of the errors that it names.
Arguments are those of libFuzzer. The first byte says which reader; seeds are the sound files of python/tests/corpus.py.
"""

import sys
import tempfile
from pathlib import Path

import atheris

with atheris.instrument_imports(include=["laplacian_simplify"], exclude=["laplacian_simplify.tables"]):
    from laplacian_simplify.files import reading
    from laplacian_simplify.files.errors import DamageError, MeshFileError
    from laplacian_simplify.files.ply_header import parse_header
    from laplacian_simplify.huge.ply_source import PlySource
    from laplacian_simplify.huge.stl_source import StlSource

_FOLDER = Path(tempfile.mkdtemp())  # in that of the run, which fuzz removes: libFuzzer ends at once
_ENDINGS = ("ply", "stl", "obj", "off", "gltf", "glb", "3mf")
_AT_ONCE = 1000


def _left_to_meshlab(source: object) -> None:
    """Its readers are not ours to fuzz."""
    raise DamageError("", f"{source} is read by MeshLab")


def _whole(content: bytes, ending: str) -> None:
    file = _FOLDER / f"mesh.{ending}"
    file.write_bytes(content)
    data = reading.read_data(file)
    if len(data.triangles) and not (0 <= data.triangles.min() and data.triangles.max() < len(data.vertices)):
        raise RuntimeError("an index is out of range")


def _in_chunks(content: bytes, source: type) -> None:
    file = _FOLDER / "huge"
    file.write_bytes(content)
    reader = source(str(file))
    for begin in range(0, min(reader.vertices, 3 * _AT_ONCE), _AT_ONCE):
        reader.bounds(begin, min(begin + _AT_ONCE, reader.vertices))
    for begin in range(0, min(reader.faces, 3 * _AT_ONCE), _AT_ONCE):
        reader.chunk(begin, min(begin + _AT_ONCE, reader.faces))


def read(data: bytes) -> None:
    """One input."""
    kind, content = data[0] if data else 0, bytes(data[1:])
    try:
        if kind == 100:
            parse_header(content)
        elif kind in (101, 102):
            _in_chunks(content, (PlySource, StlSource)[kind - 101])
        else:
            _whole(content, _ENDINGS[kind % len(_ENDINGS)])
    except (DamageError, MeshFileError):
        return


def write_seeds(folder: Path) -> None:
    """Sound files, and each once more for the readers in chunks."""
    sys.path.insert(0, str(Path(__file__).parents[2] / "python/tests"))
    from corpus import sound_files

    folder.mkdir(parents=True, exist_ok=True)
    for name, content in sound_files().items():
        ending = name.rpartition(".")[2]
        kinds = [_ENDINGS.index(ending), *{"ply": [100, 101], "stl": [102]}.get(ending, [])]
        for kind in kinds:
            (folder / f"{kind}_{name}").write_bytes(bytes([kind]) + content)


if __name__ == "__main__":
    if sys.argv[1] == "--seeds":
        write_seeds(Path(sys.argv[2]))
    else:
        reading.read_by_meshlab = _left_to_meshlab
        atheris.Setup(sys.argv, read)
        atheris.Fuzz()
