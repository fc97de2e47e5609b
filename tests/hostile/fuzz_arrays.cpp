// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// libFuzzer on the C function that the Python package calls: a mesh of any bytes, with everything it can
// carry.

#include <cstdio>
#include <cstdlib>

#include "checked_run.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    hostile::Case given = hostile::CaseOf(bytes, size);
    given.levelCount = 0;
    const hostile::Ending ending = hostile::CheckedRun(given);
    if (ending.kind != hostile::Ending::Fault) return 0;
    std::fprintf(stderr, "fault: %s\n", ending.said.c_str());
    std::abort();
}
