# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The structures of ``python/library/simplify_arrays.h``, which says what their fields mean."""

import ctypes
from ctypes import c_char, c_char_p, c_double, c_float, c_int32, c_uint32, c_uint64, c_void_p
from typing import ClassVar

CALLBACK = ctypes.CFUNCTYPE(c_int32, c_int32, c_char_p)


class MeshStructure(ctypes.Structure):
    _fields_: ClassVar = [
        ("positions", c_void_p),
        ("faces", c_void_p),
        ("vertex_count", c_uint64),
        ("face_count", c_uint64),
        ("double_positions", c_int32),
        ("index_bytes", c_int32),
        ("fixed_vertices", c_void_p),
        ("shared_seams", c_int32),
        ("selected_faces", c_void_p),
        ("stored_quality", c_void_p),
        ("corner_values", c_void_p),
        ("channel_kinds", c_void_p),
        ("channel_count", c_uint64),
        ("face_labels", c_void_p),
        ("vertex_normals", c_void_p),
        ("corner_normals", c_void_p),
    ]


class ParametersStructure(ctypes.Structure):
    _fields_: ClassVar = [
        ("target_faces", c_uint64),
        ("max_error", c_double),
        ("feature_weight", c_double),
        ("effort", c_int32),
        ("descriptor", c_int32),
        ("boundary", c_int32),
        ("attribute_weight", c_double),
        ("seams", c_int32),
        ("preserve_topology", c_int32),
        ("avoid_self_intersections", c_int32),
        ("clean_input", c_int32),
        ("weld_distance", c_double),
        ("measure_error", c_int32),
        ("threads", c_int32),
        ("cost_limit", c_double),
        ("descriptor_scale", c_double),
        ("progress", CALLBACK),
    ]


class StepStructure(ctypes.Structure):
    _fields_: ClassVar = [("cost", c_double), ("faces", c_uint64)]


class TextureStructure(ctypes.Structure):
    _fields_: ClassVar = [("rms", c_double), ("largest", c_double)]


class ResultStructure(ctypes.Structure):
    _fields_: ClassVar = [
        ("vertex_count", c_uint64),
        ("face_count", c_uint64),
        ("positions", ctypes.POINTER(c_double)),
        ("faces", ctypes.POINTER(c_uint32)),
        ("vertex_origin", ctypes.POINTER(c_uint32)),
        ("face_origin", ctypes.POINTER(c_uint32)),
        ("target_reached", c_int32),
        ("stop_reason", c_int32),
        ("non_manifold_edges", c_uint64),
        ("boundary_edges", c_uint64),
        ("has_distances", c_int32),
        ("hausdorff", c_double),
        ("rms", c_double),
        ("feature_rms", c_double),
        ("folded", c_uint64),
        ("has_self_intersections", c_int32),
        ("self_intersections", c_uint64),
        ("has_self_intersections_before", c_int32),
        ("self_intersections_before", c_uint64),
        ("has_cleaning", c_int32),
        ("welded_vertices", c_uint64),
        ("dropped_faces", c_uint64),
        ("has_certificate", c_int32),
        ("certified_error", c_double),
        ("corner_values", ctypes.POINTER(c_float)),
        ("corner_sides", ctypes.POINTER(c_uint32)),
        ("has_attributes", c_int32),
        ("charts", c_uint64),
        ("turned_faces", c_uint64),
        ("held_faces", c_uint64),
        ("rms_count", c_uint64),
        ("attribute_rms", ctypes.POINTER(c_double)),
        ("texture_count", c_uint64),
        ("textures", ctypes.POINTER(TextureStructure)),
        ("seconds", c_double),
        ("step_count", c_uint64),
        ("steps", ctypes.POINTER(StepStructure)),
        ("descriptor_scale", c_double),
        ("storage", c_void_p),
        ("message", c_char * 512),
    ]
