// SPDX-License-Identifier: MIT
// The example of the documentation, and the same torus as a fine mesh.
import * as THREE from "three";
import {torus} from "./documented.js";
import {pixelsOf} from "./three_picture.js";

function cameraOf() {
    const camera = new THREE.PerspectiveCamera(35, 1, 0.1, 100);
    camera.up.set(0, 0, 1);
    camera.position.set(1.5, -4.5, 3);
    camera.lookAt(0, 0, 0);
    return camera;
}

function pictureOf(mesh, size) {
    const scene = new THREE.Scene();
    mesh.rotation.set(0.4, 0.3, 0.2);
    scene.add(mesh);
    return pixelsOf(scene, cameraOf(), size);
}

export function examplePictures(size) {
    const material = new THREE.ShaderMaterial({
        glslVersion: THREE.GLSL3,
        vertexShader: "out vec3 across; void main() { across = normal; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
        fragmentShader: "in vec3 across; out vec4 color; void main() { color = vec4(0.5 + 0.5 * normalize(across), 1.0); }",
    });
    return [pictureOf(torus, size), pictureOf(new THREE.Mesh(new THREE.TorusGeometry(1, 0.4, 256, 512), material), size)];
}
