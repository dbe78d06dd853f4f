// SPDX-License-Identifier: MIT
// WebGL 2: programs, and what the page's shaders are made of. Nothing here knows a control.
class ShaderError extends Error {}

function compile(gl, kind, code) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, code);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
        throw new ShaderError(gl.getShaderInfoLog(shader) || "The shader compiler failed without a word.");
    }
    return shader;
}

function link(gl, fragment) {
    const program = gl.createProgram();
    for (const [kind, code] of [[gl.VERTEX_SHADER, sources["page.vert"]], [gl.FRAGMENT_SHADER, fragment]]) {
        const shader = compile(gl, kind, code);
        gl.attachShader(program, shader);
        gl.deleteShader(shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
        throw new ShaderError(gl.getProgramInfoLog(program) || "The shaders did not link.");
    }
    return program;
}

function fragmentOf(tier, files, define = "") {
    const fast = tier === "fast" ? "#define TORUS_FAST\n" : "";
    return `#version 300 es\n${fast}${define}${[library, ...files.map(name => sources[name])].join("\n")}`;
}

const fragments = {
    view: tier => fragmentOf(tier, ["pasted.glsl", "rays.glsl", "shade.glsl", "view.frag"]),
    probe: tier => fragmentOf(tier, ["pasted.glsl", "rays.glsl", "probe.frag"]),
    library: tier => fragmentOf(tier, ["pasted.glsl", "rays.glsl", "cost.frag"], "#define COST_OF libraryAnswer\n"),
    pasted: tier => fragmentOf(tier, ["pasted.glsl", "rays.glsl", "cost.frag"], "#define COST_OF pastedAnswer\n"),
    check: tier => fragmentOf(tier, ["check.frag"]),
};

class Device {
    constructor(gl) {
        this.gl = gl;
        this.restore();
    }

    // All that a lost context takes along is made again when it is next asked for.
    restore() {
        this.programs = new Map();
        this.rows = null;
        this.camera = null;
        this.timer = this.gl.getExtension("EXT_disjoint_timer_query_webgl2");
    }

    // A program, in use, with a way to set its uniforms.
    use(name, tier) {
        const gl = this.gl, key = `${name} ${tier}`;
        if (!this.programs.has(key)) {
            this.programs.set(key, {program: link(gl, fragments[name](tier)), places: new Map()});
        }
        const {program, places} = this.programs.get(key);
        gl.useProgram(program);
        return (uniform, kind, ...values) => {
            if (!places.has(uniform)) places.set(uniform, gl.getUniformLocation(program, uniform));
            gl[`uniform${kind}`](places.get(uniform), ...values);
        };
    }

    // The rays of a camera, for the program in use. Rows go to the device when the camera is another.
    setRays(set, view, camera) {
        const gl = this.gl;
        if (this.camera !== camera) {
            this.camera = camera;
            this.rows ??= gl.createTexture();
            gl.bindTexture(gl.TEXTURE_2D, this.rows);
            gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 1, camera.height * camera.side, 0, gl.RGBA, gl.FLOAT, camera.rows);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        }
        gl.bindTexture(gl.TEXTURE_2D, this.rows);
        set("torus.majorRadius", "1f", 1);
        set("torus.minorRadius", "1f", view.ratio);
        set("eye", "3f", ...camera.eye);
        set("columns", "2f", ...camera.columns);
        set("rows", "1i", 0);
        set("zero", "1ui", 0);
    }

    drawView(view, camera) {
        const gl = this.gl;
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.viewport(0, 0, camera.width, camera.height);
        const set = this.use("view", view.tier);
        this.setRays(set, view, camera);
        set("size", "2i", camera.width, camera.height);
        set("side", "1i", camera.side);
        set("wipe", "1f", Math.round(view.wipe * camera.width));
        set("turn", "1f", view.turn * Math.PI / 180);
        set("pixel", "1f", camera.pixel);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
    }
}
