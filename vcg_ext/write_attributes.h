// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include <vcg/complex/complex.h>
#include <vcg/complex/allocate.h>

#include "vcg_ext/core/mesh/decimated_mesh.h"
#include "vcg_ext/attribute_access.h"
#include "vcg_ext/mesh_attribute.h"
#include "vcg_ext/wedge_normals.h"

namespace vcg_ext
{

/// Puts the values of a result's corners back to where MeshAttributes had them from. What has not changed is
/// not written, so that it keeps its bits. A vertex has one value: the mean of its corners, or, in a mesh
/// whose vertices were doubled along seams, one for each side, and then a vertex for each side, too. Normals
/// of wedges are computed anew, for each side of hard edges.
template <class Mesh>
class AttributeWriter
{
    Mesh& mesh_;
    const AttributeLayout& layout_;
    const DecimatedMesh& result_;
    const std::vector<std::uint32_t>& inputFaces_; ///< the index in mesh.face of every face of the input
    std::vector<std::uint8_t> untouched_;          ///< of every face of the result: it is as it was
    /// Corners with one value; those of a vertex follow each other, and the first of them keeps it.
    struct Group {
        std::uint32_t vertex, end; ///< of mesh.vert; in corners_
        std::uint32_t source;      ///< the vertex that a new one is a copy of, otherwise itself
    };
    std::vector<Group> groups_;
    std::vector<std::uint32_t> corners_; ///< corner k of the result's face f is 3 f + k
    std::vector<short> textures_; ///< texture index of every corner, where vertices have different ones

  public:
    /// \pre mesh is as it was when it was read
    AttributeWriter(Mesh& mesh, const AttributeLayout& layout, const DecimatedMesh& result,
                    const std::vector<std::uint32_t>& inputFaces)
        : mesh_(mesh), layout_(layout), result_(result), inputFaces_(inputFaces),
          untouched_(result.triangles.size(), 1)
    {
        for (std::size_t i = 0; i < CornerCount(); ++i) untouched_[i / 3] = untouched_[i / 3] && IsAsItWas(i);
        if (layout_.vertexTextures)
            for (std::size_t i = 0; i < CornerCount(); ++i)
                textures_.push_back(static_cast<short>(FaceOf(i / 3).cV(static_cast<int>(i % 3))->cT().N()));
        SortCorners();
    }

    /// \pre the faces of the result name their new vertices
    void Write()
    {
        AddVertices();
        for (const MeshAttribute& attribute : layout_.attributes)
            WithAccess(mesh_, attribute, [&](const auto& access) {
                for (std::size_t c = 0; c < attribute.components.size(); ++c)
                    if (attribute.components[c].HasChannel())
                        WriteComponent(attribute.Row().place, attribute.components[c], c, access);
            });
        if (vcg::tri::HasPerWedgeNormal(mesh_)) WriteNormals();
        if (!layout_.vertexTextures || !layout_.doubledVertices) return;
        ForEachGroup([&](const Group& group, std::size_t begin) {
            mesh_.vert[group.vertex].T().N() = textures_[corners_[begin]];
        });
    }

  private:
    std::size_t CornerCount() const { return 3 * result_.triangles.size(); }
    std::size_t FaceIndex(std::size_t f) const { return inputFaces_[result_.faceOrigin[f]]; }
    auto& FaceOf(std::size_t f) { return mesh_.face[FaceIndex(f)]; }
    std::uint32_t ResultVertex(std::size_t corner) const { return result_.triangles[corner / 3][corner % 3]; }
    float Value(std::size_t corner, std::uint32_t channel) const
    {
        return result_.cornerValues[corner * layout_.channels + channel];
    }

    /// Whether the face of the corner was at its vertex before: not at one that was welded to it.
    bool WasThere(std::size_t corner)
    {
        const auto* vertex = FaceOf(corner / 3).cV(static_cast<int>(corner % 3));
        return vcg::tri::Index(mesh_, vertex) == result_.vertexOrigin[ResultVertex(corner)];
    }
    bool IsAsItWas(std::size_t corner)
    {
        if (!WasThere(corner)) return false;
        const auto& now = result_.positions[ResultVertex(corner)];
        const auto& before = mesh_.vert[result_.vertexOrigin[ResultVertex(corner)]].P();
        bool same = true;
        for (std::size_t k = 0; k < 3; ++k)
            same = same && now[k] == static_cast<double>(before[static_cast<int>(k)]);
        return same;
    }

    /// By vertices, then by groups; the group that keeps the vertex is the first.
    void SortCorners()
    {
        std::vector<std::uint32_t> begin(result_.positions.size() + 1, 0);
        for (std::size_t i = 0; i < CornerCount(); ++i) ++begin[ResultVertex(i) + 1];
        for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
        corners_.resize(CornerCount());
        std::vector<std::uint32_t> next = begin;
        for (std::size_t i = 0; i < CornerCount(); ++i)
            corners_[next[ResultVertex(i)]++] = static_cast<std::uint32_t>(i);
        const std::vector<Tolerance> tolerances = Tolerances();
        for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
            const std::uint32_t vertex = result_.vertexOrigin[v];
            for (std::uint32_t at = begin[v]; at < begin[v + 1];) {
                const std::uint32_t end = layout_.doubledVertices
                                              ? GroupFrom(at, begin[v], begin[v + 1], tolerances)
                                              : begin[v + 1];
                groups_.push_back({vertex, end, vertex});
                if (at > begin[v]) groups_.back().vertex = AttributeComponent::kNoChannel;
                at = end;
            }
        }
    }

    /// Differences of a channel of vertices that part its corners.
    struct Tolerance {
        std::uint32_t channel;
        float largest;
    };
    std::vector<Tolerance> Tolerances() const
    {
        constexpr float kOfRange = 1e-5f;
        std::vector<Tolerance> tolerances;
        for (const MeshAttribute& attribute : layout_.attributes)
            for (const AttributeComponent& component : attribute.components) {
                if (attribute.Row().place != AttributePlace::Vertex || !component.HasChannel()) continue;
                float low = 0, high = 0;
                for (std::size_t i = 0; i < CornerCount(); ++i) {
                    low = i > 0 ? std::min(low, Value(i, component.channel)) : Value(i, component.channel);
                    high = i > 0 ? std::max(high, Value(i, component.channel)) : low;
                }
                tolerances.push_back({component.channel, kOfRange * (high - low)});
            }
        return tolerances;
    }

    /// Moves the corners that belong together with one of them to \p at. \return where they end
    std::uint32_t GroupFrom(std::uint32_t at, std::uint32_t first, std::uint32_t end,
                            const std::vector<Tolerance>& tolerances)
    {
        const auto from = corners_.begin() + at, to = corners_.begin() + end;
        const auto there =
            at > first ? from : std::find_if(from, to, [&](std::uint32_t i) { return WasThere(i); });
        const std::uint32_t leader = there == to ? *from : *there;
        const auto alike = [&](std::uint32_t i) {
            if (!textures_.empty() && textures_[i] != textures_[leader]) return false;
            const auto& sides = result_.cornerSides;
            if (!sides.empty() && sides[i] != sides[leader]) return false;
            return std::all_of(tolerances.begin(), tolerances.end(), [&](const Tolerance& tolerance) {
                const float apart = Value(i, tolerance.channel) - Value(leader, tolerance.channel);
                return std::fabs(apart) <= tolerance.largest;
            });
        };
        return static_cast<std::uint32_t>(std::stable_partition(from, to, alike) - corners_.begin());
    }

    template <class Visit>
    void ForEachGroup(const Visit& visit) const
    {
        std::size_t begin = 0;
        for (const Group& group : groups_) {
            visit(group, begin);
            begin = group.end;
        }
    }

    /// Copies of vertices for the groups that have none, at the end of the mesh's.
    void AddVertices()
    {
        const auto isNew = [](const Group& group) { return group.vertex == AttributeComponent::kNoChannel; };
        const auto count = std::count_if(groups_.begin(), groups_.end(), isNew);
        if (count == 0) return;
        auto next = static_cast<std::uint32_t>(mesh_.vert.size());
        vcg::tri::Allocator<Mesh>::AddVertices(mesh_, static_cast<std::size_t>(count));
        std::size_t begin = 0;
        for (Group& group : groups_) {
            const std::size_t first = std::exchange(begin, group.end);
            if (!isNew(group)) continue;
            group.vertex = next++;
            mesh_.vert[group.vertex].P() = mesh_.vert[group.source].P();
            mesh_.vert[group.vertex].ImportData(mesh_.vert[group.source]);
            for (const auto& custom : mesh_.vert_attr)
                custom._handle->CopyValue(group.vertex, group.source, custom._handle);
            for (std::size_t i = first; i < group.end; ++i)
                FaceOf(corners_[i] / 3).V(static_cast<int>(corners_[i] % 3)) = &mesh_.vert[group.vertex];
        }
    }

    /// Sides of vertices all of whose faces are as they were keep theirs, and so do those without area.
    void WriteNormals()
    {
        const std::vector<std::size_t> first = FirstCornersOfSides(result_);
        const std::vector<Vector3<double>> normals = CornerNormals(result_, first);
        std::vector<std::uint8_t> keeps(CornerCount(), 1); // by first corners
        for (std::size_t i = 0; i < CornerCount(); ++i) keeps[first[i]] &= untouched_[i / 3];
        for (std::size_t i = 0; i < CornerCount(); ++i) {
            if (keeps[first[i]] || !(LargestComponent(normals[i]) > 0)) continue;
            auto& normal = FaceOf(i / 3).WN(static_cast<int>(i % 3));
            using Number = std::decay_t<decltype(normal[0])>;
            normal = {static_cast<Number>(normals[i].x), static_cast<Number>(normals[i].y),
                      static_cast<Number>(normals[i].z)};
        }
    }

    template <class Access>
    void WriteComponent(AttributePlace place, const AttributeComponent& component, std::size_t c,
                        const Access& access)
    {
        const auto write = [&](std::size_t element, float value) {
            if (component.ToChannel(access.Get(element, c)) != value)
                access.Set(element, c, component.FromChannel(value));
        };
        if (place == AttributePlace::Vertex) {
            ForEachGroup([&](const Group& group, std::size_t begin) {
                write(group.vertex, Mean(component.channel, begin, group.end));
            });
        } else if (place == AttributePlace::Wedge) {
            for (std::size_t i = 0; i < CornerCount(); ++i)
                write(3 * FaceIndex(i / 3) + i % 3, Value(i, component.channel));
        } else {
            for (std::size_t f = 0; f < untouched_.size(); ++f) {
                if (untouched_[f]) continue;
                float sum = 0;
                for (std::size_t k = 0; k < 3; ++k) sum += Value(3 * f + k, component.channel);
                write(FaceIndex(f), sum / 3);
            }
        }
    }

    /// Of corners in a row; the value itself where all have the same.
    float Mean(std::uint32_t channel, std::size_t begin, std::size_t end) const
    {
        const float first = Value(corners_[begin], channel);
        double sum = 0;
        bool same = true;
        for (std::size_t i = begin; i < end; ++i) {
            const float value = Value(corners_[i], channel);
            same = same && value == first;
            sum += static_cast<double>(value);
        }
        return same ? first : static_cast<float>(sum / static_cast<double>(end - begin));
    }
};

} // namespace vcg_ext
