# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the README shows works as it stands there."""

import re
import shlex
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pymeshlab
import pytest
from conftest import SAMPLE_MESHES, faces_in, run_command

import laplacian_simplify as ls
from laplacian_simplify.tables import filters

TOP = Path(__file__).parents[2]
README = (TOP / "README.md").read_text(encoding="utf-8")
TYPES = {"boolean": "RichBool", "integer": "RichInt", "real": "RichFloat", "choice": "RichEnum"}


def block(language: str) -> str:
    """The one example in that language."""
    (found,) = re.findall(rf"```{language}\n(.*?)```", README, re.DOTALL)
    return found


def test_the_python_example(tmp_path: Path) -> None:
    (tmp_path / "sample_meshes").symlink_to(SAMPLE_MESHES)
    words = [sys.executable, "-P", "-c", block("python")]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "target reached" in done.stdout
    assert faces_in(tmp_path / "small.ply") <= 2368


def test_the_script_lists_every_parameter_and_runs(tmp_path: Path) -> None:
    ls.load()
    element = ElementTree.fromstring(block("xml")).find("filter")
    assert element is not None
    (row,) = [row for row in filters() if row.name == element.get("name")]
    listed = [(parameter.get("name"), parameter.get("type")) for parameter in element]
    assert listed == [(parameter.id, TYPES[parameter.type]) for parameter in row.parameters]
    cardinalities = [parameter.get("enum_cardinality") for parameter in element]  # MeshLab 2020.09 insists on it
    assert cardinalities == [str(len(parameter.options)) if parameter.options else None for parameter in row.parameters]
    script = tmp_path / "simplify.mlx"
    script.write_text(block("xml"))
    mesh_set = pymeshlab.MeshSet()
    mesh_set.load_new_mesh(str(SAMPLE_MESHES / "flange.ply"))
    mesh_set.load_filter_script(str(script))
    mesh_set.apply_filter_script()
    assert mesh_set.current_mesh().face_number() <= 2368


def test_the_commands(tmp_path: Path) -> None:
    commands = [shlex.split(line, comments=True) for line in block("sh").splitlines()]
    for command in commands:
        assert (TOP / command[0]).is_file()
    (simplify,) = [command for command in commands if command[0] == "scripts/simplify"]
    (tmp_path / "sample_meshes").symlink_to(SAMPLE_MESHES)  # the command runs as it stands, but in a scratch folder
    assert run_command("simplify", *simplify[1:], cwd=tmp_path).returncode == 0
    assert faces_in(tmp_path / "small.ply") <= 2368


@pytest.mark.parametrize("page", ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "sample_meshes/README.md"])
def test_links_lead_somewhere(page: str) -> None:
    text = (TOP / page).read_text(encoding="utf-8")
    for target in re.findall(r"\]\(([^)#]+)\)", text):
        assert target.startswith("https://") or ((TOP / page).parent / target).exists(), target
