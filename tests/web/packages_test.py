#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The package for npm among others: three.js, Babylon.js, Vite, TypeScript. scripts/try_packages installs them and runs this.

python3 tests/web/packages_test.py <folder of dist> <folder with node_modules>
"""
from __future__ import annotations

import base64
import functools
import http.server
import json
import re
import shutil
import subprocess
import sys
import threading
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
here = Path(__file__).resolve().parent
sys.path.insert(0, str(here.parent / "support"))
from browser import BACK_ENDS, Browser  # noqa: E402

dist, site = (Path(sys.argv.pop(1)).resolve() for _ in range(2))


def documented_example() -> str:
    """The first code below the heading three.js of docs/portability.md."""
    text = (here.parents[1] / "docs/portability.md").read_text()
    return re.search(r"^## three\.js\n.*?^```js\n(.*?)^```", text, re.MULTILINE | re.DOTALL)[1] + "export {torus};\n"


def run(*command: str):
    done = subprocess.run(command, cwd=site, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"{' '.join(command)}: {done.stdout}{done.stderr}")


def copied_shader(browser: Browser) -> str:
    browser.open(f"{(dist / 'web/index.html').as_uri()}?still&size=64x64&selftest=4&distance=2000&elevation=30")
    return json.loads(browser.wait("document.getElementById('selftest').textContent"))["glsl"]


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def drawn(browser: Browser) -> dict:
    """What the built page says, from a server of our own: modules are not loaded from files."""
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=site / "dist"))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        browser.open(f"http://127.0.0.1:{server.server_address[1]}/")
        return json.loads(browser.wait("window.result"))
    finally:
        server.shutdown()
        server.server_close()


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        for file in (here / "packages").iterdir():
            shutil.copy(file, site / file.name)
        with Browser(*BACK_ENDS["SwiftShader"]) as browser:
            (site / "shader.js").write_text(f"export const shader = {json.dumps(copied_shader(browser))};\n")
            (site / "documented.js").write_text(documented_example())
            run("npx", "--offline", "vite", "build")
            cls.result = drawn(browser)
        assert "error" not in cls.result, cls.result["error"]

    def picture(self, name: str) -> bytes:
        return base64.b64decode(self.result[name])

    def test_the_picture_is_the_same_everywhere(self):
        plain = self.picture("plain")
        self.assertGreater(len(set(plain)), 100)
        for name in ("imported", "three", "babylon"):
            self.assertEqual(plain, self.picture(name), name)

    def test_the_documented_example_is_the_torus(self):
        example, mesh = self.picture("example"), self.picture("mesh")
        pixels = range(0, len(mesh), 4)
        self.assertGreater(sum(mesh[i + 3] for i in pixels), 0.2 * 255 * len(pixels))
        off = [max(abs(a - b) for a, b in zip(example[i:i + 4], mesh[i:i + 4])) for i in pixels]
        # Edges, where the mesh has corners.
        self.assertLess(sum(x > 2 for x in off), len(off) // 200)

    def test_a_loader_of_shader_files_finds_the_files(self):
        text = (dist / "npm/raytorus.min.glsl").read_text()
        # This one drops comments and empty lines.
        self.assertEqual(re.sub(r"//[^\n]*\n", "", text).split(), self.result["fromFile"].split())

    def test_the_types_hold(self):
        for resolution in ("bundler", "nodenext"):
            module = "esnext" if resolution == "bundler" else "nodenext"
            run("npx", "--offline", "tsc", "--noEmit", "--strict", "--module", module, "--moduleResolution", resolution, "types.ts")


if __name__ == "__main__":
    unittest.main()
