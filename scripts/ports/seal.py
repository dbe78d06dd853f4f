# SPDX-License-Identifier: MIT
"""Roundings that no compiler may join: each + - * / goes through an exclusive or with a zero that none can know.

The zero is made of the ray or the point that a public function is given, and handed down as the last argument: no
language has to have global variables.
"""
from __future__ import annotations

from .glsl import Node
from .splice import Splice, is_public, rounds

ZERO = "zero"


class Seals:
    """Rules for Splice. `sealing` are the functions that need the zero; `call` and `fast` write a sealed operation,
    the second one of the few that the fast tier seals, too."""

    def __init__(self, sealing: set[str], call: str, fast: str, parameter: str, declaration: str):
        self.sealing = sealing
        self.macro = call
        self.fast = fast
        self.parameter = parameter
        self.declaration = declaration
        self.divisors: set[str] = set()  # of the function that is being written

    def rules(self) -> dict:
        return {"binary": self.binary, "parentheses": self.parentheses, "call": self.call,
                "function": self.function, "declaration": self.declared}

    def binary(self, splice: Splice, node: Node) -> str:
        plain = splice.plain(node)
        if not rounds(node):
            return plain
        if node.text == "/":
            plain = self.quotient(splice, node)
        return f"{self.macro}({plain})"

    def quotient(self, splice: Splice, node: Node) -> str:
        """A second division by the same number has that sealed: else compilers multiply both by its reciprocal."""
        dividend, divisor = node.children
        written = splice.write(divisor)
        if written in self.divisors:
            written = f"{self.macro}({written})"
        self.divisors.add(splice.write(divisor))
        return splice.write(dividend) + splice.text[dividend.end:divisor.start] + written

    def parentheses(self, splice: Splice, node: Node) -> str:
        inner = node.children[0]
        return splice.write(inner) if rounds(inner) else splice.plain(node)

    def call(self, splice: Splice, node: Node) -> str:
        plain = splice.plain(node)
        return f"{plain[:-1]}, {ZERO})" if node.text in self.sealing and not is_public(node.text) else plain

    def function(self, splice: Splice, node: Node) -> str:
        self.divisors = set()
        if node.text not in self.sealing:
            return splice.plain(node)
        parameters, block = node.child("parameters"), node.child("block")
        head = splice.between(node, node.start, parameters.start)
        listed = splice.write(parameters)
        body = splice.write(block)
        if is_public(node.text):
            body = "{\n    " + self.declaration.format(zero_of(parameters)) + body[1:]
        else:
            listed = f"{listed[:-1]}, {self.parameter})"
        return f"{head}{listed} {body}"

    def declared(self, splice: Splice, node: Node) -> str:
        """What the fast tier needs rounded, too."""
        if not any(child.text == "TORUS_ROUNDED" for child in node.children):
            return splice.plain(node)
        exact, self.macro = self.macro, self.fast
        written = splice.plain(node)
        self.macro = exact
        return written


def zero_of(parameters: Node) -> str:
    """The arguments of torus_zero: the vectors that the function is given. They are hardly ever constants all."""
    vectors = []
    for parameter in parameters.children:
        name, kind = parameter.child("name").text, parameter.child("type").text
        if any(child.text == "out" for child in parameter.children):
            continue
        if kind == "vec3":
            vectors.append(name)
        elif kind == "vec2":
            vectors.append(f"vec3({name}.x, {name}.y, 0.0)")
    if not vectors:
        vectors = [f"vec3({p.child('name').text}, 0.0, 0.0)" for p in parameters.children if p.child("type").text == "float"]
    return ", ".join((vectors * 2)[:2])
