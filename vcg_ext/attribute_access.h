// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <typeindex>
#include <vector>

#include <vcg/complex/complex.h>

#include "vcg_ext/mesh_attribute.h"

namespace vcg_ext
{

namespace attribute_access_detail
{

constexpr double kByte = 255;

inline unsigned char ToByte(double part)
{
    return static_cast<unsigned char>(std::clamp(std::round(kByte * part), 0.0, kByte));
}

// Each of these reads and writes component c of element i: a vertex, a face, or corner k of face f as 3 f +
// k.

/// \param uv texture coordinates of vcglib, constant or not
template <class TexCoord>
auto& PartOf(TexCoord& uv, std::size_t c)
{
    return c == 0 ? uv.U() : uv.V();
}

template <class Mesh>
struct WedgeTexture {
    Mesh& mesh;
    double Get(std::size_t i, std::size_t c) const
    {
        const auto& uv = mesh.face[i / 3].cWT(static_cast<int>(i % 3)); // older versions return a copy
        return static_cast<double>(PartOf(uv, c));
    }
    void Set(std::size_t i, std::size_t c, double x) const
    {
        auto& number = PartOf(mesh.face[i / 3].WT(static_cast<int>(i % 3)), c);
        number = static_cast<std::decay_t<decltype(number)>>(x);
    }
};

template <class Mesh>
struct VertexTexture {
    Mesh& mesh;
    double Get(std::size_t i, std::size_t c) const
    {
        const auto& uv = mesh.vert[i].cT();
        return static_cast<double>(PartOf(uv, c));
    }
    void Set(std::size_t i, std::size_t c, double x) const
    {
        auto& number = PartOf(mesh.vert[i].T(), c);
        number = static_cast<std::decay_t<decltype(number)>>(x);
    }
};

/// Of vertices or faces.
template <class Elements>
struct Color {
    Elements& elements;
    double Get(std::size_t i, std::size_t c) const { return elements[i].cC()[static_cast<int>(c)] / kByte; }
    void Set(std::size_t i, std::size_t c, double x) const
    {
        elements[i].C()[static_cast<int>(c)] = ToByte(x);
    }
};

template <class Elements>
Color(Elements&) -> Color<Elements>;

template <class Mesh>
struct WedgeColor {
    Mesh& mesh;
    double Get(std::size_t i, std::size_t c) const
    {
        return mesh.face[i / 3].cWC(static_cast<int>(i % 3))[static_cast<int>(c)] / kByte;
    }
    void Set(std::size_t i, std::size_t c, double x) const
    {
        mesh.face[i / 3].WC(static_cast<int>(i % 3))[static_cast<int>(c)] = ToByte(x);
    }
};

template <class Elements>
struct Quality {
    Elements& elements;
    double Get(std::size_t i, std::size_t) const { return static_cast<double>(elements[i].cQ()); }
    void Set(std::size_t i, std::size_t, double x) const
    {
        auto& number = elements[i].Q();
        number = static_cast<std::decay_t<decltype(number)>>(x);
    }
};

template <class Elements>
Quality(Elements&) -> Quality<Elements>;

template <class Mesh>
struct VertexRadius {
    Mesh& mesh;
    double Get(std::size_t i, std::size_t) const { return static_cast<double>(mesh.vert[i].cR()); }
    void Set(std::size_t i, std::size_t, double x) const
    {
        auto& number = mesh.vert[i].R();
        number = static_cast<std::decay_t<decltype(number)>>(x);
    }
};

template <class Number>
struct CustomNumber {
    vcg::SimpleTempDataBase& data;
    double Get(std::size_t i, std::size_t) const
    {
        return static_cast<double>(*static_cast<const Number*>(data.At(i)));
    }
    void Set(std::size_t i, std::size_t, double x) const
    {
        *static_cast<Number*>(data.At(i)) = static_cast<Number>(x);
    }
};

template <class Number>
struct CustomPoint {
    vcg::SimpleTempDataBase& data;
    double Get(std::size_t i, std::size_t c) const
    {
        return static_cast<double>(
            (*static_cast<const vcg::Point3<Number>*>(data.At(i)))[static_cast<int>(c)]);
    }
    void Set(std::size_t i, std::size_t c, double x) const
    {
        (*static_cast<vcg::Point3<Number>*>(data.At(i)))[static_cast<int>(c)] = static_cast<Number>(x);
    }
};

/// Numbers of a custom attribute of that type; 0 where it is none of numbers.
inline std::size_t ComponentsOf(const std::type_index& type)
{
    if (type == typeid(float) || type == typeid(double)) return 1;
    if (type == typeid(vcg::Point3f) || type == typeid(vcg::Point3d)) return 3;
    return 0;
}

/// \param all the custom attributes of the mesh's vertices or faces
template <class Attributes, class Visit>
void WithCustom(const Attributes& all, const std::string& name, const Visit& visit)
{
    for (const auto& custom : all) {
        if (custom._name != name) continue;
        auto& data = *custom._handle;
        if (custom._type == typeid(float)) visit(CustomNumber<float>{data});
        if (custom._type == typeid(double)) visit(CustomNumber<double>{data});
        if (custom._type == typeid(vcg::Point3f)) visit(CustomPoint<float>{data});
        if (custom._type == typeid(vcg::Point3d)) visit(CustomPoint<double>{data});
    }
}

} // namespace attribute_access_detail

/// Calls \p visit with something that has Get(element, component) and Set(element, component, number); with
/// nothing where the mesh has no custom attribute of the name. \pre the mesh has the component
template <class Mesh, class Visit>
void WithAccess(Mesh& mesh, const MeshAttribute& attribute, const Visit& visit)
{
    using namespace attribute_access_detail;
    switch (attribute.carrier) {
    case AttributeCarrier::WedgeTexture:
        return visit(WedgeTexture<Mesh>{mesh});
    case AttributeCarrier::VertexTexture:
        return visit(VertexTexture<Mesh>{mesh});
    case AttributeCarrier::VertexColor:
        return visit(Color{mesh.vert});
    case AttributeCarrier::VertexQuality:
        return visit(Quality{mesh.vert});
    case AttributeCarrier::WedgeColor:
        return visit(WedgeColor<Mesh>{mesh});
    case AttributeCarrier::FaceColor:
        return visit(Color{mesh.face});
    case AttributeCarrier::CustomVertex:
        return WithCustom(mesh.vert_attr, attribute.name, visit);
    case AttributeCarrier::CustomFace:
        return WithCustom(mesh.face_attr, attribute.name, visit);
    case AttributeCarrier::VertexRadius:
        return visit(VertexRadius<Mesh>{mesh});
    case AttributeCarrier::FaceQuality:
        return visit(Quality{mesh.face});
    }
}

/// Gives a copy of a mesh the custom attributes of numbers that it lacks: vcglib's Append copies only those
/// that both have. \pre \p to has the elements of \p from that are not deleted, in their order
template <class Mesh>
void CopyCustomAttributes(const Mesh& from, Mesh& to)
{
    using Allocator = vcg::tri::Allocator<Mesh>;
    const auto copyAll = [&](const auto& all, const auto& elements, const auto& add) {
        for (const auto& custom : all) {
            const auto copy = [&](const auto& number) {
                using Number = std::decay_t<decltype(number)>;
                if (custom._name.empty() || custom._type != typeid(Number)) return;
                auto target = add(number, custom._name);
                std::size_t next = 0;
                for (std::size_t i = 0; i < elements.size(); ++i)
                    if (!elements[i].IsD())
                        target[next++] = *static_cast<const Number*>(custom._handle->At(i));
            };
            copy(float{});
            copy(double{});
            copy(vcg::Point3f{});
            copy(vcg::Point3d{});
        }
    };
    copyAll(from.vert_attr, from.vert, [&](const auto& number, const std::string& name) {
        return Allocator::template GetPerVertexAttribute<std::decay_t<decltype(number)>>(to, name);
    });
    copyAll(from.face_attr, from.face, [&](const auto& number, const std::string& name) {
        return Allocator::template GetPerFaceAttribute<std::decay_t<decltype(number)>>(to, name);
    });
}

/// The attributes of numbers that the mesh can hold and has switched on, without their components; custom
/// ones have as many as they have numbers.
template <class Mesh>
std::vector<MeshAttribute> AttributesOf(const Mesh& mesh)
{
    const bool has[] = {vcg::tri::HasPerWedgeTexCoord(mesh),
                        vcg::tri::HasPerVertexTexCoord(mesh),
                        vcg::tri::HasPerVertexColor(mesh),
                        vcg::tri::HasPerVertexQuality(mesh),
                        vcg::tri::HasPerWedgeColor(mesh),
                        vcg::tri::HasPerFaceColor(mesh),
                        false,
                        false,
                        vcg::tri::HasPerVertexRadius(mesh),
                        vcg::tri::HasPerFaceQuality(mesh)};
    std::vector<MeshAttribute> attributes;
    const auto addCustom = [&](const auto& all, AttributeCarrier carrier) {
        for (const auto& custom : all) { // in the order of their names; those of no name are temporary
            const std::size_t components = attribute_access_detail::ComponentsOf(custom._type);
            if (components > 0 && !custom._name.empty())
                attributes.push_back({carrier, custom._name, std::vector<AttributeComponent>(components)});
        }
    };
    for (std::size_t i = 0; i < std::size(has); ++i) {
        const auto carrier = static_cast<AttributeCarrier>(i);
        if (carrier == AttributeCarrier::CustomVertex) addCustom(mesh.vert_attr, carrier);
        if (carrier == AttributeCarrier::CustomFace) addCustom(mesh.face_attr, carrier);
        if (has[i])
            attributes.push_back(
                {carrier, kCarriers[i].name, std::vector<AttributeComponent>(kCarriers[i].components)});
    }
    return attributes;
}

} // namespace vcg_ext
