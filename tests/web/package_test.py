#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The package for npm, as a stranger installs it, without a network: python3 tests/web/package_test.py <folder of dist>.

By npm where it is. The strings and the exports are looked at without it, too.
"""
from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
root = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(root / "scripts"))
from ports import npm  # noqa: E402

dist = Path(sys.argv.pop(1)).resolve()
package = dist / "npm"
# A module that says each string, and each file, as node finds them.
ASK = """
import * as raytorus from "raytorus";
import {createRequire} from "node:module";
import {readFileSync} from "node:fs";
const find = createRequire(import.meta.url).resolve;
const files = {};
for (const name of process.argv.slice(2)) files[name] = readFileSync(find(`raytorus/${name}`), "utf8");
let hidden = "";
try { find("raytorus/index.d.ts"); } catch (error) { hidden = error.code; }
process.stdout.write(JSON.stringify({strings: {...raytorus}, files, hidden}));
"""


class Package(unittest.TestCase):
    def test_its_version_is_that_of_the_library(self):
        said = json.loads((package / "package.json").read_text())
        library = dict(re.findall(r"#define TORUS_VERSION_(\w+) (\d+)", (root / "shaders/torus/torus.glsl").read_text()))
        self.assertEqual(".".join(library[part] for part in ("MAJOR", "MINOR", "PATCH")), said["version"])
        self.assertEqual("MIT", said["license"])
        self.assertEqual((root / "LICENSE").read_text(), (package / "LICENSE").read_text())

    def test_every_string_has_its_type_and_every_file_its_export(self):
        said = json.loads((package / "package.json").read_text())
        declared = re.findall(r"^export const (\w+): string;$", (package / "index.d.ts").read_text(), re.MULTILINE)
        self.assertEqual(list(npm.STRINGS), declared)
        self.assertEqual({f"./{file}" for file in npm.STRINGS.values()} | {".", "./package.json"}, set(said["exports"]))
        self.assertLessEqual(set(npm.STRINGS.values()), set(said["files"]))
        readme = (package / "README.md").read_text()
        for name, file in npm.STRINGS.items():
            self.assertIn(f"| `{name}` | `{file}` |", readme)

    @unittest.skipUnless(shutil.which("npm") or os.environ.get("CI"), "npm is not here")
    def test_a_stranger_installs_and_imports_it_without_a_network(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            run = lambda *command: subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True).stdout  # noqa: E731
            packed = json.loads(run("npm", "pack", "--json", "--offline", str(package)))[0]
            self.assertEqual({"README.md", "LICENSE", "package.json", "index.js", "index.d.ts", *npm.STRINGS.values()},
                             {file["path"] for file in packed["files"]})
            with tarfile.open(folder / packed["filename"]) as archive:
                self.assertTrue(all(member.mode & 0o777 == 0o644 for member in archive.getmembers()))
            run("npm", "init", "--yes")
            run("npm", "install", "--offline", "--no-audit", "--no-fund", f"./{packed['filename']}")
            (folder / "ask.mjs").write_text(ASK)
            answer = json.loads(run("node", "ask.mjs", *npm.STRINGS.values()))
        self.assertEqual({key: (dist / file).read_text() for key, file in npm.STRINGS.items()}, answer["strings"])
        self.assertEqual({file: (dist / file).read_text() for file in npm.STRINGS.values()}, answer["files"])
        self.assertEqual("ERR_PACKAGE_PATH_NOT_EXPORTED", answer["hidden"])


if __name__ == "__main__":
    unittest.main()
