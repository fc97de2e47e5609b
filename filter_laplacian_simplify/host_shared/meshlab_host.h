// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include <vcg/complex/complex.h>
#include <vcg/complex/algorithms/update/normal.h>

#include "host_masks.h"
#include "layer_name.h"
#include "meshlab_version.h"

namespace laplacian_simplify
{

/// The Host of host.h in any MeshLab: one run on the current mesh of a document.
class MeshLabHost
{
    MeshDocument& document_;
    MeshModel* const original_;
    MeshModel* model_;
    MeshModel* shown_;
    int written_ = 0;
    vcg::CallBackPos* callback_;
    std::function<void(const std::string&)> log_;

  public:
    using MeshType = CMeshO;

    /// \param callback may be null
    /// \throws std::invalid_argument if the document has no current mesh
    MeshLabHost(MeshDocument& document, vcg::CallBackPos* callback,
                std::function<void(const std::string&)> log)
        : document_(document), original_(document.mm()), model_(original_), shown_(original_),
          callback_(callback), log_(std::move(log))
    {
        if (!model_) throw std::invalid_argument("there is no current mesh");
    }

    CMeshO& Mesh() { return model_->cm; }
    void Require(std::uint32_t data)
    {
        written_ |= HostMask<MeshModel>(data);
        model_->updateDataMask(HostMask<MeshModel>(data));
    }
    /// All that was required so far, as MeshLab's bits.
    int Written() const { return written_; }
    void ContinueOnCopy(const std::string& suffix)
    {
        const std::string label = LayerLabel(original_->label().toStdString(), suffix);
        model_ = &AddCopy(document_, *original_, QString::fromStdString(label));
        document_.setVisible(shown_->id(), false); // both at one place would flicker
        shown_ = model_;
    }
    void ReturnToOriginal() { model_ = original_; }
    void GeometryChanged()
    {
        UpdateBoxAndNormals(*model_);
        // MeshLab leaves them as long as the sum of the angles around the vertex.
        vcg::tri::UpdateNormal<CMeshO>::NormalizePerVertex(model_->cm);
    }
    void Log(const std::string& line) { log_(line); }
    bool Progress(int percent, const char* stage) { return !callback_ || callback_(percent, stage); }
};

} // namespace laplacian_simplify
