# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One mesh that is larger than memory: divided into blocks, which are simplified by Dask workers and joined.

``source`` reads the input in chunks. ``grid`` and ``layout`` divide space into blocks, ``scatter`` hands faces to them,
``gather`` reads a block. ``collapse`` simplifies blocks, ``finish`` does the last run and joins, ``measure`` compares.
These are tasks: each writes one file whole or not at all, and may be done again. ``stages`` has them done, ``rounds``
decides which, ``work_folder`` remembers them, and ``runs`` is the way from a file to its report.
"""
