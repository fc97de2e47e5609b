// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_bytes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace hostile
{
namespace
{

/// Reads from the front; zeros after the end.
class Reader
{
    const std::uint8_t* next_;
    std::size_t left_;

  public:
    Reader(const std::uint8_t* bytes, std::size_t size) : next_(bytes), left_(size) {}

    template <class T>
    T Take()
    {
        T value{};
        const std::size_t size = std::min(sizeof value, left_);
        if (size == 0) return value;
        std::memcpy(&value, next_, size);
        next_ += size;
        left_ -= size;
        return value;
    }
    std::size_t Left() const { return left_; }
};

enum Flags : unsigned {
    kTopology = 1,
    kCrossings = 2,
    kClean = 4,
    kMeasure = 8,
    kFixed = 16,
    kSelected = 32,
    kSingle = 64,
    kLongIndices = 128,
    kAnyIndex = 256, ///< indices are not brought into the range
    kLabels = 512,
    kEveryThreads = 1024,
    kSharp = 2048 ///< numbers of the parameters are as they are, else within their ranges
};

/// 0, and then powers of two from 1/65536 percent on: bounds matter at every scale.
double PercentOf(unsigned byte)
{
    return byte == 0 ? 0 : std::min(100.0, std::ldexp(1.0, static_cast<int>(byte % 24) - 16));
}

/// How coordinates are stored: as they are, or a few small whole numbers, of which many meet.
enum Coordinates : unsigned { kDoubles, kFloats, kLattice, kScaledLattice, kCoordinateKinds };

double TakeCoordinate(Reader& reader, unsigned kind, int exponent)
{
    if (kind == kDoubles) return reader.Take<double>();
    if (kind == kFloats) return static_cast<double>(reader.Take<float>());
    const double whole = reader.Take<std::int8_t>();
    return kind == kLattice ? whole : std::ldexp(whole, exponent);
}

void TakeParameters(Reader& reader, unsigned flags, std::size_t faces, Case& all)
{
    laplacian_simplify_parameters& p = all.parameters;
    const unsigned percent = reader.Take<std::uint8_t>(), weights = reader.Take<std::uint8_t>();
    const unsigned error = reader.Take<std::uint8_t>(), weld = reader.Take<std::uint8_t>();
    const unsigned choices = reader.Take<std::uint16_t>();
    p.target_faces = flags & kSharp ? percent : std::max<std::size_t>(1, faces * percent / 255);
    p.max_error = PercentOf(error);
    p.weld_distance = PercentOf(weld);
    p.feature_weight = static_cast<double>(weights & 15) * (flags & kSharp ? 5 : 50.0 / 15);
    p.attribute_weight = static_cast<double>(weights >> 4) * (flags & kSharp ? 9 : 100.0 / 15);
    const std::array<std::int32_t, 4> descriptors{
        LAPLACIAN_SIMPLIFY_LAPLACIAN, LAPLACIAN_SIMPLIFY_NORMALIZED_UMBRELLA,
        LAPLACIAN_SIMPLIFY_CURVATURE_ESTIMATION, LAPLACIAN_SIMPLIFY_STORED_QUALITY};
    p.descriptor = descriptors[choices & 3];
    const auto choice = [&](unsigned shift, unsigned count) {
        const unsigned value = choices >> shift & 3;
        return static_cast<std::int32_t>(flags & kSharp ? value : value % count);
    };
    p.effort = choice(2, 3);
    p.boundary = choice(4, 3);
    p.seams = choice(6, 2);
    p.preserve_topology = (flags & kTopology) != 0;
    p.avoid_self_intersections = (flags & kCrossings) != 0;
    p.clean_input = (flags & kClean) != 0;
    p.measure_error = (flags & kMeasure) != 0;
    p.threads = 1;
    all.levelCount = choices >> 8 & 3;
    for (unsigned pairs = choices >> 10 & 3, k = 0; k < 2 * pairs; ++k)
        all.channelKinds.push_back(LAPLACIAN_SIMPLIFY_TEXTURE);
    for (unsigned further = choices >> 12 & 7, k = 0; k < further; ++k)
        all.channelKinds.push_back(k % 2 ? LAPLACIAN_SIMPLIFY_SCALAR : LAPLACIAN_SIMPLIFY_COLOR);
}

void TakeArrays(Reader& reader, unsigned flags, std::size_t vertices, std::size_t faces, Case& all)
{
    if (flags & kFixed)
        for (std::size_t v = 0; v < vertices; ++v) all.fixed.push_back(reader.Take<std::uint8_t>() & 1);
    if (flags & kSelected)
        for (std::size_t f = 0; f < faces; ++f) all.selected.push_back(reader.Take<std::uint8_t>() & 1);
    if (flags & kLabels)
        for (std::size_t f = 0; f < faces; ++f) all.labels.push_back(reader.Take<std::int8_t>());
    if (all.parameters.descriptor == LAPLACIAN_SIMPLIFY_STORED_QUALITY)
        for (std::size_t v = 0; v < vertices; ++v)
            all.quality.push_back(static_cast<double>(reader.Take<float>()));
    const std::size_t numbers = 3 * faces * all.channelKinds.size();
    for (std::size_t k = 0; k < numbers; ++k) all.corners.push_back(reader.Take<float>());
}

} // namespace

Case CaseOf(const std::uint8_t* bytes, std::size_t size)
{
    Case all;
    Reader reader(bytes, size);
    const unsigned flags = reader.Take<std::uint16_t>();
    const unsigned coordinates = reader.Take<std::uint8_t>() % kCoordinateKinds;
    const int exponent = reader.Take<std::uint8_t>() - 128;
    // No more than the bytes could fill twice, so that small inputs stay quick.
    const std::size_t vertices = std::min<std::size_t>(reader.Take<std::uint16_t>(), size);
    const std::size_t faces = std::min<std::size_t>(reader.Take<std::uint16_t>(), size);
    TakeParameters(reader, flags, faces, all);
    all.singlePrecision = (flags & kSingle) != 0;
    all.longIndices = (flags & kLongIndices) != 0;
    all.forEveryThreads = (flags & kEveryThreads) != 0;
    for (std::size_t k = 0; k < 3 * vertices; ++k)
        all.positions.push_back(TakeCoordinate(reader, coordinates, exponent));
    for (std::size_t k = 0; k < 3 * faces; ++k) {
        const std::uint32_t index = reader.Take<std::uint16_t>();
        const bool kept = (flags & kAnyIndex) != 0 || vertices == 0;
        all.faces.push_back(kept ? index : index % static_cast<std::uint32_t>(vertices));
    }
    TakeArrays(reader, flags, vertices, faces, all);
    return all;
}

} // namespace hostile
