// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The functions behind the public entries are large, and as they are inline, every program that calls one
// compiles them all. Where LAPLACIAN_SIMPLIFY_COMPILED is defined their headers only declare them, and the
// files that are called compiled_*.cpp have them (CMake: the option of that name).
// Their bodies are in the headers that end in _inl.h; nothing else includes those.
#ifdef LAPLACIAN_SIMPLIFY_COMPILED
#define VCG_EXT_INLINE
#else
#define VCG_EXT_INLINE inline
#endif
