// SPDX-License-Identifier: MIT
// What a ray costs by either method: the same picture's rays, answers alone, no light. By the device's own timer where
// WebGL lends it. Otherwise by the page's clock: so many draws that they take a while, waited for by reading a pixel of them.
const costSide = 256;             // pixels of the square that is drawn
const longEnough = 15;            // ms
const mostDraws = 256;
const mostAsked = 200;            // 5 ms each

// An offscreen square to which draws are added. Where one covers the other, a driver may leave the other out.
function costTarget(device) {
    const gl = device.gl;
    const frame = gl.createFramebuffer(), texture = gl.createTexture();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, costSide, costSide);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE);
    return () => {
        gl.disable(gl.BLEND);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.deleteFramebuffer(frame);
        gl.deleteTexture(texture);
    };
}

// Makes the next draws trace a square of the picture's rays, none of them outside of it; returns how many.
function prepareCost(device, method, view, camera) {
    const set = device.use(method, view.tier);
    device.setRays(set, view, camera);
    const shorter = Math.min(camera.width, camera.height) * camera.side;
    const width = Math.min(costSide, shorter);
    set("stride", "1i", Math.floor(shorter / width));
    device.gl.viewport(0, 0, width, width);
    return width * width;
}

// Reading a pixel waits for all draws before; gl.finish() need not.
function drawsByClock(device, count) {
    const gl = device.gl;
    const begin = performance.now();
    for (let i = 0; i < count; ++i) gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    return performance.now() - begin;
}

// ns a ray.
function costByClock(device, method, view, camera) {
    const free = costTarget(device);
    const rays = prepareCost(device, method, view, camera);
    let count = 1, time = drawsByClock(device, 1);
    time = drawsByClock(device, 1);            // the first includes what the driver compiles late
    while (time < longEnough && count < mostDraws) {
        count *= 2;
        time = drawsByClock(device, count);
    }
    const nothing = drawsByClock(device, 0);
    free();
    return 1e6 * Math.max(time - nothing, 0) / (count * rays);
}

// A query that ends later; its result is asked for in the frames that follow. null where the device was disturbed.
function costByTimer(device, method, view, camera) {
    const gl = device.gl, timer = device.timer;
    const free = costTarget(device);
    const rays = prepareCost(device, method, view, camera);
    const draws = 4;
    const query = gl.createQuery();
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.beginQuery(timer.TIME_ELAPSED_EXT, query);
    for (let i = 0; i < draws; ++i) gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.endQuery(timer.TIME_ELAPSED_EXT);
    free();
    return new Promise(resolve => {
        let asked = 0;
        const ask = () => {
            if (gl.isContextLost() || ++asked > mostAsked) return resolve(null);
            if (!gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE)) return setTimeout(ask, 5);
            const disturbed = gl.getParameter(timer.GPU_DISJOINT_EXT);
            const time = gl.getQueryParameter(query, gl.QUERY_RESULT);
            gl.deleteQuery(query);
            resolve(disturbed || !time ? null : time / (draws * rays));
        };
        setTimeout(ask, 0);
    });
}

const shareToBelieve = 0.5;

// Both methods by the same clock. llvmpipe's timer shows a tenth of the time that passes: a timer that shows much less than the
// page's clock is not believed. null: the context is gone meanwhile.
async function costsOf(device, view, camera) {
    const [library, pasted] = ["library", "pasted"].map(method => costByClock(device, method, view, camera));
    if (device.timer) {
        const timed = {library: await costByTimer(device, "library", view, camera), pasted: null, byTimer: true};
        if (timed.library > shareToBelieve * library) timed.pasted = await costByTimer(device, "pasted", view, camera);
        if (timed.pasted !== null) return timed;
    }
    return device.gl.isContextLost() ? null : {library, pasted, byTimer: false};
}
