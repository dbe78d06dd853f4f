// SPDX-License-Identifier: MIT
// The controls: each shows the view, and changes it.
const element = id => document.getElementById(id);

// Sliders of what spans powers of ten are logarithmic.
const sliders = {
    ratio: {to: Math.log10, from: x => 10 ** x, shown: rounded},
    distance: {to: Math.log10, from: x => 10 ** x, shown: x => `${rounded(x)} R`},
    wipe: {to: x => 100 * x, from: x => x / 100, shown: x => `${Math.round(100 * x)} %`},
};

function bindPanel(page) {
    for (const [name, {to, from}] of Object.entries(sliders)) {
        const input = element(name);
        [input.min, input.max] = limits[name].map(to);
        input.addEventListener("input", () => {
            // The slider's own steps are coarser than three digits need.
            page.view[name] = within(name, Number(from(Number(input.value)).toPrecision(3)));
            page.changed();
        });
    }
    for (const input of document.querySelectorAll("input[name=tier], input[name=samples]")) {
        input.addEventListener("change", () => {
            page.view[input.name] = input.name === "samples" ? Number(input.value) : input.value;
            page.changed();
        });
    }
    element("turning").addEventListener("change", event => {
        page.view.turning = event.target.checked;
        page.changed();
    });
    element("reset").addEventListener("click", () => page.reset());
    holdWipe(element("grip"), element("picture"), place => {
        page.view.wipe = within("wipe", place);
        page.changed();
    });
    bindCopies(page);
}

function showPanel(view) {
    for (const [name, {to, shown}] of Object.entries(sliders)) {
        const input = element(name), text = shown(view[name]);
        input.value = to(view[name]);
        input.setAttribute("aria-valuetext", text);
        element(`${name}-shown`).textContent = text;
    }
    for (const name of ["tier", "samples"]) {
        document.querySelector(`input[name=${name}][value="${view[name]}"]`).checked = true;
    }
    element("turning").checked = view.turning;
    element("stage").style.setProperty("--wipe", view.wipe);
}

// The clipboard, or, where a browser does not lend it to a file, a field to copy from.
async function copyText(text, button) {
    const label = button.textContent;
    let copied = true;
    try {
        await navigator.clipboard.writeText(text);
    } catch {
        const field = element("copied");
        field.value = text;
        field.hidden = false;
        field.select();
        copied = document.execCommand("copy");
        field.hidden = copied;
    }
    button.textContent = copied ? "Copied" : "Select and copy";
    setTimeout(() => { button.textContent = label; }, 1200);
}

function bindCopies(page) {
    for (const kind of ["shadertoy", "glsl"]) {
        element(`copy-${kind}`).addEventListener("click", event => {
            copyText(completeShader(kind, page.view), event.target);
        });
    }
    element("copy-ray").addEventListener("click", event => copyText(element("ray-line").textContent, event.target));
}

const nanoseconds = cost => `${rounded(cost)} ns`;

function showCosts({library, pasted, byTimer}) {
    element("cost-library").textContent = nanoseconds(library);
    element("cost-pasted").textContent = nanoseconds(pasted);
    element("cost-how").textContent = byTimer
        ? "By the graphics processor's own timer."
        : "By the page's clock, over many draws: there is no timer of the graphics processor to be trusted here.";
}

function showVerdicts({samples, other}) {
    element("other-pasted").textContent = other === 0 ? "0 %" : `${rounded(100 * other / samples)} %`;
}

function showFailure(sentence, detail = "") {
    element("failure").hidden = false;
    element("failure-sentence").textContent = sentence;
    element("failure-detail").textContent = detail;
    element("failure-detail").hidden = detail === "";
}

const sevenDigits = x => String(x === 0 ? 0 : Number(x.toPrecision(7))).replace("-", "−");
const triple = values => Array.from(values, sevenDigits).join(" ");

// A row of 16: see probe.js.
function showPicked({ours, theirs}) {
    element("ray").hidden = false;
    element("ray-hint").hidden = true;
    for (const [name, row] of [["library", ours], ["pasted", theirs]]) {
        const found = row[8] === 1;
        element(`t-${name}`).textContent = found ? sevenDigits(row[9]) : "no hit";
        element(`position-${name}`).textContent = found ? triple(row.subarray(10, 13)) : "–";
        element(`normal-${name}`).textContent = found ? triple(row.subarray(13, 16)) : "–";
    }
    element("ray-line").textContent = traceLine(ours);
}
