#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds the library in other languages to the program's own answers: the same rays, bit by bit.

A row is a language, a compiler or driver, and a tier. The exact tier must have no other bit in any row. The fast tier
may: compilers are free there. What a row needs and is not here is said, and the exit code is 1.

examples:
  scripts/prove_ports                       quick rows
  scripts/prove_ports --all                 with DXC and Slang, which take 160 MB from PyPI
  scripts/prove_ports --only wgsl --rays 16384
  scripts/prove_ports --broken              the exact tier with its seals taken off: what they are for
"""
from __future__ import annotations

import argparse
import json
import os
import re
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
import kernels  # noqa: E402
import rays as ray_sets  # noqa: E402
import runners  # noqa: E402
from answers import Difference, native  # noqa: E402
from browser import BACK_ENDS  # noqa: E402

root = Path(__file__).resolve().parents[2]
TIERS = {"exact": "", "fast": "#define TORUS_FAST\n"}
# What seals a number, in each language: with --broken, the number stands there alone.
SEALED = re.compile(r"(?:uintBitsToFloat|asfloat)\((?:floatBitsToUint|asuint)\(x\) \^ \w+\)"
                    r"|bitcast<f32>\(bitcast<u32>\(x\) \^ zero\)|bitcast<vec3<f32>>\(bitcast<vec3<u32>>\(x\) \^ vec3<u32>\(zero\)\)")


@dataclass
class Row:
    """What is proved: `make` gives the answers and says who gave them."""
    language: str
    by: str
    tier: str
    make: Callable[[], tuple[runners.Answer, str]]
    needs: str = ""       # the group of --only
    nearest: bool = False  # it answers with the nearest hit alone
    valid: bool = False   # only rays that are rays: with fast math, compilers take it that there is no NaN


class Ports:
    """The files of dist/, and what is made of them."""

    def __init__(self, folder: Path, broken: bool):
        self.folder = folder
        self.broken = broken

    def text(self, name: str) -> str:
        text = (self.folder / name).read_text()
        if self.broken:
            text, count = SEALED.subn("(x)", text)
            assert count, f"{name} has no seals"
        return text

    def glsl(self, version: str, tier: str, kernel: str, name: str = "raytorus.glsl", before: str = "") -> str:
        return f"#version {version}\n{TIERS[tier]}{before}{self.text(name)}{kernel}"


def opengl_rows(ports: Ports, tier: str) -> Iterator[Row]:
    for version in ("430", "450", "310 es", "320 es"):
        for before in ("", "#define TORUS_NO_PRECISE\n"):
            language = f"GLSL {version}" + (" without precise" if before else "")
            yield Row(language, "OpenGL, compute", tier, lambda v=version, b=before: runners.opengl_compute(
                ports.glsl(v, tier, kernels.GLSL_COMPUTE, before=b)), "opengl")
    for version in ("330", "400", "300 es", "320 es"):
        for name in ("raytorus.glsl", "raytorus.min.glsl"):
            yield Row(f"GLSL {version}, {name}", "OpenGL, fragment", tier, lambda v=version, n=name: runners.opengl_fragment(
                v, ports.glsl(v, tier, kernels.GLSL_FRAGMENT, n)), "opengl")


def webgpu_rows(ports: Ports, tier: str) -> Iterator[Row]:
    name = "raytorus_fast.wgsl" if tier == "fast" else "raytorus.wgsl"
    code = ports.text(name) + kernels.WGSL_COMPUTE
    bound = kernels.GLSL_COMPUTE.replace("layout(std430, binding", "layout(std430, set = 0, binding")
    for module, driver, by in (("wgpu", "llvmpipe", "wgpu, naga"), ("wgpudawn", "SwiftShader", "Dawn, tint"),
                               ("wgpu", "SwiftShader", "wgpu, naga")):
        yield Row("WGSL", by, tier, lambda m=module, d=driver: runners.webgpu(m, code, d), "webgpu")
    for name in ("raytorus.glsl", "raytorus.min.glsl"):
        yield Row(f"GLSL 450, {name}", "wgpu, naga", tier, lambda n=name: runners.webgpu(
            "wgpu", ports.glsl("450", tier, bound, n), "llvmpipe"), "webgpu")


def webgl_rows(ports: Ports, tier: str, sets: list) -> Iterator[Row]:
    def make(name, flags):
        rows, who = runners.webgl(ports.glsl("300 es", tier, kernels.GLSL_FRAGMENT, name), flags, sets)
        answered = iter(rows)
        return lambda _torus, _rays: next(answered), who

    for driver, flags in BACK_ENDS.items():
        for name in ("raytorus.glsl", "raytorus.min.glsl"):
            yield Row(f"GLSL 300 es, {name}", f"WebGL 2, {driver}", tier, lambda n=name, f=flags: make(n, f), "webgl")


def on_vulkan(program: str, driver: str, compiler: list[str], code: Callable[[], str], suffix: str = ".comp", **environment):
    """A maker of answers: a compiler's SPIR-V on a driver."""
    return lambda: runners.vulkan(program, runners.run_compiler(compiler, code(), suffix, **environment), "--device", driver)


GLSLANG = ["glslangValidator", "-V", "--quiet", "-o", "{out}", "{in}"]


def vulkan_rows(ports: Ports, tier: str, program: str) -> Iterator[Row]:
    for driver in ("llvmpipe", "SwiftShader"):
        for name in ("raytorus.glsl", "raytorus.min.glsl"):
            for before in ("", "#define TORUS_NO_PRECISE\n"):
                language = f"GLSL 450{' without precise' if before else ''}, {name}"
                yield Row(language, "Vulkan, glslang", tier, on_vulkan(program, driver, GLSLANG, lambda n=name, b=before: ports.glsl(
                    "450", tier, kernels.GLSL_TRACE, n, b)), "vulkan")


def fast_function_rows(ports: Ports, program: str) -> Iterator[Row]:
    code = "#version 450\n" + (ports.folder / "raytorus_fast.glsl").read_text() + kernels.FAST_FUNCTION_TRACE
    for driver in ("llvmpipe", "SwiftShader"):
        yield Row("GLSL 450, raytorus_fast.glsl", "Vulkan, glslang", "fast", on_vulkan(program, driver, GLSLANG, lambda: code),
                  "vulkan", nearest=True)


def cxx_rows(ports: Ports, tier: str) -> Iterator[Row]:
    for options in (["-O0"], ["-O2"], ["-O2", "-mfma", "-ffp-contract=fast"], ["-O3", "-ffast-math"],
                    ["-O3", "-ffast-math", "-mfma"]):
        define = ["-DTORUS_FAST"] if tier == "fast" else []
        yield Row("C++", "g++ " + " ".join(options), tier, lambda o=options: runners.cxx(
            ports.text("raytorus.hpp"), *o, *define), "cxx", valid="-ffast-math" in options)


def slow_rows(ports: Ports, tier: str, program: str, tools: Path) -> Iterator[Row]:
    slang = [str(tools / "slangc"), "-lang", "glsl", "-stage", "compute", "-entry", "main", "-target", "spirv", "-o", "{out}", "{in}"]
    dxc = [str(tools / "dxc"), str(tools / "libdxcompiler.so"), "{in}", "{out}", "-T", "cs_6_0", "-E", "main", "-spirv", "-O3"]
    yield Row("GLSL 450", "Slang, Vulkan", tier, on_vulkan(program, "llvmpipe", slang, lambda: ports.glsl(
        "450", tier, kernels.GLSL_TRACE), LD_LIBRARY_PATH=str(tools)), "slang")
    for before in ("", "#define TORUS_NO_PRECISE\n"):
        yield Row("HLSL" + (" without precise" if before else ""), "DXC, Vulkan", tier, on_vulkan(program, "llvmpipe", dxc, lambda b=before: (
            TIERS[tier] + b + ports.text("raytorus.hlsl") + kernels.HLSL_TRACE), ".hlsl"), "dxc")


def prove(row: Row, sets: dict, size: Callable) -> dict:
    """A row of the table: what differs, or why it could not be run."""
    found = {"language": row.language, "by": row.by, "tier": row.tier}
    begin = time.monotonic()
    try:
        answer, who = row.make()
        difference = Difference()
        for torus, rays, expected in sets[row.tier, row.valid]:
            difference.add(expected, answer(torus, rays), size(torus), row.nearest)
        found |= {"driver": who, **asdict(difference)}
    except runners.Unavailable as missing:
        found["fault"] = f"missing: {missing}"
    except Exception as error:  # pylint: disable=broad-exception-caught
        found["fault"] = f"{type(error).__name__}: {error}"
    found["seconds"] = round(time.monotonic() - begin, 1)
    return found


def holds(found: dict) -> bool:
    return "fault" not in found and (found["tier"] == "fast" or found["other_bits"] == 0)


def line(found: dict) -> str:
    head = f"{found['language']:36} {found['by']:30} {found['tier']:5}"
    if "fault" in found:
        return f"{head}  {found['fault']}"
    return (f"{head}  {found['rays']:9} {found['missed']:7} {found['false']:6} {found['miscounted']:8} {found['other_bits']:10} "
            f"{found['position']:9.2g}  {found['driver'][:60]}")


def main() -> int:
    parser = argparse.ArgumentParser(prog="scripts/prove_ports", description=__doc__, allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(root / "build/dev/bin/raytorus"), help="raytorus, who is right")
    parser.add_argument("--dist", type=Path, default=root / "dist", help="what scripts/dist has written")
    parser.add_argument("--tools", type=Path, default=root / "build/ports", help="where dxc and slangc are")
    parser.add_argument("--rays", type=int, default=2048, help="for each of five tori, in multiples of 128 (2048)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--tier", choices=("exact", "fast"), help="this one alone")
    parser.add_argument("--only", action="append", help="opengl, webgpu, webgl, vulkan, cxx, slang or dxc")
    parser.add_argument("--all", action="store_true", help="DXC and Slang, too")
    parser.add_argument("--broken", action="store_true", help="the exact tier without its seals; exit code 0 if it shows")
    parser.add_argument("--json", action="store_true")
    arguments = parser.parse_args()
    for needed, maker in ((Path(arguments.program), "the build"), (arguments.dist / "raytorus.glsl", "scripts/dist")):
        if not needed.exists():
            parser.error(f"{needed} is not there; {maker} makes it")
    arguments.program = str(Path(arguments.program).resolve())
    arguments.tools = arguments.tools.resolve()
    if arguments.rays % runners.WIDTH or arguments.rays <= 0:
        parser.error(f"--rays {arguments.rays}: a multiple of {runners.WIDTH}")
    ports = Ports(arguments.dist, arguments.broken)
    tiers = ["exact"] if arguments.broken else [arguments.tier] if arguments.tier else ["exact", "fast"]
    methods = {"exact": [], "fast": ["--method", "raytorus-fast"]}
    sets = {}
    for tier in tiers:
        for valid in (False, True):
            sets[tier, valid] = [(torus, rays, native(arguments.program, torus, rays, *methods[tier]))
                                 for torus in ray_sets.TORI
                                 for rays in [ray_sets.rays(arguments.seed, arguments.rays, torus, valid)]]
    rows = []
    for tier in tiers:
        bare = [(torus, rays) for torus, rays, _ in sets[tier, False]]
        rows += [*vulkan_rows(ports, tier, arguments.program), *opengl_rows(ports, tier), *webgpu_rows(ports, tier),
                 *webgl_rows(ports, tier, bare), *cxx_rows(ports, tier)]
        if arguments.all or {"slang", "dxc"} & set(arguments.only or ()):
            rows += slow_rows(ports, tier, arguments.program, arguments.tools)
    if "fast" in tiers:
        rows += fast_function_rows(ports, arguments.program)
    rows = [row for row in rows if not arguments.only or row.needs in arguments.only]
    if arguments.broken:
        # Where there is `precise`, the seals are not used.
        rows = [row for row in rows if "without precise" in row.language or row.needs in ("webgpu", "webgl", "cxx", "slang")
                or "330" in row.language or "300 es" in row.language]
    found = []
    if not arguments.json:
        print(f"{'language':36} {'by':30} {'tier':5} {'rays':>9} {'missed':>7} {'false':>6} {'miscount':>8} {'other bits':>10} "
              f"{'position':>9}  driver")
    for row in rows:
        found.append(prove(row, sets, sum))
        if not arguments.json:
            print(line(found[-1]), flush=True)
    if arguments.json:
        print(json.dumps(found, indent=1))
    if arguments.broken:
        return 0 if any(f.get("other_bits") for f in found) else 1
    failed = [f for f in found if not holds(f)]
    if not arguments.json:
        print(f"{len(found) - len(failed)} of {len(found)} rows hold")
    return 1 if failed else 0


if __name__ == "__main__":
    os.environ.setdefault("XDG_RUNTIME_DIR", "/tmp")
    try:
        sys.exit(main())
    except subprocess.CalledProcessError as error:
        print(f"scripts/prove_ports: {error.cmd[0]} failed with exit code {error.returncode}", file=sys.stderr)
        sys.exit(1)
