// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <new>
#include <optional>
#include <string>

namespace laplacian_simplify
{

/// Calls \p run, because no host survives an exception of an unknown type.
/// \returns a sentence for the user if it threw anything
template <class Run>
std::optional<std::string> FailureOf(const Run& run)
{
    try {
        run();
        return std::nullopt;
    } catch (const std::bad_alloc&) {
        return "not enough memory; the mesh is unchanged";
    } catch (const std::exception& error) {
        return error.what();
    } catch (...) {
        return "unknown error";
    }
}

} // namespace laplacian_simplify
