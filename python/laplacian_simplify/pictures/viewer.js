// SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The viewer of the page: both meshes from the same place, plain or with their distances as colors.
"use strict";
(() => {
    const data = JSON.parse(document.getElementById("data").textContent);
    const stage = document.getElementById("stage");
    const legend = document.getElementById("legend");
    const edges = document.getElementById("edges");
    const turn = document.getElementById("turn");
    const GREY = 0xcdd6dd, EDGE = 0x3b444c;
    const STEP_OF_TURN = 0.006; // radians a frame
    const MOST_EDGES = 12000;   // faces up to which edges are shown at first: more would hide the surface

    function decoded(text, Type) {
        const binary = atob(text), bytes = new Uint8Array(binary.length);
        for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
        return new Type(bytes.buffer);
    }

    // The scale of colors as a texture, so that colors between the vertices are those of the distances there.
    function scaleOfColors() {
        const stops = data.colors.map(text => [1, 3, 5].map(at => parseInt(text.slice(at, at + 2), 16)));
        const pixels = new Uint8Array(4 * 256);
        for (let i = 0; i < 256; ++i) {
            const at = i / 255 * (stops.length - 1), k = Math.min(Math.floor(at), stops.length - 2);
            for (let c = 0; c < 3; ++c) pixels[4 * i + c] = stops[k][c] + (at - k) * (stops[k + 1][c] - stops[k][c]);
            pixels[4 * i + 3] = 255;
        }
        const texture = new THREE.DataTexture(pixels, 256, 1);
        texture.colorSpace = THREE.SRGBColorSpace;
        texture.magFilter = texture.minFilter = THREE.LinearFilter;
        texture.needsUpdate = true;
        return texture;
    }

    // Each edge once, as pairs of vertices.
    function edgesOf(faces, vertices) {
        const keys = new Float64Array(faces.length);
        for (let i = 0; i < faces.length; ++i) {
            const a = faces[i], b = faces[i % 3 === 2 ? i - 2 : i + 1];
            keys[i] = Math.min(a, b) * vertices + Math.max(a, b);
        }
        keys.sort();
        const ends = [];
        for (let i = 0; i < keys.length; ++i)
            if (i === 0 || keys[i] !== keys[i - 1]) ends.push(Math.floor(keys[i] / vertices), keys[i] % vertices);
        return new Uint32Array(ends);
    }

    const texture = scaleOfColors();
    const solid = {flatShading: true, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1,
                   polygonOffsetUnits: 1};
    const plainMaterial = new THREE.MeshLambertMaterial({...solid, color: GREY});
    const errorMaterial = new THREE.MeshLambertMaterial({...solid, map: texture});
    const edgeMaterial = new THREE.LineBasicMaterial({color: EDGE, transparent: true, opacity: 0.55});

    function loaded(mesh) {
        const positions = new THREE.BufferAttribute(decoded(mesh.positions, Float32Array), 3);
        const faces = decoded(mesh.faces, Uint32Array), errors = decoded(mesh.errors, Float32Array);
        const uv = new Float32Array(2 * errors.length);
        for (let i = 0; i < errors.length; ++i) {
            uv[2 * i] = (0.5 + 255 * Math.min(errors[i], 1)) / 256;
            uv[2 * i + 1] = 0.5;
        }
        function solidOf(index, material) {
            const geometry = new THREE.BufferGeometry();
            geometry.setAttribute("position", positions);
            geometry.setAttribute("uv", new THREE.BufferAttribute(uv, 2));
            geometry.setIndex(new THREE.BufferAttribute(index, 1));
            return new THREE.Mesh(geometry, material);
        }
        const wires = new THREE.BufferGeometry();
        wires.setAttribute("position", positions);
        wires.setIndex(new THREE.BufferAttribute(edgesOf(faces, positions.count), 1));
        return {
            plain: solidOf(faces, plainMaterial),
            error: solidOf(mesh.divided ? decoded(mesh.divided, Uint32Array) : faces, errorMaterial),
            wires: new THREE.LineSegments(wires, edgeMaterial),
            hasEdges: faces.length / 3 <= MOST_EDGES,
        };
    }

    let renderer;
    try {
        renderer = new THREE.WebGLRenderer({antialias: true});
    } catch (problem) {
        stage.textContent = "This browser shows no 3D (WebGL). The picture below has the same.";
        return;
    }
    renderer.setClearColor(0xffffff);
    renderer.setPixelRatio(window.devicePixelRatio);
    stage.append(renderer.domElement);

    const meshes = data.meshes.map(loaded);
    const scene = new THREE.Scene(), camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.01, 20);
    const view = data.view, middle = new THREE.Vector3(...view.middle);
    const light = new THREE.DirectionalLight(0xffffff, 0.62 * Math.PI);
    light.position.set(0.35, 0.5, 1);
    camera.add(light, light.target);
    light.target.position.set(0, 0, 0);
    scene.add(camera, new THREE.HemisphereLight(0xffffff, 0xdde2e6, 0.42 * Math.PI));
    for (const mesh of meshes) scene.add(mesh.plain, mesh.error, mesh.wires);

    const controls = new THREE.TrackballControls(camera, renderer.domElement);
    controls.rotateSpeed = 3;
    controls.staticMoving = true;

    let stale = true;
    controls.addEventListener("change", () => { stale = true; });

    function lookFromTheStart() {
        controls.target.copy(middle);
        camera.up.set(...view.up);
        camera.position.set(...view.direction).multiplyScalar(3).add(middle);
        camera.zoom = 1;
        camera.updateProjectionMatrix();
        controls.update();
        stale = true;
    }

    function fit() {
        const width = stage.clientWidth, height = stage.clientHeight;
        if (!width || !height) return;
        const half = 1.06 / 2 * Math.max(view.height, view.width * height / width);
        [camera.top, camera.bottom] = [half, -half];
        [camera.right, camera.left] = [half * width / height, -half * width / height];
        camera.updateProjectionMatrix();
        renderer.setSize(width, height);
        controls.handleResize();
        stale = true;
    }

    const shown = () => document.querySelector("input[name=shown]:checked").value;
    const shownMesh = () => shown().endsWith("after") ? 1 : 0;

    function show() {
        const withError = shown().startsWith("error"), which = shownMesh();
        meshes.forEach((mesh, k) => {
            mesh.plain.visible = k === which && !withError;
            mesh.error.visible = k === which && withError;
            mesh.wires.visible = k === which && mesh.hasEdges;
        });
        edges.checked = meshes[which].hasEdges;
        legend.hidden = !withError;
        stale = true;
    }

    function frame() {
        if (turn.checked) {
            const arm = camera.position.clone().sub(controls.target);
            camera.position.copy(arm.applyAxisAngle(new THREE.Vector3(...view.up), STEP_OF_TURN)).add(controls.target);
            stale = true;
        }
        controls.update();
        if (stale) renderer.render(scene, camera);
        stale = false;
        requestAnimationFrame(frame);
    }

    const choices = [...document.querySelectorAll("input[name=shown]")];
    for (const input of choices) input.addEventListener("change", show);
    edges.addEventListener("change", () => {
        meshes[shownMesh()].hasEdges = edges.checked;
        show();
    });
    document.getElementById("back").addEventListener("click", lookFromTheStart);
    document.addEventListener("keydown", event => {
        const choice = choices[Number(event.key) - 1];
        if (choice && !event.ctrlKey && !event.altKey && !event.metaKey) {
            choice.checked = true;
            show();
        }
    });
    new ResizeObserver(fit).observe(stage);
    fit();
    lookFromTheStart();
    show();
    frame();
})();
