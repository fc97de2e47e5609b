// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hostile
{
namespace
{

std::string FaultOfVertices(const Case& given, const Produced& result)
{
    for (std::size_t v = 0; v < result.vertexCount; ++v) {
        if (result.vertexOrigin[v] >= given.VertexCount()) return "an origin of a vertex is out of range";
        if (v > 0 && result.vertexOrigin[v] <= result.vertexOrigin[v - 1])
            return "origins of vertices are not ascending";
        for (std::size_t k = 0; k < 3; ++k)
            if (!std::isfinite(result.positions[3 * v + k])) return "a coordinate is no number";
    }
    return "";
}

bool IsSound(const std::uint32_t* v)
{
    return v[0] != v[1] && v[1] != v[2] && v[2] != v[0];
}

/// \param simplified a mesh that was small enough comes back as it is
std::string FaultOfFaces(const Case& given, const Produced& result, bool simplified)
{
    for (std::size_t f = 0; f < result.faceCount; ++f) {
        if (result.faceOrigin[f] >= given.FaceCount()) return "an origin of a face is out of range";
        if (f > 0 && result.faceOrigin[f] <= result.faceOrigin[f - 1])
            return "origins of faces are not ascending";
        const std::uint32_t* corners = result.faces + 3 * f;
        for (std::size_t k = 0; k < 3; ++k)
            if (corners[k] >= result.vertexCount) return "an index is out of range";
        // What is locked stays as it is, faces included.
        const bool free = given.fixed.empty() && given.selected.empty();
        const bool wasSound = IsSound(&given.faces[3 * std::size_t{result.faceOrigin[f]}]);
        if (simplified && !IsSound(corners) && (free || wasSound)) return "a face has a vertex twice";
    }
    return "";
}

/// The coordinates that the library has read.
double Read(const Case& given, std::size_t number)
{
    const double x = given.positions[number];
    return given.singlePrecision ? static_cast<double>(Narrowed(x)) : x;
}

/// A locked vertex is there, where it was.
std::string FaultOfLocks(const Case& given, const Produced& result)
{
    for (std::size_t v = 0; v < given.fixed.size(); ++v) {
        if (given.fixed[v] == 0) continue;
        const auto* end = result.vertexOrigin + result.vertexCount;
        const auto* found = std::lower_bound(result.vertexOrigin, end, static_cast<std::uint32_t>(v));
        if (found == end || *found != v) return "a locked vertex is gone";
        const auto place = static_cast<std::size_t>(found - result.vertexOrigin);
        for (std::size_t k = 0; k < 3; ++k)
            if (!(result.positions[3 * place + k] == Read(given, 3 * v + k)))
                return "a locked vertex has moved";
    }
    return "";
}

/// A face that is not selected has its corners where they were. With clean_input it may be gone, as a
/// duplicate.
std::string FaultOfSelection(const Case& given, const Produced& result)
{
    std::size_t kept = 0;
    for (std::size_t f = 0; f < result.faceCount && !given.selected.empty(); ++f) {
        const std::size_t origin = result.faceOrigin[f];
        if (given.selected[origin] != 0) continue;
        ++kept;
        for (std::size_t k = 0; k < 9; ++k) {
            const double now = result.positions[3 * result.faces[3 * f + k / 3] + k % 3];
            const double before = Read(given, 3 * given.faces[3 * origin + k / 3] + k % 3);
            if (!(now == before)) return "a face that is not selected has moved";
        }
    }
    if (given.parameters.clean_input) return "";
    for (std::size_t f = 0; f < given.selected.size(); ++f)
        if (given.selected[f] == 0 && IsSound(&given.faces[3 * f]) && kept-- == 0)
            return "a face that is not selected is gone";
    return "";
}

bool IsDistance(double x)
{
    return std::isfinite(x) && x >= 0;
}

} // namespace

bool HasTooLarge(const std::vector<double>& numbers)
{
    return !std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::abs(x) <= 1e18; });
}

float Narrowed(double number)
{
    if (std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max()))
        return static_cast<float>(number);
    return std::isnan(number) ? std::numeric_limits<float>::quiet_NaN()
                              : std::copysign(std::numeric_limits<float>::infinity(),
                                              static_cast<float>(std::signbit(number) ? -1 : 1));
}

std::string FaultOfAMesh(const Case& given, const Produced& result)
{
    if (result.faceCount > given.FaceCount()) return "there are more faces than before";
    const bool simplified = result.faceCount < given.FaceCount();
    std::string fault = FaultOfVertices(given, result);
    if (fault.empty()) fault = FaultOfFaces(given, result, simplified);
    if (fault.empty()) fault = FaultOfLocks(given, result);
    if (fault.empty()) fault = FaultOfSelection(given, result);
    return fault;
}

std::string FaultOfAReport(const Case& given, const laplacian_simplify_result& result)
{
    const bool reached = result.face_count <= given.parameters.target_faces;
    if ((result.target_reached != 0) != reached) return "target_reached is wrong";
    if (result.stop_reason < 0 || result.stop_reason > 4) return "an unknown reason to stop";
    if (result.stop_reason == 0 && !reached) return "stopped at the target above it";
    if (result.has_distances &&
        !(IsDistance(result.hausdorff) && IsDistance(result.rms) && IsDistance(result.feature_rms)))
        return "a distance is no number";
    if (result.has_certificate &&
        !(IsDistance(result.certified_error) && result.certified_error <= given.parameters.max_error))
        return "the certified error is above the bound";
    if (result.folded > result.face_count) return "more faces are folded than there are";
    for (std::uint64_t k = 0; k < result.rms_count; ++k)
        if (!IsDistance(result.attribute_rms[k])) return "an rms of attributes is no number";
    const std::size_t numbers = result.corner_values ? 3 * result.face_count * given.channelKinds.size() : 0;
    for (std::size_t k = 0; k < numbers; ++k)
        if (!std::isfinite(result.corner_values[k])) return "an attribute is no number";
    return "";
}

} // namespace hostile
