// SPDX-License-Identifier: MIT
// ?selftest=N: rays and answers of a grid of N samples along the longer side, as base64 of float32, in the document.
// With &lose the context is lost and returned before. Nobody but tests asks for it.
function base64(floats) {
    const bytes = new Uint8Array(floats.buffer);
    let text = "";
    for (const byte of bytes) text += String.fromCharCode(byte);
    return btoa(text);
}

function selftestOf(page) {
    page.prepare();
    const {device, view, camera} = page;
    device.drawView(view, camera);
    const grid = gridOf(camera, Number(page.query.get("selftest")));
    const [ours, theirs] = answersOf(device, view, camera, grid);
    const gl = device.gl, debug = gl.getExtension("WEBGL_debug_renderer_info");
    return {
        ours: base64(ours), pasted: base64(theirs), radii: [1, view.ratio], pixel: camera.pixel,
        width: grid.width, height: grid.height, verdicts: verdictsOf(device, view, camera, grid), kept: selfCheck(device),
        line: traceLine(ours), error: gl.getError(), restored: page.restored ?? false,
        renderer: gl.getParameter(debug ? debug.UNMASKED_RENDERER_WEBGL : gl.RENDERER),
        shadertoy: completeShader("shadertoy", view), glsl: completeShader("glsl", view),
    };
}

function runSelftest(page) {
    const report = () => page.guarded(() => { element("selftest").textContent = JSON.stringify(selftestOf(page)); });
    if (!page.query.has("lose")) return report();
    const context = page.device.gl.getExtension("WEBGL_lose_context");
    report();
    page.canvas.addEventListener("webglcontextlost", () => setTimeout(() => context.restoreContext(), 0));
    page.canvas.addEventListener("webglcontextrestored", () => {
        page.restored = true;
        report();
    });
    context.loseContext();
}
