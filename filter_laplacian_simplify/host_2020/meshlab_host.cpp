// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_2020/meshlab_host.h"

#include <stdexcept>

#include <vcg/complex/append.h>
#include <vcg/complex/algorithms/update/normal.h>

namespace laplacian_simplify
{

MeshLabHost::MeshLabHost(MeshDocument& document, vcg::CallBackPos* callback,
                         std::function<void(const std::string&)> log)
    : document_(document), model_(document.mm()), callback_(callback), log_(std::move(log))
{
    if (!model_) throw std::invalid_argument("there is no current mesh");
}

void MeshLabHost::GeometryChanged()
{
    model_->UpdateBoxAndNormals();
    // MeshLab leaves them as long as the sum of the angles around the vertex.
    vcg::tri::UpdateNormal<CMeshO>::NormalizePerVertex(model_->cm);
}

void MeshLabHost::ContinueOnCopy()
{
    MeshModel& original = *model_;
    MeshModel& copy = *document_.addNewMesh("", original.label() + " simplified", true);
    copy.updateDataMask(&original);
    vcg::tri::Append<CMeshO, CMeshO>::Mesh(copy.cm, original.cm);
    copy.updateDataMask(&original); // adjacency was made for the mesh when it was empty
    copy.cm.Tr = original.cm.Tr;
    copy.cm.shot = original.cm.shot;
    copy.UpdateBoxAndNormals();
    model_ = &copy;
}

} // namespace laplacian_simplify
