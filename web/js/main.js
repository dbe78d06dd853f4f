// SPDX-License-Identifier: MIT
function main() {
    const canvas = element("picture");
    const gl = canvas.getContext("webgl2", {alpha: false, antialias: false, depth: false, powerPreference: "high-performance"});
    if (!gl) return showFailure("This page needs WebGL 2, which this browser does not have or does not lend.");
    const page = new Page(canvas, gl, new URLSearchParams(`${location.search.slice(1)}&${location.hash.slice(1)}`));
    page.begin();
    const place = (page.query.get("pick") ?? "").split(",").map(Number);
    if (place.length === 2 && place.every(isFinite)) page.pick(place);
    if (page.query.has("selftest")) runSelftest(page);
}

main();
