// SPDX-License-Identifier: MIT
import {Engine} from "@babylonjs/core/Engines/engine.js";
import {EffectRenderer, EffectWrapper} from "@babylonjs/core/Materials/effectRenderer.js";
import "@babylonjs/core/Shaders/postprocess.vertex.js";

// As people write for it: no version, gl_FragColor. It cuts the text at each semicolon.
export async function babylonPicture(fragment, size) {
    const canvas = Object.assign(document.createElement("canvas"), {width: size, height: size});
    const engine = new Engine(canvas, false, {preserveDrawingBuffer: true});
    const wrapper = new EffectWrapper({
        engine, name: "torus", uniformNames: ["size"],
        fragmentShader: fragment.replace("#version 300 es\n", "").replace("out vec4 color;", "").replace(/\bcolor = vec4\(picture/, "gl_FragColor = vec4(picture"),
    });
    await new Promise((resolve, reject) => {
        wrapper.effect.onErrorObservable.add(effect => reject(new Error(effect.getCompilationError())));
        wrapper.effect.executeWhenCompiled(resolve);
    });
    wrapper.onApplyObservable.add(() => wrapper.effect.setFloat2("size", size, size));
    new EffectRenderer(engine).render(wrapper);
    const gl = engine._gl, bytes = new Uint8Array(4 * size * size);
    gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return bytes;
}
