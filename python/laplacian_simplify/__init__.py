# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laplacian-guided mesh simplification: the plugin's filters as functions on pymeshlab's mesh sets or on files.

>>> import laplacian_simplify as ls
>>> report = ls.simplify("bunny.off", target_percent=10)
>>> report.faces, report.stop_reason_text
(6966, 'target reached')
>>> ls.write_mesh(report.mesh_set, "small.ply")
"""

from .filters import classify, descriptor, simplify, smooth, weighted
from .mesh_reading import read_mesh
from .mesh_writing import write_mesh
from .plugin import PYMESHLAB_VERSION, load, plugin_path
from .report import (
    STOP_REASONS,
    ClassificationReport,
    DecimationReport,
    DescriptorReport,
    Report,
    SmoothingReport,
)

__all__ = [
    "PYMESHLAB_VERSION",
    "STOP_REASONS",
    "ClassificationReport",
    "DecimationReport",
    "DescriptorReport",
    "Report",
    "SmoothingReport",
    "classify",
    "descriptor",
    "load",
    "plugin_path",
    "read_mesh",
    "simplify",
    "smooth",
    "weighted",
    "write_mesh",
]
