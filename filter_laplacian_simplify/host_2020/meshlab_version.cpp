// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_2020/meshlab_version.h"

#include <vcg/complex/append.h>

namespace laplacian_simplify
{

void UpdateBoxAndNormals(MeshModel& model)
{
    model.UpdateBoxAndNormals();
}

MeshModel& AddCopy(MeshDocument& document, MeshModel& original, const QString& label)
{
    MeshModel& copy = *document.addNewMesh("", label, true);
    copy.updateDataMask(&original);
    vcg::tri::Append<CMeshO, CMeshO>::Mesh(copy.cm, original.cm);
    copy.updateDataMask(&original); // adjacency was made for the mesh when it was empty
    copy.cm.Tr = original.cm.Tr;
    copy.cm.shot = original.cm.shot;
    copy.UpdateBoxAndNormals();
    return copy;
}

} // namespace laplacian_simplify
