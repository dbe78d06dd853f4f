# SPDX-License-Identifier: MIT
"""A tree written back: its text, but for what a language says otherwise, and with roundings that are sealed."""
from __future__ import annotations

import re
from collections.abc import Callable

from .glsl import Node

SIZED = {"vec2": 2, "vec3": 3, "vec4": 4}
SAME_AS_FIRST = ("TORUS_R", "TORUS_SEALED", "sqrt", "abs", "min", "max", "clamp", "floor", "fma", "roundEven")


def literal_type(text: str) -> str:
    """Of a number or a truth value."""
    if text in ("true", "false"):
        return "bool"
    if text.endswith("u"):
        return "uint"
    return "float" if re.match(r"\d*\.\d|\d+\.?\d*[eE]", text) else "int"


class Types:
    """The types of all names of a file, and of its expressions."""

    def __init__(self, file: Node):
        self.members: dict[str, dict[str, str]] = {}
        self.results: dict[str, str] = {}
        self.constants: dict[str, str] = {}
        for node in file.children:
            if node.kind == "struct":
                self.members[node.text] = {m.text: m.children[0].text for m in node.children if m.kind == "member"}
            elif node.kind == "function":
                self.results[node.text] = node.children[0].text
            elif node.kind == "directive":
                self.constant(node.text)
        for node in file.children:
            if node.kind == "function":
                self.function(node)

    def constant(self, directive: str):
        define = re.match(r"#define (\w+) +(.+)", directive)
        if define and "(" not in define[1]:
            value = define[2].strip()
            known = "float" if "uintBitsToFloat" in value else literal_type(value.lstrip("-"))
            self.constants[define[1]] = known

    def function(self, function: Node):
        names = dict(self.constants)
        for node in function.walk():
            if node.kind in ("parameter", "declaration"):
                kind = node.child("type").text
                names[node.child("name").text] = kind
        self.settle(function, names)

    def settle(self, node: Node, names: dict[str, str]):
        """Types from the leaves up."""
        for child in node.children:
            self.settle(child, names)
        if node.kind == "name":
            node.type = names.get(node.text, "")
        elif node.kind in ("number", "truth"):
            node.type = literal_type(node.text)
        elif node.kind in ("parentheses", "unary"):
            node.type = node.children[0].type
        elif node.kind == "choice":
            node.type = node.children[1].type
        elif node.kind == "constructor":
            node.type = node.text
        elif node.kind == "index":
            node.type = "float" if node.children[0].type in SIZED else node.children[0].type
        elif node.kind == "access":
            of = node.children[0].type
            node.type = "float" if of in SIZED else self.members.get(of, {}).get(node.children[1].text, "")
        elif node.kind == "call":
            node.type = self.call(node)
        elif node.kind == "binary":
            left, right = node.children[0].type, node.children[1].type
            if node.text in ("<", ">", "<=", ">=", "==", "!=", "&&", "||"):
                node.type = "bool"
            else:
                node.type = right if right in SIZED else left

    def call(self, node: Node) -> str:
        first = node.children[1].type if len(node.children) > 1 else ""
        if node.text in SAME_AS_FIRST:
            return first
        if node.text == "floatBitsToUint":
            return "uint"
        if node.text == "uintBitsToFloat":
            return "float"
        return self.results.get(node.text, "")


Rule = Callable[["Splice", Node], str]


class Splice:
    """Writes a tree. `rules` say what stands for a kind of node; where none does, its own text does, with its parts."""

    def __init__(self, text: str, rules: dict[str, Rule]):
        self.text = text
        self.rules = rules

    def write(self, node: Node) -> str:
        rule = self.rules.get(node.kind)
        return rule(self, node) if rule else self.plain(node)

    def plain(self, node: Node) -> str:
        """The node's own text around its parts."""
        if not node.children:
            return self.text[node.start:node.end]
        return self.between(node, node.start, node.end)

    def between(self, node: Node, start: int, end: int) -> str:
        """The text from start to end, with those of the node's parts that lie there."""
        written, at = [], start
        for child in node.children:
            if child.start < start or child.end > end:
                continue
            written += [self.text[at:child.start], self.write(child)]
            at = child.end
        return "".join(written) + self.text[at:end]


def is_power_of_two(node: Node) -> bool:
    """A factor that rounds nothing, whatever it is moved to."""
    if node.kind == "unary" and node.text == "-":
        return is_power_of_two(node.children[0])
    if node.kind != "number" or node.type != "float":
        return False
    value = float(node.text)
    mantissa = value.hex().split("p")[0] if value else ""
    return mantissa == "0x1.0000000000000"


def rounds(node: Node) -> bool:
    """Whether an operation has to round as it stands: no compiler may join it with another."""
    if node.kind != "binary" or node.text not in ("+", "-", "*", "/") or node.type not in ("float", *SIZED):
        return False
    return not (node.text == "*" and any(is_power_of_two(child) for child in node.children))


def sealing_functions(file: Node) -> set[str]:
    """The functions with an operation that rounds, or that call one that has one."""
    calls, sealing = {}, set()
    for function in (node for node in file.children if node.kind == "function"):
        calls.setdefault(function.text, set()).update(node.text for node in function.walk() if node.kind == "call")
        if any(rounds(node) for node in function.walk()):
            sealing.add(function.text)
    while True:
        more = {name for name, called in calls.items() if called & sealing} - sealing
        if not more:
            return sealing
        sealing |= more


def is_public(name: str) -> bool:
    """torusNormal, not torus_turn."""
    return re.match(r"torus[A-Z]", name) is not None
