// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_2022/meshlab_host.h"

#include <stdexcept>

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
    model_->updateBoxAndNormals();
    // MeshLab leaves them as long as the sum of the angles around the vertex.
    vcg::tri::UpdateNormal<CMeshO>::NormalizePerVertex(model_->cm);
}

void MeshLabHost::ContinueOnCopy()
{
    const MeshModel& original = *model_;
    MeshModel& copy = *document_.addNewMesh(original.cm, original.label() + " simplified", true);
    copy.cm.Tr = original.cm.Tr;
    copy.cm.shot = original.cm.shot;
    copy.updateDataMask(&original);
    for (const auto& [name, image] : original.getTextures()) copy.addTexture(name, image);
    model_ = &copy;
}

} // namespace laplacian_simplify
