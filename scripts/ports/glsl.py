# SPDX-License-Identifier: MIT
"""Reads the library's GLSL: a subset of the language, into a tree whose nodes know their place in the text.

The subset is what tests/library/files.cmake lets in: structures and functions at file scope, no overloads, no swizzles,
one declaration a statement. Comments and layout stay in the text between the nodes, so that whatever is written from
the tree keeps them.
"""
from __future__ import annotations

import re
from dataclasses import dataclass, field

TOKEN = re.compile(
    r"(?P<comment>//[^\n]*)|(?P<directive>\#(?:\\\n|(?!\s*//)[^\n])*)|(?P<number>0x[0-9a-fA-F]+u?|(?:\d+\.\d*|\.\d+|\d+)(?:[eE][+-]?\d+)?u?)"
    r"|(?P<name>[A-Za-z_]\w*)|(?P<sign>\+\+|--|[-+*/]=|<=|>=|==|!=|&&|\|\||<<|>>|[-+*/%<>=!&|^~?:;,.(){}\[\]])")

QUALIFIERS = ("const", "in", "out", "inout", "TORUS_PRECISE", "TORUS_ROUNDED")
BUILTIN_TYPES = ("void", "bool", "int", "uint", "float", "vec2", "vec3", "vec4")
# From the loosest to the tightest.
OPERATORS = (("||",), ("&&",), ("|",), ("^",), ("&",), ("==", "!="), ("<", ">", "<=", ">="), ("<<", ">>"), ("+", "-"),
             ("*", "/", "%"))


class GlslError(Exception):
    """What is not in the subset, with its line."""


@dataclass
class Token:
    kind: str
    text: str
    start: int
    end: int


@dataclass
class Node:
    """A part of the text, from `start` to `end`. `text` is its word or operator, `type` that of an expression."""
    kind: str
    start: int
    end: int
    text: str = ""
    type: str = ""
    children: list[Node] = field(default_factory=list)

    def child(self, kind: str) -> Node | None:
        """The first child of this kind."""
        return next((node for node in self.children if node.kind == kind), None)

    def walk(self):
        """This node and all below it, in the order of the text."""
        yield self
        for node in self.children:
            yield from node.walk()


def tokenize(text: str) -> list[Token]:
    """All tokens but comments."""
    tokens, at = [], 0
    while at < len(text):
        if text[at].isspace():
            at += 1
            continue
        match = TOKEN.match(text, at)
        if not match:
            raise GlslError(f"line {text.count(chr(10), 0, at) + 1}: no GLSL: {text[at:at + 20]!r}")
        if match.lastgroup != "comment":
            tokens.append(Token(match.lastgroup, match.group(), at, match.end()))
        at = match.end()
    tokens.append(Token("end", "", len(text), len(text)))
    return tokens


class Parser:
    """One file. `types` are the names of structures, those of other files included."""

    def __init__(self, text: str):
        self.text = text
        self.tokens = tokenize(text)
        self.at = 0
        self.structures: set[str] = set(re.findall(r"^struct (\w+)", text, re.MULTILINE))

    def fault(self, expected: str):
        token = self.tokens[self.at]
        line = self.text.count("\n", 0, token.start) + 1
        raise GlslError(f"line {line}: {expected} expected, not {token.text!r}")

    def peek(self, ahead: int = 0) -> Token:
        return self.tokens[min(self.at + ahead, len(self.tokens) - 1)]

    def take(self, *texts: str) -> Token:
        token = self.peek()
        if texts and token.text not in texts:
            self.fault(" or ".join(texts))
        self.at += 1
        return token

    def accept(self, *texts: str) -> Token | None:
        return self.take() if self.peek().text in texts else None

    def leaf(self, kind: str) -> Node:
        token = self.take()
        if token.kind != "name":
            self.at -= 1
            self.fault(kind)
        return Node(kind, token.start, token.end, token.text)

    def isType(self, token: Token) -> bool:
        return token.text in BUILTIN_TYPES or token.text in self.structures

    def qualifiers(self) -> list[Node]:
        found = []
        while self.peek().text in QUALIFIERS:
            found.append(self.leaf("qualifier"))
        return found

    def node(self, kind: str, children: list[Node], start: int, text: str = "") -> Node:
        """From `start` to the end of the last token taken."""
        return Node(kind, start, self.tokens[self.at - 1].end, text, "", children)

    def file(self) -> Node:
        children = []
        while self.peek().kind != "end":
            children.append(self.outermost())
        return Node("file", 0, len(self.text), "", "", children)

    def outermost(self) -> Node:
        token = self.peek()
        if token.kind == "directive":
            return self.directive()
        if token.text == "precision":
            while self.take().text != ";":
                pass
            return self.node("precision", [], token.start)
        if token.text == "struct":
            return self.structure()
        return self.function()

    def directive(self) -> Node:
        token = self.take()
        return Node("directive", token.start, token.end, token.text)

    def structure(self) -> Node:
        start = self.take("struct").start
        name = self.leaf("typeName")
        self.take("{")
        members = []
        while not self.accept("}"):
            begin = self.peek().start
            member = [self.leaf("type"), self.leaf("memberName")]
            self.take(";")
            members.append(self.node("member", member, begin, member[1].text))
        self.take(";")
        return self.node("struct", [name, *members], start, name.text)

    def function(self) -> Node:
        start = self.peek().start
        result, name = self.leaf("type"), self.leaf("functionName")
        begin = self.take("(").start
        parameters = []
        while not self.accept(")"):
            first = self.peek().start
            parts = [*self.qualifiers(), self.leaf("type"), self.leaf("name")]
            if self.accept("["):
                parts.append(self.number())
                self.take("]")
            parameters.append(self.node("parameter", parts, first))
            if self.peek().text != ")":
                self.take(",")
        listed = self.node("parameters", parameters, begin)
        body = self.block()
        return self.node("function", [result, name, listed, body], start, name.text)

    def block(self) -> Node:
        start = self.take("{").start
        children = []
        while not self.accept("}"):
            children.append(self.statement())
        return self.node("block", children, start)

    def statement(self) -> Node:
        token = self.peek()
        following = self.peek(1)
        if token.kind == "directive":
            return self.directive()
        if token.text == "{":
            return self.block()
        if token.text == "if":
            return self.branch()
        if token.text == "for":
            return self.loop()
        if token.text == "return":
            self.take()
            value = [] if self.peek().text == ";" else [self.expression()]
            self.take(";")
            return self.node("return", value, token.start)
        if token.kind == "name" and token.text.isupper() and token.text.startswith("TORUS_ON_"):
            self.take()
            return Node("hook", token.start, token.end, token.text)
        if token.text in QUALIFIERS or (self.isType(token) and following.kind == "name"):
            return self.declaration()
        return self.simple(";")

    def declaration(self) -> Node:
        start = self.peek().start
        parts = [*self.qualifiers(), self.leaf("type"), self.leaf("name")]
        if self.accept("="):
            parts.append(self.expression())
        self.take(";")
        return self.node("declaration", parts, start)

    def simple(self, closing: str) -> Node:
        """An assignment, an increment or a call."""
        start = self.peek().start
        if self.accept("++"):
            target = [self.postfix()]
            self.take(closing)
            return self.node("increment", target, start)
        target = self.postfix()
        sign = self.accept("=", "+=", "-=", "*=", "/=")
        if not sign:
            self.take(closing)
            return self.node("callStatement", [target], start)
        value = self.expression()
        self.take(closing)
        return self.node("assignment", [target, value], start, sign.text)

    def branch(self) -> Node:
        start = self.take("if").start
        self.take("(")
        parts = [self.expression()]
        self.take(")")
        parts.append(self.block())
        if self.accept("else"):
            parts.append(self.branch() if self.peek().text == "if" else self.block())
        return self.node("if", parts, start)

    def loop(self) -> Node:
        start = self.take("for").start
        self.take("(")
        parts = [self.declaration(), self.expression()]
        self.take(";")
        parts.append(self.simple(")"))
        # The closing parenthesis belongs to the loop.
        parts[-1].end = parts[-1].children[-1].end
        parts.append(self.block())
        return self.node("for", parts, start)

    def expression(self) -> Node:
        start = self.peek().start
        condition = self.binary(0)
        if not self.accept("?"):
            return condition
        first = self.expression()
        self.take(":")
        return self.node("choice", [condition, first, self.expression()], start)

    def binary(self, level: int) -> Node:
        if level == len(OPERATORS):
            return self.unary()
        start = self.peek().start
        left = self.binary(level + 1)
        while self.peek().text in OPERATORS[level] and self.peek().kind == "sign":
            sign = self.take()
            left = self.node("binary", [left, self.binary(level + 1)], start, sign.text)
        return left

    def unary(self) -> Node:
        token = self.accept("-", "!", "~")
        if token:
            return self.node("unary", [self.unary()], token.start, token.text)
        return self.postfix()

    def number(self) -> Node:
        token = self.take()
        if token.kind != "number":
            self.at -= 1
            self.fault("a number")
        return Node("number", token.start, token.end, token.text)

    def postfix(self) -> Node:
        start = self.peek().start
        value = self.primary()
        while self.peek().text in (".", "["):
            if self.accept("."):
                value = self.node("access", [value, self.leaf("memberName")], start)
            else:
                self.take("[")
                index = self.expression()
                self.take("]")
                value = self.node("index", [value, index], start)
        return value

    def primary(self) -> Node:
        token = self.peek()
        if token.kind == "number":
            return self.number()
        if self.accept("("):
            inner = self.expression()
            self.take(")")
            return self.node("parentheses", [inner], token.start)
        if token.text in ("true", "false"):
            self.take()
            return Node("truth", token.start, token.end, token.text)
        if self.peek(1).text != "(":
            return self.leaf("name")
        kind = "constructor" if self.isType(token) else "call"
        name = self.leaf("type" if kind == "constructor" else "functionName")
        self.take("(")
        arguments = []
        while not self.accept(")"):
            arguments.append(self.expression())
            if self.peek().text != ")":
                self.take(",")
        return self.node(kind, [name, *arguments], token.start, name.text)


def parse(text: str) -> Node:
    """The tree of a text, without types."""
    return Parser(text).file()
