# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many meshes: found, handed to Dask workers within a memory budget, and written down in a manifest.

``inputs`` finds the meshes, ``manifest`` knows which of them are done, ``scheduling`` keeps the workers busy, and
``worker`` is what runs there.
"""
