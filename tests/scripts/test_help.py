# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A script that is asked for help prints its usage and does nothing else."""

import subprocess
from pathlib import Path

import pytest

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
HANDED_ON = {"simplify", "python"}  # to what they run, which has its own help
NAMES = sorted({path.name for path in SCRIPTS.iterdir() if path.is_file() and not path.suffix} - HANDED_ON)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("option", ["-h", "--help"])
def test_usage_is_all_that_happens(tmp_path: Path, name: str, option: str) -> None:
    environment = {"HOME": str(tmp_path), "PATH": "/usr/bin:/bin"}
    done = subprocess.run([SCRIPTS / name, option], env=environment, capture_output=True, text=True)
    assert done.returncode == 0
    assert done.stdout.startswith(f"Usage: scripts/{name}")
    assert done.stderr == ""
    assert not list(tmp_path.iterdir())
