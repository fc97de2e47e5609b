// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vcg_ext/core/collapse/engine_inl.h"
#include "vcg_ext/core/descriptor/laplacian_inl.h"
