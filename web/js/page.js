// SPDX-License-Identifier: MIT
// The page: draws when something changed, and while the paint turns; measures when all is at rest for a moment.
const restBefore = 400;           // ms without a change, before costs are measured
const degreesASecond = 12;
const verdictSamples = 192;       // along the longer side

class Page {
    constructor(canvas, gl, query) {
        this.canvas = canvas;
        this.query = query;
        this.view = viewOf(query);
        this.device = new Device(gl);
        this.frames = [];
        this.fixed = (query.get("size") ?? "").match(/^(\d+)x(\d+)$/)?.slice(1).map(Number);
    }

    changed() {
        this.camera = null;
        showPanel(this.view);
        this.showMark();
        this.later();
        clearTimeout(this.resting);
        this.resting = setTimeout(() => this.guarded(() => this.rest()), restBefore);
    }

    reset() {
        const {tier, samples, turning} = this.view;
        this.view = {...initial, tier, samples, turning};
        this.changed();
    }

    later() {
        this.waiting ??= requestAnimationFrame(time => {
            this.waiting = null;
            this.guarded(() => this.frame(time));
        });
    }

    // What shaders' compilers say is shown. Between the loss of a context and its return nothing is done.
    guarded(work) {
        if (this.device.gl.isContextLost() || this.failed) return;
        const failed = error => {
            this.failed = true;
            showFailure(error instanceof ShaderError ? "A shader does not compile here." : "The page has failed.",
                        error instanceof ShaderError ? error.message : String(error.stack ?? error));
        };
        try {
            work()?.catch?.(failed);
        } catch (error) {
            failed(error);
        }
    }

    // The picture has as many pixels as its place on the screen.
    fit() {
        const box = this.canvas.getBoundingClientRect();
        const [width, height] = this.fixed ?? [box.width, box.height].map(x => Math.max(1, Math.round(x * devicePixelRatio)));
        if (this.canvas.width !== width || this.canvas.height !== height) {
            this.canvas.width = width;
            this.canvas.height = height;
            this.camera = null;
        }
    }

    prepare() {
        this.fit();
        this.camera ??= cameraOf(this.view, this.canvas.width, this.canvas.height);
    }

    frame(time) {
        const since = Math.min(time - (this.drawn ?? time), 100);
        this.drawn = time;
        if (this.view.turning) this.view.turn = (this.view.turn + since * degreesASecond / 1000) % 360;
        this.prepare();
        this.device.drawView(this.view, this.camera);
        this.count(time);
        if (this.view.turning) this.later();
    }

    // Frames of the last second.
    count(time) {
        this.frames.push(time);
        this.frames = this.frames.filter(other => time - other < 1000);
        const enough = this.view.turning && this.frames.length > 1;
        const rate = 1000 * (this.frames.length - 1) / (time - this.frames[0]);
        element("frames").textContent = enough ? `${rate < 10 ? rate.toFixed(1) : Math.round(rate)} frames a second` : "drawn once";
    }

    // Measures, and notes the view in the address.
    async rest() {
        history.replaceState(null, "", `#${addressOf(this.view)}`);
        this.prepare();
        showVerdicts(verdictsOf(this.device, this.view, this.camera, gridOf(this.camera, verdictSamples)));
        element("kept").textContent = selfCheck(this.device)
            ? "This device keeps every rounding that the exact tier rests on."
            : "This device does not keep the roundings that the exact tier rests on: its last bits are not to be trusted.";
        const costs = await costsOf(this.device, this.view, this.camera);
        if (costs) showCosts(costs);
    }

    // place: pixels from the middle, upwards.
    pick(place) {
        this.guarded(() => {
            this.prepare();
            const {width, height, side} = this.camera;
            const at = [Math.floor(place[0] + width / 2), Math.floor(place[1] + height / 2)];
            if (at[0] < 0 || at[1] < 0 || at[0] >= width || at[1] >= height) return;
            const grid = {first: at.map(x => x * side), stride: 1, width: 1, height: 1};
            const [ours, theirs] = answersOf(this.device, this.view, this.camera, grid);
            this.picked = {place};
            showPicked({ours, theirs});
            this.showMark();
        });
    }

    // A small cross where the ray was picked.
    showMark() {
        const mark = element("mark");
        mark.hidden = !this.picked;
        if (!this.picked) return;
        const box = this.canvas.getBoundingClientRect(), scale = box.width / this.canvas.width;
        mark.style.left = `${box.width / 2 + this.picked.place[0] * scale}px`;
        mark.style.top = `${box.height / 2 - this.picked.place[1] * scale}px`;
    }

    begin() {
        bindPanel(this);
        this.hand = new Hand(this.canvas, this);
        this.canvas.addEventListener("webglcontextlost", event => event.preventDefault());
        this.canvas.addEventListener("webglcontextrestored", () => {
            this.device.restore();
            this.changed();
        });
        new ResizeObserver(() => this.changed()).observe(this.canvas);
        this.changed();
    }
}
