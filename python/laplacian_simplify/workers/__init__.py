# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Dask workers and the processes in which they do their jobs, for all commands that use them."""
