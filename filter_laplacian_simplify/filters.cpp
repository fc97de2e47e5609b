// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters.h"

namespace laplacian_simplify
{
namespace
{

constexpr const char* kZhang2012 = "<i>Lin Zhang, Zhen Ma, Zhong Zhou, Wei Wu</i><br/>"
                                   "<b>\"Laplacian-Based Feature Preserving Mesh Simplification\"</b><br/>"
                                   "Advances in Multimedia Information Processing (PCM 2012).";

constexpr const char* kGarland1997 = "<i>Michael Garland, Paul S. Heckbert</i><br/>"
                                     "<b>\"Surface Simplification Using Quadric Error Metrics\"</b><br/>"
                                     "SIGGRAPH 1997.";

constexpr const char* kLindstrom1998 = "<i>Peter Lindstrom, Greg Turk</i><br/>"
                                       "<b>\"Fast and Memory Efficient Polygonal Simplification\"</b><br/>"
                                       "IEEE Visualization 1998.";

constexpr const char* kMelax1998 = "<i>Stan Melax</i><br/>"
                                   "<b>\"A Simple, Fast, and Effective Polygon Reduction Algorithm\"</b><br/>"
                                   "Game Developer, November 1998.";

constexpr const char* kLi2010 =
    "<i>Li Li, Mingyi He, Peng Wang</i><br/>"
    "<b>\"Mesh Simplification Algorithm Based on Absolute Curvature-weighted Quadric Error Metrics\"</b><br/>"
    "ICIEA 2010.";

constexpr const char* kDesbrun1999 =
    "<i>Mathieu Desbrun, Mark Meyer, Peter Schröder, Alan H. Barr</i><br/>"
    "<b>\"Implicit Fairing of Irregular Meshes using Diffusion and Curvature Flow\"</b><br/>"
    "SIGGRAPH 1999.";

} // namespace

const std::vector<Filter>& Filters()
{
    static const std::vector<Filter> filters = {
        {FilterId::ShapeDescriptor,
         "descriptor",
         "Laplacian Shape Descriptor",
         "compute_scalar_by_laplacian_descriptor_per_vertex",
         "Stores in the vertex quality how strongly each vertex deviates from its neighbors.",
         "0 where the surface is flat, toward 1 on creases and corners.",
         "The Laplacian descriptor is the mean of the edge vectors at a vertex, measured along the vertex normal and "
         "divided by the mean edge length, so it does not depend on the size of the mesh. Curvatures are "
         "offered for comparison; unless rescaled, they have the unit of a curvature.",
         {kZhang2012},
         {Category::Quality, Category::VertexColoring},
         kVertexQuality | kVertexColor},
        {FilterId::FeatureSelection,
         "classify",
         "Select Feature Vertices by Laplacian Descriptor",
         "compute_selection_by_laplacian_descriptor_per_vertex",
         "Selects the vertices on creases, corners and fine details by clustering a shape descriptor.",
         "The current vertex selection is replaced.",
         "One-dimensional k-means divides the descriptor values into classes (the global optimum, not a "
         "local one). The vertices of the highest classes are selected. Two classes find the sharp edges of mechanical parts. On natural shapes the boundary "
         "between the classes is arbitrary.",
         {kZhang2012},
         {Category::Selection},
         kVertexSelection | kFaceSelection | kVertexQuality},
        {FilterId::GuidedDecimation,
         "simplify",
         "Simplification: Laplacian-Guided Quadric Edge Collapse",
         "meshing_decimation_laplacian_quadric_edge_collapse",
         "Simplifies a mesh (decimation) and keeps creases, corners and details longest.",
         "", // its dialog is the longest, and 2020.09 has no scroll bar
         "Edges collapse in the order of their quadric error. Collapses near features cost more; \"Feature "
         "weight\" sets how much. No collapse turns a face by more than 78 degrees or creates a non-manifold "
         "edge. The result is bit-identical for any number of threads. If the target cannot be reached, the "
         "filter stops above it and says why. Texture coordinates, colors, quality and custom attributes guide the "
         "decimation and are fitted to the result; seams stay. Nothing changes if a parameter is out of range or "
         "the run is canceled.",
         {kZhang2012, kGarland1997, kLindstrom1998},
         {Category::Remeshing},
         kGeometryAndTopology},
        {FilterId::WeightedDecimation,
         "weighted",
         "Simplification: Laplacian-Weighted Edge Collapse (Zhang et al. 2012)",
         "meshing_decimation_laplacian_weighted_edge_collapse",
         "Simplifies a mesh by the decimation of Zhang et al. (PCM 2012), a faithful implementation for research.",
         "For everyday work the Laplacian-Guided filter is faster and more accurate.",
         "Edges collapse in strict order of an error function multiplied by exp(feature weight * descriptor) "
         "(Eq. 6), in VCG's priority queue.",
         {kZhang2012, kMelax1998, kLi2010},
         {Category::Remeshing},
         kGeometryAndTopology},
        {FilterId::LevelsOfDetail,
         "lod",
         "Simplification: Laplacian-Guided Levels of Detail",
         "generate_laplacian_levels_of_detail",
         "Several simplifications of a mesh (decimation), each coarser than the one before, as new layers.",
         "The original stays, hidden, as all levels but the last.",
         "Each level is a result of the Laplacian-Guided Quadric Edge Collapse, with all that it promises, refined and "
         "measured against the original. The collapse of a level goes on where the one before it stopped; levels with an error bound and those of order \"strict\" are runs of their own. The layers are named "
         "after the mesh and the percentage or the error. Numbers are returned as lists, one number for each level; one "
         "that a level lacks is not a number (NaN).",
         {kZhang2012, kGarland1997, kLindstrom1998},
         {Category::Remeshing},
         kGeometryAndTopology},
        {FilterId::UmbrellaSmooth,
         "smooth",
         "Umbrella Smooth (Uniform, Scale- or Normal-Dependent)",
         "apply_coord_umbrella_smoothing",
         "Moves each vertex toward the mean of its neighbors, with one of three umbrella operators.",
         "The normal-dependent one leaves flat regions as they are.",
         "The uniform operator uses the plain mean. The scale-dependent operator weights each neighbor by "
         "the inverse of its distance. The normal-dependent operator moves vertices along their normals "
         "only, which leaves flat regions exactly where they are.",
         {kDesbrun1999, kZhang2012},
         {Category::Smoothing},
         kVertexPosition | kVertexNormal | kFaceNormal},
    };
    return filters;
}

const Filter& Row(FilterId id)
{
    return Filters().at(static_cast<std::size_t>(id));
}

std::string References(const Filter& filter)
{
    std::string text;
    for (const char* reference : filter.references)
        text += (text.empty() ? "" : "<br/>") + std::string(reference);
    return text;
}

std::string Description(const Filter& filter)
{
    const auto line = [](const char* text) {
        return "<small><nobr> " + std::string(text) + " </nobr></small>";
    };
    return *filter.note ? line(filter.summary) + "<br/>" + line(filter.note) : line(filter.summary);
}

} // namespace laplacian_simplify
