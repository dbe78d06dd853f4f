# SPDX-License-Identifier: MIT
"""Who runs a port: each gives a function from a torus and rays to answers, 26 floats a ray."""
from __future__ import annotations

import base64
import html
import importlib
import json
import os
import re
import subprocess
import tempfile
from array import array
from collections.abc import Callable
from pathlib import Path

import kernels
from answers import RAY, ROW, native

Answer = Callable[[tuple[float, float], array], array]
# Rays of a picture side by side, where a ray is a pixel.
WIDTH = 128


class Unavailable(Exception):
    """What is not here, and where it comes from."""


def webgpu(module: str, code: str, what: str) -> tuple[Answer, str]:
    """WGSL, or GLSL by naga's front end, in a compute shader. `what` names the adapter's driver."""
    try:
        wgpu = importlib.import_module(module)
    except ImportError as error:
        raise Unavailable(f"the Python package {module}") from error
    adapters = [a for a in wgpu.gpu.enumerate_adapters_sync() if a.info["backend_type"] == "Vulkan"]
    adapter = next((a for a in adapters if what in a.info["device"] + a.info["description"]), None)
    if adapter is None:
        raise Unavailable(f"a Vulkan driver called {what} for {module}")
    device = adapter.request_device_sync()
    label = {"label": "comp"} if code.startswith("#version") else {}
    shader = device.create_shader_module(code=code, **label)
    pipeline = device.create_compute_pipeline(layout="auto", compute={"module": shader, "entry_point": "main"})
    storage = wgpu.BufferUsage.STORAGE

    def answer(torus, rays):
        count = len(rays) // RAY
        rows = device.create_buffer(size=4 * ROW * count, usage=storage | wgpu.BufferUsage.COPY_SRC)
        buffers = [device.create_buffer_with_data(data=rays.tobytes(), usage=storage), rows,
                   device.create_buffer_with_data(data=array("f", torus).tobytes(), usage=storage)]
        entries = [{"binding": i, "resource": {"buffer": buffer}} for i, buffer in enumerate(buffers)]
        group = device.create_bind_group(layout=pipeline.get_bind_group_layout(0), entries=entries)
        encoder = device.create_command_encoder()
        work = encoder.begin_compute_pass()
        work.set_pipeline(pipeline)
        work.set_bind_group(0, group)
        work.dispatch_workgroups((count + 63) // 64)
        work.end()
        device.queue.submit([encoder.finish()])
        return array("f", bytes(device.queue.read_buffer(rows)))

    return answer, adapter.info["description"] or adapter.info["device"]


def opengl():
    """A context of OpenGL without a window, which takes GLSL ES, too."""
    try:
        moderngl = importlib.import_module("moderngl")
    except ImportError as error:
        raise Unavailable("the Python package moderngl") from error
    return moderngl.create_standalone_context(backend="egl")


def opengl_compute(code: str) -> tuple[Answer, str]:
    context = opengl()
    shader = context.compute_shader(code)

    def answer(torus, rays):
        count = len(rays) // RAY
        rows = context.buffer(reserve=4 * ROW * count)
        for i, buffer in enumerate((context.buffer(rays.tobytes()), rows, context.buffer(array("f", torus).tobytes()))):
            buffer.bind_to_storage_buffer(i)
        shader.run((count + 63) // 64)
        return array("f", rows.read())

    return answer, context.info["GL_RENDERER"]


def from_targets(targets: list[array], count: int) -> array:
    """Rows of what a fragment shader has written into its targets."""
    rows = array("f")
    for i in range(count):
        row = array("f")
        for target in targets:
            row.extend(target[4 * i:4 * i + 4])
        rows.extend(row[:ROW])
    return rows


def opengl_fragment(version: str, code: str) -> tuple[Answer, str]:
    context = opengl()
    program = context.program(vertex_shader=f"#version {version}\n{kernels.GLSL_VERTEX}", fragment_shader=code)
    triangle = context.vertex_array(program, [])

    def answer(torus, rays):
        count = len(rays) // RAY
        height = count // WIDTH
        assert height * WIDTH == count, f"rays in multiples of {WIDTH}"
        context.texture((2 * WIDTH, height), 4, rays.tobytes(), dtype="f4").use(0)
        program["rays"] = 0
        program["radii"] = torus
        targets = [context.texture((WIDTH, height), 4, dtype="f4") for _ in range(7)]
        frame = context.framebuffer(targets)
        frame.use()
        triangle.render(vertices=3)
        return from_targets([array("f", target.read()) for target in targets], count)

    return answer, context.info["GL_RENDERER"]


def cxx(header: str, *options: str) -> tuple[Answer, str]:
    """C++ by the system's compiler."""
    built = Path(tempfile.mkdtemp(prefix="raytorus-port-"))
    (built / "raytorus.hpp").write_text(header)
    (built / "port.cpp").write_text(kernels.CXX_PROGRAM)
    command = ["c++", "-std=c++11", "-I.", *options, "port.cpp", "-o", "port"]
    subprocess.run(command, cwd=built, check=True)
    version = subprocess.run(["c++", "--version"], capture_output=True, text=True, check=True).stdout.split("\n")[0]

    def answer(torus, rays):
        done = subprocess.run([built / "port", *(f"{radius!r}" for radius in torus)], input=rays.tobytes(),
                              capture_output=True, check=True)
        return array("f", done.stdout)

    return answer, version


def vulkan(program: str, module: bytes, *device: str) -> tuple[Answer, str]:
    """A SPIR-V module that asks as shaders/trace.comp does, by `raytorus trace`."""
    folder = Path(tempfile.mkdtemp(prefix="raytorus-port-"))
    (folder / "trace.comp.spv").write_bytes(module)

    def answer(torus, rays):
        return native(program, torus, rays, "--shaders", str(folder), *device)

    return answer, " ".join(device[1:]) or "the default device"


def run_compiler(command: list[str], code: str, suffix: str, **environment) -> bytes:
    """SPIR-V from a compiler whose command has {in} and {out}."""
    with tempfile.TemporaryDirectory(prefix="raytorus-port-") as name:
        source, module = Path(name) / f"port{suffix}", Path(name) / "port.spv"
        source.write_text(code)
        filled = [part.format(**{"in": source, "out": module}) for part in command]
        try:
            done = subprocess.run(filled, capture_output=True, text=True, env={**os.environ, **environment}, check=False)
        except FileNotFoundError as error:
            raise Unavailable(command[0]) from error
        if done.returncode or not module.exists():
            raise RuntimeError(f"{' '.join(filled)}: {done.stdout}{done.stderr}")
        return module.read_bytes()


PAGE = """<!doctype html>
<pre id="answers">nothing yet</pre>
<script>
const work = WORK;
const toBytes = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));
const toText = bytes => { let s = ""; for (const b of bytes) s += String.fromCharCode(b); return btoa(s); };
function run() {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl) return {error: "no WebGL 2"};
    if (!gl.getExtension("EXT_color_buffer_float")) return {error: "no EXT_color_buffer_float"};
    const program = gl.createProgram();
    for (const [kind, code] of [[gl.VERTEX_SHADER, work.vertex], [gl.FRAGMENT_SHADER, work.fragment]]) {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, code);
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) return {error: gl.getShaderInfoLog(shader)};
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return {error: gl.getProgramInfoLog(program)};
    gl.useProgram(program);
    const debug = gl.getExtension("WEBGL_debug_renderer_info");
    const rows = [];
    for (const {torus, rays} of work.sets) {
        const values = new Float32Array(toBytes(rays).buffer), height = values.length / 8 / work.width;
        const texture = (width, data) => {
            const made = gl.createTexture();
            gl.bindTexture(gl.TEXTURE_2D, made);
            gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, data);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
            return made;
        };
        const frame = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
        const attachments = [];
        for (let i = 0; i < 7; ++i) {
            attachments.push(gl.COLOR_ATTACHMENT0 + i);
            gl.framebufferTexture2D(gl.FRAMEBUFFER, attachments[i], gl.TEXTURE_2D, texture(work.width, null), 0);
        }
        gl.drawBuffers(attachments);
        gl.bindTexture(gl.TEXTURE_2D, texture(2 * work.width, values));
        gl.uniform2f(gl.getUniformLocation(program, "radii"), torus[0], torus[1]);
        gl.viewport(0, 0, work.width, height);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        const targets = attachments.map(attachment => {
            gl.readBuffer(attachment);
            const read = new Float32Array(4 * work.width * height);
            gl.readPixels(0, 0, work.width, height, gl.RGBA, gl.FLOAT, read);
            return toText(new Uint8Array(read.buffer));
        });
        if (gl.getError()) return {error: "a GL error"};
        rows.push(targets);
    }
    return {rows, renderer: gl.getParameter(debug ? debug.UNMASKED_RENDERER_WEBGL : gl.RENDERER)};
}
let result;
try { result = run(); } catch (error) { result = {error: String(error)}; }
document.getElementById("answers").textContent = JSON.stringify(result);
</script>
"""


def webgl(code: str, back_end: tuple[str, ...], sets: list[tuple[tuple[float, float], array]]) -> tuple[list[array], str]:
    """GLSL ES 3.00 in Chromium, without a window: the answers to all sets, from one page."""
    work = {"vertex": f"#version 300 es\n{kernels.GLSL_VERTEX}", "fragment": code, "width": WIDTH,
            "sets": [{"torus": torus, "rays": base64.b64encode(rays.tobytes()).decode()} for torus, rays in sets]}
    with tempfile.TemporaryDirectory(prefix="raytorus-webgl-") as folder:
        page = Path(folder) / "page.html"
        page.write_text(PAGE.replace("WORK", json.dumps(work).replace("</", "<\\/"), 1))
        command = ["chromium", "--headless", "--no-sandbox", "--disable-gpu-sandbox", f"--user-data-dir={folder}/profile",
                   "--virtual-time-budget=600000", "--timeout=600000", *back_end, "--dump-dom", page.as_uri()]
        try:
            said = subprocess.run(command, capture_output=True, text=True, timeout=600, check=True).stdout
        except FileNotFoundError as error:
            raise Unavailable("the Debian package chromium") from error
    found = re.search(r'<pre id="answers">(.*?)</pre>', said, re.DOTALL)
    result = json.loads(html.unescape(found[1]))
    if "error" in result:
        raise RuntimeError(f"WebGL 2: {result['error']}")
    rows = []
    for (_, rays), targets in zip(sets, result["rows"]):
        rows.append(from_targets([array("f", base64.b64decode(text)) for text in targets], len(rays) // RAY))
    return rows, result["renderer"]
