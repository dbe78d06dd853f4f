# SPDX-License-Identifier: MIT
"""The library in WGSL, which has neither a preprocessor nor `precise`: a tier a file. In the exact tier every rounding is sealed."""
from __future__ import annotations

import math
import re
import struct

from . import glsl, source
from .c_like import BLOCK, NOTE
from .glsl import Node
from .single_glsl import wrap
from .splice import SIZED, Splice, Types

TYPES = {"float": "f32", "int": "i32", "uint": "u32", "vec2": "vec2<f32>", "vec3": "vec3<f32>", "vec4": "vec4<f32>"}
FUNCTIONS = {"floatBitsToUint": "bitcast<u32>", "uintBitsToFloat": "bitcast<f32>"}
# Words that WGSL has taken.
RENAMED = {"from": "since", "move": "motion"}
# naga_oil refuses names that end in a digit.
DIGITS = {"0": "Zero", "1": "One", "2": "Squared", "3": "Vector"}
SEALED = """// A sum or product that is rounded as it stands: the exclusive or with a zero that no compiler can know keeps it from being
// joined with another.
fn torus_sealed(x: f32, zero: u32) -> f32 {
    return bitcast<f32>(bitcast<u32>(x) ^ zero);
}

fn torus_sealedVector(x: vec3<f32>, zero: u32) -> vec3<f32> {
    return bitcast<vec3<f32>>(bitcast<vec3<u32>>(x) ^ vec3<u32>(zero));
}

"""
NOTES = """// Made of the folder shaders/torus by scripts/dist: {tier}. To WESL it is a module as it stands.
"""


def named(name: str) -> str:
    """A name without a last digit, and none that WGSL has taken."""
    name = RENAMED.get(name, name)
    return name[:-1] + DIGITS[name[-1]] if name[-1] in DIGITS else name


def type_of(name: str) -> str:
    return TYPES.get(name, name)


class Wgsl:
    """Rules for Splice."""

    def __init__(self, tree: Node, types: Types):
        self.types = types
        # Of each function the places of the arguments that it writes.
        self.written: dict[str, set[int]] = {}
        for function in (node for node in tree.children if node.kind == "function"):
            listed = function.child("parameters").children
            self.written[function.text] = {i for i, parameter in enumerate(listed) if is_output(parameter)}
        self.pointers: set[str] = set()
        self.assigned: set[str] = set()

    def rules(self) -> dict:
        return {"struct": self.structure, "member": self.member, "function": self.function, "parameter": self.parameter,
                "declaration": self.declaration, "increment": self.increment,
                "choice": self.choice, "constructor": self.constructor, "call": self.call, "name": self.name,
                "functionName": lambda _s, n: FUNCTIONS.get(n.text, named(n.text)), "type": lambda _s, n: type_of(n.text),
                "memberName": lambda _s, n: named(n.text), "directive": self.directive, "binary": self.binary,
                "hook": lambda _s, _n: "", "precision": lambda _s, _n: ""}

    def structure(self, splice: Splice, node: Node) -> str:
        return splice.plain(node)[:-1]

    def member(self, _splice: Splice, node: Node) -> str:
        return f"{named(node.text)}: {type_of(node.children[0].text)},"

    def function(self, splice: Splice, node: Node) -> str:
        listed = node.child("parameters")
        self.pointers = {p.child("name").text for p in listed.children if is_output(p)}
        self.assigned = assigned_names(node, self.written)
        by_value = {p.child("name").text for p in listed.children} - self.pointers
        assert not by_value & self.assigned, f"{node.text} writes a parameter that is handed over by value"
        result = node.children[0].text
        arrow = "" if result == "void" else f" -> {type_of(result)}"
        return f"fn {named(node.text)}{splice.write(listed)}{arrow} {splice.write(node.child('block'))}"

    def parameter(self, _splice: Splice, node: Node) -> str:
        kind, size = type_of(node.child("type").text), node.child("number")
        kind = f"array<{kind}, {size.text}>" if size else kind
        return f"{named(node.child('name').text)}: " + (f"ptr<function, {kind}>" if is_output(node) else kind)

    def declaration(self, splice: Splice, node: Node) -> str:
        name, kind, value = node.child("name").text, node.child("type").text, node.children[-1]
        word = "var" if name in self.assigned or value.kind == "name" and value.text == name else "let"
        if value is node.child("name"):
            return f"var {named(name)}: {type_of(kind)};"
        # Between the equals sign and the value there may be a line's end.
        gap = splice.text[node.child("name").end:value.start]
        return f"{word} {named(name)}: {type_of(kind)}{gap}{splice.write(value)};"

    def increment(self, splice: Splice, node: Node) -> str:
        closing = ";" if splice.text[node.start:node.end].endswith(";") else ""
        return f"{splice.write(node.children[0])} += 1{closing}"

    def choice(self, splice: Splice, node: Node) -> str:
        condition, first, second = (splice.write(child) for child in node.children)
        return f"select({second}, {first}, {condition})"

    def constructor(self, splice: Splice, node: Node) -> str:
        return f"{type_of(node.text)}({', '.join(splice.write(child) for child in node.children[1:])})"

    def call(self, splice: Splice, node: Node) -> str:
        arguments = []
        for at, child in enumerate(node.children[1:]):
            if at in self.written.get(node.text, ()):
                arguments.append(named(child.text) if child.text in self.pointers else f"&{named(child.text)}")
            else:
                arguments.append(splice.write(child))
        name = FUNCTIONS.get(node.text, named(node.text))
        if node.text in ("TORUS_R", "TORUS_SEALED"):
            name = "torus_sealedVector" if node.children[1].type in SIZED else "torus_sealed"
            arguments.append("zero")
        return f"{name}({', '.join(arguments)})"

    def name(self, _splice: Splice, node: Node) -> str:
        return f"(*{named(node.text)})" if node.text in self.pointers else named(node.text)

    def binary(self, splice: Splice, node: Node) -> str:
        """&& beside ||, and a bitwise operator beside any other, need parentheses."""
        left, right = node.children
        parts = []
        for child in (left, right):
            written = splice.write(child)
            mixed = child.kind == "binary" and (
                {child.text, node.text} == {"&&", "||"} or
                (child.text != node.text and (node.text in "&|^" or node.text in ("<<", ">>"))))
            parts.append(f"({written})" if mixed else written)
        return parts[0] + splice.text[left.end:right.start] + parts[1]

    def directive(self, splice: Splice, node: Node) -> str:
        define = re.match(r"#define (\w+) (.+)", node.text)
        if not define or "(" in define[1].split(" ")[0]:
            return ""
        value = define[2]
        bits = re.fullmatch(r"uintBitsToFloat\((0x[0-9a-f]+)u\)", value)
        if bits:
            # Exactly a product: naga has no bitcast in a constant, wesl-rs no hexadecimal float, and the largest float
            # in decimal may be rounded up.
            mantissa, exponent = math.frexp(struct.unpack("f", struct.pack("I", int(bits[1], 16)))[0])
            value = f"{2 * mantissa!r}f * {2.0 ** (exponent - 1)!r}f"
        return f"const {define[1]}: {type_of(self.types.constants[define[1]])} = {value};"


def is_output(parameter: Node) -> bool:
    return any(child.text in ("out", "inout") for child in parameter.children)


def assigned_names(function: Node, written: dict[str, set[int]]) -> set[str]:
    """What a function changes after its declaration, by itself or through a call."""
    names = set()
    for node in function.walk():
        if node.kind in ("assignment", "increment"):
            target = node.children[0]
            while target.kind in ("access", "index"):
                target = target.children[0]
            names.add(target.text)
        elif node.kind == "call":
            names |= {child.text for at, child in enumerate(node.children[1:]) if at in written.get(node.text, ())}
    return names


def translate(full: str, fast: bool) -> str:
    """One tier."""
    text, count = BLOCK.subn(lambda _: "", full)
    assert count == 1, "language.glsl's block"
    note = NOTES.format(tier="the fast tier" if fast else "the exact tier, with the same bits as in GLSL")
    text, count = NOTE.subn(lambda _: note, text)
    assert count == 1, "the head's note"
    text = source.decide(text, {"TORUS_FAST": ""} if fast else {})
    text = re.sub(r"^TORUS_ON_\w+\n", "", text, flags=re.MULTILINE)
    if fast:
        # The fast tier has its one rounding by the other name.
        text = re.sub(r"\bTORUS_R\(", "(", text)
    tree = glsl.parse(text)
    types = Types(tree)
    written = Splice(text, Wgsl(tree, types).rules()).write(tree)
    place = written.index("// 0, but 1 if a number")
    written = written[:place] + SEALED + written[place:]
    written = re.sub(r"[ \t]+$", "", written, flags=re.MULTILINE)
    written = "\n".join(wrap(line) for line in written.splitlines()) + "\n"
    return re.sub(r"\n{3,}", "\n\n", written)
