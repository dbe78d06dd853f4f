# SPDX-License-Identifier: MIT
"""Answers to rays: 26 float32 a ray, and how those of a port differ from those of the program."""
from __future__ import annotations

import subprocess
import tempfile
from array import array
from dataclasses import dataclass
from pathlib import Path

NEAREST, ALL, ANY = 8, 17, 1
ROW = NEAREST + ALL + ANY
RAY = 8


def native(program: str, torus: tuple[float, float], rays: array, *options: str) -> array:
    """What `raytorus trace` answers: the nearest hit, all hits, any hit."""
    parts = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "rays.bin").write_bytes(rays.tobytes())
        for query in ([], ["--all"], ["--any"]):
            command = [program, "trace", "rays.bin", "-o", "hits.bin", "--torus", f"{torus[0]!r},{torus[1]!r}", *query, *options]
            subprocess.run(command, cwd=folder, check=True)
            parts.append(array("f", (folder / "hits.bin").read_bytes()))
    rows = array("f")
    for i in range(len(rays) // RAY):
        for part, size in zip(parts, (NEAREST, ALL, ANY)):
            rows.extend(part[i * size:(i + 1) * size])
    return rows


@dataclass
class Difference:
    """Of a port's answers: how many rows there are, and what is wrong with them."""
    rays: int = 0
    missed: int = 0        # hits that the port does not have
    false: int = 0         # hits that are none
    miscounted: int = 0    # rows with another number of hits
    other_bits: int = 0    # rows with another bit
    position: float = 0.0  # the farthest that a position is off, in R + r

    def add(self, expected: array, found: array, size: float, nearest_only: bool = False):
        width = 4 * ROW
        theirs, ours = found.tobytes(), expected.tobytes()
        assert len(theirs) == len(ours), f"{len(theirs)} bytes of answers instead of {len(ours)}"
        self.rays += len(ours) // width
        for i in range(len(ours) // width):
            if ours[i * width:(i + 1) * width] == theirs[i * width:(i + 1) * width]:
                continue
            self.other_bits += 1
            right, other = expected[i * ROW:(i + 1) * ROW], found[i * ROW:(i + 1) * ROW]
            if nearest_only:
                other[NEAREST:] = right[NEAREST:]
            self.missed += right[0] > other[0] or right[-1] > other[-1]
            self.false += right[0] < other[0] or right[-1] < other[-1]
            self.miscounted += right[NEAREST] != other[NEAREST]
            if right[0] == 1.0 == other[0]:
                off = max(abs(right[k] - other[k]) for k in range(2, 5))
                # Not a number is as far off as can be.
                self.position = max(self.position, off / size if off == off else float("inf"))
