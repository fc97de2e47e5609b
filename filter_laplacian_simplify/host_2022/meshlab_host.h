// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include <common/ml_document/mesh_document.h>

#include "host_masks.h"

namespace laplacian_simplify
{

/// The Host of host.h in MeshLab 2022.02 and later: one run on the current mesh of a document.
class MeshLabHost
{
    MeshDocument& document_;
    MeshModel* model_;
    vcg::CallBackPos* callback_;
    std::function<void(const std::string&)> log_;

  public:
    using MeshType = CMeshO;

    /// \param callback may be null
    /// \throws std::invalid_argument where the document has no current mesh
    MeshLabHost(MeshDocument& document, vcg::CallBackPos* callback,
                std::function<void(const std::string&)> log);

    CMeshO& Mesh() { return model_->cm; }
    void Require(std::uint32_t data) { model_->updateDataMask(HostMask<MeshModel>(data)); }
    void ContinueOnCopy();
    void GeometryChanged();
    void Log(const std::string& line) { log_(line); }
    bool Progress(int percent, const char* stage) { return !callback_ || callback_(percent, stage); }
};

} // namespace laplacian_simplify
