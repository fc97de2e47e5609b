// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/base/buffer.h"
#include "vcg_ext/core/base/parallel.h"

namespace vcg_ext
{

/// Who was joined to whom before the first collapse.
struct OriginalEdges {
    Buffer<std::uint32_t> offset;         ///< one more than vertices
    std::vector<std::uint32_t> neighbour; ///< of vertex v: from offset[v] on, ascending, each once
    Buffer<float> longest;                ///< of the edges at a vertex

    /// \param neighboursOf neighboursOf(v, list) appends the neighbors of v, some perhaps twice
    /// \param length length(v, w) of an edge
    template <class NeighboursOf, class Length>
    void Build(std::size_t vertices, int threads, const NeighboursOf& neighboursOf, const Length& length)
    {
        constexpr std::size_t kGrain = 1 << 13;
        offset.Allocate(vertices + 1);
        longest.Allocate(vertices);
        std::vector<std::vector<std::uint32_t>> parts((vertices + kGrain - 1) / kGrain);
        ParallelRanges(threads, vertices, kGrain, [&](std::size_t begin, std::size_t end, int) {
            std::vector<std::uint32_t>& part = parts[begin / kGrain];
            std::vector<std::uint32_t> list;
            for (std::size_t v = begin; v < end; ++v) {
                const auto vertex = static_cast<std::uint32_t>(v);
                list.clear();
                neighboursOf(vertex, list);
                std::sort(list.begin(), list.end());
                list.erase(std::unique(list.begin(), list.end()), list.end());
                offset[v] = static_cast<std::uint32_t>(list.size());
                longest[v] = 0;
                for (const std::uint32_t w : list) longest[v] = std::max(longest[v], length(vertex, w));
                part.insert(part.end(), list.begin(), list.end());
            }
        });
        std::size_t count = 0;
        for (const auto& part : parts) count += part.size();
        neighbour.reserve(count);
        for (auto& part : parts) {
            neighbour.insert(neighbour.end(), part.begin(), part.end());
            std::vector<std::uint32_t>().swap(part);
        }
        std::uint32_t total = 0;
        for (std::size_t v = 0; v < vertices; ++v) {
            const std::uint32_t here = offset[v];
            offset[v] = total;
            total += here;
        }
        offset[vertices] = total;
    }

    std::size_t VertexCount() const { return longest.size(); }
    const std::uint32_t* Begin(std::uint32_t v) const { return neighbour.data() + offset[v]; }
    const std::uint32_t* End(std::uint32_t v) const { return neighbour.data() + offset[v + 1]; }
};

} // namespace vcg_ext
