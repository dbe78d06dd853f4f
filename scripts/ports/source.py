# SPDX-License-Identifier: MIT
"""The library's folder as one text, and that text with its conditions decided."""
from __future__ import annotations

import re
from pathlib import Path

INCLUDE = re.compile(r'#include "(\w+\.glsl)"')
SPDX = "// SPDX-License-Identifier: MIT\n"


def body(text: str) -> list[str]:
    """The lines of a file without its licence line, and without its include guard."""
    lines = text.removeprefix(SPDX).splitlines()
    guard = next(i for i, line in enumerate(lines) if line.startswith("#ifndef TORUS_"))
    last = max(i for i, line in enumerate(lines) if line == "#endif")
    return lines[:guard] + lines[guard + 2:last]


def flatten(folder: Path, name: str = "torus.glsl", seen: set[str] | None = None) -> list[str]:
    """The lines of a file with every file that it includes, each once. What a conditional inclusion includes itself
    stands before the condition, where either branch has it."""
    seen = set() if seen is None else seen
    seen.add(name)
    written: list[str] = []
    depth, condition = 0, 0
    for line in body((folder / name).read_text()):
        if re.match(r"#\s*if", line):
            condition = len(written) if depth == 0 else condition
            depth += 1
        depth -= line.startswith("#endif")
        include = INCLUDE.match(line)
        if not include:
            written.append(line)
            continue
        if include[1] in seen:
            continue
        inner = flatten_own(folder, include[1], seen)
        place = condition if depth else len(written)
        written[place:place] = inner[0]
        written += inner[1]
    return written


def flatten_own(folder: Path, name: str, seen: set[str]) -> tuple[list[str], list[str]]:
    """What a file includes, and its own lines."""
    seen.add(name)
    before: list[str] = []
    own: list[str] = []
    for line in body((folder / name).read_text()):
        include = INCLUDE.match(line)
        if not include:
            own.append(line)
        elif include[1] not in seen:
            inner = flatten_own(folder, include[1], seen)
            before += inner[0] + inner[1]
    return before, own


def single_file(folder: Path) -> str:
    """Without runs of empty lines."""
    return re.sub(r"\n{3,}", "\n\n", "\n".join(flatten(folder)) + "\n")


def holds(condition: str, defined: dict[str, str]) -> bool:
    """Whether the condition of an #if holds."""
    text = re.sub(r"defined\s*\(?\s*(\w+)\s*\)?", lambda match: str(match[1] in defined), condition)
    text = re.sub(r"[A-Za-z_]\w*", lambda match: match[0] if match[0] in ("True", "False") else defined.get(match[0], "0"), text)
    text = text.replace("&&", " and ").replace("||", " or ")
    return bool(eval(re.sub(r"!(?!=)", " not ", text), {"__builtins__": {}}))  # pylint: disable=eval-used


def decide(text: str, defined: dict[str, str]) -> str:
    """The text where only these names are defined before it, without the lines that are skipped and without
    conditions. What the text itself defines as nothing is left out, too."""
    defined = dict(defined)
    written: list[str] = []
    # Of each open condition whether its present branch is taken, and whether one has been.
    stack: list[list[bool]] = []
    for line in text.splitlines():
        directive = re.match(r"#\s*(\w+)\s*(.*)", line)
        word, rest = (directive[1], directive[2]) if directive else ("", "")
        active = all(taken for taken, _ in stack)
        if word in ("ifdef", "ifndef", "if"):
            taken = active and (holds(rest, defined) if word == "if" else (rest in defined) == (word == "ifdef"))
            stack.append([taken, taken])
        elif word in ("else", "elif"):
            outer = all(taken for taken, _ in stack[:-1])
            taken = outer and not stack[-1][1] and (word == "else" or holds(rest, defined))
            stack[-1] = [taken, stack[-1][1] or taken]
        elif word == "endif":
            stack.pop()
        elif active:
            if word == "define":
                name, _, value = rest.partition(" ")
                defined[name] = value
                if not value:
                    continue
            written.append(line)
    return re.sub(r"\n{3,}", "\n\n", "\n".join(written).strip("\n") + "\n")
