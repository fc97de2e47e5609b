# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Effort balanced is not worse than fast, whose result it refines."""

import pytest
from conftest import SAMPLE_NAMES

import laplacian_simplify as ls

ROUNDING = 0.001  # percent of the diagonal


@pytest.mark.parametrize("percent", [50, 20, 10, 2])
@pytest.mark.parametrize("name", SAMPLE_NAMES)
def test_balanced_is_not_worse_than_fast(load_sample, name, percent):
    fast, balanced = (
        ls.simplify(load_sample(name), target_percent=percent, effort=effort) for effort in ("fast", "balanced")
    )
    for error in ("rms", "feature_rms", "hausdorff"):
        before, after = getattr(fast, error), getattr(balanced, error)
        assert after <= max(1.01 * before, before + ROUNDING), error
