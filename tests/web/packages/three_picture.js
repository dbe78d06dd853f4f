// SPDX-License-Identifier: MIT
import * as THREE from "three";

export function pixelsOf(scene, camera, size) {
    const renderer = new THREE.WebGLRenderer({antialias: false});
    renderer.debug.onShaderError = (gl, program, vertex, fragment) => {
        throw new Error(gl.getShaderInfoLog(vertex) + gl.getShaderInfoLog(fragment));
    };
    const target = new THREE.WebGLRenderTarget(size, size);
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    const bytes = new Uint8Array(4 * size * size);
    renderer.readRenderTargetPixels(target, 0, 0, size, size, bytes);
    return bytes;
}

export function threePicture(fragment, size) {
    const material = new THREE.ShaderMaterial({
        glslVersion: THREE.GLSL3,
        uniforms: {size: {value: new THREE.Vector2(size, size)}},
        vertexShader: "void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }",
        fragmentShader: fragment.replace("#version 300 es\n", ""),
    });
    const scene = new THREE.Scene();
    scene.add(new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material));
    return pixelsOf(scene, new THREE.Camera(), size);
}
