// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters.h"

namespace laplacian_simplify
{
namespace
{

constexpr const char* kZhang2012 =
    "<i>Lin Zhang, Zhen Ma, Zhong Zhou, Wei Wu</i><br/><b>\"Laplacian-Based Feature Preserving Mesh "
    "Simplification\"</b><br/>Advances in Multimedia Information Processing (PCM 2012).";

constexpr const char* kZhang2012AndQuadrics =
    "<i>Lin Zhang, Zhen Ma, Zhong Zhou, Wei Wu</i><br/><b>\"Laplacian-Based Feature Preserving Mesh "
    "Simplification\"</b><br/>Advances in Multimedia Information Processing (PCM 2012).<br/>"
    "<i>Michael Garland, Paul S. Heckbert</i><br/><b>\"Surface Simplification Using Quadric Error "
    "Metrics\"</b><br/>SIGGRAPH 1997.<br/>"
    "<i>Peter Lindstrom, Greg Turk</i><br/><b>\"Fast and Memory Efficient Polygonal "
    "Simplification\"</b><br/>IEEE Visualization 1998.";

constexpr const char* kWeighting =
    "<i>Lin Zhang, Zhen Ma, Zhong Zhou, Wei Wu</i><br/><b>\"Laplacian-Based Feature Preserving Mesh "
    "Simplification\"</b><br/>Advances in Multimedia Information Processing (PCM 2012).<br/>"
    "<i>Stan Melax</i><br/><b>\"A Simple, Fast, and Effective Polygon Reduction Algorithm\"</b><br/>"
    "Game Developer, November 1998.<br/>"
    "<i>Li Li, Mingyi He, Peng Wang</i><br/><b>\"Mesh Simplification Algorithm Based on Absolute "
    "Curvature-weighted Quadric Error Metrics\"</b><br/>ICIEA 2010.";

constexpr const char* kZhang2012AndFairing =
    "<i>Mathieu Desbrun, Mark Meyer, Peter Schröder, Alan H. Barr</i><br/><b>\"Implicit Fairing of "
    "Irregular Meshes using Diffusion and Curvature Flow\"</b><br/>SIGGRAPH 1999.<br/>"
    "<i>Lin Zhang, Zhen Ma, Zhong Zhou, Wei Wu</i><br/><b>\"Laplacian-Based Feature Preserving Mesh "
    "Simplification\"</b><br/>Advances in Multimedia Information Processing (PCM 2012).";

} // namespace

const std::vector<Filter>& Filters()
{
    static const std::vector<Filter> filters = {
        {FilterId::ShapeDescriptor,
         "descriptor",
         "Laplacian Shape Descriptor",
         "compute_scalar_by_laplacian_descriptor_per_vertex",
         "Stores in the vertex quality how much every vertex stands out of its neighbourhood.",
         "The Laplacian descriptor is the part of the umbrella vector along the vertex normal, divided by "
         "the "
         "mean edge length: 0 where the surface is flat, towards 1 on creases, corners and fine details. It "
         "has no unit and does not depend on the size of the mesh. Curvatures are offered for comparison; "
         "they have the unit of a curvature unless they are rescaled.",
         kZhang2012,
         {Category::Quality, Category::VertexColoring},
         kVertexQuality | kVertexColor},
        {FilterId::FeatureSelection,
         "classify",
         "Select Feature Vertices by Laplacian Descriptor",
         "compute_selection_by_laplacian_descriptor_per_vertex",
         "Selects the vertices on creases, corners and details, found by clustering a shape descriptor.",
         "The descriptor's values are divided into classes by one-dimensional k-means (the optimum, not an "
         "approximation), and the vertices of the highest classes are selected; the former vertex selection "
         "is replaced. Two classes find the sharp edges of mechanical parts; on natural shapes the border "
         "between the classes is arbitrary.",
         kZhang2012,
         {Category::Selection},
         kVertexSelection | kFaceSelection | kVertexQuality},
        {FilterId::GuidedDecimation,
         "simplify",
         "Simplification: Laplacian-Guided Quadric Edge Collapse",
         "meshing_decimation_laplacian_quadric_edge_collapse",
         "Reduces the number of faces and keeps creases, corners and details longest.",
         "Edges are collapsed in the order of a quadric error that is weighted by e to the power of "
         "feature_weight times the Laplacian descriptor. No collapse turns a face by more than 78 degrees or "
         "makes a non-manifold edge, and the result does not depend on the number of threads. Where a target "
         "cannot be reached the filter stops before it and says why. Selection, colours, quality and texture "
         "coordinates of what remains are kept as they were, not interpolated. Nothing is changed when a "
         "parameter is out of range or the run is cancelled.",
         kZhang2012AndQuadrics,
         {Category::Remeshing},
         kGeometryAndTopology},
        {FilterId::WeightedDecimation,
         "weighted",
         "Simplification: Laplacian-Weighted Edge Collapse (Zhang et al. 2012)",
         "meshing_decimation_laplacian_weighted_edge_collapse",
         "The decimation of the paper to the letter, for comparison and research.",
         "Edges are collapsed in the strict order of an error function times e to the power of "
         "feature_weight "
         "times the descriptor (Eq. 6), by VCG's own local optimisation. For everyday work the "
         "Laplacian-Guided "
         "filter is faster and more exact.",
         kWeighting,
         {Category::Remeshing},
         kGeometryAndTopology},
        {FilterId::UmbrellaSmooth,
         "smooth",
         "Umbrella Smooth (Uniform, Scale- or Normal-Dependent)",
         "apply_coord_umbrella_smoothing",
         "Moves every vertex towards the mean of its neighbours, by one of three umbrella operators.",
         "The uniform operator takes the plain mean, the scale-dependent one weights the neighbours by "
         "the inverse of their distance, and the normal-dependent one keeps only the movement along the "
         "vertex normal, which leaves flat regions exactly where they are.",
         kZhang2012AndFairing,
         {Category::Smoothing},
         kVertexPosition | kVertexNormal | kFaceNormal},
    };
    return filters;
}

const Filter& Row(FilterId id)
{
    return Filters().at(static_cast<std::size_t>(id));
}

std::string Description(const Filter& filter)
{
    return std::string(filter.summary) + "<br/>" + filter.help + "<br/><br/>See:<br/>" + filter.references;
}

} // namespace laplacian_simplify
