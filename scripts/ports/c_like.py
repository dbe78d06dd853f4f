# SPDX-License-Identifier: MIT
"""The library in languages that read like GLSL: HLSL, Metal, Godot's, and C++."""
from __future__ import annotations

import re
from dataclasses import dataclass, field

from . import glsl
from .glsl import Node
from .splice import SIZED, Splice, Types


@dataclass
class Language:
    """What such a language says otherwise."""
    name: str
    note: str                    # for the head: how to use it
    language: str                # what stands for language.glsl
    types: dict[str, str] = field(default_factory=dict)
    functions: dict[str, str] = field(default_factory=dict)
    renamed: dict[str, str] = field(default_factory=dict)  # names that the language has taken
    suffix: str = ""             # of a float
    function_prefix: str = ""    # before each function
    reference: str = ""          # of an `out` parameter, with {type} and {name}
    array_reference: str = ""    # ... and {size}
    braces: bool = False         # a structure is made by Name{...}; else by a function
    macros: str = "TORUS_R"      # which macro seals a number
    prologue: str = ""           # before the structures
    epilogue: str = ""


class CLike:
    """Rules for Splice."""

    def __init__(self, language: Language, types: Types):
        self.language = language
        self.types = types

    def rules(self) -> dict:
        return {"type": self.type, "functionName": self.function_name, "name": self.name, "memberName": self.name,
                "number": self.number, "constructor": self.constructor, "parameter": self.parameter,
                "declaration": self.declaration, "struct": self.structure, "function": self.function,
                "directive": self.directive, "precision": lambda _s, _n: "", "hook": lambda _s, _n: ""}

    def type(self, _splice: Splice, node: Node) -> str:
        return self.language.types.get(node.text, node.text)

    def function_name(self, _splice: Splice, node: Node) -> str:
        return self.language.functions.get(node.text, node.text)

    def name(self, _splice: Splice, node: Node) -> str:
        return self.language.renamed.get(node.text, node.text)

    def number(self, _splice: Splice, node: Node) -> str:
        return node.text + (self.language.suffix if node.type == "float" else "")

    def constructor(self, splice: Splice, node: Node) -> str:
        arguments = ", ".join(splice.write(child) for child in node.children[1:])
        if node.text in SIZED:
            return f"{self.language.types.get(node.text, node.text)}({arguments})"
        return f"{node.text}{{{arguments}}}" if self.language.braces else f"{maker(node.text)}({arguments})"

    def parameter(self, splice: Splice, node: Node) -> str:
        qualifiers = [child.text for child in node.children if child.kind == "qualifier"]
        kind, name, size = node.child("type"), node.child("name"), node.child("number")
        written = {"type": splice.write(kind), "name": splice.write(name), "size": size.text if size else ""}
        written["way"] = next((q for q in qualifiers if q != "const"), "")
        if written["way"] and self.language.reference:
            return (self.language.array_reference if size else self.language.reference).format(**written)
        array = f"[{size.text}]" if size else ""
        return f"{written['way']} {written['type']} {written['name']}{array}".strip()

    def declaration(self, splice: Splice, node: Node) -> str:
        plain = splice.plain(node)
        keeps = "TORUS_PRECISE" in self.language.language
        return plain if keeps else re.sub(r"\bTORUS_(PRECISE|ROUNDED) ", "", plain)

    def structure(self, splice: Splice, node: Node) -> str:
        plain = splice.plain(node)
        if self.language.braces:
            return plain
        members = [(m.children[0], m.children[1]) for m in node.children if m.kind == "member"]
        listed = ", ".join(f"{splice.write(kind)} {splice.write(name)}" for kind, name in members)
        set_all = "".join(f"    made.{splice.write(name)} = {splice.write(name)};\n" for _, name in members)
        return f"{plain}\n\n{node.text} {maker(node.text)}({listed}) {{\n    {node.text} made;\n{set_all}    return made;\n}}"

    def function(self, splice: Splice, node: Node) -> str:
        return self.language.function_prefix + splice.plain(node)

    def directive(self, _splice: Splice, node: Node) -> str:
        define = re.match(r"#define (\w+) (.*)", node.text)
        if not define or "(" in define[1]:
            return node.text
        value = define[2]
        for old, new in self.language.functions.items():
            value = re.sub(rf"\b{old}\b", new, value)
        if self.types.constants.get(define[1]) == "float" and re.fullmatch(r"[-\d.eE+]+", value):
            value += self.language.suffix
        return f"#define {define[1]} {value}"


def maker(structure: str) -> str:
    """torus_Line: torus_makeLine. Torus, which users make, too: torus_makeTorus."""
    return "torus_make" + structure.removeprefix("torus_")


BLOCK = re.compile(r"// GLSL ES computes.*?(?=// Whether doubts are decided)", re.DOTALL)
NOTE = re.compile(r"// Made of the folder shaders/torus by scripts/dist:.*?(?=#ifndef TORUS_GLSL)", re.DOTALL)


def translate(full: str, language: Language) -> str:
    """The single file of GLSL in such a language."""
    text, count = BLOCK.subn(lambda _: language.language, full)
    assert count == 1, "language.glsl's block"
    text, count = NOTE.subn(lambda _: language.note, text)
    assert count == 1, "the head's note"
    tree = glsl.parse(text)
    taken = {node.text for node in tree.walk() if node.kind in ("name", "memberName")} & set(language.renamed.values())
    assert not taken, f"{language.name}: {taken} is a name already"
    written = Splice(text, CLike(language, Types(tree)).rules()).write(tree)
    written = written.replace("#define TORUS_GLSL\n", "#define TORUS_GLSL\n" + language.prologue, 1)
    written = re.sub(r" +$", "", written, flags=re.MULTILINE)
    written = re.sub(r"\n{3,}", "\n\n", written)
    return written.removesuffix("#endif\n") + language.epilogue + "#endif\n"
