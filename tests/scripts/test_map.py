# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The map of CONTRIBUTING.md is the tree, and nothing includes what its row does not allow."""

import ast
import re
import subprocess
import sys
from dataclasses import dataclass
from functools import cache
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', re.MULTILINE)
# Where a quoted name is looked for, after the folder of the file and the top: the include folders of the build.
INCLUDE_FOLDERS = [
    "tests/support",
    "filter_laplacian_simplify",
    "filter_laplacian_simplify/host_2020",  # meshlab_version.h, which host_2022 has, too
]
LIBRARIES = {
    "vcglib": re.compile(r"(vcg|wrap)/"),
    "Eigen": re.compile(r"(Eigen|eigenlib)/"),
    "Qt": re.compile(r"Qt?[A-Z]\w+$"),
    "MeshLab": re.compile(r"common/"),
    "OpenMP": re.compile(r"omp\.h$"),
    "the system": re.compile(r"(sys/\w+|[ei]mmintrin)\.h$"),
}
STANDARD = re.compile(r"[a-z_0-9]+$")


@dataclass(frozen=True)
class Row:
    folder: str  # with a slash at its end
    and_below: bool
    text: str
    allowed: str
    above: tuple[str, ...]  # the folders of the rows before it

    def allows(self, path: str) -> bool:
        """Whether files of the folder may include the file ``path``."""
        names = re.findall(r"`([^`]+)`", self.allowed)
        folders = [name for name in names if name.endswith("/")]
        return (
            path in names
            or any(path.startswith(folder) for folder in folders)
            or ("the rows above" in self.allowed and f"{Path(path).parent}/" in self.above)
        )


@cache
def rows() -> list[Row]:
    section = (PROJECT / "CONTRIBUTING.md").read_text().split("## Map of the code")[1].split("\n## ")[0]
    found: list[Row] = []
    for line in section.splitlines():
        match = re.match(r"\| `([^`]+/)`( and below)? \| (.*) \| ?(.*?) ?\|$", line)
        if match:
            above = tuple(row.folder for row in found)
            found.append(Row(match[1], bool(match[2]), match[3], match[4], above))
    return found


@cache
def tracked() -> list[str]:
    done = subprocess.run(["git", "ls-files", "-z"], cwd=PROJECT, check=True, capture_output=True, text=True)
    return [name for name in done.stdout.split("\0") if name and (PROJECT / name).exists()]


def row_of(path: str) -> Row | None:
    """The row of a file's folder, else the closest one "and below" that it is in."""
    folder = f"{Path(path).parent}/"
    exact = [row for row in rows() if row.folder == folder]
    wide = [row for row in rows() if row.and_below and folder.startswith(row.folder)]
    return next(iter(exact + sorted(wide, key=lambda row: -len(row.folder))), None)


def sources(*suffixes: str) -> list[str]:
    return [name for name in tracked() if name.endswith(suffixes)]


def includes(path: str) -> list[tuple[str, str]]:
    """Bracket and name of each include, but for what moc generates."""
    found = INCLUDE.findall((PROJECT / path).read_text(encoding="utf-8"))
    return [(bracket, name) for bracket, name in found if not name.endswith(".moc")]


def resolved(path: str, name: str) -> str | None:
    """The file of the project that a quoted include means."""
    for folder in [str(Path(path).parent), ".", *INCLUDE_FOLDERS]:
        if (PROJECT / folder / name).is_file():
            return str(Path(folder) / name)
    return None


def test_every_folder_is_on_the_map() -> None:
    folders = {f"{Path(name).parent}/" for name in tracked()} - {"./"}
    assert {folder for folder in folders if row_of(f"{folder}file") is None} == set()


def test_every_row_is_a_folder_with_a_sentence() -> None:
    assert len(rows()) > 30
    missing = [row.folder for row in rows() if not any(name.startswith(row.folder) for name in tracked())]
    assert missing == []
    assert len({row.folder for row in rows()}) == len(rows())
    assert [row.folder for row in rows() if not row.text.endswith(".")] == []


def test_headers_of_the_project_are_those_that_the_row_allows() -> None:
    wrong = []
    for path in sources(".h", ".cpp"):
        row = row_of(path)
        for bracket, name in includes(path):
            if bracket != '"':
                continue
            header = resolved(path, name)
            assert header, f"{path} includes {name}, which is nowhere"
            if Path(header).parent != Path(path).parent and not row.allows(header):
                wrong.append(f"{path} includes {header}")
    assert wrong == []


def test_libraries_are_those_that_the_row_allows() -> None:
    wrong = []
    for path in sources(".h", ".cpp"):
        if path.startswith("benchmarks/peers/"):  # each includes its own library
            continue
        for bracket, name in includes(path):
            if bracket != "<" or STANDARD.match(name):
                continue
            library = next((word for word, pattern in LIBRARIES.items() if pattern.match(name)), "unknown")
            if library not in row_of(path).allowed:
                wrong.append(f"{path} includes <{name}> of {library}")
    assert wrong == []


def test_headers_of_the_library_are_named_from_the_top() -> None:
    """So that they are found where they are installed, whatever else is on the include path."""
    quoted = [(path, name) for path in sources(".h") if path.startswith("vcg_ext/") for _, name in includes(path)]
    wrong = [(path, name) for path, name in quoted if resolved(path, name) and not name.startswith("vcg_ext/")]
    assert wrong == []


def test_no_header_includes_itself_by_way_of_others() -> None:
    """One that ends in _inl.h is the second half of its header, which includes it at its end."""

    def whole(path: str) -> str:
        return path.replace("_inl.h", ".h")

    graph: dict[str, list[str]] = {}
    for path in sources(".h"):
        headers = [resolved(path, name) for bracket, name in includes(path) if bracket == '"']
        others = [whole(header) for header in headers if header and whole(header) != whole(path)]
        graph.setdefault(whole(path), []).extend(others)
    done: set[str] = set()

    def visit(path: str, way: tuple[str, ...]) -> None:
        assert path not in way, " -> ".join([*way[way.index(path) :], path])
        if path not in done:
            for header in graph.get(path, []):
                visit(header, (*way, path))
            done.add(path)

    for path in graph:
        visit(path, ())


def test_headers_change_no_diagnostic_of_the_program_that_includes_them() -> None:
    pragma = re.compile(r"^\s*#\s*pragma\s+(GCC|clang)\s+(diagnostic|optimize|target|push_options)", re.MULTILINE)
    headers = [path for path in sources(".h") if path.startswith("vcg_ext/")]
    assert [path for path in headers if pragma.search((PROJECT / path).read_text())] == []


def test_package_imports_what_it_is_installed_with() -> None:
    wrong = []
    for path in sources(".py"):
        if not path.startswith("python/laplacian_simplify/"):
            continue
        allowed = re.findall(r"`(\w+)`", row_of(path).allowed)
        for node in ast.walk(ast.parse((PROJECT / path).read_text(encoding="utf-8"))):
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            if isinstance(node, ast.ImportFrom) and node.level == 0:
                names = [node.module or ""]
            tops = {name.split(".")[0] for name in names} - set(sys.stdlib_module_names) - set(allowed)
            wrong += [f"{path} imports {top}" for top in tops]
    assert wrong == []
