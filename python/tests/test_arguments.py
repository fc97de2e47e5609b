# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong arguments end with exit code 2 and one line, before any file is touched."""

from pathlib import Path

import pytest
from conftest import SAMPLE_MESHES, assert_one_line, run_command

from laplacian_simplify.options import SHORT_NAMES, WITHOUT_OPTION, commands

FLANGE = SAMPLE_MESHES / "flange.ply"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--faces", "-5"), "--faces -5 is outside [1, "),
        (("--faces", "0"), "--faces 0 is outside [1, "),
        (("--faces", "many"), "--faces: invalid int value: 'many'"),
        (("--faces", "99999999999"), "--faces 99999999999 is outside [1, "),
        (("--percent", "200"), "--percent 200 is outside (0, 100]"),
        (("--percent", "0"), "--percent 0 is outside (0, 100]"),
        (("--percent", "nan"), "--percent nan is outside (0, 100]"),
        (("--faces", "10", "--percent", "5"), "not allowed with argument"),
        ((), "one of the arguments --faces --percent --max-error is required"),
        (("--max-error", "0%"), "--max-error 0 is outside (0, 100]"),
        (("--max-error", "101%"), "--max-error 101 is outside [0, 100]"),
        (("--max-error", "-1"), "--max-error -1 is outside (0, "),
        (("--max-error", "small"), "invalid error_bound value: 'small'"),
        (("--percent", "5", "--feature-weight", "-1"), "--feature-weight -1 is outside [0, 50]"),
        (("--percent", "5", "--effort", "huge"), "invalid choice: 'huge'"),
        (("--percent", "5", "--no-such-option"), "unrecognized arguments: --no-such-option"),
    ],
)
def test_wrong_option(arguments: tuple[str, ...], said: str, tmp_path: Path) -> None:
    done = run_command("simplify", FLANGE, tmp_path / "small.ply", *arguments)
    assert done.returncode == 2, done.stderr
    assert_one_line(done.stderr)
    assert said in done.stderr
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("arguments", [(), ("no-such-command",), ("simplify",), ("simplify", "a.ply")])
def test_incomplete_command(arguments: tuple[str, ...]) -> None:
    done = run_command(*arguments)
    assert done.returncode == 2
    assert_one_line(done.stderr)


def test_every_number_is_checked_on_both_sides(tmp_path: Path) -> None:
    """Every option that takes a number refuses what lies outside its row of the table."""
    from laplacian_simplify.command_line import main

    for command in commands():
        target = () if not command.filter.has("target_faces") else ("--percent", "50")
        if command.has_levels:
            target = ("--percents", "50")
        for row in command.filter.parameters:
            if row.type not in ("integer", "real") or row.id in WITHOUT_OPTION:
                continue
            option = SHORT_NAMES.get(row.id, "--" + row.id.replace("_", "-"))
            for value in (row.minimum - 1, row.maximum + 1):
                number = int(value) if row.type == "integer" else value
                chosen = () if row.id in SHORT_NAMES else target
                words = [command.name, FLANGE, tmp_path / "out.ply", *chosen, f"{option}={number}"]
                assert main([str(word) for word in words]) == 2, (command.name, row.id, value)
    assert list(tmp_path.iterdir()) == []


def test_every_parameter_that_makes_sense_has_an_option() -> None:
    """And none has one that the plugin does not have."""
    for command in commands():
        shown = run_command(command.name, "--help").stdout
        for row in command.filter.parameters:
            option = SHORT_NAMES.get(row.id, "--" + row.id.replace("_", "-"))
            assert (option in shown) == (row.id not in WITHOUT_OPTION), (command.name, row.id)
            for choice in row.options:
                assert choice.id in shown


def test_help_and_version() -> None:
    shown = run_command("--help")
    assert shown.returncode == 0
    for command in commands():
        assert command.name in shown.stdout
    assert run_command("--version").stdout.startswith("laplacian-simplify ")
