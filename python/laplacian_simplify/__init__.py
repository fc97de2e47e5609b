# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laplacian-guided mesh simplification of arrays and of meshes of other libraries, and the plugin's filters as
functions on pymeshlab's mesh sets or on files.

>>> import laplacian_simplify as ls
>>> vertices, faces = ls.simplify(vertices, faces, target_percent=10)
>>> report = ls.simplify("bunny.off", target_percent=10)
>>> report.faces, report.stop_reason_text
(6966, 'target reached')
>>> ls.write_mesh(report.mesh_set, "small.ply")

What is used is imported when it is first used: the command has to be ready for Ctrl+C before anything else.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .arrays import Simplified
    from .batch.api import simplify_many
    from .batch.runs import BatchReport
    from .comparison.api import compare
    from .comparison.report import CompareReport
    from .files.errors import MeshFileError
    from .files.reading import MeshFileWarning, read_mesh
    from .files.writing import write_mesh
    from .filters import classify, descriptor, levels_of_detail, smooth, weighted
    from .huge.api import simplify_huge
    from .huge.report import HugeReport
    from .levels import LevelReport
    from .plugin import PYMESHLAB_VERSION, load, plugin_path
    from .report import (
        STOP_REASONS,
        ClassificationReport,
        DecimationReport,
        DescriptorReport,
        Report,
        SmoothingReport,
        StopReason,
    )
    from .simplification import simplify

    __version__: str

_MODULES = {
    "arrays": ("Simplified",),
    "batch.api": ("simplify_many",),
    "batch.runs": ("BatchReport",),
    "comparison.api": ("compare",),
    "comparison.report": ("CompareReport",),
    "files.errors": ("MeshFileError",),
    "files.reading": ("MeshFileWarning", "read_mesh"),
    "files.writing": ("write_mesh",),
    "filters": ("classify", "descriptor", "levels_of_detail", "smooth", "weighted"),
    "huge.api": ("simplify_huge",),
    "huge.report": ("HugeReport",),
    "levels": ("LevelReport",),
    "plugin": ("PYMESHLAB_VERSION", "load", "plugin_path"),
    "report": (
        "STOP_REASONS",
        "ClassificationReport",
        "DecimationReport",
        "DescriptorReport",
        "Report",
        "SmoothingReport",
        "StopReason",
    ),
    "simplification": ("simplify",),
}

__all__ = [
    "PYMESHLAB_VERSION",
    "STOP_REASONS",
    "BatchReport",
    "ClassificationReport",
    "CompareReport",
    "DecimationReport",
    "DescriptorReport",
    "HugeReport",
    "LevelReport",
    "MeshFileError",
    "MeshFileWarning",
    "Report",
    "Simplified",
    "SmoothingReport",
    "StopReason",
    "__version__",
    "classify",
    "compare",
    "descriptor",
    "levels_of_detail",
    "load",
    "plugin_path",
    "read_mesh",
    "simplify",
    "simplify_huge",
    "simplify_many",
    "smooth",
    "weighted",
    "write_mesh",
]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        globals()[name] = version = import_module("importlib.metadata").version("laplacian-simplify")
        return version
    for module, names in _MODULES.items():
        if name in names:
            globals()[name] = value = getattr(import_module("." + module, __name__), name)
            return value
    raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
