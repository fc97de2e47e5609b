# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The comparison as a function."""

import operator
from os import PathLike
from time import perf_counter
from typing import Any

from .arguments import SAMPLES
from .distances import measure
from .report import CompareReport, report_of
from .sources import surface_of

MOST_SAMPLES = 10**9
MOST_THREADS = 1024


def compare(
    a: Any,
    b: Any,
    *,
    samples: int = SAMPLES,
    threads: int = 0,
    picture: "str | PathLike[str] | None" = None,
    report: "str | PathLike[str] | None" = None,
) -> CompareReport:
    """Distances between any two meshes, whatever made them.

    >>> print(ls.compare("part.stl", "part_by_another_tool.ply"))
    >>> ls.compare(mesh, small).rms  # in percent of the diagonal of the first mesh's bounding box
    >>> ls.compare((vertices, faces), (other_vertices, other_faces), report="difference.html")

    Args:
        a: the mesh that is compared with; percent are of the diagonal of its bounding box. A file, a pair of NumPy
            arrays (vertices, faces), a pymeshlab.MeshSet, or a mesh of trimesh, pyvista, Open3D, meshio, vedo or
            pymeshlab; files in formats that MeshLab alone reads need pymeshlab.
        b: the other mesh, of the same kind or another.
        samples: points a side at which distances are taken, beside all vertices.
        threads: 0 all; the result does not depend on it.
        picture: a PNG file to write: both meshes, and the distances as colors; needs laplacian-simplify[pictures].
        report: an HTML file to write: one page with the same, and meshes that turn; needs the same.

    Returns:
        The report, which prints as a summary. Distances at points are exact up to the rounding of double precision. A
        spot that holds no point, of an area below one over ``samples`` of the surface and without a vertex, may be
        farther away than ``hausdorff``, by less than the way to the next point.

    Raises:
        TypeError: something is of a type that cannot be compared; the text says what can.
        ValueError: a mesh has no faces or is otherwise unusable, or a value is outside its range.
        OSError: a file cannot be read or written.
        ImportError: a picture or a page is asked for, and what draws is not installed.
    """
    from ..pictures.outputs import Outputs
    from ..pictures.scene import Facts, Scene

    samples, threads = checked(samples, threads)
    outputs = Outputs(picture, report, names=("picture", "report"))
    outputs.check()
    surfaces = surface_of(a, "A"), surface_of(b, "B")
    start = perf_counter()
    found = measure(*surfaces, samples, threads)
    result = report_of(*surfaces, found, samples, perf_counter() - start)
    if outputs:
        outputs.write(Scene(*surfaces), Facts.of_comparison(result, {"samples": samples}), samples, threads)
    return result


def checked(samples: int, threads: int) -> tuple[int, int]:
    """
    Raises:
        TypeError: one of them is no whole number.
        ValueError: one is outside its range.
    """
    for name, value, least, most in (("samples", samples, 1, MOST_SAMPLES), ("threads", threads, 0, MOST_THREADS)):
        try:
            operator.index(value)
        except TypeError:
            raise TypeError(f"{name} must be a whole number, not {type(value).__name__}") from None
        if not least <= value <= most:
            raise ValueError(f"{name} = {value:,} is outside [{least}, {most:,}]")
    return int(samples), int(threads)
