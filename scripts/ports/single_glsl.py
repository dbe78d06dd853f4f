# SPDX-License-Identifier: MIT
"""The library as a single file of GLSL, for every version from 3.30 and ES 3.00: full, and stripped."""
from __future__ import annotations

import re

from . import glsl
from .seal import Seals
from .splice import Splice, Types, is_public, sealing_functions

ERROR = re.compile(r"#ifdef TORUS_NO_PRECISE\n#error[^\n]*\n#endif\n")
# What stands in its place. The sizes of a float's bits are those of a finite number unless the ray is none.
SEALS = """#ifdef TORUS_NO_PRECISE
#define TORUS_PRECISE
#define TORUS_ROUNDED
#define TORUS_SEALED(x) uintBitsToFloat(floatBitsToUint(x) ^ zero)
#else
#define TORUS_SEALED(x) (x)
#endif
// A sum or product that is rounded as it stands. Without `precise`, the exclusive or with a zero that no compiler can know
// forbids what `precise` does. The fast tier needs that in one place alone.
#ifdef TORUS_FAST
#define TORUS_R(x) (x)
#else
#define TORUS_R(x) TORUS_SEALED(x)
#endif
"""
ZERO = """// 0, but 1 if a number is infinite or NaN, of which no hit comes: so no compiler knows that it is 0.
uint torus_zero(vec3 v, vec3 w) {
    float x = max(abs(v.x), abs(w.x));
    float y = max(abs(v.y), abs(w.y));
    float z = max(abs(v.z), abs(w.z));
    return (0x7f7fffffu - floatBitsToUint(max(max(x, y), z))) >> 31u;
}

"""
NEEDS = re.compile(r"// Needs GLSL 4\.60.*?\n(?=#define)", re.DOTALL)
HEAD = """// Made of the folder shaders/torus by scripts/dist: to include or to paste, in GLSL from 3.30 and GLSL ES from 3.00. Where
// the language has no `precise`, or with `#define TORUS_NO_PRECISE` before it, the bits are the same without.
"""


def full(flat: str) -> str:
    """Readable, with all comments."""
    tree = glsl.parse(flat)
    Types(tree)
    seals = Seals(sealing_functions(tree), "TORUS_R", "TORUS_SEALED", "uint zero",
                  "uint zero = torus_zero({});")
    text = Splice(flat, seals.rules()).write(tree)
    text, count = ERROR.subn(lambda _: SEALS, text)
    assert count == 1, "the folder's #error for a language without `precise`"
    text = text.replace("// 1 / x for a power of two", ZERO + "// 1 / x for a power of two", 1)
    text, count = NEEDS.subn(lambda _: HEAD, text)
    assert count == 1, "the folder's sentence about GLSL 4.60"
    text = re.sub(r"^#ifndef TORUS_GLSL\n#define TORUS_GLSL\n", "", text, flags=re.MULTILINE)
    text = text.replace("#define TORUS_VERSION_MAJOR", "#ifndef TORUS_GLSL\n#define TORUS_GLSL\n\n#define TORUS_VERSION_MAJOR", 1)
    return "// SPDX-License-Identifier: MIT\n" + "\n".join(wrap(line) for line in text.splitlines()) + "\n\n#endif\n"


WIDTH = 120


def wrap(line: str) -> str:
    """Breaks a line of code that is too long behind its outermost comma or operator."""
    if len(line) <= WIDTH or "//" in line or line.startswith("#"):
        return line
    depth, places = 0, []
    for at, sign in enumerate(line[:WIDTH]):
        depth += (sign in "([") - (sign in ")]")
        if sign == " " and at > len(line) - len(line.lstrip()) and line[at - 1] in "=,+-*/?:&|(<>":
            places.append((depth, -at))
    if not places:
        return line
    at = -min(places)[1]
    indent = " " * (len(line) - len(line.lstrip()) + 4)
    return line[:at] + "\n" + wrap(indent + line[at + 1:])


# Names that stay: what users call, members that they read, and what GLSL knows.
PUBLIC_MEMBERS = ("majorRadius", "minorRadius", "t", "position")
COMPONENTS = {"x": 0, "y": 1, "z": 2}


def short_names():
    """t_a, t_b, ... t_aa: a prefix that no macro of a user has."""
    letters = "abcdefghijklmnopqrstuvwxyz"
    for first in ["", *letters]:
        for second in letters:
            yield f"t_{first}{second}"


class Stripped:
    """Rules that give each local name, parameter and private member a short name with a prefix, and components an index."""

    def __init__(self, tree: glsl.Node):
        self.names: dict[str, str] = {}
        names = short_names()
        public = {node.text for node in tree.walk() if node.kind == "functionName" and is_public(node.text)}
        for node in tree.walk():
            kept = node.text.startswith("TORUS_") or node.text in public
            if node.kind in ("name", "memberName") and not kept:
                self.names.setdefault(node.text, "")
        for name in [*sorted(self.names), "zero"]:
            self.names[name] = next(names)

    def rules(self) -> dict:
        return {"name": self.name, "memberName": self.member, "access": self.access}

    def name(self, _splice: Splice, node: glsl.Node) -> str:
        return self.names.get(node.text, node.text)

    def member(self, _splice: Splice, node: glsl.Node) -> str:
        return node.text if node.text in PUBLIC_MEMBERS else self.names.get(node.text, node.text)

    def access(self, splice: Splice, node: glsl.Node) -> str:
        of, member = node.children
        if of.type in ("vec2", "vec3", "uvec3") and member.text in COMPONENTS:
            return f"{splice.write(of)}[{COMPONENTS[member.text]}]"
        return f"{splice.write(of)}.{splice.write(member)}"


def stripped(text: str) -> str:
    """A full file without comments and indentation, and with names that no macro of a user touches."""
    head = re.match(r"(// SPDX[^\n]*\n)", text)[1]
    text = re.sub(r"//[^\n]*", "", text)
    tree = glsl.parse(text)
    Types(tree)
    rules = Stripped(tree)
    text = Splice(text, rules.rules()).write(tree)
    text = re.sub(r"\bzero\b", rules.names["zero"], text)
    lines: list[str] = []
    for line in text.splitlines():
        line = line.strip()
        if line.startswith("#"):
            lines.append(re.sub(r"\s+", " ", line))
        elif line:
            line = re.sub(r"\s*([-+*/%<>=!&|^?:;,.(){}\[\]])\s*", r"\1", line)
            joined = lines and not lines[-1].startswith("#") and len(lines[-1]) < WIDTH
            if joined:
                glue = " " if re.match(r"\w", line) and re.search(r"\w$", lines[-1]) else ""
                lines[-1] += glue + line
            else:
                lines.append(line)
    return head + "\n".join(lines) + "\n"
