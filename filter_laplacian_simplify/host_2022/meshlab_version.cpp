// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_2022/meshlab_version.h"

namespace laplacian_simplify
{

void UpdateBoxAndNormals(MeshModel& model)
{
    model.updateBoxAndNormals();
}

MeshModel& AddCopy(MeshDocument& document, MeshModel& original, const QString& label)
{
    MeshModel& copy = *document.addNewMesh(original.cm, label, true);
    copy.cm.Tr = original.cm.Tr;
    copy.cm.shot = original.cm.shot;
    copy.updateDataMask(&original);
    // MeshLab says of every copy that it has these.
    for (const int data : {MeshModel::MM_VERTQUALITY, MeshModel::MM_VERTCOLOR})
        if (!original.hasDataMask(data)) copy.clearDataMask(data);
    for (const auto& [name, image] : original.getTextures()) copy.addTexture(name, image);
    return copy;
}

} // namespace laplacian_simplify
