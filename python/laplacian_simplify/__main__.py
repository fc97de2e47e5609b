# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m laplacian_simplify: the command laplacian-simplify."""

import sys

from .command_line import main

sys.exit(main())
