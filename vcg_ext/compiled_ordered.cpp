// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The bodies of the large functions that need VCG's queue, once for all programs:
// vcg_ext/core/base/compiled.h.
#include "vcg_ext/decimate_inl.h"
#include "vcg_ext/ordered/decimate_inl.h"
