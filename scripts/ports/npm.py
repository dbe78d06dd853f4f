# SPDX-License-Identifier: MIT
"""The package raytorus for npm: shader text as strings of a module. scripts/dist puts the files beside it."""
from __future__ import annotations

import json

# The strings of the module, and their files.
STRINGS = {
    "raytorus": "raytorus.glsl",
    "raytorusMin": "raytorus.min.glsl",
    "raytorusFast": "raytorus_fast.glsl",
    "raytorusWgsl": "raytorus.wgsl",
    "raytorusFastWgsl": "raytorus_fast.wgsl",
}


# The module's name among what scripts/dist has made.
MODULE = "npm/index.js"


def module(texts: dict[str, str]) -> str:
    """The strings. texts: what scripts/dist has written, by name."""
    return "// SPDX-License-Identifier: MIT\n" + "".join(
        f"export const {name} = {json.dumps(texts[file], ensure_ascii=False)};\n" for name, file in STRINGS.items())
