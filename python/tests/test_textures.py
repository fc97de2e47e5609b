# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The textures of the input are those of the output, whatever they are called; one that is missing is said."""

from pathlib import Path

import pytest
from conftest import SAMPLE_MESHES, run_command
from mesh_files import PNG
from reading_checks import names_in, reading_of, write

import laplacian_simplify as ls
from laplacian_simplify.files.texture_names import decoded, encoded

SQUARE = (
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "usemtl a\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\nusemtl b\nf 2/1 5/2 6/3\nf 2/1 6/3 3/4\n"
)


def _material(texture: str, name: str = "a") -> str:
    return f"newmtl {name}\nKd 1 1 1\nmap_Kd {texture}\n"


def _written_with(folder: Path, texture: str) -> Path:
    """A mesh with this texture, smoothed into an OBJ of another folder."""
    source, target = folder / "in", folder / "out"
    source.mkdir()
    target.mkdir()
    write(source / "m.obj", "mtllib m.mtl\n" + SQUARE)
    write(source / "m.mtl", _material(texture) + _material(texture, "b"))
    image = source / texture.replace("\\", "/")
    image.parent.mkdir(parents=True, exist_ok=True)
    image.write_bytes(PNG)
    done = run_command("smooth", source / "m.obj", target / "small.obj")
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return target


@pytest.mark.parametrize("name", ["paint.png", "Base Color.png", "größe %41.png", "a#b.png", "~{x}.png"])
def test_a_texture_keeps_its_name_and_its_bytes(name: str, tmp_path: Path) -> None:
    target = _written_with(tmp_path, name)
    assert names_in(target) == sorted([name, "small.obj", "small.obj.mtl"])
    assert (target / name).read_bytes() == PNG
    assert f"map_Kd {name}\n" in (target / "small.obj.mtl").read_text()


@pytest.mark.parametrize("name", ["maps/paint.png", "maps\\paint.png"])
def test_a_texture_in_a_folder_stays_in_it(name: str, tmp_path: Path) -> None:
    target = _written_with(tmp_path, name)
    assert (target / "maps" / "paint.png").read_bytes() == PNG
    assert "map_Kd maps/paint.png\n" in (target / "small.obj.mtl").read_text()


def test_a_texture_elsewhere_comes_beside_the_output(tmp_path: Path) -> None:
    (tmp_path / "maps").mkdir()
    for name in ("../maps/paint.png", str(tmp_path / "maps" / "paint.png")):
        target = tmp_path / f"of {len(name)}"
        target.mkdir()
        _written_with(target, "../../maps/paint.png" if name.startswith(".") else name)
        assert names_in(target / "out") == ["paint.png", "small.obj", "small.obj.mtl"]


def test_a_texture_of_a_ply_keeps_its_name(tmp_path: Path) -> None:
    write(tmp_path / "m.obj", "mtllib m.mtl\n" + SQUARE)
    write(tmp_path / "m.mtl", _material("Base Color.png") + _material("Base Color.png", "b"))
    (tmp_path / "Base Color.png").write_bytes(PNG)
    ls.write_mesh(ls.read_mesh(tmp_path / "m.obj"), tmp_path / "m.ply")
    assert b"comment TextureFile Base Color.png\n" in (tmp_path / "m.ply").read_bytes()
    mesh_set = ls.read_mesh(tmp_path / "m.ply")
    assert list(mesh_set.current_mesh().textures()) == [encoded("Base Color.png")]


def test_options_of_a_map_are_no_part_of_its_name(tmp_path: Path) -> None:
    write(
        tmp_path / "m.mtl",
        _material("-s 1 1 1 -blendu off Base Color.png") + _material("x", "b").replace("x", "-o 1 p.png"),
    )
    for name in ("Base Color.png", "p.png"):
        (tmp_path / name).write_bytes(PNG)
    reading = reading_of(tmp_path / "m.obj", "mtllib m.mtl\n" + SQUARE)
    assert reading.notes == []
    assert [texture.name for texture in reading.textures] == ["Base Color.png", "p.png"]


def test_two_textures_stay_apart(tmp_path: Path) -> None:
    write(tmp_path / "m.mtl", _material("a/t.png") + _material("b/t.png", "b"))
    for folder in "ab":
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "t.png").write_bytes(PNG)
    reading = reading_of(tmp_path / "m.obj", "mtllib m.mtl\n" + SQUARE)
    assert list(reading.mesh_set.current_mesh().textures()) == ["a%2Ft.png", "b%2Ft.png"]


@pytest.mark.parametrize(
    ("library", "said"),
    [
        ("gone.mtl", "material file 'gone.mtl' does not exist; the mesh was read without it"),
        (".", "material file '.' is not a file"),
        ("/", "material file '/' is not a file"),
        ("/dev/zero", "material file '/dev/zero' is not a file"),
        ("wide.mtl", "material file 'wide.mtl' cannot be read: line 1: the text is UTF-16"),
    ],
)
def test_a_library_that_is_none_is_noted(library: str, said: str, tmp_path: Path) -> None:
    write(tmp_path / "wide.mtl", _material("p.png").encode("utf-16"))
    write(tmp_path / "m.obj", f"mtllib {library}\n" + SQUARE)
    done = run_command("smooth", tmp_path / "m.obj", tmp_path / "out.ply")
    assert done.returncode == 0, done.stderr
    assert said in done.stderr


@pytest.mark.parametrize(
    ("texture", "said"),
    [
        ("gone.png", "texture 'gone.png' does not exist; the result has none in its place"),
        ("cut.png", "texture 'cut.png' is no image that MeshLab reads"),
        ("damaged.png", "texture 'damaged.png' is damaged; the result has none in its place"),
        ("odd.dds", "texture 'odd.dds' is no image that MeshLab reads"),
        (".", "texture '.' does not exist"),
    ],
)
def test_a_texture_that_is_none_is_noted(texture: str, said: str, tmp_path: Path) -> None:
    write(tmp_path / "cut.png", "no image")
    write(tmp_path / "damaged.png", PNG[:50] + b"??" + PNG[52:])
    write(tmp_path / "odd.dds", "DDS ")
    write(tmp_path / "m.mtl", _material(texture))
    reading = reading_of(tmp_path / "m.obj", "mtllib m.mtl\n" + SQUARE)
    assert any(said in note for note in reading.notes), reading.notes
    mesh = reading.mesh_set.current_mesh()
    assert mesh.texture_number() == 0
    assert mesh.has_wedge_tex_coord()


def test_the_function_warns_of_what_is_missing(tmp_path: Path) -> None:
    write(tmp_path / "m.obj", "mtllib gone.mtl\n" + SQUARE)
    with pytest.warns(ls.MeshFileWarning, match=r"material file 'gone.mtl' does not exist"):
        ls.read_mesh(tmp_path / "m.obj")


def test_a_library_named_after_the_mesh_needs_no_mention(tmp_path: Path) -> None:
    write(tmp_path / "m.mtl", "newmtl a\nKd 0 1 0\nnewmtl b\nKd 0 0 1\n")
    reading = reading_of(tmp_path / "m.obj", SQUARE)
    colors = reading.mesh_set.current_mesh().face_color_matrix()
    assert colors[:, 1].tolist() == [1, 1, 0, 0]


def test_names_between_reading_and_writing() -> None:
    for name in ("paint.png", "Base Color.png", "größe %41.png", "maps/a b.png", "\udcff.png"):
        assert decoded(encoded(name)) == name
        assert encoded(name).isascii()
    assert encoded("paint-1_b.png") == "paint-1_b.png"


def test_the_sample_keeps_its_texture(tmp_path: Path) -> None:
    done = run_command("simplify", SAMPLE_MESHES / "painted_box.obj", tmp_path / "small.obj", "--percent", 50)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "painted_box.png").read_bytes() == (SAMPLE_MESHES / "painted_box.png").read_bytes()
