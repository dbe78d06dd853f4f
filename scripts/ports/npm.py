# SPDX-License-Identifier: MIT
"""The package raytorus for npm: shader text as files and as strings of a module."""
from __future__ import annotations

import json
import re
from pathlib import Path

# The strings of the module, and their files.
STRINGS = {
    "raytorus": "raytorus.glsl",
    "raytorusMin": "raytorus.min.glsl",
    "raytorusFast": "raytorus_fast.glsl",
    "raytorusWgsl": "raytorus.wgsl",
    "raytorusFastWgsl": "raytorus_fast.wgsl",
}


def version(root: Path) -> str:
    return re.search(r"^project\(raytorus VERSION (\S+)", (root / "CMakeLists.txt").read_text(), re.MULTILINE)[1]


def package(root: Path, texts: dict[str, str]) -> dict[str, str]:
    """The package's files by name. texts: what scripts/dist has written, by name."""
    files = {file.name: file.read_text() for file in sorted((root / "packaging/npm").iterdir())}
    files["package.json"] = files["package.json"].replace("@VERSION@", version(root))
    files["LICENSE"] = (root / "LICENSE").read_text()
    files["index.js"] = "// SPDX-License-Identifier: MIT\n" + "".join(
        f"export const {name} = {json.dumps(texts[file], ensure_ascii=False)};\n" for name, file in STRINGS.items())
    return files | {file: texts[file] for file in STRINGS.values()}
