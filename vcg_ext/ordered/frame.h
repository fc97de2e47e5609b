// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

namespace vcg_ext
{

/// Coordinates in which the box of all vertices that have faces has its centre at the origin and a diagonal
/// of 1, so that size and place of a mesh decide nothing.
class CollapseFrame
{
    vcg::Point3d centre_{0, 0, 0};
    double diagonal_ = 1;

  public:
    CollapseFrame() = default;

    template <class Mesh>
    explicit CollapseFrame(const Mesh& mesh)
    {
        vcg::Box3d box;
        for (const auto& face : mesh.face)
            if (!face.IsD())
                for (int k = 0; k < 3; ++k) box.Add(vcg::Point3d::Construct(face.cP(k)));
        if (box.IsNull()) return;
        centre_ = box.Center();
        if (box.Diag() > 0) diagonal_ = box.Diag();
    }

    /// From coordinates of the mesh.
    vcg::Point3d Into(const vcg::Point3d& p) const { return (p - centre_) / diagonal_; }
    /// To coordinates of the mesh.
    vcg::Point3d OutOf(const vcg::Point3d& p) const { return p * diagonal_ + centre_; }
};

} // namespace vcg_ext
