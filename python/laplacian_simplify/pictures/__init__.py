# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures and pages of two meshes and of how far they are apart: --picture and --report.

What draws is optional (``pip install laplacian-simplify[pictures]``) and runs in a process of its own, without a
display: VTK and the caller's windows, or pymeshlab's Qt, do not meet, and a crash there is a message here.

The page is one file that asks for nothing else. Its viewer is ``viewer.js`` on the part of three.js that it uses, which
lies in this folder as ``three.min.js`` (MIT licence): so neither building nor installing the package takes Node.js or a
network. ``scripts/bundle-viewer`` of the project writes it anew from npm, by pinned hashes.
"""
