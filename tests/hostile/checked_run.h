// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "mesh_bytes.h"

namespace hostile
{

/// How a run ended.
struct Ending {
    enum Kind { Done, Refused, Fault } kind = Done;
    std::string said; ///< the refusal, or what is wrong
};

/// Runs a case and checks that the result is a mesh, that what is locked stays, that the report speaks of
/// that mesh, and that the caller's arrays are as they were.
Ending CheckedRun(const Case& given);

} // namespace hostile
