# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Damage has one kind of answer: exit code 0 or 1, one line that names the file, little time and memory.

``python damaged_runs.py`` does the same with thousands of files.
"""

import os
from collections import Counter

import pytest
from corpus import corpus, sound_files
from damaged_runs import faults
from mesh_files import VOLUME, ply
from reading_checks import reading_of, refusal, volume, write

THROUGH_THE_COMMAND = 60
IN_THIS_PROCESS = 1500


def test_files_through_the_command() -> None:
    counts: Counter[str] = Counter()
    found = faults(corpus(THROUGH_THE_COMMAND), os.cpu_count() or 1, counts)
    assert found == []
    assert counts["refused"] > THROUGH_THE_COMMAND / 3


def test_more_files_by_the_readers_alone(tmp_path) -> None:
    """They may not crash the interpreter that they run in."""
    refused = 0
    for file in corpus(IN_THIS_PROCESS, seed=3):
        said = refusal(write(tmp_path / file.name, file.content))
        assert "\n" not in said, (file.name, said)
        assert not said or said.startswith(f"{tmp_path}/"), (file.name, said)
        refused += bool(said)
        (tmp_path / file.name).unlink()
    assert refused > IN_THIS_PROCESS / 3


def test_the_sound_files_are_sound(tmp_path) -> None:
    for name, content in sound_files().items():
        assert volume(reading_of(tmp_path / name, content)) > 3
    assert volume(reading_of(tmp_path / "box.ply", ply())) == pytest.approx(VOLUME)
