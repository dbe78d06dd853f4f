# SPDX-License-Identifier: MIT
"""Chromium without a window, led by its own protocol over two pipes: pages as people see, click and type them."""
from __future__ import annotations

import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

# WebGL 2 by each driver that a machine without a GPU has.
BACK_ENDS = {
    "SwiftShader": ("--use-angle=swiftshader", "--enable-unsafe-swiftshader"),
    "llvmpipe": ("--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"),
}
TIMEOUT = 120.0


class Browser:
    """One tab. `with Browser(flags) as browser`."""

    def __init__(self, *flags: str):
        self.profile = tempfile.mkdtemp(prefix="raytorus-web-")
        to_read, self.to = os.pipe()
        self.come, from_write = os.pipe()
        # Chromium reads commands from descriptor 3 and answers on 4.
        self.process = subprocess.Popen(
            ["bash", "-c", 'exec "$@" 3<&"$0" 4>&"$RAYTORUS_ANSWERS"', str(to_read), "chromium", "--headless", "--no-sandbox",
             "--disable-gpu-sandbox", f"--user-data-dir={self.profile}", "--remote-debugging-pipe", "--no-first-run",
             "--hide-scrollbars", *flags, "about:blank"],
            env={**os.environ, "RAYTORUS_ANSWERS": str(from_write)}, pass_fds=(to_read, from_write),
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_read)
        os.close(from_write)
        self.buffer = b""
        self.number = 0
        self.events: list[dict] = []
        self.session = None
        page = next(t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=page["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(f"{domain}.enable")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self.to)
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.come)
        shutil.rmtree(self.profile, ignore_errors=True)

    def receive(self, until: float) -> dict:
        while b"\0" not in self.buffer:
            if not select.select([self.come], [], [], max(until - time.monotonic(), 0))[0]:
                raise TimeoutError("Chromium does not answer")
            part = os.read(self.come, 1 << 20)
            if not part:
                raise RuntimeError("Chromium has ended (is the Debian package chromium installed?)")
            self.buffer += part
        text, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(text)

    def call(self, method: str, **arguments) -> dict:
        self.number += 1
        message = {"id": self.number, "method": method, "params": arguments}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to, json.dumps(message).encode() + b"\0")
        until = time.monotonic() + TIMEOUT
        while (answer := self.receive(until)).get("id") != self.number:
            self.events.append(answer)
        if "error" in answer:
            raise RuntimeError(f"{method}: {answer['error']['message']}")
        return answer["result"]

    def evaluate(self, code: str):
        result = self.call("Runtime.evaluate", expression=code, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(str(result["exceptionDetails"]["exception"].get("description")))
        return result["result"].get("value")

    def wait(self, code: str):
        """Until an expression is true; its value."""
        until = time.monotonic() + TIMEOUT
        while not (value := self.evaluate(code)):
            if time.monotonic() > until:
                raise TimeoutError(f"never true: {code}")
            time.sleep(0.05)
        return value

    def open(self, address: str, width: int = 1280, height: int = 800, scale: float = 1.0, touch: bool = False):
        self.events.clear()
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale, mobile=touch)
        self.call("Emulation.setTouchEmulationEnabled", enabled=touch)
        self.call("Page.navigate", url=address)
        self.wait(f"location.href.startsWith({json.dumps(address)}) && document.readyState === 'complete'")

    def screenshot(self, path: Path) -> bytes:
        png = base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])
        path.write_bytes(png)
        return png

    def key(self, key: str, shift: bool = False):
        text = {"text": key} if len(key) == 1 else {"Enter": {"text": "\r"}}.get(key, {})
        codes = {"Tab": 9, "Enter": 13, " ": 32, "Home": 36, "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40}
        fields = {"key": key, "code": "Space" if key == " " else key, "windowsVirtualKeyCode": codes.get(key, ord(key[0])),
                  "modifiers": 8 if shift else 0}
        self.call("Input.dispatchKeyEvent", type="keyDown", **fields, **text)
        self.call("Input.dispatchKeyEvent", type="keyUp", **fields)

    def drag(self, *places: tuple[float, float]):
        """The pointer goes down at the first place, by the others, and up at the last."""
        for kind, (x, y) in [("mousePressed", places[0]), *(("mouseMoved", p) for p in places[1:]), ("mouseReleased", places[-1])]:
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=int(kind != "mouseReleased"), clickCount=1)

    def touches(self, *steps: list[tuple[float, float]]):
        """Fingers: where they are at each step, then away."""
        for kind, step in [("touchStart", steps[0]), *(("touchMove", s) for s in steps[1:]), ("touchEnd", [])]:
            self.call("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(step)])

    def said(self) -> list[str]:
        """Errors that the browser or the page reported."""
        entries = [e["params"]["entry"] for e in self.events if e.get("method") == "Log.entryAdded"]
        thrown = [e["params"]["exceptionDetails"] for e in self.events if e.get("method") == "Runtime.exceptionThrown"]
        return [e["text"] for e in entries if e["level"] == "error"] + [t.get("exception", {}).get("description", t["text"]) for t in thrown]

    def requests(self) -> list[str]:
        """Where the page asked for anything."""
        return [e["params"]["request"]["url"] for e in self.events if e.get("method") == "Network.requestWillBeSent"]
