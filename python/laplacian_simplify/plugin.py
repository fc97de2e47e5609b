# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin that lies in this package, and the pymeshlab that it fits."""

from importlib.util import find_spec
from pathlib import Path

PYMESHLAB_VERSION = "2025.7.post1"
"""The only version that can run the plugin: it was built against the library of this one."""


def plugin_path() -> Path:
    """Where the plugin lies."""
    return Path(__file__).parent / "libfilter_laplacian_simplify.so"


def require_pymeshlab() -> None:
    """Refuses to go on where there is no pymeshlab, which arrays do without.

    Raises:
        ImportError: it says how to get one.
    """
    if find_spec("pymeshlab") is None:
        raise ImportError(
            "files and mesh sets need pymeshlab, which is not installed: "
            "python -m pip install 'laplacian-simplify[meshlab]'",
            name="pymeshlab",
        )


def check_pymeshlab(installed: str) -> None:
    """Refuses every version but the one that the plugin was built against.

    Raises:
        ImportError: names both versions and the way out.
    """
    if installed != PYMESHLAB_VERSION:
        raise ImportError(
            f"this build of laplacian_simplify needs pymeshlab {PYMESHLAB_VERSION}, but {installed} is installed; "
            f"run: python -m pip install pymeshlab=={PYMESHLAB_VERSION}"
        )


def load() -> None:
    """Loads the plugin into pymeshlab, so that ``mesh_set.apply_filter`` knows its filters, and mesh sets have them as
    methods, as pymeshlab's own: what MeshLab copies as a PyMeshLab call runs.

    A second call does nothing. Every function of this package calls it.

    Raises:
        ImportError: pymeshlab is not installed, or is not the one that the plugin was built against, or this package
            was built without the plugin.
    """
    from importlib.metadata import version

    require_pymeshlab()
    check_pymeshlab(version("pymeshlab"))
    if not plugin_path().exists():
        raise ImportError(
            "this laplacian_simplify was built from its sources without MeshLab, for arrays only; "
            "the wheel has the plugin for files and mesh sets"
        )
    import pymeshlab

    from .tables import filters
    from .turns import turn

    with turn():
        if filters()[0].python_name not in pymeshlab.filter_list():
            pymeshlab.load_plugin(str(plugin_path()))
        for row in filters():
            if not hasattr(pymeshlab.MeshSet, row.python_name):
                setattr(pymeshlab.MeshSet, row.python_name, pymeshlab.bind_function(row.python_name))
