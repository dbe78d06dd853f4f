# SPDX-License-Identifier: MIT
"""Rays to prove ports with: 8 float32 a ray, as `raytorus trace` reads them."""
from __future__ import annotations

import math
import random
from array import array

# Major and minor radius: a ring, a wire, a horn, a spindle, a fat ring.
TORI = ((1.0, 0.25), (1.0, 0.01), (1.0, 1.0), (1.0, 1.3), (1.0, 0.5))


def unit(rng: random.Random) -> tuple[float, float, float]:
    """A direction, all as likely."""
    z = rng.uniform(-1.0, 1.0)
    angle = rng.uniform(0.0, 2.0 * math.pi)
    across = math.sqrt(1.0 - z * z)
    return across * math.cos(angle), across * math.sin(angle), z


def surface(rng: random.Random, major: float, minor: float):
    """A point of the torus, and its normal."""
    u, v = rng.uniform(0.0, 2.0 * math.pi), rng.uniform(0.0, 2.0 * math.pi)
    normal = (math.cos(v) * math.cos(u), math.cos(v) * math.sin(u), math.sin(v))
    centre = (major * math.cos(u), major * math.sin(u), 0.0)
    return [c + minor * n for c, n in zip(centre, normal)], normal


def ray(rng: random.Random, kind: int, major: float, minor: float) -> list[float]:
    """0: from a box around; 1: from afar; 2: beside a tangent; 3: any; 4: what is no ray, or has limits."""
    size = major + minor
    begin, end = 0.0, math.inf
    target, normal = surface(rng, major, minor)
    if kind == 2:
        direction = unit(rng)
        dot = sum(d * n for d, n in zip(direction, normal))
        direction = tuple(d - dot * n for d, n in zip(direction, normal))
        offset = rng.choice((-1.0, 1.0)) * minor * 10.0 ** rng.uniform(-6.0, math.log10(0.03))
        target = [t + offset * n for t, n in zip(target, normal)]
        origin = [t - size * rng.uniform(1.0, 5.0) * d for t, d in zip(target, direction)]
        return [*origin, begin, *direction, end]
    distance = size * (10.0 ** rng.uniform(math.log10(2.0), 4.0) if kind == 1 else rng.uniform(0.1, 2.0))
    origin = [t + distance * d for t, d in zip(target, unit(rng))]
    if kind == 3:
        target = [rng.uniform(-size, size) for _ in range(3)]
    length = 10.0 ** rng.uniform(-3.0, 3.0) if kind == 3 else 1.0
    direction = [(t - o) * length for t, o in zip(target, origin)]
    if kind == 4:
        begin, end = rng.choice(((0.5, math.inf), (0.0, 3.0), (0.5, 1.5), (-math.inf, 0.0), (2.0, 1.0)))
        place = rng.randrange(12)
        if place < 8:
            row = [*origin, begin, *direction, end]
            row[place] = rng.choice((math.nan, math.inf, -math.inf, 0.0))
            return row
        direction = direction if place > 8 else [0.0, 0.0, 0.0]
    return [*origin, begin, *direction, end]


def rays(seed: int, count: int, torus: tuple[float, float], valid: bool = False) -> array:
    """So many rays, a fifth of each kind; with `valid`, none of the last."""
    rng = random.Random(f"{seed} {torus}")
    values = array("f")
    for i in range(count):
        values.extend(ray(rng, i % (4 if valid else 5), *torus))
    return values
