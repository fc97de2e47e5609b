# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/files.md says what the tables of formats say."""

import re
from pathlib import Path

from laplacian_simplify.files.formats import READERS
from laplacian_simplify.files.output_formats import OUTPUT_FORMATS

PAGE = (Path(__file__).parents[2] / "docs" / "files.md").read_text(encoding="utf-8")


def _rows(heading: str) -> list[list[str]]:
    section = PAGE.partition(f"\n## {heading}\n")[2].partition("\n## ")[0]
    lines = [line for line in section.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]


def test_every_reader_is_on_the_page() -> None:
    expected = [[f"`.{extension}`" for extension in reader.extensions] for reader in READERS]
    assert [row[0].split(", ") for row in _rows("Reading")] == expected


def test_every_output_format_is_on_the_page_with_what_it_keeps() -> None:
    digits = {"16": 1e-15, "16 after the point": 1e-15, "7": 1e-7, "6": 1e-5}
    rows = {re.sub("[`.]", "", row[0]): row[1:] for row in _rows("Writing")}
    assert list(rows) == [row.extension for row in OUTPUT_FORMATS]
    for row in OUTPUT_FORMATS:
        keeps, precision = rows[row.extension]
        assert keeps == ", ".join(row.keeps)
        assert row.relative_error <= digits[precision] <= row.relative_error * 20
