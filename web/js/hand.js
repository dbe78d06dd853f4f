// SPDX-License-Identifier: MIT
// Hands on the picture: pointer, touch, wheel and keys change the view. It says so to `changed`, and picks by `pick`.
const degreesAPixel = 0.4;
const clickLength = 5;         // pixels: a longer way is a drag
const keyTurn = 5, keyZoom = 1.15;

function orbit(view, turn, elevation) {
    view.turn = (view.turn + turn) % 360;
    view.elevation = within("elevation", view.elevation + elevation);
}

// Zooms, and what is under `place` stays there. pixel: its width; place: pixels from the middle of the picture, upwards.
function zoomAt(view, pixel, factor, place) {
    const zoom = within("zoom", view.zoom * factor);
    const kept = pixel * (1 - view.zoom / zoom);
    view.panX += place[0] * kept;
    view.panY += place[1] * kept;
    view.zoom = zoom;
}

function panBy(view, pixel, x, y) {
    view.panX -= x * pixel;
    view.panY -= y * pixel;
}

class Hand {
    constructor(canvas, page) {
        this.canvas = canvas;
        this.page = page;
        this.fingers = new Map();
        canvas.addEventListener("pointerdown", event => this.down(event));
        canvas.addEventListener("pointermove", event => this.move(event));
        canvas.addEventListener("pointerup", event => this.up(event));
        canvas.addEventListener("pointercancel", event => this.fingers.delete(event.pointerId));
        canvas.addEventListener("wheel", event => this.wheel(event), {passive: false});
        canvas.addEventListener("keydown", event => this.key(event));
        canvas.addEventListener("contextmenu", event => event.preventDefault());
    }

    // Pixels of the picture from its middle, upwards.
    place(event) {
        const box = this.canvas.getBoundingClientRect();
        const scale = this.canvas.width / box.width;
        return [(event.clientX - box.left - box.width / 2) * scale, (box.top + box.height / 2 - event.clientY) * scale];
    }

    // Not the camera's: several events may come before the next frame makes one.
    pixel() {
        return pixelOf(this.page.view, this.canvas.width, this.canvas.height);
    }

    down(event) {
        this.canvas.setPointerCapture(event.pointerId);
        this.fingers.set(event.pointerId, this.place(event));
        this.way = this.fingers.size > 1 ? Infinity : 0;
    }

    move(event) {
        const before = this.fingers.get(event.pointerId);
        if (!before) return;
        const {view} = this.page, now = this.place(event);
        const [x, y] = [now[0] - before[0], now[1] - before[1]];
        this.way += Math.hypot(x, y);
        if (this.fingers.size === 2) {
            const other = [...this.fingers].find(([id]) => id !== event.pointerId)[1];
            const spread = place => Math.max(Math.hypot(place[0] - other[0], place[1] - other[1]), 1);
            panBy(view, this.pixel(), x / 2, y / 2);
            zoomAt(view, this.pixel(), spread(now) / spread(before), [(now[0] + other[0]) / 2, (now[1] + other[1]) / 2]);
        } else if (event.shiftKey || event.buttons & 6) {
            panBy(view, this.pixel(), x, y);
        } else {
            const scale = degreesAPixel * this.canvas.clientWidth / this.canvas.width;
            orbit(view, x * scale, -y * scale);
        }
        this.fingers.set(event.pointerId, now);
        this.page.changed();
    }

    up(event) {
        const place = this.fingers.get(event.pointerId);
        this.fingers.delete(event.pointerId);
        if (place && event.button === 0 && this.way < clickLength * devicePixelRatio) this.page.pick(place);
    }

    wheel(event) {
        event.preventDefault();
        const lines = event.deltaMode === 1 ? 16 : 1;
        zoomAt(this.page.view, this.pixel(), Math.exp(-0.002 * lines * event.deltaY), this.place(event));
        this.page.changed();
    }

    key(event) {
        const {view} = this.page;
        const zoom = factor => zoomAt(view, this.pixel(), factor, [0, 0]);
        const moves = {
            ArrowLeft: () => orbit(view, -keyTurn, 0), ArrowRight: () => orbit(view, keyTurn, 0),
            ArrowUp: () => orbit(view, 0, keyTurn), ArrowDown: () => orbit(view, 0, -keyTurn),
            "+": () => zoom(keyZoom), "=": () => zoom(keyZoom), "-": () => zoom(1 / keyZoom), Home: () => this.page.reset(),
        };
        const steps = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
        if (event.key === "Enter") {
            this.page.pick(this.page.picked?.place ?? [0, 0]);
        } else if (event.shiftKey && steps[event.key]) {
            const [x, y] = this.page.picked?.place ?? [0, 0];
            this.page.pick([x + steps[event.key][0], y + steps[event.key][1]]);
        } else if (moves[event.key]) {
            moves[event.key]();
            this.page.changed();
        } else {
            return;
        }
        event.preventDefault();
    }
}

// The line between the two methods, and its grip.
function holdWipe(grip, canvas, set) {
    grip.addEventListener("pointerdown", event => grip.setPointerCapture(event.pointerId));
    grip.addEventListener("pointermove", event => {
        if (!grip.hasPointerCapture(event.pointerId)) return;
        const box = canvas.getBoundingClientRect();
        set((event.clientX - box.left) / box.width);
    });
}
