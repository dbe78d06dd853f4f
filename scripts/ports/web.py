# SPDX-License-Identifier: MIT
"""The page in WebGL 2, as one file that needs no other: web/index.html with the styles, scripts, shaders and library in it."""
from __future__ import annotations

import base64
import hashlib
import json
from pathlib import Path

# In the order in which they stand in the page. main.js begins.
SCRIPTS = ("view", "rows", "device", "probe", "cost", "text", "hand", "panel", "page", "selftest", "main")


def literal(value) -> str:
    """A JavaScript literal that ends no script element."""
    return json.dumps(value, ensure_ascii=False).replace("<", "\\u003c")


def digest(text: str) -> str:
    """What a page's security policy says of a text, so that it admits no other."""
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def page(folder: Path, library: str) -> str:
    """folder: web; library: GLSL for ES 3.00."""
    shaders = {file.name: file.read_text() for file in sorted((folder / "shaders").iterdir())}
    scripts = "\n".join((folder / f"js/{name}.js").read_text() for name in SCRIPTS)
    script = (f'"use strict";\n(() => {{\nconst library = {literal(library)};\nconst sources = {literal(shaders)};\n'
              f"{scripts}}})();\n")
    style = (folder / "page.css").read_text()
    text = (folder / "index.html").read_text()
    for mark, value in (("@STYLE_HASH@", digest(style)), ("@SCRIPT_HASH@", digest(script)), ("@STYLE@", style), ("@SCRIPT@", script)):
        text = text.replace(mark, value, 1)
    return text
