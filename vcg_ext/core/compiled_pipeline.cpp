// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The bodies of the core's large functions, once for all programs: vcg_ext/core/base/compiled.h. Those of the
// collapse are in collapse/compiled_collapse.cpp, so that two compilers can work on them.
#include "vcg_ext/core/levels_inl.h"
#include "vcg_ext/core/pipeline_inl.h"
#include "vcg_ext/core/simplify_inl.h"
