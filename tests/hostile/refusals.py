# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a refusal has to be like: one of the sentences that name the culprit."""

import re

_SENTENCES = (
    r"the mesh has no faces( \([\d,]+ vertices\))?",
    r"the mesh is unusable: the coordinates of [\d,]+ of [\d,]+ vertices are not finite or larger than 1e18",
    r"the coordinates of \d+ of \d+ vertices are not finite or larger than 1e18",
    r"the coordinates of \d+ of \d+ vertices are not finite",
    r"the attributes of \d+ of \d+ faces are not finite",
    r"all \d+ faces are degenerate: each has the same vertex at two corners",
    r"the vertex indices of \d+ of \d+ faces are outside \[0, \d+\); the first of them is face \d+",
    r"weld_distance = [\d.]+ leaves no face: every one has two corners that are welded",
    r"classes = \d+ exceeds the number of distinct values, \d+",
    r"(effort|boundary|seams|feature_weight|attribute_weight) = [\d.]+ is outside \[0, \d+\]",
    r"target_faces = 0 is less than 1",
    r"selected_only = true, but no face is selected",
    r"selected_only = true, but no face or vertex is selected",
    r"lock_selected_vertices = true, but no vertex is selected",
    r"descriptor = vertex_quality, but the quality is not finite at [\d,]+ of [\d,]+ vertices",
)


def fault_of_a_refusal(message: str) -> str:
    """Empty where the message is one of them."""
    sentence = message.strip().splitlines()[-1].removeprefix("Details: ") if message.strip() else ""
    known = any(re.fullmatch(pattern, sentence) for pattern in _SENTENCES)
    return "" if known else "a refusal that does not name the culprit"
