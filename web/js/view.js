// SPDX-License-Identifier: MIT
// What is seen: a torus with R = 1, from where, how large. The address gives any of it, so that a view can be shown again.
const limits = {
    ratio: [0.001, 1.5],       // r / R
    distance: [3, 1e6],        // of the eye from the centre, in R
    elevation: [-90, 90],      // degrees
    zoom: [0.2, 200],
    wipe: [0, 1],              // of the width
    samples: [1, 2],           // across a pixel
};
const initial = {
    ratio: 0.35, distance: 1000, elevation: 32, turn: 0, zoom: 1, panX: 0, panY: 0, wipe: 0.5, samples: 1,
    tier: "exact", turning: true,
};

function within(name, value) {
    const [low, high] = limits[name] ?? [-Infinity, Infinity];
    return Math.min(Math.max(value, low), high);
}

// Numbers and words of the query that are known; all others are passed over.
function viewOf(query) {
    const view = {...initial};
    for (const [name, value] of query) {
        if (typeof initial[name] === "number" && value !== "" && isFinite(value)) view[name] = within(name, Number(value));
    }
    if (query.get("tier") === "fast") view.tier = "fast";
    if (query.has("still") || matchMedia("(prefers-reduced-motion: reduce)").matches) view.turning = false;
    return view;
}

// The address of a view, behind #: what differs from the beginning.
function addressOf(view) {
    const other = Object.entries(view).filter(([name, value]) => name !== "turning" && value !== initial[name]);
    return new URLSearchParams(other.map(([name, value]) => [name, typeof value === "number" ? String(Number(value.toPrecision(9))) : value]));
}
