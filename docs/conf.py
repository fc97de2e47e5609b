# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How Sphinx builds the documentation; scripts/docs runs it. The pages are Markdown that also reads as it stands."""

import sys
import tomllib
from pathlib import Path

from sphinx.application import Sphinx

TOP = Path(__file__).parents[1]
sys.path.insert(0, str(TOP / "python"))  # docstrings are read from the sources; MeshLab is not needed

project = "Laplacian Simplify"
author = "The Laplacian Simplify authors"
project_copyright = "2026 The Laplacian Simplify authors"
release = tomllib.loads((TOP / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
myst_heading_anchors = 3  # links to headings, as "files.md#writing", are checked
exclude_patterns = ["examples"]
nitpicky = True
# Types to which no page here leads: those of others, and the dictionaries of keywords, which simplify describes.
nitpick_ignore_regex = [
    ("py:class", r"(collections\.abc|os|pathlib|pymeshlab)\..*|PathLike|NDArray|(.*\.)?M|\w+Options"),
]

autodoc_typehints = "signature"
autodoc_member_order = "bysource"
python_use_unqualified_type_names = True
napoleon_numpy_docstring = False

html_theme = "furo"
html_title = f"Laplacian Simplify {release}"
html_copy_source = False
html_show_sphinx = False


# Pages of the repository outside docs/, and the pages here that include them.
INCLUDED = {"../sample_meshes/README.md": "sample_meshes.md", "../python/README.md": "python.md"}


def lead_to_included_pages(_app: Sphinx, _page: str, source: list[str]) -> None:
    """Links that are right in the repository lead to the pages here."""
    for there, here in INCLUDED.items():
        source[0] = source[0].replace(f"]({there}", f"]({here}")


def keep_colons(_app: Sphinx, what: str, _name: str, _value: object, _options: object, lines: list[str]) -> None:
    """Napoleon takes what comes before a colon in the first line about an attribute for its type."""
    if what in ("attribute", "data", "property"):
        lines[:0] = ["..", ""]  # an empty comment


def setup(app: Sphinx) -> None:
    app.connect("autodoc-process-docstring", keep_colons, priority=400)  # before napoleon, which has 500
    app.connect("source-read", lead_to_included_pages)
