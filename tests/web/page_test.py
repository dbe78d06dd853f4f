#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The page in WebGL 2, in Chromium without a window.

python3 tests/web/page_test.py <folder of dist> <program raytorus> <folder for pictures> [argument of unittest...]
"""
from __future__ import annotations

import base64
import json
import math
import re
import struct
import subprocess
import sys
import tempfile
import unittest
from array import array
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from browser import BACK_ENDS, Browser  # noqa: E402

dist, program, pictures = (Path(sys.argv.pop(1)).resolve() for _ in range(3))
page = dist / "web/index.html"
ROW, RAY, HIT = 16, 8, 8
# A ring, a wire, a horn, a spindle; from near and as far as the slider goes.
VIEWS = [f"ratio={ratio}&distance={distance}&elevation={elevation}" for ratio, distance, elevation in (
    (0.35, 4, 32), (0.001, 1e4, 75), (0.001, 1e6, 20), (1, 100, 5), (1.5, 3, 60), (1.5, 1e6, -40), (0.35, 1e6, 32), (0.05, 1e4, -90))]
SHADERTOY = """#version 300 es
precision highp float;
uniform vec3 iResolution;
uniform float iTime;
uniform vec4 iMouse;
out vec4 shown;
void mainImage(out vec4 color, in vec2 place);
void main() { mainImage(shown, gl_FragCoord.xy); }
"""


def address(query: str, path: Path = page) -> str:
    return f"{path.as_uri()}?still&{query}"


def floats(text: str) -> array:
    return array("f", base64.b64decode(text))


def selftest(browser: Browser, query: str, samples: int = 48) -> dict:
    browser.open(address(f"size=320x240&{query}&selftest={samples}"))
    ready = "true" if "lose" not in query else "JSON.parse(text).restored"
    result = json.loads(browser.wait(f"(text => text && {ready} ? text : '')(document.getElementById('selftest').textContent)"))
    return result | {"ours": floats(result["ours"]), "pasted": floats(result["pasted"])}


def traced(radii: list[float], rows: array) -> array:
    """What the program answers to the rays of rows."""
    with tempfile.TemporaryDirectory() as name:
        rays = array("f")
        for i in range(0, len(rows), ROW):
            rays.extend(rows[i:i + RAY])
        (Path(name) / "rays.bin").write_bytes(rays.tobytes())
        subprocess.run([program, "trace", "rays.bin", "-o", "hits.bin", "--torus", f"{radii[0]!r},{radii[1]!r}"], cwd=name, check=True)
        return array("f", (Path(name) / "hits.bin").read_bytes())


def hits_of(rows: array) -> array:
    return array("f", [x for i in range(0, len(rows), ROW) for x in rows[i + RAY:i + ROW]])


def other_rows(one: array, two: array) -> int:
    """Of two lists of hits: rows with another bit."""
    a, b = one.tobytes(), two.tobytes()
    assert len(a) == len(b)
    return sum(a[i:i + 4 * HIT] != b[i:i + 4 * HIT] for i in range(0, len(a), 4 * HIT))


class Answers:
    """On one back end."""
    back_end = ""

    @classmethod
    def setUpClass(cls):
        cls.browser = Browser(*BACK_ENDS[cls.back_end])

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()

    def test_the_exact_tier_has_no_other_bit_than_the_program(self):
        for view in VIEWS:
            with self.subTest(view):
                found = selftest(self.browser, view)
                self.assertIn(self.back_end, found["renderer"])
                self.assertTrue(found["kept"])
                self.assertEqual(0, found["error"])
                hits = hits_of(found["ours"])
                self.assertGreater(sum(hits[::HIT]), 0)
                self.assertEqual(0, other_rows(hits, traced(found["radii"], found["ours"])))
        self.assertEqual([], self.browser.said())

    def test_the_fast_tier_has_the_same_verdicts_but_at_edges(self):
        for view, bound in ((VIEWS[0], 4e-6 * 1.35), (VIEWS[6], math.inf)):
            exact, fast = (hits_of(selftest(self.browser, f"{view}&tier={tier}")["ours"]) for tier in ("exact", "fast"))
            rows = range(0, len(exact), HIT)
            self.assertGreater(other_rows(exact, fast), 0, "the tier is switched")
            self.assertLessEqual(sum(exact[i] != fast[i] for i in rows), len(rows) // 500)
            off = sorted(max(abs(exact[i + k] - fast[i + k]) for k in (2, 3, 4)) for i in rows if exact[i] == fast[i] == 1)
            self.assertLess(off[len(off) * 98 // 100], bound)

    def test_the_pasted_form_is_right_near_and_wrong_from_afar(self):
        near = selftest(self.browser, "distance=4")["verdicts"]
        self.assertLessEqual(near["other"], near["samples"] // 200)
        for distance, part in ((1e3, 0.05), (1e4, 0.1), (1e6, 0.1)):
            far = selftest(self.browser, f"distance={distance}")
            program_hits = traced(far["radii"], far["ours"])[::HIT]
            pasted_hits = hits_of(far["pasted"])[::HIT]
            self.assertEqual(far["verdicts"]["other"], sum(a != b for a, b in zip(program_hits, pasted_hits)))
            self.assertGreater(far["verdicts"]["other"], part * far["verdicts"]["samples"])

    def test_a_lost_context_comes_back_with_the_same_answers(self):
        before, after = (selftest(self.browser, f"distance=50{lose}") for lose in ("", "&lose"))
        self.assertTrue(after["restored"])
        self.assertEqual(before["ours"].tobytes(), after["ours"].tobytes())

    def test_a_picked_ray_is_a_line_for_the_program(self):
        self.browser.open(address("distance=20000&ratio=0.2&pick=-60,-90"))
        line = self.browser.wait("document.getElementById('ray-line').textContent")
        with tempfile.TemporaryDirectory() as name:
            (Path(name) / "rays.csv").write_text(line + "\n")
            subprocess.run([program, "trace", "rays.csv", "-o", "hits.bin", "--torus", "1,0.2"], cwd=name, check=True)
            hit = array("f", (Path(name) / "hits.bin").read_bytes())
        shown = [self.browser.evaluate(f"document.getElementById('{what}-library').textContent") for what in ("t", "position", "normal")]
        values = [float(x) for x in " ".join(shown).replace("−", "-").split()]
        self.assertEqual(1, hit[0])
        self.assertEqual([float(f"{x:.7g}") for x in hit[1:]], values)


class SwiftShader(Answers, unittest.TestCase):
    back_end = "SwiftShader"


class Llvmpipe(Answers, unittest.TestCase):
    back_end = "llvmpipe"


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser(*BACK_ENDS["llvmpipe"])

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()

    def changed_page(self, old: str, new: str) -> Path:
        """The page with another text in it, and no policy that forbids that."""
        text = page.read_text()
        self.assertIn(old, text)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = Path(folder.name) / "index.html"
        path.write_text(re.sub(r"<meta http-equiv[^\n]*\n", "", text).replace(old, new))
        return path

    def text(self, name: str) -> str:
        return self.browser.evaluate(f"document.getElementById('{name}').textContent")

    def view(self) -> dict[str, str]:
        """What the address says of the view, when the page has come to rest."""
        code = """new Promise(resolve => setTimeout(() => resolve(
            Object.fromEntries(new URLSearchParams(location.hash.slice(1)))), 900))"""
        return {name: float(value) if name != "tier" else value for name, value in self.browser.evaluate(code).items()}

    def test_rays_stand_where_their_pixels_are_from_a_million_radii(self):
        found = selftest(self.browser, "distance=1e6&elevation=33", 240)
        rows, pixel, width = found["ours"], found["pixel"], found["width"]
        stride = -(-320 // 240)
        offsets = []
        for i in range(0, len(rows), ROW * width):
            x, _, z, _, dx, _, dz, _ = rows[i:i + RAY]
            offsets.append((x * dz - z * dx) / math.hypot(dx, dz))
        for one, two in zip(offsets, offsets[1:]):
            self.assertLess(abs(abs(two - one) / (stride * pixel) - 1), 0.2)

    def test_nothing_leaves_the_page(self):
        text = page.read_text()
        self.assertEqual([], re.findall(r"""https?://|(?:src|href)=["'](?!data:)|url\(|@import|\bfetch\(|XMLHttpRequest|WebSocket""", text))
        self.assertIn("default-src 'none'", text)
        self.browser.open(address(""))
        self.browser.wait("document.getElementById('cost-how').textContent")
        self.assertEqual([address("")], self.browser.requests())
        self.assertEqual([], self.browser.said())

    def test_the_policy_admits_no_other_script(self):
        text = page.read_text()
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "index.html"
            path.write_text(text.replace("main();\n", "main() ;\n"))
            self.browser.open(path.as_uri())
            self.assertIn("Content Security Policy", " ".join(self.browser.said()))

    def test_what_a_shader_compiler_says_is_shown(self):
        path = self.changed_page("vec3 shadePaint(float R", "vec3 shadePaint(floot R")
        self.browser.open(path.as_uri())
        self.browser.wait("!document.getElementById('failure').hidden")
        self.assertEqual("A shader does not compile here.", self.text("failure-sentence"))
        self.assertIn("floot", self.text("failure-detail"))

    def test_without_webgl_a_sentence(self):
        with Browser("--disable-3d-apis") as browser:
            browser.open(address(""))
            self.assertEqual("This page needs WebGL 2, which this browser does not have or does not lend.",
                             browser.evaluate("document.getElementById('failure-sentence').innerText"))
            self.assertEqual([], browser.said())

    def test_every_control_is_reached_by_the_keyboard(self):
        self.browser.open(address("pick=0,0"))
        reached = []
        for _ in range(20):
            self.browser.key("Tab")
            reached.append(self.browser.evaluate("document.activeElement.name || document.activeElement.id"))
        wanted = ["picture", "ratio", "distance", "wipe", "tier", "samples", "turning", "ray-line", "copy-ray", "copy-shadertoy", "copy-glsl",
                  "reset"]
        self.assertEqual(wanted, [name for name in dict.fromkeys(reached) if name and name != "panel"])

    def test_keys_turn_zoom_pick_and_switch(self):
        self.browser.open(address("elevation=10"))
        self.browser.evaluate("document.getElementById('picture').focus()")
        for key in ("ArrowUp", "ArrowUp", "ArrowRight", "+"):
            self.browser.key(key)
        self.assertEqual({"elevation": 20, "turn": 5, "zoom": 1.15}, self.view())
        self.browser.key("Enter")
        first = self.text("ray-line")
        self.browser.key("ArrowUp", shift=True)
        self.assertNotEqual(first, self.text("ray-line"))
        self.browser.key("Home")
        self.assertEqual({}, self.view())
        self.browser.evaluate("document.querySelector('input[name=tier]').focus()")
        self.browser.key("ArrowRight")
        self.assertEqual({"tier": "fast"}, self.view())

    def test_pointer_turns_wipes_and_picks(self):
        self.browser.open(address("elevation=10&wipe=0.5"))
        self.browser.drag((200, 300), (250, 340), (300, 350))
        self.assertEqual({"elevation": 30, "turn": 40}, self.view())
        middle = self.browser.evaluate("document.getElementById('picture').clientWidth / 2")
        self.browser.drag((middle, 600), (300, 600), (middle / 2, 600))
        self.assertEqual({"elevation": 30, "turn": 40, "wipe": 0.25}, self.view())
        self.browser.drag((middle, 500), (middle, 500))
        self.assertRegex(self.text("ray-line"), r"^([-.\de]+,){7}1000000000$")
        self.assertFalse(self.browser.evaluate("document.getElementById('mark').hidden"))

    def test_two_fingers_zoom_where_they_are(self):
        self.browser.open(address(""), 360, 640, 2.0, touch=True)
        self.browser.touches([(100, 100), (140, 100)], [(80, 100), (160, 100)])
        view = self.view()
        self.assertEqual(2, view["zoom"])
        self.assertLess(view["panX"], 0)
        self.assertGreater(view["panY"], 0)

    def test_it_fits_a_phone_and_a_desktop(self):
        for width, height, scale in ((360, 640, 2.0), (1280, 800, 1.0)):
            self.browser.open(address("pick=60,60"), width, height, scale, touch=scale > 1)
            self.browser.wait("document.getElementById('cost-how').textContent")
            self.assertTrue(self.browser.evaluate("""document.documentElement.scrollWidth <= innerWidth &&
                [...document.querySelectorAll('#panel *')].every(e => e.getBoundingClientRect().right <= innerWidth + 0.5)"""))
            drawn, shown = self.browser.evaluate("(c => [[c.width, c.height], [c.clientWidth, c.clientHeight]])(document.getElementById('picture'))")
            self.assertTrue(all(abs(a - scale * b) <= 1 for a, b in zip(drawn, shown)), f"{drawn} {shown}")
            pictures.mkdir(parents=True, exist_ok=True)
            png = self.browser.screenshot(pictures / f"page-{width}x{height}.png")
            self.assertEqual((width * scale, height * scale), struct.unpack(">II", png[16:24]))

    def test_costs_are_shown_beside_each_other(self):
        self.browser.open(address(""))
        self.browser.wait("document.getElementById('cost-how').textContent")
        for method in ("library", "pasted"):
            self.assertRegex(self.text(f"cost-{method}"), r"^[\d.]+ ns$")
        self.browser.evaluate("document.getElementById('turning').click()")
        self.browser.wait("document.getElementById('frames').textContent.includes('frames a second')")

    def test_copied_shaders_are_complete(self):
        for query in ("", "tier=fast&ratio=1&distance=1e6&panX=0.5"):
            found = selftest(self.browser, query, 4)
            for name, code in (("glsl", found["glsl"]), ("shadertoy", SHADERTOY + found["shadertoy"])):
                done = subprocess.run(["glslangValidator", "--stdin", "-S", "frag"], input=code, capture_output=True, text=True, check=False)
                self.assertEqual(0, done.returncode, f"{name}: {done.stdout}")
                self.assertEqual(query != "", "#define TORUS_FAST" in code)


if __name__ == "__main__":
    unittest.main()
