// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What python/laplacian_simplify/pictures/viewer.js may use of three.js.
export {
    BufferAttribute, BufferGeometry, Color, DataTexture, DirectionalLight, DoubleSide, HemisphereLight,
    LinearFilter, LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial, OrthographicCamera, REVISION,
    Scene, SRGBColorSpace, Vector3, WebGLRenderer,
} from "three";
export {TrackballControls} from "three/examples/jsm/controls/TrackballControls.js";
