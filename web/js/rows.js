// SPDX-License-Identifier: MIT
// Rays of a picture, in double. From 10^6 R a float32 direction of length 1 has steps of 0.06 R on the torus. But a direction
// may have any length, and each length rounds otherwise: a row takes the first that is sharp enough, or the best of many.
const lengths = 512;
const goldenRatio = 0.6180339887498949;
const sharpness = 1 / 16;      // of a sample

// The x and z of a direction along (x, z), both float32; and the length that came of it.
function roundedDirection(x, z, tolerance) {
    const square = x * x + z * z;
    let best = [0, 0, 0], least = Infinity;
    for (let i = 0; i < lengths && least > tolerance; ++i) {
        const length = 1 + (i * goldenRatio) % 1;
        const nearX = Math.fround(length * x), nearZ = Math.fround(length * z);
        const off = Math.abs(nearX * z - nearZ * x) / length;
        if (off < least) {
            least = off;
            best = [nearX, nearZ, (nearX * x + nearZ * z) / square];
        }
    }
    return best;
}

// Half of what is seen along the shorter side, in R at the centre; and the width of a pixel there.
function extentOf(view) {
    return 1.2 * (1 + view.ratio) / view.zoom;
}

function pixelOf(view, width, height) {
    return 2 * extentOf(view) / Math.min(width, height);
}

// Eye, columns and rows of samples for a picture of width and height pixels. The eye is in the plane y = 0.
function cameraOf(view, width, height) {
    const side = view.samples;
    const elevation = view.elevation * Math.PI / 180;
    const eye = [Math.fround(view.distance * Math.cos(elevation)), 0, Math.fround(view.distance * Math.sin(elevation))];
    const distance = Math.hypot(eye[0], eye[2]);
    const up = [-eye[2] / distance, eye[0] / distance];
    const pixel = pixelOf(view, width, height), sample = pixel / side;
    const rows = new Float32Array(4 * height * side);
    for (let j = 0; j < height * side; ++j) {
        const place = view.panY + (j + 0.5 - height * side / 2) * sample;
        const [x, z, length] = roundedDirection((place * up[0] - eye[0]) / distance, (place * up[1] - eye[2]) / distance,
                                                sharpness * sample / distance);
        rows.set([x, z, length / distance, 0], 4 * j);
    }
    return {width, height, side, eye, pixel, rows, columns: [view.panX + (0.5 - width * side / 2) * sample, sample]};
}
