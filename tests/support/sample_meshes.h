// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include <vcg/complex/complex.h>
#include <wrap/io_trimesh/import_obj.h>
#include <wrap/io_trimesh/import_ply.h>
#include <wrap/ply/plylib.cpp> // VCG's reader of PLY is no header

#include "analytic_meshes.h"
#include "test_meshes.h"

/// The project's own sample meshes, read by VCG. For one file of a program: the reader is not inline.
namespace test_meshes
{

inline constexpr const char* kSampleMeshes[] = {
    "bracket_quads.ply",    "creature.ply",    "flange.ply",     "folded_sheet.ply",
    "leaves_and_cones.ply", "painted_box.obj", "relief_scan.ply"};

/// Polygons become triangles with faux edges. \throws std::runtime_error where the file cannot be read
inline IndexedMesh SampleMesh(const std::string& name)
{
    const std::string path = std::string(SAMPLE_MESHES_DIR) + "/" + name;
    DoubleMesh mesh;
    int loaded = 0;
    const bool isObj = name.substr(name.size() - 3) == "obj";
    using Obj = vcg::tri::io::ImporterOBJ<DoubleMesh>;
    using Ply = vcg::tri::io::ImporterPLY<DoubleMesh>;
    const bool failed = isObj ? Obj::ErrorCritical(Obj::Open(mesh, path.c_str(), loaded))
                              : Ply::ErrorCritical(Ply::Open(mesh, path.c_str()));
    // Attributes of a mesh do not go with it.
    vcg::tri::Allocator<DoubleMesh>::DeletePerFaceAttribute(mesh, "materialIndex");
    vcg::tri::Allocator<DoubleMesh>::DeletePerMeshAttribute(mesh, "materialVector");
    if (failed || mesh.fn == 0) throw std::runtime_error("cannot read " + path);
    IndexedMesh result = Arrays(mesh);
    for (const auto& face : mesh.face)
        result.fauxEdges.push_back(
            static_cast<std::uint8_t>(face.IsF(0) | face.IsF(1) << 1 | face.IsF(2) << 2));
    return result;
}

} // namespace test_meshes
