# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin that lies in this package, and the pymeshlab that it fits."""

from pathlib import Path

PYMESHLAB_VERSION = "2025.7.post1"
"""The only version that can run the plugin: it was built against the library of this one."""


def plugin_path() -> Path:
    """Where the plugin lies."""
    return Path(__file__).parent / "libfilter_laplacian_simplify.so"


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
        ImportError: the installed pymeshlab is not the one that the plugin was built against.
    """
    from importlib.metadata import version

    check_pymeshlab(version("pymeshlab"))
    import pymeshlab

    from .tables import filters
    from .turns import turn

    with turn():
        if filters()[0].python_name not in pymeshlab.filter_list():
            pymeshlab.load_plugin(str(plugin_path()))
        for row in filters():
            if not hasattr(pymeshlab.MeshSet, row.python_name):
                setattr(pymeshlab.MeshSet, row.python_name, pymeshlab.bind_function(row.python_name))
