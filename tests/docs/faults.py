#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fails unless scripts/check_docs and links.py see each fault of a page, and none in a page that has none."""
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
CHECK = HERE.parents[1] / "scripts/check_docs"
LINKS = HERE / "links.py"

TABLE = "<!-- check: printf '1 0.58\\n2 6.03e-08\\n' -->\n\n| n | error |\n|---|---|\n| 1 | {} |\n| 2 | 6.03·10⁻⁸ |\n"
TEXT = "<!-- check: echo 41812345 2\n     text: # rays and # rings -->\n\nThere are {} rays and\n{} rings.\n"
CODE = "<!-- check: printf 'one 1\\ntwo 2\\nthree 3\\n' -->\n\n```console\n$ count\none 1\n...\n{}\n```\n"
LINK = "# A page\n\n[here]({})\n"
# What is checked, a page, the exit code, a part of what is said.
PAGES = [
    ([CHECK], TABLE.format("0.6"), 0, "1 as printed"),
    ([CHECK], TABLE.format("0.57"), 1, ":5: documented 1, 0.57"),
    ([CHECK], TABLE.replace("| 2 |", "| 3 |").format("0.58"), 1, ":6: documented 3"),
    ([CHECK], TABLE.format("0.58") + "| 3 | 1 |\n", 1, "3 rows"),
    ([CHECK], TEXT.format("41.8 million", "two"), 0, "1 as printed"),
    ([CHECK], TEXT.format("41 812 345", "2"), 0, "1 as printed"),
    ([CHECK], TEXT.format("41.9 million", "two"), 1, ":4: documented 41.9 million"),
    ([CHECK], TEXT.format("41.8 million", "no"), 1, "documented 41.8 million, 0"),
    ([CHECK], "<!-- check: echo 2\n     text: # rings -->\n\nRings.\n", 1, "does not say"),
    ([CHECK], "<!-- check: echo 100\n     within: 5 %, it varies\n     text: # ms -->\n\n104 ms\n", 0, "1 as printed"),
    ([CHECK], "<!-- check: echo 100\n     within: 5 %, it varies\n     text: # ms -->\n\n110 ms\n", 1, "documented 110"),
    ([CHECK], "<!-- check: sleep 1\n     takes: 6 min\n     text: # -->\n\n1\n", 0, "1 left out"),
    ([CHECK], "<!-- check: echo version 7\n     only: version 8\n     text: # -->\n\n1\n", 0, "1 left out"),
    ([CHECK], "<!-- check: exit 3\n     text: # -->\n\n1\n", 1, "exit code 3"),
    ([CHECK], "1\n\n<!-- check: echo 1\n     text: # -->\n", 1, "does not say"),
    ([CHECK], CODE.format("three 3"), 0, "1 as printed"),
    ([CHECK], CODE.format("three 4"), 1, "documented three 4"),
    ([CHECK, "--unmarked"], "| n |\n|---|\n| 1 |\n", 1, ":1: this table"),
    ([CHECK, "--unmarked"], "<!-- unchecked: a word -->\n\n| n |\n|---|\n| 1 |\n", 0, "has a mark"),
    ([CHECK, "--unmarked"], "```console\n$ count\n3\n```\n", 1, ":2: this code"),
    ([CHECK, "--unmarked"], "```sh\ncount 3\n```\n", 0, "has a mark"),
    ([LINKS], LINK.format("page.md#a-page"), 0, "1 pages"),
    ([LINKS], LINK.format("other.md"), 1, "page.md:3: there is no other.md"),
    ([LINKS], LINK.format("#another-page"), 1, "page.md has no heading #another-page"),
]


def main():
    faults = 0
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder) / "page.md"
        (pathlib.Path(folder) / "bin").mkdir()
        for command, text, code, words in PAGES:
            page.write_text(text, encoding="utf-8")
            where = [folder] if command == [LINKS] else [page, "--build", folder]
            run = subprocess.run([*command, *where], capture_output=True, text=True, check=False)
            if run.returncode != code or words not in run.stdout:
                print(f"exit code {run.returncode}, not {code}, or no \"{words}\":\n{text}\n{run.stdout}{run.stderr}\n")
                faults += 1
    print(f"{len(PAGES) - faults} of {len(PAGES)} pages are judged right")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
