// SPDX-License-Identifier: MIT
// Numbers as text, and the page's shaders as text for other places.

// The fewest digits that are this float32 again.
function shortest(x) {
    for (let digits = 1; digits < 9; ++digits) {
        if (Math.fround(Number(x.toPrecision(digits))) === x) return String(Number(x.toPrecision(digits)));
    }
    return String(Number(x.toPrecision(9)));
}

const exponents = "⁰¹²³⁴⁵⁶⁷⁸⁹";

// Three digits, and a power of ten where it is large.
function rounded(x) {
    if (!isFinite(x)) return "–";
    if (Math.abs(x) < 1e4) return String(Number(x.toPrecision(3)));
    const power = Math.floor(Math.log10(x) + 1e-9);
    const factor = Number((x / 10 ** power).toPrecision(2));
    const ten = `10${[...String(power)].map(digit => exponents[digit]).join("")}`;
    return factor === 1 ? ten : `${factor}·${ten}`;
}

// A line for `raytorus trace`: origin, tMin, direction, tMax.
function traceLine(row) {
    return Array.from(row.subarray(0, 8), shortest).join(",");
}

function literal(x) {
    const text = shortest(Math.fround(x));
    return /[.e]/.test(text) ? text.replace(/^(-?\d+)e/, "$1.0e") : `${text}.0`;
}

// What is seen, as a shader of its own.
function constantsOf(view) {
    return Object.entries({
        MINOR_RADIUS: view.ratio, DISTANCE: view.distance, EXTENT: extentOf(view), PAN_X: view.panX, PAN_Y: view.panY,
        ELEVATION: view.elevation * Math.PI / 180, TURN: view.turn * Math.PI / 180,
    }).map(([name, value]) => `const float ${name} = ${literal(value)};\n`).join("");
}

function completeShader(kind, view) {
    const begin = kind === "glsl" ? "#version 300 es\n" : "";
    const fast = view.tier === "fast" ? "#define TORUS_FAST\n" : "";
    const end = kind === "glsl" ? "copy_glsl.frag" : "copy_shadertoy.glsl";
    return `${begin}${fast}${library}\n${constantsOf(view)}\n` +
        ["shade.glsl", "copy_picture.glsl", end].map(name => sources[name]).join("\n");
}
