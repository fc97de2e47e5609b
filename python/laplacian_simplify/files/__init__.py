# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh files in and out.

A file is read in three steps: ``source`` finds the bytes and the format, a reader of the table in ``formats`` checks
them and makes a ``MeshData`` of arrays, and ``handover`` gives that to MeshLab. Damage ends as a ``MeshFileError``
whose text is one line: the file, the line or element, what is wrong and what helps.
"""
