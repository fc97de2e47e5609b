# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page docs/paper.md: entries, their verdicts and tables."""

from dataclasses import dataclass, field

HOLDS, IN_PART, FAILS = "holds", "holds in part", "does not hold"


@dataclass(frozen=True)
class Check:
    """Something that the claim implies, and whether the numbers agree."""

    statement: str
    agrees: bool


@dataclass(frozen=True)
class Entry:
    """One figure or table of the paper, reproduced."""

    title: str
    claim: str
    pictures: list[tuple[str, str]]  # file name, what it shows
    columns: list[str]
    rows: list[list]
    checks: list[Check]
    notes: list[str] = field(default_factory=list)

    @property
    def verdict(self) -> str:
        """From the checks alone."""
        agreeing = sum(check.agrees for check in self.checks)
        return HOLDS if agreeing == len(self.checks) else IN_PART if agreeing else FAILS


def cell(value) -> str:
    """Three significant digits; a dash for what there is not."""
    if value is None:
        return "–"
    if isinstance(value, float):
        return f"{value:.3g}" if abs(value) < 1000 else f"{value:.0f}"
    return str(value)


def table(columns: list[str], rows: list[list]) -> list[str]:
    """A Markdown table; columns of numbers are aligned to the right."""
    numeric = [all(not isinstance(row[i], str) for row in rows) for i in range(len(columns))]
    lines = ["| " + " | ".join(columns) + " |", "|" + "|".join("---:" if right else "---" for right in numeric) + "|"]
    return lines + ["| " + " | ".join(cell(value) for value in row) + " |" for row in rows]


def entry_lines(entry: Entry) -> list[str]:
    """One section of the page."""
    lines = [f"## {entry.title}", "", f"**Claim.** {entry.claim}", "", f"**Verdict: {entry.verdict}.**", ""]
    lines += [f"- {'yes' if check.agrees else 'no'}: {check.statement}" for check in entry.checks]
    for name, caption in entry.pictures:
        lines += ["", f"![{caption}](images/paper/{name})", "", f"*{caption}*"]
    if entry.rows:
        lines += ["", *table(entry.columns, entry.rows)]
    for note in entry.notes:
        lines += ["", note]
    return lines + [""]


def overview(entries: list[Entry]) -> list[str]:
    """The verdicts at a glance."""
    rows = [
        [
            entry.title.split(":")[0],
            entry.claim,
            f"*{entry.verdict}*",
            f"{sum(c.agrees for c in entry.checks)} of {len(entry.checks)}",
        ]
        for entry in entries
    ]
    return table(["", "claim", "verdict", "checks"], rows)
