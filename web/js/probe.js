// SPDX-License-Identifier: MIT
// Rays and answers read back from the device, as the bits that its shaders had.
const targets = 4;

// A framebuffer with `count` textures of unsigned integers, which any WebGL 2 draws to and reads from.
function integerTargets(gl, count, width, height) {
    const frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    const textures = [], attachments = [];
    for (let i = 0; i < count; ++i) {
        textures.push(gl.createTexture());
        attachments.push(gl.COLOR_ATTACHMENT0 + i);
        gl.bindTexture(gl.TEXTURE_2D, textures[i]);
        gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32UI, width, height);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, attachments[i], gl.TEXTURE_2D, textures[i], 0);
    }
    gl.drawBuffers(attachments);
    const read = () => attachments.map(attachment => {
        gl.readBuffer(attachment);
        const bits = new Uint32Array(4 * width * height);
        gl.readPixels(0, 0, width, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, bits);
        return bits;
    });
    const free = () => {
        gl.deleteFramebuffer(frame);
        textures.forEach(texture => gl.deleteTexture(texture));
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    };
    return {read, free};
}

// 16 floats a sample: the ray as `raytorus trace` takes it, and its row of hits. Samples from `first`, each `stride`-th.
function probe(device, view, camera, {first, stride, width, height, pasted}) {
    const gl = device.gl;
    const frame = integerTargets(gl, targets, width, height);
    gl.viewport(0, 0, width, height);
    const set = device.use("probe", view.tier);
    device.setRays(set, view, camera);
    set("first", "2i", ...first);
    set("stride", "1i", stride);
    set("pasted", "1i", pasted ? 1 : 0);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const parts = frame.read();
    frame.free();
    const bits = new Uint32Array(4 * targets * width * height);
    for (let i = 0; i < width * height; ++i) {
        parts.forEach((part, k) => bits.set(part.subarray(4 * i, 4 * i + 4), 4 * (targets * i + k)));
    }
    return new Float32Array(bits.buffer);
}

function answersOf(device, view, camera, grid) {
    return [false, true].map(pasted => probe(device, view, camera, {...grid, pasted}));
}

// A grid over the whole picture, with at most `count` samples along its longer side.
function gridOf(camera, count) {
    const across = camera.width * camera.side, upwards = camera.height * camera.side;
    const stride = Math.max(1, Math.ceil(Math.max(across, upwards) / count));
    const begin = Math.floor((stride - 1) / 2);
    const along = samples => Math.floor((samples - 1 - begin) / stride) + 1;
    return {first: [begin, begin], stride, width: along(across), height: along(upwards)};
}

// Of a grid of samples: how many hit the torus, and how many the pasted form sees otherwise.
function verdictsOf(device, view, camera, grid) {
    const [ours, theirs] = answersOf(device, view, camera, grid);
    let hits = 0, other = 0;
    for (let i = 0; i < ours.length; i += 4 * targets) {
        hits += ours[i + 8];
        other += ours[i + 8] !== theirs[i + 8] ? 1 : 0;
    }
    return {samples: grid.width * grid.height, hits, other};
}

// The bits of TORUS_CHECK_SUMS, _PRODUCTS and _HIGHP: what the exact tier needs.
const checkNeeded = 7;

function selfCheck(device) {
    const gl = device.gl;
    const frame = integerTargets(gl, 1, 1, 1);
    gl.viewport(0, 0, 1, 1);
    device.use("check", "exact")("one", "1f", 1);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const [bits] = frame.read();
    frame.free();
    return (bits[0] & checkNeeded) === checkNeeded;
}
