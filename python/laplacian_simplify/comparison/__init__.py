# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far any two surfaces are apart, whatever made them: ls.compare, and the command compare.

Distances are measured as simplify measures its result, by the same C functions: at points spread evenly by area over
both surfaces and at all vertices, each to the closest point of the other surface.
"""
