#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fails unless each relative link of each Markdown page leads to a file, and to a heading where it has an anchor.

Usage: tests/docs/links.py [folder]     the project unless given
"""
import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)\s]+)\)")


def without_code(text):
    text = re.sub(r"^```.*?^```$", lambda block: "\n" * block[0].count("\n"), text, flags=re.M | re.S)
    text = re.sub(r"^<!--.*?-->$", lambda comment: "\n" * comment[0].count("\n"), text, flags=re.M | re.S)
    return re.sub(r"`[^`\n]*`", "``", text)


def anchors_of(page):
    """The anchors that GitHub makes of a page's headings."""
    anchors = set()
    text = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
    for heading in re.findall(r"^#+ (.+)$", text, flags=re.M):
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
        anchor = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        copies = sum(1 for other in anchors if re.fullmatch(re.escape(anchor) + r"(-\d+)?", other))
        anchors.add(f"{anchor}-{copies}" if copies else anchor)
    return anchors


def faults_of(page):
    for number, line in enumerate(without_code(page.read_text(encoding="utf-8")).split("\n"), 1):
        for link in LINK.findall(line):
            if re.match(r"[a-z]+:", link):
                continue
            path, _, anchor = link.partition("#")
            target = (page.parent / path).resolve() if path else page
            if not target.exists():
                yield f"{page}:{number}: there is no {path}"
            elif anchor and target.suffix == ".md" and anchor not in anchors_of(target):
                yield f"{page}:{number}: {target.name} has no heading #{anchor}"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    root = root if root.is_dir() else root.parents[2]
    pages = [page for page in sorted(root.rglob("*.md")) if not {"build", "out"} & set(page.relative_to(root).parts)]
    faults = [fault for page in pages for fault in faults_of(page)]
    print("\n".join(faults) or f"every link of {len(pages)} pages leads somewhere")
    return 1 if faults or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
